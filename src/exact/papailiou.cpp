#include "strandyn/exact/papailiou.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "strandyn/conductor/constants.hpp"
#include "strandyn/conductor/contact.hpp"
#include "strandyn/core/assert.hpp"

namespace strandyn::exact {
namespace {

// A wire nearer to the neutral plane than this is on it: it carries no bending force and never slips.
constexpr double on_neutral_plane = 1e-12;

}  // namespace

PapailiouLayer::PapailiouLayer(const conductor::Strand& strand, double tension) {
  if (strand.layers.size() != 2) throw std::invalid_argument("Papailiou's closed form is for a core and one layer");
  const conductor::Layer& layer = strand.layers[1];
  const conductor::ContactGeometry at = conductor::contact_geometry(strand)[1];
  if (at.residual != 0) throw std::invalid_argument("Papailiou's closed form is for a layer without residual force");
  const conductor::SectionConstants constants = conductor::section_constants(strand);
  wires_ = layer.wires;
  F_0_ = conductor::axial_wire_forces(strand, tension / constants.EA, 0)[1];
  m_ = at.mu_int * at.sin_lay;
  stick_slope_ = layer.EA_wire() * at.cos_lay * at.cos_lay * layer.helix_radius;
  arm_ = at.cos_lay * layer.helix_radius;
  EI_min_ = constants.EI_min;
}

double PapailiouLayer::first_slip() const {
  return m_ * F_0_ / stick_slope_;
}

double PapailiouLayer::limit_force(double theta) const {
  return F_0_ * std::expm1(m_ * theta);
}

double PapailiouLayer::slip_curvature(double theta) const {
  if (std::abs(theta) < on_neutral_plane) return first_slip();
  return limit_force(theta) / (stick_slope_ * std::sin(theta));
}

double PapailiouLayer::bending_force(double theta, double chi) const {
  STRANDYN_ASSERT(chi >= 0, chi);
  return chi < slip_curvature(theta) ? stick_slope_ * std::sin(theta) * chi : limit_force(theta);
}

// Both halves of the turn behave alike: each wire's place is folded to -pi/2 .. pi/2.
std::vector<double> PapailiouLayer::places(double theta_first) const {
  std::vector<double> folded;
  for (int i = 0; i < wires_; ++i)
    folded.push_back(std::asin(std::sin(theta_first + 2 * std::numbers::pi * i / wires_)));
  return folded;
}

double PapailiouLayer::moment(double theta_first, double chi) const {
  double sum = 0;
  for (const double theta : places(theta_first)) sum += bending_force(theta, chi) * std::sin(theta);
  return EI_min_ * chi + arm_ * sum;
}

std::vector<double> PapailiouLayer::kinks(double theta_first) const {
  std::vector<double> curvatures;
  for (const double theta : places(theta_first)) {
    if (std::abs(theta) >= on_neutral_plane) curvatures.push_back(slip_curvature(theta));
  }
  std::sort(curvatures.begin(), curvatures.end());
  return curvatures;
}

}  // namespace strandyn::exact
