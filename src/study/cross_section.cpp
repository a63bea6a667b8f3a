#include "cross_section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::study {
namespace {

/// From 0 to 1: the swept angle of a wire at a place.
double turn_at(const Wire& wire, double x) {
  const double turns = wire.turns + x / wire.lay;
  return turns - std::floor(turns);
}

}  // namespace

std::vector<Wire> wires_of(const conductor::Strand& strand) {
  std::vector<Wire> wires;
  for (std::size_t j = 1; j < strand.layers.size(); ++j) {
    const conductor::Layer& layer = strand.layers[j];
    const double lay = 2 * std::numbers::pi * layer.helix_radius / std::tan(layer.lay_angle);
    for (int i = 0; i < layer.wires; ++i) {
      wires.push_back({.layer = j, .turns = static_cast<double>(i) / layer.wires, .lay = lay});
    }
  }
  return wires;
}

bool slips(const section::WireState& state, const Wire& wire, double x) {
  if (wire.layer > state.layers.size()) return false;  // a stretch of another conductor
  const auto& around = state.layers[wire.layer - 1].slips;
  const auto cell = static_cast<std::size_t>(turn_at(wire, x) * static_cast<double>(around.size()));
  return around[std::min(cell, around.size() - 1)];
}

double slipping_share(const section::WireState& state) {
  std::size_t slipping = 0, all = 0;
  for (const section::LayerState& layer : state.layers) {
    slipping += static_cast<std::size_t>(std::ranges::count(layer.slips, true));
    all += layer.slips.size();
  }
  return all > 0 ? static_cast<double>(slipping) / static_cast<double>(all) : 0;
}

void add_cross_section(const conductor::Strand& strand, double x, const std::function<double(std::size_t)>& share,
                       const std::string& title, const std::string& caption, Outcome& outcome) {
  results::Table table({"layer", "wire", "across_m", "up_m", "radius_m", "slipping_share"});
  table.append(std::array{0.0, 0.0, 0.0, 0.0, strand.layers.front().diameter / 2, 0.0});
  const std::vector<Wire> wires = wires_of(strand);
  for (std::size_t w = 0; w < wires.size(); ++w) {
    const conductor::Layer& layer = strand.layers[wires[w].layer];
    const double angle = 2 * std::numbers::pi * turn_at(wires[w], x);
    table.append(std::array{static_cast<double>(wires[w].layer), static_cast<double>(w + 1),
                            layer.helix_radius * std::cos(angle), layer.helix_radius * std::sin(angle),
                            layer.diameter / 2, share(w)});
  }
  outcome.tables.push_back({.file = "cross_section.csv", .table = std::move(table)});
  outcome.figures.push_back({.name = "cross_section",
                             .title = title,
                             .kind = "wires",
                             .table = "cross_section.csv",
                             .x = "across_m",
                             .y = {"up_m", "radius_m", "slipping_share"},
                             .caption = caption});
}

}  // namespace strandyn::study
