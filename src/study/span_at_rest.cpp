#include <algorithm>
#include <cmath>

#include "parts.hpp"
#include "strandyn/solver/static/equilibrium.hpp"

namespace strandyn::study {

using casefile::Scene;
using json = nlohmann::ordered_json;

SpanAtRest::SpanAtRest(const Scene& scene)
    : built(build::build_span(scene)), system(built.model), u(system.make_vector()) {
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

json vector_json(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// What a support does to the chain: force [N] and moment [N m] on the end node.
json reaction(const system::System& system, const system::Vector& force, std::size_t node) {
  return {{"force_N", vector_json(system.model().displacement(force.data(), node))},
          {"moment_N_m", vector_json(system.model().rotation(force.data(), node))}};
}

/// [m] greatest vertical distance below the chord between the supports, at a node.
double sag(const model::Model& model, const system::Vector& u) {
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

}  // namespace

void add_rest(const SpanAtRest& span, CaseResult& result) {
  if (span.built.hanging.size() == 0) return;
  const model::Model& model = span.built.model;
  system::Vector force = span.system.make_vector();
  span.system.residual({.u = span.u.data()}, {.time = 0, .part = 0}, force.data());
  json& rest = result.summary["rest"] = json{{"unstressed_length_m", model.unstressed_length()}};
  if (span.built.catenary_sag) {
    rest["sag_m"] = sag(model, span.u);
    rest["catenary_sag_m"] = *span.built.catenary_sag;
    rest["horizontal_tension_N"] = model.displacement(force.data(), model.nodes.size() - 1).x();
    rest["catenary_horizontal_tension_N"] = span.built.tension;
  }
}

void add_shape(const SpanAtRest& span, double load_factor, CaseResult& result) {
  const model::Model& model = span.built.model;
  results::Table table({"arc_m", "x_m", "y_m", "z_m", "rotation_x_rad", "rotation_y_rad", "rotation_z_rad"});
  const std::vector<double> arc = model::arc_lengths(model);
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    const Eigen::Vector3d at = model.nodes[node] + model.displacement(span.u.data(), node);
    const Eigen::Vector3d turn = model.rotation(span.u.data(), node);
    table.append(std::array{arc[node], at.x(), at.y(), at.z(), turn.x(), turn.y(), turn.z()});
  }
  result.tables.push_back({"shape.csv", std::move(table)});
  const std::size_t last = model.nodes.size() - 1;
  result.summary["right_end_m"] = vector_json(model.nodes[last] + model.displacement(span.u.data(), last));

  system::Vector force = span.system.make_vector();
  span.system.reactions({.u = span.u.data()}, {.time = 0, .part = load_factor}, force.data());
  result.summary["reactions"] = {{"left", reaction(span.system, force, 0)},
                                 {"right", reaction(span.system, force, last)}};
}

}  // namespace strandyn::study
