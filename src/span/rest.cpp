#include "strandyn/span/rest.hpp"

#include <algorithm>
#include <cmath>

#include "strandyn/solver/static/equilibrium.hpp"

namespace strandyn::span {

using system::Vector;

SpanAtRest::SpanAtRest(build::BuiltSpan built_span)
    : built(std::move(built_span)), system(built.model), u(system.make_vector()) {
  if (built.hanging.size() > 0) {
    u = solver::find_rest(system, {.guess = built.hanging, .straight = built.straight});
  } else {
    system.begin(u);
  }
}

void SpanAtRest::apply_static_loads() {
  solver::find_equilibrium(system, u, {});
}

namespace {

Components components(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// [N], [N m] internal less external forces: what the supports do where the chain is in balance.
Vector unbalanced(const SpanAtRest& span, double load_factor) {
  Vector force = span.system.make_vector();
  span.system.residual({.u = span.u.data()}, {.time = 0, .part = load_factor}, force.data());
  return force;
}

/// [m] greatest vertical distance below the chord between the supports, at a node.
double sag(const model::Model& model, const Vector& u) {
  const Eigen::Vector3d left = model.nodes.front() + model.displacement(u.data(), 0);
  const Eigen::Vector3d right = model.nodes.back() + model.displacement(u.data(), model.nodes.size() - 1);
  double sag = 0;
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    const Eigen::Vector3d at = model.nodes[node] + model.displacement(u.data(), node);
    const double part = (at.x() - left.x()) / (right.x() - left.x());
    sag = std::max(sag, left.y() + part * (right.y() - left.y()) - at.y());
  }
  return sag;
}

/// [m] greatest distance along z from the plane of the supports; nothing where none leaves it.
std::optional<double> swing(const model::Model& model, const Vector& u) {
  double swing = 0;
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    swing = std::max(swing, std::abs(model.displacement(u.data(), node).z()));
  }
  return swing > 1e-9 * model.unstressed_length() ? std::optional(swing) : std::nullopt;
}

}  // namespace

std::optional<Rest> rest_of(const SpanAtRest& span) {
  if (span.built.hanging.size() == 0) return std::nullopt;
  const model::Model& model = span.built.model;
  Rest rest{.unstressed_length = model.unstressed_length()};
  if (!span.built.catenary_sag) return rest;
  const Vector force = unbalanced(span, 0);
  rest.sag = sag(model, span.u);
  rest.swing = swing(model, span.u);
  rest.horizontal_tension = model.displacement(force.data(), model.nodes.size() - 1).x();
  // A line hangs in as many catenaries as it has spans: the largest sag and the tension at its right end are its own.
  if (model.supports.size() > 2) return rest;
  rest.catenary_sag = span.built.catenary_sag;
  rest.catenary_horizontal_tension = span.built.tension;
  return rest;
}

Reactions reactions_of(const SpanAtRest& span, double load_factor) {
  const model::Model& model = span.built.model;
  const Vector force = unbalanced(span, load_factor);
  const auto at = [&](std::size_t node) -> Reaction {
    return {.force = components(model.displacement(force.data(), node)),
            .moment = components(model.rotation(force.data(), node))};
  };
  return {.left = at(0), .right = at(model.nodes.size() - 1)};
}

Components right_end_of(const SpanAtRest& span) {
  const model::Model& model = span.built.model;
  const std::size_t last = model.nodes.size() - 1;
  return components(model.nodes[last] + model.displacement(span.u.data(), last));
}

results::Table shape_of(const SpanAtRest& span) {
  const model::Model& model = span.built.model;
  results::Table table({"arc_m", "x_m", "y_m", "z_m", "rotation_x_rad", "rotation_y_rad", "rotation_z_rad"});
  const std::vector<double> arc = model::arc_lengths(model);
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    const Eigen::Vector3d at = model.nodes[node] + model.displacement(span.u.data(), node);
    const Eigen::Vector3d turn = model.rotation(span.u.data(), node);
    table.append(std::array{arc[node], at.x(), at.y(), at.z(), turn.x(), turn.y(), turn.z()});
  }
  return table;
}

double longest_element(const SpanAtRest& span) {
  double longest = 0;
  for (const beam::SpatialElement& element : span.built.model.elements) longest = std::max(longest, element.length);
  return longest;
}

}  // namespace strandyn::span
