// The method "periodic" of a self-damping study, and the sweep.
#include <doctest/doctest.h>

#include <cmath>

#include "results/scratch_folder.hpp"
#include "strandyn/casefile/read.hpp"
#include "support/check_close.hpp"
#include "support/run.hpp"

using namespace strandyn;
using nlohmann::ordered_json;
using test::check_close;

namespace {

/// Six metres of Curlew in the fourth mode: short, so that it is quick.
std::string span_and(const std::string& rest, const std::string& law = "return-map") {
  return "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.5\n[section]\nlaw = \"" + law +
         "\"\n[span]\nlength_m = 6\nelements = 32\nmass = \"consistent\"\n" + rest;
}

const std::string study_of = "[analysis]\ntype = \"self-damping\"\nmethod = \"periodic\"\nmode_shape = \"clamped\"\n";

ordered_json summary_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return test::run(casefile::read_scene_text(text, "test.toml", overrides)).summary;
}

/// Off by no more than its own size times this.
double share(const ordered_json& a, const ordered_json& b) {
  return std::abs(a.get<double>() / b.get<double>() - 1);
}

}  // namespace

TEST_CASE("the free span of a periodic vibration loses what the quadrature over its mode says") {
  const ordered_json s =
      summary_of(span_and(study_of + "modes = 4\nantinode_amplitude_mm = 1\ntensions_rts = 0.2\n"
                                     "[[analysis.at]]\nmode = 4\nantinode_amplitude_mm = 1\ntension_rts = 0.2\n"
                                     "method = \"quadrature\"\n",
                          "compliant"));
  REQUIRE(s["comparisons"].size() == 1);
  const ordered_json& comparison = s["comparisons"][0];
  CHECK(comparison["reference"] == "periodic");
  check_close(comparison["free_span_ratio"], 1.0, {.absolute = 0.05});  // the band
  // The parts are factors of the ratio.
  double product = 1;
  for (const auto& part : comparison["parts"]) product *= part.get<double>();
  check_close(product, comparison["free_span_ratio"], {.relative = 1e-12});
}

TEST_CASE("a wave is compared at the resonance of the span: what is left of the difference is not its frequency") {
  const ordered_json s =
      summary_of(span_and("[analysis]\ntype = \"self-damping\"\nfrequencies_Hz = 40\nantinode_amplitude_mm = 1\n"
                          "tensions_rts = 0.2\n[[analysis.at]]\nfrequency_Hz = 40\nantinode_amplitude_mm = 1\n"
                          "tension_rts = 0.2\nmethod = \"periodic\"\n",
                          "compliant"));
  REQUIRE(s["comparisons"].size() == 1);
  const ordered_json& comparison = s["comparisons"][0];
  const double asked = comparison["free_span_ratio"], at_resonance = comparison["free_span_ratio_at_resonance"];
  check_close(asked, at_resonance * comparison["parts"]["frequency"].get<double>(), {.relative = 1e-12});
  CHECK(std::abs(at_resonance - 1) < 0.05);  // the band of the comparison
  // The power of a wave goes with more than the sixth power of its frequency: a per cent of it is not a per cent of
  // loss.
  const double sharp = s["points"][1]["resonance_Hz"].get<double>() / 40;
  CHECK(asked > std::pow(sharp, -5));
}

TEST_CASE("the antinode reaches the amplitude that was asked for and the drive gives what is lost") {
  const ordered_json row = summary_of(
      span_and(study_of + "frequencies_Hz = 40\nantinode_amplitude_mm = 3\ntensions_rts = 0.2\n"))["points"][0];
  check_close(row["reached_amplitude_m"], 3e-3, {.relative = 1e-5});  // where the search ends
  CHECK(row["self_damping_W_per_m"] > 0.0);
  CHECK(std::abs(row["imbalance"].get<double>()) < 1e-7);
  check_close(row["self_damping_W_per_m"].get<double>() * row["span_length_m"].get<double>(), row["drive_power_W"],
              {.relative = 1e-7});
  // The span is as long as its mode wants it: 40 Hz but for the mesh and the stretch of the unstressed mass.
  check_close(row["sticking_frequency_Hz"], 40.0, {.relative = 2e-3});
}

TEST_CASE("below first slip friction is exactly zero and modal damping is found as it was given") {
  const ordered_json row =
      summary_of(span_and("[damping]\nmodal = [[4, 1e-3]]\n" + study_of +
                          "modes = 4\nantinode_amplitude_mm = 0.02\ntensions_rts = 0.2\n"))["points"][0];
  CHECK(row["friction_W_per_m"] == 0.0);
  CHECK(row["self_damping_free_span_W_per_m"] == 0.0);
  CHECK(row["viscous_W_per_m"] > 0.0);
  // loss factor = 2 zeta of a sine; the clamps make the mode no sine: measured 2 %.
  check_close(row["loss_factor"], 2e-3, {.relative = 0.05});
}

TEST_CASE("below first slip a vibration however small has an answer until rounding drowns it and it says so") {
  const auto point = [](const char* amplitude_over_diameter) {
    return summary_of(span_and(study_of + "modes = 4\namplitude_over_diameter = " + amplitude_over_diameter +
                               "\ntensions_rts = 0.2\n"))["points"][0];
  };
  for (const char* small : {"1e-4", "1e-7", "1e-9"}) {
    const ordered_json row = point(small);
    CHECK(!row.contains("failed"));
    CHECK(row["self_damping_W_per_m"] == 0.0);
  }
  const std::string failed = point("1e-13")["failed"];
  CHECK(failed.find("the amplitude drowns in the rounding of coordinates") != std::string::npos);
}

TEST_CASE("in gross slip a point with many harmonics is found though the third lies near a mode of its own") {
  const std::string point = study_of + "modes = 4\nantinode_amplitude_mm = 6\ntensions_rts = 0.2\n";
  const ordered_json s = summary_of(span_and(point), {"analysis.periodic.harmonics=9"});
  REQUIRE(s["points"].size() == 1);
  const ordered_json& row = s["points"][0];
  REQUIRE(row.contains("self_damping_W_per_m"));
  CHECK(row["harmonics"] == 9);
  check_close(row["reached_amplitude_m"], 6e-3, {.relative = 1e-5});
  CHECK(std::abs(row["imbalance"].get<double>()) < 1e-6);
  // It took 16.9 million when every attempt began at the mode, with all its harmonics.
  CHECK(row["section_evaluations"] < 3e6);
}

TEST_CASE("a force and a moving support lead the same span to the same loss") {
  const std::string point = study_of + "modes = 4\nantinode_amplitude_mm = 3\ntensions_rts = 0.2\n";
  const std::string push = "[[load]]\ntype = \"harmonic-force\"\nat_m = 0.375\namplitude_N = 1\nfrequency_Hz = 1\n";
  const ordered_json pushed = summary_of(span_and(push + point))["points"][0];
  const ordered_json moved = summary_of(
      span_and("[[motion]]\ntype = \"harmonic-motion\"\nat = \"left\"\namplitude_mm = 1\nfrequency_Hz = 1\n" +
               point))["points"][0];
  REQUIRE(moved.contains("drive_motion_m"));
  CHECK(moved["drive_motion_m"] > 0.0);
  // The free span does not know what shakes it, but for the field near the force, a quarter into the first loop, and
  // for antinodes that are not all alike: measured 3.6 %, and 8.3 % with the force in the middle of the loop.
  CHECK(share(moved["self_damping_free_span_W_per_m"], pushed["self_damping_free_span_W_per_m"]) < 0.05);
}

TEST_CASE("a periodic point is its own whatever other points there are") {
  const auto points = [](const std::string& amplitudes) {
    return summary_of(
        span_and(study_of + "modes = 4\nantinode_amplitude_mm = " + amplitudes + "\ntensions_rts = 0.2\n"))["points"];
  };
  CHECK(points("[1, 2]")[1] == points("[2, 0.5]")[0]);
}

TEST_CASE("what a periodic response cannot have for a drive is refused") {
  const auto message = [](const std::string& rest) {
    return test::message_of<InputError>(
        [&] { summary_of(span_and(rest + study_of + "modes = 4\nantinode_amplitude_mm = 1\ntensions_rts = 0.2\n")); });
  };
  const std::string force = "[[load]]\ntype = \"harmonic-force\"\namplitude_N = 1\nfrequency_Hz = 1\n";
  CHECK(message(force + "per_length = true\n").find("acts on the whole span") != std::string::npos);
  CHECK(message(force + "at_m = 1\n" + force + "at_m = 2\n").find("is a second shaker") != std::string::npos);
  CHECK(message(force + "at_m = 0\n").find("a support holds this point") != std::string::npos);
  CHECK(message(force + "at_m = 1\ndirection = [1, 0, 0]\n").find("does not act along y") != std::string::npos);
}

TEST_CASE("a sweep goes through the resonance of the same amplitude that asks for the same force") {
  const ordered_json s = summary_of(span_and(
      "tension_rts = 0.2\n[[load]]\ntype = \"harmonic-force\"\nat_m = 0.4\namplitude_N = 8\nfrequency = \"mode 4\"\n"
      "[analysis]\ntype = \"sweep\"\nrelative_width = 0.03\nbackbone_points = 2\n"));
  REQUIRE(s["peak"]["inside"] == true);
  const ordered_json& top = s["backbone"].back();
  check_close(top["drive"], 8.0, {.relative = 0.01});  // chords of a tenth of the response near the crest
  check_close(top["frequency_Hz"], s["resonance"]["frequency_Hz"], {.relative = 1e-4});
  check_close(top["dissipated_power_W"], s["resonance"]["dissipated_power_W"], {.relative = 0.02});
  for (const auto& point : s["sweep"]) {
    // A point at which slip has hardly begun loses less than what the solver's residual leaves of the drive's power.
    const double unnoticed = 1e-9 * s["resonance"]["dissipated_power_W"].get<double>();
    check_close(point["drive_power_W"], point["dissipated_power_W"], {.relative = 1e-6, .absolute = unnoticed});
  }
}

TEST_CASE("a sweep that is stopped keeps its points") {
  int heard = 0;
  const test::Run result =
      test::run(casefile::read_scene_text(
                    span_and("tension_rts = 0.2\n[[load]]\ntype = \"harmonic-force\"\nat_m = 0.4\namplitude_N = 2\n"
                             "frequency = \"mode 4\"\n[analysis]\ntype = \"sweep\"\n"),
                    "test.toml"),
                {.stop = [&] { return heard >= 4; }, .progress = [&](double, std::string_view) { ++heard; }});
  CHECK(result.exit_code == ExitCode::interrupted);
  CHECK(result.summary["sweep"].size() == 4);
  CHECK_FALSE(result.summary.contains("backbone"));
}

TEST_CASE("the wave of a free span at the resonance of a shaken span loses what that span's free part loses" *
          doctest::test_suite("slow")) {
  // The points of cases/self_damping/curlew_periodic.toml: where slip bends the loop out of a sine, at 32 Hz and A/D
  // 0.12, five per cent, everywhere else one and a half.
  const std::string head =
      "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.5\n[section]\nlaw = \"compliant\"\n"
      "[span]\nlength_m = 20\nelements = 70\nmass = \"consistent\"\n[analysis]\n"
      "type = \"self-damping\"\ntensions_rts = 0.2\n";
  const ordered_json shaken = summary_of(head +
                                         "method = \"periodic\"\nfrequencies_Hz = [12, 20, 32]\n"
                                         "amplitude_over_diameter = [0.03, 0.06, 0.12]\n"
                                         "periodic = { samples = 128 }\n")["points"];  // 64 lose one per cent
  REQUIRE(shaken.size() == 9);
  for (const ordered_json& point : shaken) {
    const double frequency = point["frequency_Hz"], amplitude = point["antinode_amplitude_m"];
    const ordered_json wave =
        summary_of(head + fmt::format("frequencies_Hz = {:.12g}\nantinode_amplitude_mm = {:.12g}\n",
                                      point["resonance_Hz"].get<double>(), 1e3 * amplitude))["points"][0];
    const bool widest = frequency > 30 && point["amplitude_over_diameter"] > 0.1;
    check_close(wave["self_damping_free_span_W_per_m"], point["self_damping_free_span_W_per_m"],
                {.relative = widest ? 0.05 : 0.015}, fmt::format("{} Hz, {} m", frequency, amplitude));
  }
}
