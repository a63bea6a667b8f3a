#include "strandyn/span/modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strandyn/observe/deflection_points.hpp"

namespace strandyn::span {

std::vector<solver::Mode> modes_across(const SpanAtRest& span, int count, const Stop& stop) {
  if (count == 0) return {};
  return solver::transverse_modes(span.system, span.u, static_cast<std::size_t>(count), stop);
}

solver::Mode mode_near(const SpanAtRest& span, double frequency, const Stop& stop) {
  const auto away = [frequency](const solver::Mode& mode) { return std::abs(mode.frequency - frequency); };
  auto count = static_cast<int>(std::ceil(span.built.length / span.built.loop_length(frequency))) + 1;
  for (;; count *= 2) {
    const std::vector<solver::Mode> modes = modes_across(span, count, stop);
    if (modes.back().frequency < frequency) continue;
    return *std::ranges::min_element(modes, {}, away);
  }
}

system::Vector unit_antinode(const SpanAtRest& span, const solver::Mode& mode) {
  const observe::DeflectionPoints places(span.built.model, span.built.loop_length(mode.frequency));
  return mode.shape / places.largest(mode.shape.data());
}

namespace {

/// Changes of sign along the chain and one. What is below a thousandth of the largest counts as nothing.
int half_waves(const model::Model& model, const solver::Mode& mode) {
  std::vector<double> along;
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    const Eigen::Matrix3d& triad = model.elements[std::min(node, model.elements.size() - 1)].triad;
    const Eigen::Vector3d d = triad.transpose() * model.displacement(mode.shape.data(), node);
    const auto twist = model.index(node, model::Unknown::rotation_x);
    switch (mode.kind) {
      case solver::ModeKind::axial:
        along.push_back(d.x());
        break;
      case solver::ModeKind::in_plane:
        along.push_back(d.y());
        break;
      case solver::ModeKind::out_of_plane:
        along.push_back(d.z());
        break;
      case solver::ModeKind::rigid:
        return 0;
      case solver::ModeKind::torsional:
        along.push_back(twist ? mode.shape(static_cast<Eigen::Index>(*twist)) : 0);
        break;
    }
  }
  double largest = 0;
  for (double value : along) largest = std::max(largest, std::abs(value));
  int count = 0;
  double last = 0;
  for (double value : along) {
    if (std::abs(value) <= 1e-3 * largest) continue;
    if (last == 0 || (value < 0) != (last < 0)) ++count;
    last = value;
  }
  return count;
}

}  // namespace

std::vector<ModeRow> rows_of(const SpanAtRest& span, const std::vector<solver::Mode>& modes) {
  std::vector<ModeRow> rows;
  for (const solver::Mode& mode : modes) {
    rows.push_back({.number = mode.number,
                    .frequency = mode.frequency,
                    .half_waves = half_waves(span.built.model, mode),
                    .kind = name_of(mode.kind),
                    .modal_mass = mode.modal_mass});
  }
  return rows;
}

results::Table shapes_of(const SpanAtRest& span, const std::vector<solver::Mode>& modes) {
  const model::Model& model = span.built.model;
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

}  // namespace strandyn::span
