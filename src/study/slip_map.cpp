#include "slip_map.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cross_section.hpp"
#include "strandyn/build/section_law.hpp"

namespace strandyn::study {

void check_slip_map(const casefile::Scene& scene) {
  if (scene.as<casefile::StaticAnalysis>().slip_map_loads.empty() || build::has_wires(scene.section.law)) return;
  refuse(scene.source, "analysis.slip_map_loads_N", "this law knows no wires", "use law = \"return-map\"");
}

SlipMap::SlipMap(const casefile::Scene& scene, const span::SpanAtRest& span, std::size_t node)
    : span_(span),
      wanted_(scene.as<casefile::StaticAnalysis>().slip_map_loads),
      point_(node > 0 ? node * beam::gauss_points - 1 : 0),
      place_(model::arc_lengths(span.built.model)[node]),
      strand_(scene.conductor ? &scene.conductor->strand : nullptr),
      table_({"load_N", "layer", "theta_rad", "force_N", "gradient_N_per_m", "limit_N_per_m", "slips"}) {
  std::sort(wanted_.begin(), wanted_.end());
}

void SlipMap::watch(double load) {
  for (; next_ < wanted_.size() && load >= wanted_[next_] * (1 - 1e-9); ++next_) {
    const section::WireState wires =
        span_.built.model.law->wires(span_.system.history(), span_.system.committed_strains(), point_);
    SlipMapRow& row = rows_.emplace_back();
    last_ = wires;
    row.load = load;
    for (std::size_t j = 0; j < wires.layers.size(); ++j) {
      const section::LayerState& layer = wires.layers[j];
      const auto slipping = static_cast<double>(std::count(layer.slips.begin(), layer.slips.end(), true));
      row.layers.push_back({.layer = j + 1, .slipping_share = slipping / static_cast<double>(layer.slips.size())});
      for (std::size_t i = 0; i < wires.theta.size(); ++i) {
        table_.append(std::array{load, static_cast<double>(j + 1), wires.theta[i], layer.force[i], layer.gradient[i],
                                 layer.limit[i], layer.slips[i] ? 1.0 : 0.0});
      }
    }
  }
}

std::vector<results::MemberNote> SlipMap::notes() {
  return results::ReferenceWriter::of<SlipMapSummary>();
}

void SlipMap::add_to(Outcome& outcome) {
  if (wanted_.empty()) return;
  outcome.tell(SlipMapSummary{.maps = rows_});
  outcome.tables.push_back({.file = "slip_maps.csv", .table = std::move(table_)});
  outcome.figures.push_back({.name = "slip_maps",
                             .title = "Wire forces around the section",
                             .kind = "section",
                             .table = "slip_maps.csv",
                             .x = "theta_rad",
                             .y = {"force_N"},
                             .series = {"load_N", "layer"},
                             .caption = "Force of the wires of each layer around the lay, at the section beside the "
                                        "loaded point."});
  if (const conductor::Strand* strand = strand_; strand && !rows_.empty()) {
    const std::vector<Wire> wires = wires_of(*strand);
    add_cross_section(
        *strand, place_, [&](std::size_t w) { return slips(last_, wires[w], place_) ? 1.0 : 0.0; }, "Wires that slip",
        fmt::format("The section beside the loaded point under {:.4g} N: filled wires slip.", rows_.back().load),
        outcome);
  }
  if (next_ < wanted_.size()) {
    outcome.warnings.emplace_back("analysis.slip_map_loads_N asks for loads that the run did not reach");
  }
}

}  // namespace strandyn::study
