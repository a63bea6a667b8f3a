// The `modes` analysis: meshes that carry what is asked for, frequencies that are nearest, and their places.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "conductor/strands.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/exact/tensioned_beam.hpp"
#include "support/check_close.hpp"
#include "support/run.hpp"
#include "system/spans.hpp"

using namespace strandyn;
using strandyn::test::check_close;

namespace {

auto modes_near(double length, double frequency) {
  return test::run(casefile::read_scene_text(
                       fmt::format("[conductor]\ncatalogue = \"curlew\"\n[section]\nlaw = \"stick\"\n"
                                   "[span]\nlength_m = {}\ntension_rts = 0.2\n[analysis]\ntype = \"modes\"\n"
                                   "near_Hz = {}\ncount = 5\n",
                                   length, frequency),
                       "test.toml"))
      .summary;
}

}  // namespace

TEST_CASE(
    "modes near any frequency have the frequencies of a taut stiff string, within a thousandth, and its numbers") {
  const auto c = conductor::section_constants(test::curlew());
  for (double length : {10.0, 100.0, 1000.0}) {
    for (double frequency : {5.0, 20.0, 200.0}) {
      const auto summary = modes_near(length, frequency);
      for (const auto& mode : summary["modes"]) {
        if (mode["kind"] != "in-plane") continue;
        const int n = static_cast<int>(mode["half_waves"].get<double>());
        const double tension = 0.2 * 162.8e3;
        const double stretch = 1 + tension / c.EA;
        const exact::TensionedBeamMode exact{{.tension = tension,
                                              .EI = c.EI_max * stretch,
                                              .mass_per_length = test::curlew_mass / stretch,
                                              .length = length},
                                             exact::BeamEnds::clamped,
                                             n};
        check_close(mode["frequency_Hz"].get<double>(), exact.frequency(), {.relative = 1e-3},
                    fmt::format("{} m, {} Hz, {} half-waves", length, frequency, n));
      }
    }
  }
}

TEST_CASE("modes near 20 Hz of a 400 m span are numbered as what they are") {
  // By 2600 elements. A string without stiffness would have 123 half-waves at the first.
  const double expected[] = {19.7056, 19.8813, 20.0573, 20.2335, 20.4099};
  const auto modes = modes_near(400, 20)["modes"];
  REQUIRE(modes.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    check_close(modes[i]["frequency_Hz"].get<double>(), expected[i], {.relative = 1e-3});
    CHECK(modes[i]["half_waves"].get<int>() == 119 + static_cast<int>(i));
    // Nothing but vibration across the span lies below 20 Hz but one mode along it.
    CHECK(modes[i]["number"].get<int>() >= modes[i]["half_waves"].get<int>());
    CHECK(modes[i]["number"].get<int>() <= modes[i]["half_waves"].get<int>() + 3);
  }
}

TEST_CASE("modes near a frequency are those whose frequencies are nearest, not their squares") {
  const auto f = test::run(casefile::read_scene_text(
                               "[section]\nlaw = \"elastic\"\nEA_N = 4e7\nEI_N_m2 = 1000\nGJ_N_m2 = 500\n"
                               "mass_kg_per_m = 1.6\npolar_kg_m = 1e-4\n"
                               "[span]\nlength_m = 30\ntension_kN = 28\nelements = 60\ngrading = \"uniform\"\n"
                               "dimension = \"spatial\"\n[analysis]\ntype = \"modes\"\ncount = 10\nnear_Hz = 50\n",
                               "test.toml"))
                     .summary["frequencies_Hz"];
  // As all modes from the lowest up have them.
  const double expected[] = {45.367, 48.075, 50.831, 53.635, 56.491};
  REQUIRE(f.size() == 10);
  for (std::size_t i = 0; i < 10; ++i) check_close(f[i].get<double>(), expected[i / 2], {.relative = 1e-4});
}

TEST_CASE("modes of a span with a load and a body a rounding apart are those with both at one place") {
  const auto frequencies = [](const char* place_of_body) {
    return test::run(casefile::read_scene_text(
                         fmt::format("[conductor]\ncatalogue = \"curlew\"\n[section]\nlaw = \"stick\"\n"
                                     "[span]\nlength_m = 30\ntension_rts = 0.15\nelements = 80\n"
                                     "[[load]]\ntype = \"harmonic-force\"\nat_m = 3.333333\namplitude_N = 60\n"
                                     "frequency_Hz = 24.4\n[[body]]\nat_m = {}\nmass_kg = 0.2\n"
                                     "[analysis]\ntype = \"modes\"\ncount = 3\n",
                                     place_of_body),
                         "test.toml"))
        .summary["frequencies_Hz"];
  };
  const auto one = frequencies("3.333333");
  const auto near = frequencies("3.333334");
  const auto millimetre = frequencies("3.334333");
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(near[i] == one[i]);
    check_close(millimetre[i].get<double>(), one[i].get<double>(), {.relative = 1e-4});
  }
  check_close(one[0].get<double>(), 1.890715, {.relative = 1e-6});
}

namespace {

/// Asked whether to stop: says yes after so many times, and keeps the longest time of work between two askings.
struct Asked {
  int most = 0;
  int times = 0;
  double longest = 0;  // [s] of the processor
  std::clock_t last = std::clock();

  bool operator()() {
    const std::clock_t now = std::clock();
    longest = std::max(longest, static_cast<double>(now - last) / CLOCKS_PER_SEC);
    last = now;
    return ++times >= most;
  }
};

}  // namespace

TEST_CASE("modes and periodic points of a long span ask several times a second whether to stop and obey") {
  const std::string span =
      "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.5\n[span]\nlength_m = 400\ntension_rts = 0.2\n";
  for (const auto& [analysis, most] : {std::pair{"type = \"modes\"\nnear_Hz = 20\ncount = 40\n", 100},
                                       std::pair{"type = \"self-damping\"\nmethod = \"periodic\"\nfrequencies_Hz = 20\n"
                                                 "amplitude_over_diameter = 0.1\ntensions_rts = 0.2\n",
                                                 600}}) {
    Asked asked{.most = most};
    study::Hooks hooks;
    hooks.stop = [&] { return asked(); };
    const auto run = test::run(casefile::read_scene_text(span + "[analysis]\n" + analysis, "test.toml"), hooks);
    CHECK(run.exit_code == ExitCode::interrupted);
    CHECK(asked.times >= most);
    CHECK(asked.longest < 1);
  }
}
