#include "strandyn/section/compliant.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "compliant_kernel.hpp"
#include "strandyn/conductor/contact.hpp"

namespace strandyn::section {

using enum Component;

namespace {

/// Phases for the angles of a quarter turn. An angle sees the amplitude times its cosine and loses with the cube of it:
/// the springs of all angles, seen from the amplitude, are spread evenly over the grading, each by its part in the
/// loss. The other half turn has them half a ratio further on.
std::vector<double> phases_of(const std::vector<double>& cosine, double ratio) {
  double total = 0;
  for (double c : cosine) total += c * c * c;
  std::vector<double> phases;
  double sum = 0;
  for (double c : cosine) {
    const double part = c * c * c / total;
    const double shifted = sum + part / 2 - std::log(c) / std::log(ratio);
    phases.push_back(shifted - std::floor(shifted));
    sum += part;
  }
  return phases;
}

/// The line contact's curve depends on its load by a logarithm: taken under the force of this strain, or a trace of
/// one.
constexpr double usual_strain = 1e-3;
constexpr double least_load = 1e-9;  // [N/m]

/// [-] Of a cell's gradient on its own limit: what lies beyond sticks anyway.
constexpr double largest_feedback = 0.9;

conductor::SlipCurve curve_of(const conductor::Interface& face, double load) {
  return face.line ? conductor::SlipCurve::line(face.along.slip_logarithm(std::max(load, least_load)))
                   : conductor::SlipCurve::spot();
}

}  // namespace

std::optional<std::string> find_fault(const CompliantOptions& o) {
  if (o.points < 4 || o.points % 4 != 0) return "points: a positive multiple of 4";
  if (o.springs < 4) return "springs: at least 4";
  if (!(o.smallest_slip >= 1e-6 && o.smallest_slip <= 0.03)) return "smallest_slip: from 1e-6 to 0.03";
  if (!(o.compliance_scale > 0)) return "compliance_scale: above 0; a rigid contact is the law return-map";
  return std::nullopt;
}

SpringTable::SpringTable(const std::array<conductor::SpringChain, 2>& sides)
    : springs_(sides[0].limit.size()), rows_((springs_ + 1) * row_length) {
  for (std::size_t side = 0; side < 2; ++side) {
    const auto at = [&](std::size_t spring, Column column) -> double& {
      return rows_[spring * row_length + 2 * column + side];
    };
    at(0, pull_below) = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < springs_; ++i) {
      at(i, kappa) = sides[side].stiffness[i];
      at(i, phi) = sides[side].limit[i];
      at(i, per_kappa) = 1 / at(i, kappa);
      at(i, per_phi) = 1 / at(i, phi);
      at(i + 1, pull_below) = std::min(at(i, pull_below), at(i, kappa) / at(i, phi));
      at(i + 1, phi_below) = at(i, phi_below) + at(i, phi);
    }
    for (std::size_t i = springs_; i-- > 0;) {
      at(i, kappa_from) = at(i + 1, kappa_from) + at(i, kappa);
      at(i, pull_from) = std::max(at(i + 1, pull_from), at(i, kappa) / at(i, phi));
    }
  }
}

CompliantCoefficients compliant_coefficients(const conductor::Strand& strand, const CompliantOptions& options) {
  if (strand.layers.size() > most_compliant_layers + 1) throw std::invalid_argument("compliant: too many layers");
  CompliantCoefficients c;
  c.planar = planar_coefficients(strand, options.points);
  c.springs = static_cast<std::size_t>(options.springs);
  c.compliance_scale = options.compliance_scale;
  const std::vector<conductor::Interface> faces = conductor::interfaces(strand);
  conductor::ChainPlan plan{.springs = options.springs, .smallest_slip = options.smallest_slip};
  std::vector<double> phases(c.planar.cosine.size(), 0.5);
  if (options.shifted_chains) phases = phases_of(c.planar.cosine, conductor::grading_ratio(plan));
  const std::vector<conductor::ContactForces> usual =
      conductor::contact_forces(strand, conductor::axial_wire_forces(strand, usual_strain, 0));

  for (std::size_t i = 0; i < c.planar.layers.size(); ++i) {
    const std::size_t j = strand.layers.size() - 1 - i;
    const conductor::Layer& wire = strand.layers[j];
    const PlanarCoefficients::Layer& p = c.planar.layers[i];
    const double turns = std::max(std::abs(std::sin(wire.lay_angle)), 1e-9) / wire.helix_radius;
    CompliantCoefficients::Layer layer;
    layer.k_w = wire.EA_wire() * turns * turns;
    layer.wires_per_length = wire.wires / std::cos(wire.lay_angle);
    layer.own_load = p.kappa * p.half_step;
    if (p.mu_int > 0) layer.own_load = std::min(layer.own_load, largest_feedback / p.mu_int);
    if (i > 0) {
      CompliantCoefficients::Layer& outside = c.layers.back();
      const bool crossed = (wire.lay_angle < 0) != (strand.layers[j + 1].lay_angle < 0);
      layer.load_of_outer = p.c_ext * p.next_layer_ratio * c.planar.layers[i - 1].inverse_c_int;
      layer.traction_of_outer = crossed ? layer.load_of_outer : -layer.load_of_outer;
      outside.slip_of_inner = layer.traction_of_outer * layer.wires_per_length / outside.wires_per_length;
    }
    layer.face = faces[j];
    const conductor::SlipCurve curve = curve_of(layer.face, usual[j].f_int);
    for (double phase : phases) {
      const double other = options.shifted_chains ? phase + 0.5 : phase;
      plan.phase = phase;
      conductor::ChainPlan of_other = plan;
      of_other.phase = other - std::floor(other);
      layer.chains.emplace_back(
          std::array{conductor::spring_chain(curve, plan), conductor::spring_chain(curve, of_other)});
    }
    c.layers.push_back(std::move(layer));
  }
  return c;
}

namespace compliant_kernel {

void contact_stiffness(const CompliantCoefficients& c, double strain, const StiffnessOut& out) {
  double f_int = 0;  // of the layer outside, and its derivative
  double f_int_slope = 0;
  for (std::size_t i = 0; i < c.layers.size(); ++i) {
    const PlanarCoefficients::Layer& p = c.planar.layers[i];
    const CompliantCoefficients::Layer& layer = c.layers[i];
    const double inner = p.kappa * p.force_per_strain * strain + layer.load_of_outer * f_int + p.inner_residual;
    const bool closed = inner > 0;
    f_int_slope = closed ? p.kappa * p.force_per_strain + layer.load_of_outer * f_int_slope : 0;
    f_int = std::max(0.0, inner);
    const conductor::Stiffness K = layer.face.stiffness(f_int, layer.face.per_outer_wire);
    out.value[i * block_lanes] = K.value / c.compliance_scale;
    if (out.slope) out.slope[i * block_lanes] = K.slope * f_int_slope / c.compliance_scale;
  }
}

History pressed_history(const CompliantCoefficients& c, const ContactLayout& layout, const Field& strains) {
  History history = kernel::blank_history(strains.points(), layout.rows_of_block);
  for (std::size_t i = 0; i < strains.points(); ++i) {
    double* at = history.data.data() + i / block_lanes * layout.rows_of_block * block_lanes + i % block_lanes;
    at[layout.peak_strain * block_lanes] = strains[axial][i];
    contact_stiffness(c, strains[axial][i], {.value = at + layout.stiffness * block_lanes});
  }
  return history;
}

}  // namespace compliant_kernel

History CompliantLaw::start(const Field& strains) const {
  using namespace compliant_kernel;
  History history = pressed_history(
      c_, {.rows_of_block = rows_of_block(c_), .peak_strain = peak_strain, .stiffness = stiffness}, strains);
  // A strand that is brought straight to a curvature slips on the way; that is part of getting there, not of a step.
  StepEnergy ignored(strains.points());
  commit(history, strains, ignored);
  return history;
}

Effort CompliantLaw::respond(const History& history, const Field& strains, Field& stresses,
                             TangentField* tangents) const {
  compliant_kernel::respond(c_, history.data.data(), kernel::planar_view(strains),
                            kernel::planar_view(stresses, tangents, c_.planar.EA));
  return {.evaluations = strains.points(), .sweeps = strains.points()};
}

Effort CompliantLaw::commit(History& history, const Field& strains, StepEnergy& energy) const {
  compliant_kernel::commit(c_, history.data.data(), kernel::planar_view(strains), kernel::view(energy));
  return {.evaluations = strains.points(), .sweeps = strains.points()};
}

}  // namespace strandyn::section
