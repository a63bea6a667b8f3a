// Spans in the wind, with dampers, and what their clamps feel, from case files.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "strandyn/study/run_case.hpp"
#include "study/scenes.hpp"
#include "support/check_close.hpp"
#include "support/run.hpp"

using namespace strandyn;
using std::numbers::pi;
using test::check_close;
using test::span_scene;

namespace {

const std::string locked_in =
    "[[wind]]\nmodel = \"power-curve\"\nmode = 4\ncurve = \"diana-falco\"\n"
    "[integrator]\nmethod = \"generalized-alpha\"\nsteps_per_cycle = 80\n"
    "[analysis]\ntype = \"forced\"\ncycles = 60\n";
const std::string damped_decay =
    "[[damper]]\nat_m = 0.8\ncatalogue = \"z5\"\n"
    "[integrator]\nmethod = \"generalized-alpha\"\nrho_inf = 1\nsteps_per_cycle = 200\n"
    "[analysis]\ntype = \"decay\"\nmode = 4\nantinode_amplitude_mm = 3\ncycles = 10\n";
const std::string clamps = "[clamps]\n";
const std::string decay =
    "[integrator]\nsteps_per_cycle = 100\n"
    "[analysis]\ntype = \"decay\"\nmode = 4\nantinode_amplitude_mm = 3\ncycles = 3\n";

}  // namespace

TEST_CASE("wind: the ledger of a span in locked-in wind closes, and a small vibration grows at the rate of the curve") {
  const auto s = test::run(span_scene(locked_in, {"section.law=stick"})).summary;
  CHECK(s["wind"]["mode"] == 4);
  CHECK(s["wind"]["model"] == "power-curve");
  const double f = s["wind"]["frequency_Hz"], D = s["wind"]["diameter_m"];
  check_close(s["wind"]["wind_speed_m_per_s"], f * D / 0.2, {.relative = 1e-12});
  double kinetic = 0, elastic = 0;
  bool first = true;
  for (const auto& c : s["cycles"]) {
    const double change = c["kinetic_J"].get<double>() - kinetic + c["elastic_J"].get<double>() - elastic;
    if (!first)
      check_close(c["wind_work_J"].get<double>() - change - c["numerical_dissipation_J"].get<double>(), 0,
                  {.absolute = 1e-10});
    kinetic = c["kinetic_J"];
    elastic = c["elastic_J"];
    first = false;
    CHECK(c["wind_work_J"] > 0);
    CHECK(c["external_work_J"] == 0);
  }
  // At the bottom of the curve the power goes with A^2: d(ln A)/dt = c/(2 m), c = f D^2 fnc(a)/(pi a)^2.
  const double a = 0.01, fnc = 3.12858 * a + 208.972 * a * a;
  const double rate = f * D * D * fnc / (pi * pi * a * a) / (2 * 1.981);
  const auto& cycles = s["cycles"];
  const double grown = std::log(cycles[9]["kinetic_J"].get<double>() + cycles[9]["elastic_J"].get<double>()) -
                       std::log(cycles[1]["kinetic_J"].get<double>() + cycles[1]["elastic_J"].get<double>());
  CHECK(rate > 0);
  check_close(grown, 2 * rate * 8 / f, {.relative = 0.15});
}

TEST_CASE("wind: it meets the sleeve of ice around the conductor") {
  const auto wind = [](const std::vector<std::string>& overrides) {
    return test::run(span_scene(locked_in, overrides)).summary["wind"];
  };
  const auto bare = wind({"analysis.cycles=1"});
  const auto iced = wind({"analysis.cycles=1", "span.ice_kg_per_m=0.5", "span.ice_density_kg_per_m3=800"});
  const double D = bare["diameter_m"];
  check_close(iced["diameter_m"], std::sqrt(D * D + 4 * 0.5 / (pi * 800)), {.relative = 1e-12});
  CHECK(iced["frequency_Hz"] < bare["frequency_Hz"]);
}

TEST_CASE("wind: a speed locks in to the mode nearest to its shedding frequency") {
  const auto by_mode = test::run(span_scene(locked_in, {"analysis.cycles=2"})).summary["wind"];
  const double speed = by_mode["wind_speed_m_per_s"];
  std::string text = locked_in;
  text.replace(text.find("mode = 4"), 8, "speed_m_per_s = " + std::to_string(1.03 * speed));
  const auto by_speed = test::run(span_scene(text, {"analysis.cycles=2"})).summary["wind"];
  CHECK(by_speed["mode"] == 4);
  check_close(by_speed["wind_speed_m_per_s"], 1.03 * speed, {.relative = 1e-5});
}

TEST_CASE(
    "damper on a span: the ledger closes with the arms' energies, and the damper takes most of a small vibration") {
  const auto s = test::run(span_scene(damped_decay)).summary;
  double kinetic = 0, elastic = 0;
  bool first = true;
  for (const auto& c : s["cycles"]) {
    const double lost = c["friction_dissipation_J"].get<double>() + c["damper_dissipation_J"].get<double>();
    const double change = c["kinetic_J"].get<double>() - kinetic + c["elastic_J"].get<double>() - elastic;
    if (!first) check_close(-change - lost - c["numerical_dissipation_J"].get<double>(), 0, {.absolute = 1e-9});
    kinetic = c["kinetic_J"];
    elastic = c["elastic_J"];
    first = false;
    CHECK(c["damper_dissipation_J"] > c["friction_dissipation_J"]);
    CHECK(std::abs(c["numerical_dissipation_J"].get<double>()) < 0.01 * c["damper_dissipation_J"].get<double>());
  }
  CHECK(s["steady"]["dampers_W"] > 0);
}

TEST_CASE("damper on a span: half the step, the same loss") {
  const auto lost = [](const char* steps) {
    const auto s =
        test::run(span_scene(damped_decay, {"section.law=stick", std::string("integrator.steps_per_cycle=") + steps}))
            .summary;
    double sum = 0;
    for (const auto& c : s["cycles"]) sum += c["damper_dissipation_J"].get<double>();
    return sum;
  };
  check_close(lost("100"), lost("200"), {.relative = 0.01});
}

TEST_CASE("damper on a span: near the right support the other way round it is the mirror image of the left one") {
  const auto lost = [](std::vector<std::string> overrides) {
    overrides.insert(overrides.end(), {"section.law=stick", "analysis.mode=3", "analysis.cycles=4"});
    const auto s = test::run(span_scene(damped_decay, overrides)).summary;
    double sum = 0;
    for (const auto& c : s["cycles"]) sum += c["damper_dissipation_J"].get<double>();
    return sum;
  };
  const double at_left = lost({});
  check_close(lost({"damper[0].at_m=9.2", "damper[0].turned=true"}), at_left, {.relative = 1e-6});
  CHECK(std::abs(lost({"damper[0].at_m=9.2"}) / at_left - 1) > 1e-3);
}

TEST_CASE(
    "clamps: while nothing slips the wire stress is E cos^2 of the strain of a plane section, and its own bending") {
  // Curlew, outermost layer: 24 wires of 3.52 mm; amplitude so small that all wires stick.
  const auto run = test::run(span_scene(clamps + decay, {"analysis.antinode_amplitude_mm=0.02"}));
  const auto& row = run.summary["clamps"][0];
  CHECK(row["end"] == "left");
  CHECK(run.summary["clamps"].size() == 2);
  CHECK(run.summary["clamps"][1]["end"] == "right");
  check_close(row["bending_amplitude_m"], run.summary["clamps"][1]["bending_amplitude_m"], {.relative = 0.05});
  CHECK(row["worst_wire"]["amplitude_Pa"] > row["worst_wire"]["axial_amplitude_Pa"]);
  CHECK(row["poffenberger_swart_Pa"] > 0);
  CHECK(row["cycles_endured"] > 1e9);
}

TEST_CASE(
    "clamps: of sticking wires every layer and angle tells the same curvature by its axial part and by its own "
    "bending") {
  const casefile::Scene scene = span_scene(clamps + decay, {"analysis.antinode_amplitude_mm=0.02"});
  study::Outcome outcome;
  study::prepare(scene)->run({}, outcome);
  const auto found = std::ranges::find(outcome.tables, "clamp_wires.csv", &results::NamedTable::file);
  REQUIRE(found != outcome.tables.end());
  const results::Table& t = found->table;
  const auto& layers = scene.conductor->strand.layers;
  double curvature = 0, at = -1;
  std::size_t compared = 0;
  for (std::size_t row = 0; row < t.rows(); ++row) {
    if (t.column("end")[row] != 0) break;
    if (t.column("at_m")[row] != at) {
      at = t.column("at_m")[row];
      curvature = 0;
    }
    const auto layer = static_cast<std::size_t>(t.column("layer")[row]);
    if (layer == 0) continue;
    const conductor::Layer& wire = layers[layer];
    const double c = std::cos(wire.lay_angle), theta = t.column("theta_rad")[row];
    const double s = std::sin(theta), own_shape = std::hypot(std::cos(theta), c * s);
    // E cos^2 R |sin| chi along the wire, E d/2 cos sqrt(cos^2 + cos^2(lay) sin^2) chi across it.
    const double chi = t.column("axial_amplitude_Pa")[row] / (wire.young * c * c * wire.helix_radius * std::abs(s));
    const double across = t.column("amplitude_Pa")[row] - t.column("axial_amplitude_Pa")[row];
    if (curvature == 0) curvature = chi;
    // The tension swings with the amplitude's square: 1e-8 of it here.
    check_close(chi, curvature, {.relative = 1e-4});
    check_close(across / (wire.young * wire.diameter / 2 * c * own_shape), curvature, {.relative = 1e-4});
    ++compared;
  }
  CHECK(compared > 100);
}
