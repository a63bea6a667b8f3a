#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "results/scratch_folder.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/self_damping/method.hpp"
#include "study/self_damping_scene.hpp"
#include "support/check_close.hpp"
#include "support/run.hpp"

using namespace strandyn;
using nlohmann::ordered_json;
using test::check_close;
using test::damping_scene;

namespace {

/// Single points whose m f^2 A takes the same five values at each of four frequencies.
std::string proportional_grid() {
  std::string text = "mode_shape = \"string\"\n";
  for (double f : {10.0, 16.0, 25.0, 50.0}) {
    for (double s : {6.0, 9.0, 13.0, 20.0, 30.0}) {
      text += fmt::format("[[analysis.at]]\nfrequency_Hz = {}\nantinode_amplitude_mm = {:.17g}\ntension_rts = 0.2\n", f,
                          1e3 * s / (f * f));
    }
  }
  return text;
}

ordered_json summary_of(const casefile::Scene& scene) {
  return test::run(scene).summary;
}

const std::string small_grid =
    "frequencies_Hz = [10, 30]\namplitude_over_diameter = [0.1, 0.4]\ntensions_rts = [0.15, 0.25]\n";

/// Stops a study once it has told that so many of its points are done.
class StopAfter {
 public:
  explicit StopAfter(int points) : points_(points) {}
  study::Hooks hooks(const std::filesystem::path& folder) {
    return {
        .stop = [this] { return done_ >= points_; },
        .progress = [this](double,
                           std::string_view what) { std::sscanf(std::string(what).c_str(), "point %d of", &done_); },
        .folder = folder};
  }

 private:
  int points_;
  int done_ = -1;  // nothing told
};

}  // namespace

TEST_CASE("at one tension P over f depends on m f2 A over T alone") {
  for (const char* law : {"return-map", "masing", "compliant"}) {
    const ordered_json points = summary_of(damping_scene(law, proportional_grid()))["points"];
    REQUIRE(points.size() == 20);
    for (std::size_t i = 5; i < 20; ++i) {
      const ordered_json& first = points[i % 5];
      const double expected = first["self_damping_W_per_m"].get<double>() / first["frequency_Hz"].get<double>();
      CHECK(expected > 0);
      check_close(points[i]["self_damping_W_per_m"].get<double>() / points[i]["frequency_Hz"].get<double>(), expected,
                  {.relative = 1e-6});
    }
  }
}

TEST_CASE("at one tension the exponent of frequency is twice that of amplitude plus one") {
  const ordered_json fit = summary_of(damping_scene("return-map", proportional_grid()))["fit"];
  // ln f and ln(f^2 A) are independent on this grid, so the fit sees the identity itself, however curved the law is.
  check_close(fit["m"], 2 * fit["l"].get<double>() + 1, {.relative = 1e-6});
  CHECK_FALSE(fit.contains("n"));  // one tension says nothing about its exponent
}

TEST_CASE("small amplitudes of compliant contacts lose with the cube of amplitude and the seventh power of frequency") {
  const ordered_json s =
      summary_of(damping_scene("compliant",
                               "mode_shape = \"string\"\nfrequencies_Hz = [10, 12, 15, 20]\namplitude_over_diameter = "
                               "[0.005, 0.01, 0.02, 0.03]\ntensions_rts = 0.2\n"));
  check_close(s["fit_free_span"]["l"], 3.0, {.absolute = 0.05});
  check_close(s["fit_free_span"]["m"], 7.0, {.absolute = 0.1});
}

TEST_CASE("Curlew at 20 Hz and a fifth of its strength loses some milliwatts per metre") {
  const ordered_json points = summary_of(damping_scene(
      "compliant",
      "mode_shape = \"string\"\nfrequencies_Hz = 20\namplitude_over_diameter = [0.1, 0.2]\ntensions_rts = 0.2\n"))
      ["points"];
  // The loops of an analysis of type "section" at 16 places of the sine (400 steps a cycle), their mean times 20 Hz.
  check_close(points[0]["self_damping_W_per_m"], 1.0769e-3, {.relative = 0.01});
  check_close(points[1]["self_damping_W_per_m"], 10.509e-3, {.relative = 0.01});
}

TEST_CASE("the closed form gives the published values of Aster 570") {
  const ordered_json points = summary_of(casefile::read_scene_text(
      "[conductor]\ncatalogue = \"aster-570\"\n[section]\nlaw = \"return-map\"\n"
      "[analysis]\ntype = \"self-damping\"\nmethod = \"foti-2018\"\nfrequencies_Hz = 20\ntensions_rts = 0.15\n"
      "amplitude_over_diameter = [0.05, 0.2, 0.5, 1.0, 1.5]\n"
      "foti_2018 = { EI_N_m2 = 2155, chi_0_at_rated_strength_per_m = 0.140652 }\n",
      "test.toml"))["points"];
  const double expected[] = {1.15340e-3, 7.38178e-2, 1.15340, 7.82789, 18.3469};
  for (std::size_t i = 0; i < 5; ++i) {
    check_close(points[i]["self_damping_W_per_m"], expected[i], {.relative = 1e-5});  // the digits given
  }
}

TEST_CASE("the bare Drake line settles where wind and damping balance") {
  const ordered_json balance = summary_of(casefile::read_scene_text(
      "[conductor]\ncatalogue = \"drake\"\n[section]\nlaw = \"return-map\"\n"
      "[analysis]\ntype = \"self-damping\"\nmethod = \"foti-2018\"\nfrequencies_Hz = [10, 15, 20, 30, 40, 50]\n"
      "tensions_kN = 28\namplitude_over_diameter = 0.1\n"
      "foti_2018 = { EI_N_m2 = 1444, chi_0_at_rated_strength_per_m = 0.09641882 }\n"
      "[[analysis.energy_balance]]\nself_damping = \"published\"\nlaw = \"Noiseux\"\nfactor = 1.863\n"
      "[[analysis.energy_balance]]\nself_damping = \"foti-2018\"\n",
      "test.toml"))["energy_balance"];
  const double expected[] = {0.829, 0.555, 0.291, 0.0837, 0.0458, 0.0322, 0.610, 0.239, 0.104, 0.0418, 0.0257, 0.0183};
  REQUIRE(balance.size() == 12);
  for (std::size_t i = 0; i < 12; ++i) {
    CAPTURE(i);
    REQUIRE(balance[i].contains("amplitude_over_diameter"));
    check_close(balance[i]["amplitude_over_diameter"], expected[i], {.relative = 0.01});
    CHECK(balance[i]["within_curve"] == (expected[i] > 0.05));  // where the cubic was fitted
  }
}

TEST_CASE("where rigid contacts hold the study says up to which amplitude and fits nothing") {
  const ordered_json s = summary_of(damping_scene(
      "return-map", "frequencies_Hz = [10, 20]\namplitude_over_diameter = [0.01, 0.02]\ntensions_rts = 0.2\n"));
  for (const auto& point : s["points"]) CHECK(point["self_damping_W_per_m"] == 0.0);
  CHECK_FALSE(s["fit"].contains("k"));
  CHECK(s["fit"]["points_without_loss"] == 4);
  REQUIRE(s["no_slip_below"].size() == 2);
  CHECK(s["no_slip_below"][1]["antinode_amplitude_m"] >= s["points"][3]["antinode_amplitude_m"]);
}

TEST_CASE("first slip stands between an amplitude that loses nothing and one that loses") {
  const auto scene = [](double amplitude_mm) {
    return damping_scene("return-map", fmt::format("frequencies_Hz = 30\nantinode_amplitude_mm = [{:.12g}, 20]\n"
                                                   "tensions_rts = 0.2\n",
                                                   amplitude_mm));
  };
  const double onset = 1e3 * summary_of(scene(1))["no_slip_below"][0]["antinode_amplitude_m"].get<double>();
  CHECK(summary_of(scene(0.999 * onset))["points"][0]["self_damping_W_per_m"] == 0.0);
  CHECK(summary_of(scene(1.001 * onset))["points"][0]["self_damping_W_per_m"] > 0.0);
}

TEST_CASE("a study that was stopped goes on and ends with the same file") {
  const casefile::Scene scene = damping_scene("return-map", small_grid);
  const test::ScratchFolder whole, parted;
  const auto reference = test::run(scene, {.stop = {}, .progress = {}, .folder = whole.path()});
  REQUIRE(reference.exit_code == ExitCode::done);

  StopAfter three(3);
  const auto part = test::run(scene, three.hooks(parted.path()));
  CHECK(part.exit_code == ExitCode::interrupted);
  const std::size_t there = part.summary["points"].size();
  CHECK(there >= 3);  // another core may have ended one more
  CHECK(there < 8);
  // Killed while it wrote: the last line is cut.
  std::ofstream(parted / "points.jsonl", std::ios::app) << "{\"point\":7,\"row\":{\"frequ";

  std::vector<std::string> told;
  const auto rest = test::run(scene, {.stop = {},
                                      .progress = [&](double, std::string_view what) { told.emplace_back(what); },
                                      .folder = parted.path(),
                                      .resume = true});
  CHECK(told.front() == fmt::format("point {} of 8", there));
  CHECK(rest.summary["points"] == reference.summary["points"]);
  CHECK(rest.summary["fit"] == reference.summary["fit"]);
  CHECK(rest.summary["cost"]["section_evaluations"] == reference.summary["cost"]["section_evaluations"]);
  CHECK(results::read_file(parted / "points.jsonl") == results::read_file(whole / "points.jsonl"));
}

TEST_CASE("the points of another case are not taken up and a finished study computes anew") {
  const test::ScratchFolder folder;
  const auto first_word = [&](const casefile::Scene& scene, int points_until_stop) {
    StopAfter enough(points_until_stop);
    study::Hooks hooks = enough.hooks(folder.path());
    hooks.resume = true;
    std::string told;
    hooks.progress = [&, after = hooks.progress](double fraction, std::string_view what) {
      if (told.empty()) told = what;
      after(fraction, what);
    };
    test::run(scene, hooks);
    return told;
  };
  CHECK(first_word(damping_scene("return-map", small_grid), 3) == "point 0 of 8");
  CHECK(first_word(damping_scene("masing", small_grid), 2) == "point 0 of 8");
  const std::string resumed = first_word(damping_scene("masing", small_grid), 100);
  CHECK(resumed != "point 0 of 8");
  CHECK(resumed != "point 8 of 8");
  CHECK(first_word(damping_scene("masing", small_grid), 100) == "point 0 of 8");
}

TEST_CASE("a study that is stopped while it makes its tables tells that, and takes up the tables that were made") {
  const casefile::Scene scene = damping_scene("return-map", small_grid);
  const test::ScratchFolder folder, whole;
  const auto at_once = test::run(scene, {.stop = [] { return true; }, .progress = {}, .folder = folder.path()});
  CHECK(at_once.exit_code == ExitCode::interrupted);
  CHECK(at_once.summary["points"].size() == 0);
  const auto rest = test::run(scene, {.stop = {}, .progress = {}, .folder = folder.path(), .resume = true});
  const auto reference = test::run(scene, {.stop = {}, .progress = {}, .folder = whole.path()});
  CHECK(rest.exit_code == ExitCode::done);
  CHECK(rest.summary["points"] == reference.summary["points"]);
}

TEST_CASE("a point that fails is a row that says why") {
  const casefile::Scene scene = damping_scene("return-map", small_grid);
  class Failing final : public self_damping::Method {
    self_damping::PointResult at(const self_damping::Point&, const self_damping::Watch&) const override {
      throw ComputationError("no periodic state was found");
    }
    self_damping::Expected expected(const std::vector<self_damping::Point>&) const override { return {}; }
  };
  const auto row =
      self_damping::compute_row(scene, Failing(), {.frequency = 20, .antinode_amplitude = 0.01, .tension = 3e4}, {});
  REQUIRE(row);
  CHECK(row->failed == "no periodic state was found");
  CHECK(row->frequency == 20.0);
  CHECK_FALSE(row->has_numbers());
}

TEST_CASE("modes and velocities give the frequencies and amplitudes that they name") {
  const casefile::Scene scene = casefile::read_scene_text(
      "[conductor]\ncatalogue = \"curlew\"\n[section]\nlaw = \"return-map\"\n[span]\nlength_m = 30\n"
      "[analysis]\ntype = \"self-damping\"\nmode_shape = \"string\"\nmodes = [4, 12]\nantinode_velocity_m_per_s = "
      "[0.1, 0.2]\ntensions_kN = "
      "25\n",
      "test.toml");
  const auto points = self_damping::points_of(scene);
  REQUIRE(points.size() == 4);
  const double f12 = 12 * std::sqrt(25e3 / 1.981) / 60;  // n c/(2 L)
  check_close(points[3].frequency, f12, {.relative = 1e-12});
  check_close(points[3].antinode_amplitude, 0.2 / (2 * 3.14159265358979 * f12), {.relative = 1e-12});
  CHECK(points[3].mode == 12);
}

TEST_CASE("clamped ends add to what the span loses and the free span loses less than the string") {
  const std::string grid = "frequencies_Hz = 20\namplitude_over_diameter = 0.3\ntensions_rts = 0.2\n";
  const std::string span = "[span]\nlength_m = 30\n";
  const auto points = [&](const std::string& shape) {
    return summary_of(
        casefile::read_scene_text("[conductor]\ncatalogue = \"curlew\"\n[section]\nlaw = \"compliant\"\n" + span +
                                      "[analysis]\ntype = \"self-damping\"\n" + grid + shape,
                                  "test.toml"))["points"][0];
  };
  const ordered_json sine = points("");
  const ordered_json clamped = points("mode_shape = \"clamped\"\n");
  CHECK(clamped["self_damping_W_per_m"] > clamped["self_damping_free_span_W_per_m"]);
  CHECK(clamped["self_damping_free_span_W_per_m"] < sine["self_damping_free_span_W_per_m"]);
  CHECK(clamped["mode"] >= 3);
}

TEST_CASE("what a study lacks is named") {
  const auto message = [](const std::string& analysis) {
    return test::message_of<InputError>([&] { test::run(damping_scene("return-map", analysis)); });
  };
  CHECK(message("tensions_rts = 0.2\namplitude_over_diameter = 0.1\n").find("frequencies are missing") !=
        std::string::npos);
  CHECK(message("mode_shape = \"clamped\"\nfrequencies_Hz = 20\ntensions_rts = 0.2\n").find("amplitudes are missing") !=
        std::string::npos);
  CHECK(message("modes = 3\ntensions_rts = 0.2\namplitude_over_diameter = 0.1\n").find("span.length_m") !=
        std::string::npos);
  CHECK(message(small_grid + "[[analysis.energy_balance]]\nself_damping = \"published\"\nlaw = \"Noisy\"\n")
            .find("choose one of Claren & Diana") != std::string::npos);
}
