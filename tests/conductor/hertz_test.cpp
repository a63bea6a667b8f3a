#include "strandyn/conductor/hertz.hpp"

#include <cmath>
#include <numbers>

#include "conductor/strands.hpp"
#include "strandyn/conductor/contact.hpp"
#include "support/check_close.hpp"

using namespace strandyn::conductor;
using std::numbers::pi;
using strandyn::test::check_close;
using strandyn::test::curlew;
using strandyn::test::degrees;

namespace {

constexpr ContactBody aluminium{.radius = 1.76e-3, .young = 69e9, .poisson = 0.33};
constexpr ContactBody steel{.radius = 2e-3, .young = 200e9, .poisson = 0.3};

/// How often a wire of one layer passes over wires of the other in `length` of strand, counted one by one.
double crossings_counted(const Layer& outer, const Layer& inner, double length) {
  const double relative =
      std::tan(outer.lay_angle) / outer.helix_radius - std::tan(inner.lay_angle) / inner.helix_radius;
  int count = 0;
  double place = 0.5;  // of the outer wire between two inner ones, in parts of their spacing
  constexpr int steps = 1'000'000;
  for (int i = 0; i < steps; ++i) {
    place += std::abs(relative) * length / steps * inner.wires / (2 * pi);
    if (place >= 1) {
      place -= 1;
      ++count;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("hertz: wires that cross at a right angle touch like a ball and a plane, and Mindlin's stiffness is 8a/sum") {
  const SpotContact spot({steel, steel}, pi / 2);
  const double P = 30;
  const double modulus = steel.young / (2 * (1 - 0.3 * 0.3));
  const double a = std::cbrt(3 * P * steel.radius / (4 * modulus));
  check_close(spot.long_half_axis(P), a, {.relative = 1e-14});
  CHECK(spot.axis_ratio() == 1);
  check_close(spot.stiffness(P).value, 8 * a / (2 * 1.7 / steel.shear()), {.relative = 1e-14});
}

TEST_CASE("hertz: under a crossing angle the ellipse has the pressure's displacement, and slips as one piece") {
  // Integrals over the ellipse around its middle, in polar coordinates, summed up. Pressure p0 sqrt(1 - x^2/a^2 -
  // y^2/b^2) moves the surfaces by w0 - A x^2 - B y^2; a traction 1/sqrt(...) moves all points of the ellipse alike.
  const double phi = 26 * degrees;
  const double P = 30;
  const SpotContact spot({aluminium, steel}, phi);
  const double a = spot.long_half_axis(P);
  const double b = spot.axis_ratio() * a;
  constexpr int n = 20'000;
  double along = 0, across = 0, plain = 0, weighted = 0;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * pi * (i + 0.5) / n;
    const double c2 = std::pow(std::cos(angle), 2);
    const double g = c2 / (a * a) + (1 - c2) / (b * b);
    plain += 1 / std::sqrt(g) / n;
    weighted += c2 / std::sqrt(g) / n;
    // A chord through (x, y) carries pi p0/(2 sqrt(g)) (1 - x^2 sin^2/(a^2 b^2 g) - ...): half of it each way.
    along += (1 - c2) / (b * b) / (a * a) / std::pow(g, 1.5) / n;
    across += c2 / (a * a) / (b * b) / std::pow(g, 1.5) / n;
  }
  const double p0 = 3 * P / (2 * pi * a * b);
  const double modulus = 1 / ((1 - 0.33 * 0.33) / 69e9 + (1 - 0.3 * 0.3) / 200e9);
  const double r1 = aluminium.radius;
  const double r2 = steel.radius;
  const double A = p0 / modulus * pi / 2 * along;
  const double B = p0 / modulus * pi / 2 * across;
  const double sum = (1 / r1 + 1 / r2) / 2;
  const double difference = std::sqrt(1 / (r1 * r1) + 1 / (r2 * r2) + 2 * std::cos(2 * phi) / (r1 * r2)) / 2;
  check_close(A + B, sum, {.relative = 1e-9});
  check_close(B - A, difference, {.relative = 1e-9});
  double compliance = 0;
  for (const ContactBody& body : {aluminium, steel}) {
    compliance += ((1 - body.poisson) * plain + body.poisson * weighted) / (4 * body.shear() * a * b);
  }
  check_close(spot.stiffness(P).value, 1 / compliance, {.relative = 1e-9});
}

TEST_CASE("hertz: contact stiffness grows with the force as its slope says, and is zero where nothing presses") {
  const SpotContact spot({aluminium, steel}, 20 * degrees);
  const LineContact line({aluminium, steel});
  for (double force : {1e-3, 20.0, 5000.0}) {
    const double h = 1e-5 * force;
    // Central differences of this step are good for ten digits less the rounding of the difference.
    check_close((spot.stiffness(force + h).value - spot.stiffness(force - h).value) / (2 * h),
                spot.stiffness(force).slope, {.relative = 1e-8});
    check_close((line.stiffness(force + h).value - line.stiffness(force - h).value) / (2 * h),
                line.stiffness(force).slope, {.relative = 1e-8});
  }
  CHECK(spot.stiffness(0).value == 0);
  CHECK(spot.stiffness(0).slope == 0);
  CHECK(line.stiffness(0).value == 0);
  CHECK(line.stiffness(0).slope == 0);
}

TEST_CASE("hertz: a strip that sticks on a disc moves against its mean as the integral over the strip says") {
  // Traction 1/(pi sqrt(b^2 - s^2)) with the Neumann function of the disc: flat over the strip, and the closed form.
  const LineContact line({steel, steel});
  const double load = 4000;
  const double b = line.half_width(load);
  for (double place : {0.0, 0.37, -0.8}) {
    double mean = 0;
    constexpr int n = 2'000'000;
    for (int i = 0; i < n; ++i) {
      mean += std::log(steel.radius / (b * std::abs(place - std::cos(pi * (i + 0.5) / n)))) / n;
    }
    const double displacement = (mean + 1.0 / 4 - 1.0 / 8) / (pi * steel.shear());
    // The sum passes a logarithmic pole: log(n)/n of it is left.
    check_close(1 / line.stiffness(load).value, 2 * displacement, {.relative = 1e-5});
  }
}

TEST_CASE("hertz: the half width of a line is that of two cylinders") {
  // Johnson's (4.43) for two steel cylinders, written out: b^2 = 4 p R'/(pi E*), R' = r/2, E* = E/(2 (1 - nu^2)).
  const LineContact line({steel, steel});
  check_close(line.half_width(4000), std::sqrt(4 * 4000 * 1e-3 / (pi * 200e9 / (2 * 0.91))), {.relative = 1e-14});
  check_close(line.slip_logarithm(4000), std::log(2 * steel.radius / line.half_width(4000)) + 0.625,
              {.relative = 1e-14});
}

TEST_CASE("hertz: the crossings of Curlew's wires are those counted one by one, the same seen from both layers") {
  const Strand strand = curlew();
  const std::vector<Interface> faces = interfaces(strand);
  REQUIRE(faces.size() == 5);
  for (std::size_t j = 2; j < 5; ++j) {
    const Layer& outer = strand.layers[j];
    const Layer& inner = strand.layers[j - 1];
    CHECK_FALSE(faces[j].line);
    const double per_strand = faces[j].per_outer_wire / std::cos(outer.lay_angle);
    check_close(100 * per_strand, crossings_counted(outer, inner, 100), {.absolute = 1.01});
    check_close(outer.wires * per_strand, inner.wires * faces[j].per_inner_wire / std::cos(inner.lay_angle),
                {.relative = 1e-14});
  }
  // Opposite lays: the angle is about the sum of both, 14.2 and 11.7 degrees.
  check_close(faces[4].crossing_angle, 25.9 * degrees, {.relative = 0.01});
}

TEST_CASE("hertz: the innermost layer, and layers of equal lay length, touch along lines") {
  Strand strand = curlew();
  CHECK(interfaces(strand)[1].line);
  CHECK(interfaces(strand)[1].per_inner_wire == 0);
  // Layer 3 in parallel with layer 2: it lies in its grooves and crosses nothing.
  strand.layers[3].lay_angle =
      std::atan(std::tan(strand.layers[2].lay_angle) * strand.layers[3].helix_radius / strand.layers[2].helix_radius);
  const std::vector<Interface> faces = interfaces(strand);
  CHECK(faces[3].line);
  check_close(faces[3].per_inner_wire, 18.0 / 12, {.relative = 1e-15});
  CHECK_FALSE(faces[4].line);
  // Straight wires on straight wires as well.
  for (Layer& layer : strand.layers) layer.lay_angle = 0;
  for (std::size_t j = 1; j < 5; ++j) CHECK(interfaces(strand)[j].line);
}

TEST_CASE("hertz: stiffness per length of wire is that of its contacts, each with its part of the load") {
  const Interface face = interfaces(curlew())[4];
  const double load = 2200;
  const double share = face.per_outer_wire;
  check_close(face.stiffness(load, share).value, share * face.spot.stiffness(load / share).value, {.relative = 1e-15});
  CHECK(face.stiffness(load, 0).value == 0);
}
