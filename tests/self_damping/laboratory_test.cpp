// The wave of a free span, and what a fit over a grid says.
#include <doctest/doctest.h>

#include <cmath>
#include <ctime>
#include <numbers>

#include "strandyn/self_damping/grid_fit.hpp"
#include "strandyn/self_damping/mode_loss.hpp"
#include "study/self_damping_scene.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using namespace strandyn::self_damping;
using casefile::DampingMethod;
using std::numbers::pi;
using test::check_close;

namespace {

/// The quadrature of a scene of Curlew, ready for its points.
struct Ready {
  Ready(const std::string& law, const std::string& keys)
      : scene(test::damping_scene(law, keys)), points(points_of(scene)), quadrature(scene) {
    quadrature.begin(points);
  }
  double power(std::size_t i) const { return quadrature.at(points[i], {}).self_damping; }

  casefile::Scene scene;
  std::vector<Point> points;
  Quadrature quadrature;
};

const char* const laboratory =
    "frequencies_Hz = [10, 20, 40]\nantinode_velocity_m_per_s = [0.05, 0.1, 0.2]\ntensions_rts = [0.15, 0.2, 0.25]\n";

std::vector<PointRow> rows_of(const Ready& ready) {
  std::vector<PointRow> rows;
  for (const Point& point : ready.points) rows.push_back(*compute_row(ready.scene, ready.quadrature, point, {}));
  return rows;
}

}  // namespace

TEST_CASE(
    "free span: on a string every law without rate loses twice as much at twice the frequency and a quarter of A") {
  for (const char* law : {"masing", "return-map", "compliant"}) {
    const Ready ready(law,
                      "mode_shape = \"string\"\nfrequencies_Hz = [15, 30]\nantinode_amplitude_mm = [10, 40]\n"
                      "tensions_rts = 0.2\n");
    const double at = ready.power(1), scaled = ready.power(2);  // (15 Hz, 40 mm), (30 Hz, 10 mm)
    CHECK(at > 0);
    check_close(scaled, 2 * at, {.relative = 1e-9}, law);
  }
}

TEST_CASE("free span: on a string local exponents obey m = 2 l + 1") {
  // Neighbours half a per cent apart, the amplitudes by the square of the frequencies: both go through the same two
  // values of A f^2, and the identity holds to the rounding of P over 0.005.
  const Ready ready("compliant",
                    "mode_shape = \"string\"\nfrequencies_Hz = [20, 20.1]\nantinode_amplitude_mm = [3, 3.030075]\n"
                    "tensions_rts = 0.2\n");
  const double l = std::log(ready.power(1) / ready.power(0)) / std::log(1.010025);
  const double m = std::log(ready.power(2) / ready.power(0)) / std::log(20.1 / 20);
  CHECK(l > 2.9);
  check_close(m, 2 * l + 1, {.absolute = 1e-6});
}

TEST_CASE("free span: the wave has the stiffness that the law has at its antinode") {
  const Ready ready("compliant", laboratory);
  for (const Point& point : ready.points) {
    const Loop loop = ready.quadrature.loop_at(point);
    const double omega = 2 * pi * point.frequency;
    const double mass = *casefile::mass_per_length(ready.scene);
    const double k2 = loop.wavenumber * loop.wavenumber;
    check_close(loop.EI * k2 * k2 + point.tension * k2, mass * omega * omega, {.relative = 1e-12});
    check_close(loop.curvature, k2 * point.antinode_amplitude, {.relative = 1e-14});
    check_close(loop.EI, ready.quadrature.at_tension(point.tension).secant(loop.curvature), {.relative = 1e-12});
    CHECK(loop.EI < build::section_numbers(ready.scene).EI_max);
  }
}

TEST_CASE("free span: the tabulated secant is that of the law in fine steps") {
  const Ready ready("compliant", laboratory);
  const double tension = ready.points.front().tension;
  const build::SectionNumbers numbers = build::section_numbers(ready.scene);
  const auto law = build::build_law(ready.scene, section::Dimension::planar);
  const std::vector<double> amplitudes = {1e-4, 5e-4, 1.3e-3};
  section::Effort effort;
  const auto loops = closed_loops(*law, {.axial_strain = tension / numbers.EA, .EI_max = numbers.EI_max}, amplitudes,
                                  {.steps = 256}, effort);
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    check_close(ready.quadrature.at_tension(tension).secant(amplitudes[i]), loops[i].moment / amplitudes[i],
                {.relative = 1e-3});
  }
}

TEST_CASE("material: with sticking wires on a string l = 2, m = 5, n = 2") {
  const Ready ready("stick", std::string(laboratory) +
                                 "mode_shape = \"string\"\n[material]\nloss_factor_aluminium = 3e-4\n"
                                 "loss_factor_steel = 1e-4\n");
  const GridFits fits = fit_grids(ready.scene, rows_of(ready));
  REQUIRE(fits.by_velocity);
  CHECK_FALSE(fits.by_amplitude);
  check_close(*fits.by_velocity->self_damping.l, 2, {.absolute = 1e-3});
  check_close(*fits.by_velocity->self_damping.m, 5, {.absolute = 1e-3});
  check_close(*fits.by_velocity->self_damping.n, 2, {.absolute = 1e-3});
  CHECK_FALSE(fits.by_velocity->caveat);
}

TEST_CASE("grid: air has its own entry and its own fit, and is in no self-damping") {
  const Ready dry("compliant", laboratory);
  const Ready wet("compliant", std::string(laboratory) + "[air]\n");
  const std::vector<PointRow> without = rows_of(dry), with = rows_of(wet);
  for (std::size_t i = 0; i < with.size(); ++i) {
    CHECK(*with[i].self_damping == *without[i].self_damping);
    const double omega = 2 * pi * with[i].frequency;
    const double c = air::attached_flow({}, dry.scene.conductor->strand.outer_diameter(), with[i].frequency);
    check_close(*with[i].parts->air_free_span, c * std::pow(omega * with[i].antinode_amplitude, 2) / 4,
                {.relative = 1e-12});
  }
  const GridFits fits = fit_grids(wet.scene, with);
  REQUIRE(fits.by_velocity);
  REQUIRE(fits.by_velocity->dissipation);
  CHECK(*fits.by_velocity->dissipation->l < *fits.by_velocity->self_damping.l - 0.1);
  CHECK(fits.by_velocity->caveat);  // two powers are none
}

TEST_CASE(
    "grid: the fit of a study is of all that is lost, friction beside it, and the law of the balance has no air") {
  const Ready dry("compliant", laboratory);
  const Ready wet("compliant", std::string(laboratory) + "[air]\n");
  const Fits without = fit_points(dry.scene, rows_of(dry)), with = fit_points(wet.scene, rows_of(wet));
  CHECK_FALSE(without.friction);
  REQUIRE(with.friction);
  CHECK(*with.friction->l == *without.fit.l);
  CHECK(*with.fit.l < *without.fit.l - 0.1);
  CHECK(with.law->amplitude == *without.fit.l);
  CHECK(with.law->factor == without.law->factor);
}

TEST_CASE("grid: local exponents of one power are that power at every point, of velocities and of amplitudes") {
  for (const bool velocities : {true, false}) {
    std::vector<analysis::SelfDampingPoint> points;
    for (const double f : {10.0, 15.0, 30.0}) {
      for (const double a : {0.05, 0.1, 0.3}) {
        for (const double T : {20e3, 30e3}) {
          const double A = velocities ? a / (2 * pi * f) : a * 1e-2;
          points.push_back({.at = {.antinode_amplitude = A, .frequency = f, .tension = T},
                            .power = 3 * std::pow(A, 2.4) * std::pow(f, 5.6) / std::pow(T, 2.7)});
        }
      }
    }
    // A grid of velocities has no neighbours of equal amplitude, but for the points where they meet.
    for (const LocalExponents& local : local_exponents(points)) {
      REQUIRE(local.l);
      REQUIRE(local.m);
      REQUIRE(local.n);
      check_close(*local.l, 2.4, {.absolute = 1e-9});
      check_close(*local.m, 5.6, {.absolute = 1e-9});
      check_close(*local.n, 2.7, {.absolute = 1e-9});
    }
  }
}

TEST_CASE("grid: local exponents of forty thousand points are there before a stop would be late") {
  std::vector<analysis::SelfDampingPoint> points;
  for (int k = 0; k < 10000; ++k) {
    const double f = 10 + 0.005 * k;
    for (const double A : {1e-3, 2e-3}) {
      for (const double T : {20e3, 30e3}) {
        points.push_back({.at = {.antinode_amplitude = A, .frequency = f, .tension = T},
                          .power = std::pow(A, 2.4) * std::pow(f, 5.6) / std::pow(T, 2.7)});
      }
    }
  }
  const auto begin = std::clock();
  const std::vector<LocalExponents> found = local_exponents(points);
  CHECK(double(std::clock() - begin) / CLOCKS_PER_SEC < 1);  // each against each other: some ten seconds
  REQUIRE(found.size() == points.size());
  for (const std::size_t i : {std::size_t{0}, found.size() / 2, found.size() - 1}) {
    check_close(found[i].l.value(), 2.4, {.absolute = 1e-9});
    check_close(found[i].m.value(), 5.6, {.absolute = 1e-6});  // ln f of neighbours differs by 1e-4
    check_close(found[i].n.value(), 2.7, {.absolute = 1e-9});
  }
}

TEST_CASE("grid: points at which nothing slips are no neighbours of those that lose") {
  // The smallest amplitude loses nothing, whatever the frequency: the law of the others shows all the same.
  std::vector<analysis::SelfDampingPoint> points;
  for (const double f : {10.0, 15.0, 30.0}) {
    for (const double A : {1e-3, 2e-3, 5e-3}) {
      points.push_back({.at = {.antinode_amplitude = A, .frequency = f, .tension = 2e4},
                        .power = A < 1.5e-3 ? 0 : 3 * std::pow(A, 2.4) * std::pow(f, 5.6)});
    }
  }
  const std::vector<LocalExponents> found = local_exponents(points);
  CHECK(found.size() == 6);
  for (const LocalExponents& local : found) {
    REQUIRE(local.l);
    REQUIRE(local.m);
    check_close(*local.l, 2.4, {.absolute = 1e-9});
    check_close(*local.m, 5.6, {.absolute = 1e-9});
  }
}

TEST_CASE("grid: a loss just above first slip that is next to nothing has a finite exponent") {
  const std::vector<analysis::SelfDampingPoint> points = {
      {.at = {.antinode_amplitude = 1e-3, .frequency = 10, .tension = 2e4}, .power = 1e-310},
      {.at = {.antinode_amplitude = 2e-3, .frequency = 10, .tension = 2e4}, .power = 1e-2}};
  for (const LocalExponents& local : local_exponents(points)) {
    REQUIRE(local.l);
    check_close(*local.l, 308 * std::log2(10), {.relative = 1e-3});
  }
}

TEST_CASE("grid: velocities beyond the amplitude that is allowed give no point") {
  const Ready ready("stick",
                    "frequencies_Hz = [10, 50]\nantinode_velocity_m_per_s = [0.1, 1]\n"
                    "highest_amplitude_over_diameter = 0.3\ntensions_rts = 0.2\n");
  // 1 m/s at 10 Hz is an amplitude of 15.9 mm, half the diameter.
  CHECK(ready.points.size() == 3);
  const Ready standard("stick", "frequencies_Hz = [10, 50]\ntensions_rts = 0.2\n");
  CHECK(standard.points.size() == 10);  // the laboratories' velocities
  for (const Point& point : standard.points) {
    const double velocity = 2 * pi * point.frequency * point.antinode_amplitude;
    CHECK(velocity > 0.049);
    CHECK(velocity < 0.401);
  }
}

TEST_CASE("grid: what no laboratory runs is said with its number") {
  const Ready ready("stick", "frequencies_Hz = [20, 120]\nantinode_amplitude_mm = [2, 40]\ntensions_rts = 0.1\n");
  const std::vector<std::string> warnings = warnings_of_points(ready.scene, rows_of(ready));
  REQUIRE(warnings.size() == 3);
  CHECK(warnings[0].find("3 of 4 points have an antinode velocity above 1 m/s, up to 30.2") != std::string::npos);
  CHECK(warnings[1].find("2 of 4 points have an antinode amplitude above the diameter, up to 1.26") !=
        std::string::npos);
  CHECK(warnings[2].find("2 of 4 points have a wave shorter than 40 diameters, down to 23.8") != std::string::npos);
}

TEST_CASE("grid: where the air's flow is attached no more, the study says so, unless a drag stands for it") {
  const std::string wide = "frequencies_Hz = 20\nantinode_amplitude_mm = [2, 12]\ntensions_rts = 0.2\n";
  const auto warnings = [&](const std::string& air) {
    const Ready ready("stick", wide + air);
    return warnings_of_points(ready.scene, rows_of(ready));
  };
  CHECK(warnings("").size() == 1);  // 1.5 m/s
  CHECK(warnings("[air]\ndrag_per_K = 0.2\n").size() == 1);
  const std::vector<std::string> attached = warnings("[air]\n");
  REQUIRE(attached.size() == 2);
  // K = 2.38 at 12 mm; the limit at beta = 1338 is 0.99.
  CHECK(attached[1].find("1 of 2 points swing so wide") != std::string::npos);
  CHECK(attached[1].find("up to 2.41 times") != std::string::npos);
}

TEST_CASE("published: the common factor belongs to conductors of 30 mm, and says so of Hawk") {
  const auto warning_of = [](const std::string& name) {
    casefile::Scene scene = test::damping_scene("stick", laboratory, {"conductor.catalogue=" + name});
    return warning_of_common_factor(scene);
  };
  CHECK_FALSE(warning_of("curlew"));
  CHECK_FALSE(warning_of("drake"));
  const auto hawk = warning_of("hawk");
  REQUIRE(hawk);
  CHECK(hawk->find("42") != std::string::npos);
}
