// The test bench: the control finds resonance and amplitude, and the routes say what is known of a damped span.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "strandyn/casefile/read.hpp"
#include "strandyn/core/error.hpp"
#include "support/check_close.hpp"
#include "support/run.hpp"

using namespace strandyn;
using nlohmann::ordered_json;
using std::numbers::pi;
using test::check_close;

namespace {

constexpr double mass = 1.976;  // [kg/m]

/// A pinned span of a linear section: sines, whose frequency and energy are known. More tables follow.
casefile::Scene linear_bench(const std::string& tables, const std::vector<std::string>& overrides = {}) {
  return casefile::read_scene_text(
      "[section]\nlaw = \"elastic\"\nEA_N = 47e6\nEI_N_m2 = 100\nmass_kg_per_m = 1.976\n"
      "[span]\nlength_m = 15\nelements = 40\nleft = \"pinned\"\nright = \"pinned\"\ngrading = \"uniform\"\n"
      "mass = \"consistent\"\n[integrator]\nsteps_per_cycle = 100\n"
      "[analysis]\ntype = \"self-damping\"\nmethod = \"transient\"\nmodes = 5\nantinode_amplitude_mm = 1\n"
      "tensions_kN = 30\n" +
          tables,
      "test.toml", overrides);
}

ordered_json only_point(const casefile::Scene& scene) {
  const ordered_json points = test::run(scene).summary["points"];
  REQUIRE(points.size() == 1);
  return points[0];
}

/// Of the first modes, so that what the shaker strikes beside the fifth dies out.
std::string modal_damping(double ratio) {
  std::string rows;
  for (int mode = 1; mode <= 12; ++mode) rows += fmt::format("{}[{}, {}]", mode > 1 ? ", " : "", mode, ratio);
  return "[damping]\nmodal = [" + rows + "]\n";
}

/// [W/m] zeta m omega V^2/2 at the frequency and the amplitude of the bench.
double power_of(const ordered_json& bench, double zeta) {
  const double omega = 2 * pi * bench["frequency_Hz"].get<double>();
  const double velocity = omega * bench["fundamental_amplitude_m"].get<double>();
  return zeta * mass * omega * velocity * velocity / 2;
}

}  // namespace

TEST_CASE("test bench: whatever the damping is the span comes to resonance and all routes say that damping") {
  for (const double zeta : {1e-4, 1e-3, 1e-2, 5e-2}) {
    CAPTURE(zeta);
    const ordered_json point = only_point(linear_bench(modal_damping(zeta)));
    CAPTURE(point.dump());
    REQUIRE(!point.contains("failed"));
    const ordered_json& bench = point["bench"];
    check_close(bench["antinode_amplitude_m"], 1e-3, {.relative = 2e-3});
    CHECK(std::abs(bench["power"]["phase_deg"].get<double>()) < 1.5);
    const double expected = power_of(bench, zeta);
    // The other modes' forced motion takes its share: of the order of (5 zeta)^2 of it, and 5 zeta of the shape.
    check_close(bench["ledger"]["self_damping_W_per_m"], expected, {.relative = 1e-3 + 3 * zeta});
    check_close(bench["power"]["over_ledger"], 1, {.relative = 1e-3});
    check_close(bench["power"]["from_work_W_per_m"], bench["ledger"]["self_damping_W_per_m"], {.relative = 1e-3});
    // Measured 1.5e-3 at 100 steps per cycle, 6e-4 at 200, 1e-4 at 400.
    check_close(bench["decay"]["over_ledger"], 1, {.relative = 2e-3 + 3 * zeta});
    CHECK(bench["ledger"]["numerical_share"].get<double>() < 0.01);
  }
}

TEST_CASE("test bench: drag is found alike by all four routes with a force and with a moved support") {
  const std::string drag = "[damping]\ndrag_N_s_per_m2 = 1.0\n";
  for (const std::string shaker :
       {"", "[[motion]]\ntype = \"harmonic-motion\"\nat = \"left\"\namplitude_mm = 0.01\nfrequency_Hz = 20\n"}) {
    CAPTURE(shaker);
    const ordered_json point = only_point(linear_bench(drag + shaker));
    CAPTURE(point.dump());
    REQUIRE(!point.contains("failed"));
    const ordered_json& bench = point["bench"];
    const double zeta = 1.0 / (2 * mass * 2 * pi * bench["frequency_Hz"].get<double>());
    check_close(bench["ledger"]["self_damping_W_per_m"], power_of(bench, zeta), {.relative = 5e-3});
    check_close(bench["power"]["over_ledger"], 1, {.relative = 1e-3});
    check_close(bench["decay"]["over_ledger"], 1, {.relative = 2e-3});
    check_close(bench["iswr"]["over_ledger"], 1, {.relative = 5e-3});
  }
}

TEST_CASE("test bench: from rest it arrives where it starts from its mode") {
  const ordered_json from_mode = only_point(linear_bench(modal_damping(5e-3)));
  const ordered_json from_rest = only_point(linear_bench(modal_damping(5e-3), {"analysis.bench.start=rest"}));
  CAPTURE(from_rest.dump());
  REQUIRE(!from_rest.contains("failed"));
  check_close(from_rest["self_damping_W_per_m"], from_mode["self_damping_W_per_m"], {.relative = 5e-3});
  check_close(from_rest["bench"]["frequency_Hz"], from_mode["bench"]["frequency_Hz"], {.relative = 2e-4});
}

TEST_CASE("test bench: a span that loses nothing needs no force") {
  const ordered_json point = only_point(linear_bench(""));
  CAPTURE(point.dump());
  REQUIRE(!point.contains("failed"));
  CHECK(point["self_damping_W_per_m"] == 0.0);
  CHECK(std::abs(point["bench"]["shaker_force_N"].get<double>()) < 1e-4);  // 7e-7 of the energy a cycle, the method's
}

TEST_CASE("test bench: one that does not become steady says so in words") {
  const ordered_json point =
      only_point(linear_bench(modal_damping(1e-3), {"analysis.bench.max_cycles=40", "analysis.bench.start=rest"}));
  CHECK(point["failed"].get<std::string>().find("not steady after") != std::string::npos);
  CHECK(point["failed"].get<std::string>().find("max_cycles") != std::string::npos);
}

TEST_CASE("test bench: a span in which a wave loses most of itself on its round trip comes to rest, too") {
  // The force in the first quarter of a loop: resonance at the shaker is there for some drives and not for others.
  // In its middle: resonance lies 0.2 % beside the mode's frequency.
  for (const auto& [at, tuned] : {std::pair{0.5, "antinode"}, std::pair{1.0, "shaker"}}) {
    CAPTURE(at);
    const ordered_json point = only_point(casefile::read_scene_text(
        "[conductor]\ncatalogue = \"bersimis\"\nfriction = 0.5\n[section]\nlaw = \"return-map\"\npoints = 12\n"
        "[span]\nlength_m = 10\nelements = 48\n[integrator]\nsteps_per_cycle = 100\n" +
            fmt::format("[[load]]\ntype = \"harmonic-force\"\nat_m = {}\namplitude_N = 1\nfrequency = \"mode 5\"\n",
                        at) +
            "[analysis]\ntype = \"self-damping\"\nmethod = \"transient\"\nmodes = 5\n"
            "amplitude_over_diameter = 0.15\ntensions_rts = 0.15\n"
            "bench = { max_cycles = 400, cycles = 8, decay_cycles = 6 }\n",
        "test.toml"));
    CAPTURE(point.dump());
    REQUIRE(!point.contains("failed"));
    const ordered_json& bench = point["bench"];
    CHECK(bench["tuned_at"] == tuned);
    check_close(bench["antinode_amplitude_m"], 0.15 * 35.052e-3, {.relative = 2e-3});
    check_close(bench["power"]["over_ledger"], 1, {.relative = 2e-3});
  }
}

TEST_CASE("test bench: what has no shaker of one frequency is refused") {
  const std::string force = "[[load]]\ntype = \"harmonic-force\"\nat_m = 1\namplitude_N = 1\nfrequency_Hz = 20\n";
  CHECK_THROWS_WITH_AS(test::run(linear_bench(force + force)), doctest::Contains("is a second shaker"), InputError);
  CHECK_THROWS_WITH_AS(test::run(linear_bench("[[load]]\ntype = \"harmonic-force\"\nper_length = true\n"
                                              "amplitude_N = 1\nfrequency_Hz = 20\n")),
                       doctest::Contains("acts on the whole span"), InputError);
  CHECK_THROWS_WITH_AS(test::run(linear_bench("", {"integrator.method=ida", "integrator.step=adaptive"})),
                       doctest::Contains("counts its cycles in whole steps"), InputError);
}
