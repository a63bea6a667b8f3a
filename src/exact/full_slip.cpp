#include "strandyn/exact/full_slip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strandyn/conductor/constants.hpp"
#include "strandyn/conductor/contact.hpp"
#include "strandyn/core/assert.hpp"

namespace strandyn::exact {
namespace {

constexpr double pi = std::numbers::pi;

// g(F_at + F_b) = max(m F_b + g_0, g_1) of one layer. [N/rad]
struct Gradient {
  double m = 0;
  double g_0 = 0;
  double g_1 = 0;
};

// What the quarter turns of a layer add up to.
struct Sums {
  double cos_g = 0;  // [N] integral of cos(theta) g dtheta
  double F_b = 0;    // [N rad] integral of F_b dtheta
};

// (e^z - 1)/z and (e^z - 1 - z)/z^2, also near zero.
double phi_1(double z) {
  return z == 0 ? 1 : std::expm1(z) / z;
}
double phi_2(double z) {
  if (std::abs(z) > 0.1) return (std::expm1(z) - z) / (z * z);
  double sum = 0;
  for (int k = 12; k >= 2; --k) sum = (1 + z * sum) / k;
  return sum;
}

// A piece of a quarter turn on which the gradient grows by `rate` per radian.
struct Piece {
  double begin = 0;
  double end = 0;
  double gradient = 0;  // at the beginning
  double rate = 0;
};

// Adds a piece; `F_b` goes from its beginning to its end, up (sign = 1) or down (-1).
void add(Sums& sums, double& F_b, double sign, const Piece& piece) {
  const double width = piece.end - piece.begin;
  const double z = piece.rate * width;
  const auto primitive = [&](double theta) { return piece.rate * std::cos(theta) + std::sin(theta); };
  sums.cos_g +=
      piece.gradient * (std::exp(z) * primitive(piece.end) - primitive(piece.begin)) / (1 + piece.rate * piece.rate);
  sums.F_b += F_b * width + sign * piece.gradient * width * width * phi_2(z);
  F_b += sign * piece.gradient * width * phi_1(z);
}

Sums closed_form(const Gradient& g) {
  Sums sums;
  double up = 0;
  if (g.g_0 >= g.g_1) {
    add(sums, up, 1, {.begin = 0, .end = pi / 2, .gradient = g.g_0, .rate = g.m});
  } else {  // the contact is open at the neutral plane and closes where the wire is pulled tight enough
    const double closes = g.g_1 > 0 ? std::min(pi / 2, (g.g_1 - g.g_0) / (g.m * g.g_1)) : pi / 2;
    add(sums, up, 1, {.begin = 0, .end = closes, .gradient = g.g_1, .rate = 0});
    add(sums, up, 1, {.begin = closes, .end = pi / 2, .gradient = g.g_1, .rate = g.m});
  }
  double down = 0;
  double opens = 0;
  if (g.g_0 > g.g_1) {
    opens = g.g_1 > 0 ? std::min(pi / 2, std::log(g.g_0 / g.g_1) / g.m) : pi / 2;
    add(sums, down, -1, {.begin = 0, .end = opens, .gradient = g.g_0, .rate = -g.m});
  }
  add(sums, down, -1, {.begin = opens, .end = pi / 2, .gradient = g.g_1, .rate = 0});
  return sums;
}

Sums midpoint_rule(const Gradient& g, int points) {
  Sums sums;
  const double cell = 2 * pi / points;
  STRANDYN_ASSERT(g.m * cell < 2, g.m * cell);
  for (const double sign : {1.0, -1.0}) {
    double F_b = 0;
    for (int i = 0; i < points / 4; ++i) {
      // The gradient at the middle of the cell, from the force there: F_b + sign gradient cell/2.
      const double gradient = std::max((g.m * F_b + g.g_0) / (1 - sign * g.m * cell / 2), g.g_1);
      sums.cos_g += std::cos((i + 0.5) * cell) * gradient * cell;
      sums.F_b += (F_b + sign * gradient * cell / 2) * cell;
      F_b += sign * gradient * cell;
    }
  }
  return sums;
}

// From the outermost layer inward; `sweep` maps a Gradient to the Sums of both quarter turns.
template <class Sweep>
FullSlip march(const conductor::Strand& strand, double tension, Sweep&& sweep) {
  const auto geometry = conductor::contact_geometry(strand);
  const auto constants = conductor::section_constants(strand);
  std::vector<double> wire_force = conductor::axial_wire_forces(strand, tension / constants.EA, 0);
  FullSlip result;
  result.layer_moment.assign(strand.layers.size(), 0.0);
  for (std::size_t j = strand.layers.size() - 1; j > 0; --j) {
    const conductor::Layer& layer = strand.layers[j];
    const conductor::ContactGeometry& at = geometry[j];
    // The layers outside have their average force by now, this one still has F_at.
    const conductor::ContactForces contact = conductor::contact_forces(strand, wire_force)[j];
    const double per_radian = layer.helix_radius / at.sin_lay;
    const double pressed = at.kappa * wire_force[j] + at.c_ext * contact.f_ext + at.c_int * at.residual;
    Gradient g;
    g.m = at.mu_int * at.sin_lay;
    g.g_1 = per_radian * at.mu_ext * at.c_ext * contact.f_ext;
    g.g_0 = per_radian * at.mu_int * pressed + g.g_1;
    const Sums sums = sweep(g);
    result.layer_moment[j] = layer.wires * layer.helix_radius * at.cos_lay * sums.cos_g / pi;
    result.M_inf += result.layer_moment[j];
    wire_force[j] += sums.F_b / pi;
  }
  const double EI_friction = constants.EI_max - constants.EI_min;
  result.chi_0 = EI_friction > 0 ? result.M_inf / EI_friction : 0;
  result.M_0 = constants.EI_max * result.chi_0;
  return result;
}

}  // namespace

FullSlip full_slip(const conductor::Strand& strand, double tension) {
  return march(strand, tension, closed_form);
}

FullSlip full_slip_at_points(const conductor::Strand& strand, double tension, int points) {
  STRANDYN_ASSERT(points > 0 && points % 4 == 0, points);
  return march(strand, tension, [points](const Gradient& g) { return midpoint_rule(g, points); });
}

}  // namespace strandyn::exact
