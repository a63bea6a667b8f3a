#include <fmt/format.h>

#include "parts.hpp"

namespace strandyn::study {

using casefile::Scene;
using json = nlohmann::ordered_json;

namespace {

/// Shapes of all modes, one row per node: displacements along x, y, z where the chain has them.
results::Table shapes(const model::Model& model, const std::vector<solver::Mode>& modes) {
  std::vector<std::string> names = {"arc_m"};
  const bool spatial = model::is_spatial(model.freedom);
  for (std::size_t i = 1; i <= modes.size(); ++i) {
    for (const char* axis : {"x", "y", "z"}) {
      if (spatial || *axis != 'z') names.push_back(fmt::format("mode_{}_{}", i, axis));
    }
  }
  results::Table table(names);
  const std::vector<double> arc = model::arc_lengths(model);
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    std::vector<double> row = {arc[node]};
    for (const solver::Mode& mode : modes) {
      const Eigen::Vector3d d = model.displacement(mode.shape.data(), node);
      row.insert(row.end(), d.data(), d.data() + (spatial ? 3 : 2));
    }
    table.append(row);
  }
  return table;
}

}  // namespace

void run_modes(const Scene& scene, CaseResult& result) {
  SpanAtRest span(scene);
  add_rest(span, result);
  span.apply_static_loads();
  const auto count = static_cast<std::size_t>(scene.analysis.modes.count);
  const bool planar = !model::is_spatial(span.built.model.freedom);
  const auto& near = scene.analysis.modes.near_frequency;
  // In a plane and from the lowest up, modes along the span are left out: what is counted is vibration across it.
  const bool across_only = planar && !near && scene.span->nodes.empty();
  const std::vector<solver::Mode> modes =
      across_only ? solver::transverse_modes(span.system, span.u, count)
                  : solver::find_modes(span.system, span.u, {.count = count, .near = near.value_or(0)});
  json frequencies = json::array();
  json list = json::array();
  for (const solver::Mode& mode : modes) {
    frequencies.push_back(mode.frequency);
    list.push_back(
        {{"frequency_Hz", mode.frequency}, {"kind", name_of(mode.kind)}, {"modal_mass_kg", mode.modal_mass}});
  }
  result.summary["frequencies_Hz"] = frequencies;
  result.summary["modes"] = list;
  add_effort(span.system, result.summary["cost"]);
  result.tables.push_back({"modes.csv", shapes(span.built.model, modes)});
}

}  // namespace strandyn::study
