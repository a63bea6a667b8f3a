#include "strandyn/section/material_damping.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strandyn/conductor/constants.hpp"

namespace strandyn::section {

using std::numbers::pi;

namespace {

constexpr int loss_branches = 6;
constexpr double distance = 1.5;                                 // in ln tau
constexpr double lowest_frequency = 1, highest_frequency = 200;  // [Hz]

/// `loss`: sum of eta K over what has this loss.
void add_constant_loss(const ComponentStiffness& loss, MaterialBranches& branches) {
  if (std::ranges::all_of(loss, [](double x) { return x == 0; })) return;
  const double beyond = 1 / (1 - std::exp(-distance));
  const double middle = 2 * pi * std::sqrt(lowest_frequency * highest_frequency);  // [rad/s]
  for (int b = 0; b < loss_branches; ++b) {
    const double place = (b - (loss_branches - 1) / 2.0) * distance;
    const bool outermost = b == 0 || b == loss_branches - 1;
    MaterialBranch branch{.relaxation_time = std::exp(place) / middle};
    for (std::size_t c = 0; c < component_count; ++c) {
      branch.stiffness[c] = 2 / pi * distance * loss[c] * (outermost ? beyond : 1);
    }
    branches.push_back(branch);
  }
}

/// Like layers share a branch.
void add_heat_flow(double tau, double strength, MaterialBranches& branches) {
  for (MaterialBranch& branch : branches) {
    if (branch.relaxation_time != tau) continue;
    for (Component c : {Component::bending2, Component::bending3}) {
      branch.stiffness[static_cast<std::size_t>(c)] += strength;
    }
    return;
  }
  branches.push_back({.relaxation_time = tau, .stiffness = {0, 0, strength, strength}});
}

conductor::SectionConstants constants_of(const conductor::Layer& layer) {
  return conductor::section_constants({.name = {}, .layers = {layer}});
}

/// (1 - exp(-x))/x.
double mean_decay(double x) {
  return x == 0 ? 1 : -std::expm1(-x) / x;
}

/// (x - 2 tanh(x/2))/x^2, without cancellation where x is small.
double ramp_loss(double x) {
  if (x > 0.1) return (x - 2 * std::tanh(x / 2)) / (x * x);
  const double square = x * x;
  return x * (1.0 / 12 - square * (1.0 / 120 - square * 17 / 20160));
}

}  // namespace

MaterialLoss material_loss(const conductor::Strand& strand, const std::vector<Metal>& metals, double temperature,
                           Wires wires) {
  MaterialLoss loss;
  for (std::size_t j = 0; j < strand.layers.size(); ++j) {
    const conductor::Layer& layer = strand.layers[j];
    const Metal& metal = metals[j];
    const conductor::SectionConstants c = constants_of(layer);
    const double EI = wires == Wires::sticking ? c.EI_max : c.EI_min;
    const ComponentStiffness stiffness = {c.EA, c.GJ, EI, EI};
    for (std::size_t k = 0; k < component_count; ++k) loss.constant[k] += metal.loss_factor * stiffness[k];
    if (metal.thermal_strain == 0) continue;
    const double strength =
        layer.young * metal.thermal_strain * metal.thermal_strain * temperature / metal.heat_capacity;
    add_heat_flow(layer.diameter * layer.diameter / (13.55 * metal.diffusivity), strength * c.EI_min, loss.heat);
  }
  return loss;
}

MaterialLoss material_loss(const ComponentStiffness& stiffness, double loss_factor) {
  MaterialLoss loss{.constant = stiffness, .heat = {}};
  for (double& x : loss.constant) x *= loss_factor;
  return loss;
}

double loss_at(const MaterialLoss& loss, Component component, double omega) {
  return loss.constant[static_cast<std::size_t>(component)] + stiffness_at(loss.heat, component, omega).loss;
}

MaterialBranches branches_of(const MaterialLoss& loss) {
  MaterialBranches branches;
  add_constant_loss(loss.constant, branches);
  branches.insert(branches.end(), loss.heat.begin(), loss.heat.end());
  return branches;
}

ComplexStiffness stiffness_at(const MaterialBranches& branches, Component component, double omega) {
  ComplexStiffness sum;
  for (const MaterialBranch& branch : branches) {
    const double x = omega * branch.relaxation_time;
    const double part = branch.stiffness[static_cast<std::size_t>(component)] * x / (1 + x * x);
    sum.storage += part * x;
    sum.loss += part;
  }
  return sum;
}

MaterialMemory::MaterialMemory(MaterialBranches branches, Dimension dimension, std::size_t points)
    : branches_(std::move(branches)), forces_(branches_.size(), Field(dimension, points)) {
  if (branches_.empty()) return;
  stored_.assign(padded(points), 0.0);
  dissipated_ = quadrature_error_ = stored_;
}

void MaterialMemory::relax() {
  for (Field& forces : forces_) {
    for (std::size_t c = 0; c < component_count; ++c) {
      std::fill(forces[Component{c}].begin(), forces[Component{c}].end(), 0.0);
    }
  }
  for (AlignedVector* energy : {&stored_, &dissipated_, &quadrature_error_}) {
    std::fill(energy->begin(), energy->end(), 0.0);
  }
}

void MaterialMemory::respond(const Field& before, const Field& strains, double step, Field& stresses,
                             TangentField* tangents) const {
  for (std::size_t b = 0; b < branches_.size(); ++b) {
    const double x = step / branches_[b].relaxation_time;
    const double decay = std::exp(-x);
    const double mean = mean_decay(x);
    for (std::size_t c = 0; c < component_count; ++c) {
      const double stiffness = mean * branches_[b].stiffness[c];
      const Component component{c};
      const AlignedVector& force = forces_[b][component];
      if (branches_[b].stiffness[c] == 0) continue;
      for (std::size_t p = 0; p < force.size(); ++p) {
        stresses[component][p] += decay * force[p] + stiffness * (strains[component][p] - before[component][p]);
      }
      if (!tangents) continue;
      for (std::size_t p = 0; p < force.size(); ++p) (*tangents)(component, component)[p] += stiffness;
    }
  }
}

void MaterialMemory::commit(const Field& before, const Field& strains, double step) {
  if (branches_.empty()) return;
  for (AlignedVector* energy : {&stored_, &dissipated_, &quadrature_error_}) {
    std::fill(energy->begin(), energy->end(), 0.0);
  }
  for (std::size_t b = 0; b < branches_.size(); ++b) {
    const double x = step / branches_[b].relaxation_time;
    const double decay = std::exp(-x);
    const double mean = mean_decay(x);
    // The loss as a sum of two squares: of the force as it would decay from what it was, and of the ramp.
    const double half = x == 0 ? 0.5 : std::tanh(x / 2) / x;
    const double square = x * mean_decay(2 * x);
    const double ramp = ramp_loss(x);
    for (std::size_t c = 0; c < component_count; ++c) {
      const double E = branches_[b].stiffness[c];
      if (E == 0) continue;
      const Component component{c};
      AlignedVector& force = forces_[b][component];
      for (std::size_t p = 0; p < force.size(); ++p) {
        const double de = strains[component][p] - before[component][p];
        const double from = force[p];
        const double to = decay * from + E * mean * de;
        force[p] = to;
        stored_[p] += to * to / (2 * E);
        const double mixed = from + E * half * de;
        const double lost = square * mixed * mixed / E + ramp * E * de * de;
        const double work = (from + to) / 2 * de;
        dissipated_[p] += lost;
        quadrature_error_[p] += lost + (to * to - from * from) / (2 * E) - work;
      }
    }
  }
}

}  // namespace strandyn::section
