#pragma once
/// \file Spans for tests of everything that moves: the laboratory span of the case file, and shorter ones.

#include <cmath>
#include <memory>
#include <random>

#include "conductor/strands.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/model/mesh.hpp"
#include "strandyn/model/model.hpp"
#include "strandyn/section/linear_law.hpp"
#include "strandyn/section/return_map.hpp"
#include "strandyn/section/spatial_return_map.hpp"
#include "strandyn/system/system.hpp"

namespace strandyn::test {

using LawPointer = std::shared_ptr<const section::Law>;

inline LawPointer linear_law(double EA, double EI) {
  return std::make_shared<section::LinearLaw>("elastic", section::Dimension::planar,
                                              section::LinearStiffness{.EA = EA, .GJ = 0, .C_AT = 0, .EI = EI});
}

/// Curlew with all wires sticking, or all slipping.
inline LawPointer stick_law() {
  const auto c = conductor::section_constants(curlew());
  return linear_law(c.EA, c.EI_max);
}
inline LawPointer slip_law() {
  const auto c = conductor::section_constants(curlew());
  return linear_law(c.EA, c.EI_min);
}
/// Curlew's laws for a chain of any freedom.
inline LawPointer stick_law(model::Freedom freedom) {
  if (!model::is_spatial(freedom)) return stick_law();
  const auto c = conductor::section_constants(curlew());
  return std::make_shared<section::LinearLaw>(
      "stick", section::Dimension::spatial,
      section::LinearStiffness{.EA = c.EA, .GJ = c.GJ, .C_AT = c.C_AT, .EI = c.EI_max});
}
inline LawPointer return_map() {
  return std::make_shared<section::PlanarReturnMap>(curlew(), 36);
}

inline LawPointer return_map(model::Freedom freedom) {
  if (!model::is_spatial(freedom)) return return_map();
  return std::make_shared<section::SpatialReturnMap>(curlew(), section::SpatialReturnMapOptions{.points = 36});
}

constexpr double curlew_mass = 1.981;              // [kg/m]
constexpr double curlew_tension = 0.15 * 162.8e3;  // [N]

struct SpanOptions {
  double length = 30;  // [m]
  std::size_t elements = 80;
  double tension = curlew_tension;  // [N]
  bool clamped = true;
  bool graded = true;
  model::MassMatrix mass = model::MassMatrix::lumped;
  double rotary = 0;  // [kg m]
  double drag = 0;    // [N s/m^2]
  model::Freedom freedom = model::Freedom::planar;
  section::MaterialBranches material = {};
};

/// A Curlew span between two clamps or pins, meshed as `grading = "clamps"` does.
inline model::Model curlew_span(LawPointer law, const SpanOptions& o = {}) {
  const auto c = conductor::section_constants(curlew());
  model::Model model;
  model.freedom = o.freedom;
  const auto nodes = model::span_mesh({.length = o.length,
                                       .elements = o.elements,
                                       .end_size = 0.5 * std::sqrt(c.EI_min / o.tension),
                                       .grade_left = o.graded,
                                       .grade_right = o.graded,
                                       .stations = {}});
  model::lay_out(model, {.positions = nodes, .strain = o.tension / c.EA});
  const std::array<bool, model::unknown_kinds> ends = {true, true, true, true, o.clamped, o.clamped};  // twist held
  model.supports = {{.node = 0, .fixed = ends}, {.node = o.elements, .fixed = ends}};
  model.law = std::move(law);
  model.inertia = {.mass = curlew_mass, .rotary = o.rotary, .polar = 2 * o.rotary};
  model.mass_matrix = o.mass;
  model.drag = o.drag;
  model.material = o.material;
  return model;
}

/// A cantilever along x, clamped at its left end, without tension.
inline model::Model cantilever(LawPointer law, double length, std::size_t elements) {
  model::Model model;
  model::lay_out(
      model, {.positions = model::span_mesh({.length = length, .elements = elements, .stations = {}}), .strain = 0});
  model.supports = {{.node = 0, .fixed = {true, true, true, true, true, true}}};
  model.law = std::move(law);
  model.inertia = {.mass = 1};
  return model;
}

inline system::Vector zeros(const model::Model& model) {
  return system::Vector::Zero(static_cast<Eigen::Index>(model.unknowns()));
}

/// Random numbers in the proportions of a vibrating span, sideways a thousand times more than along it; zero where the
/// unknown is held.
class RandomMotion {
 public:
  explicit RandomMotion(unsigned seed) : random_(seed) {}

  system::Vector operator()(const system::System& system, double size) {
    std::uniform_real_distribution<double> between(-size, size);
    system::Vector x(static_cast<Eigen::Index>(system.unknowns()));
    for (std::size_t i = 0; i < system.unknowns(); ++i) {
      const double number = between(random_) * (system.model().kind(i) == model::Unknown::x ? 1e-3 : 1);
      x(static_cast<Eigen::Index>(i)) = system.is_held(i) ? 0 : number;
    }
    return x;
  }

 private:
  std::mt19937 random_;
};

}  // namespace strandyn::test
