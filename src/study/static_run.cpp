#include <fmt/format.h>

#include <numbers>

#include "parts.hpp"
#include "strandyn/solver/equilibrium.hpp"

namespace strandyn::study {

using casefile::Scene;
using json = nlohmann::ordered_json;
using model::unknowns_per_node;

SpanAtRest::SpanAtRest(const Scene& scene)
    : built(casefile::build_span(scene)),
      system(built.model),
      u(system::Vector::Zero(static_cast<Eigen::Index>(built.model.unknowns()))) {
  system.begin(u);
}

void run_static(const Scene& scene, CaseResult& result) {
  SpanAtRest span(scene);
  if (span.built.model.loads.empty()) {
    refuse(scene.source, "analysis.type", "there is no load", "give a [[load]] of type \"static-force\"");
  }
  const solver::EquilibriumSummary found =
      solver::find_equilibrium(span.system, span.u, {.steps = scene.analysis.static_.steps});
  const model::Load& load = span.built.model.loads.front();
  results::Table table({"load_N", "displacement_m", "sections_slipping"});
  json steps = json::array();
  for (const solver::EquilibriumStep& step : found.steps) {
    // Along the load: the displacement that its work is done on.
    const auto at = static_cast<Eigen::Index>(load.node * unknowns_per_node);
    const double size = load.amplitude.norm();
    const double displacement = size > 0 ? load.amplitude.dot(step.u.segment<3>(at)) / size : 0;
    steps.push_back({{"load_N", step.load_factor * size},
                     {"displacement_m", displacement},
                     {"sections_slipping", step.sections_slipping}});
    table.append(std::array{step.load_factor * size, displacement, static_cast<double>(step.sections_slipping)});
  }
  result.summary["steps"] = steps;
  result.summary["cost"]["steps"] = found.steps.size();
  add_effort(span.system, result.summary["cost"]);
  result.tables.push_back({"steps.csv", std::move(table)});
}

void run_modes(const Scene& scene, CaseResult& result) {
  SpanAtRest span(scene);
  solver::find_equilibrium(span.system, span.u, {});
  const auto modes =
      solver::transverse_modes(span.system, span.u, static_cast<std::size_t>(scene.analysis.modes.count));
  std::vector<std::string> names = {"x_m"};
  for (std::size_t i = 0; i < modes.size(); ++i) names.push_back(fmt::format("mode_{}", i + 1));
  results::Table table(names);
  for (std::size_t node = 0; node < span.built.model.nodes.size(); ++node) {
    std::vector<double> row = {span.built.model.nodes[node].x()};
    for (const solver::Mode& mode : modes) {
      row.push_back(mode.shape(static_cast<Eigen::Index>(node * unknowns_per_node + 1)));
    }
    table.append(row);
  }
  json frequencies = json::array();
  for (const solver::Mode& mode : modes) frequencies.push_back(mode.frequency);
  result.summary["frequencies_Hz"] = frequencies;
  add_effort(span.system, result.summary["cost"]);
  result.tables.push_back({"modes.csv", std::move(table)});
}

}  // namespace strandyn::study
