#include "slip_map.hpp"

#include <algorithm>

#include "strandyn/section/wire_state.hpp"

namespace strandyn::study {

using json = nlohmann::ordered_json;

SlipMap::SlipMap(const casefile::Scene& scene, const SpanAtRest& span, std::size_t node)
    : span_(span),
      wanted_(scene.analysis.static_.slip_map_loads),
      point_(node > 0 ? node * beam::gauss_points - 1 : 0),
      table_({"load_N", "layer", "theta_rad", "force_N", "gradient_N_per_m", "limit_N_per_m", "slips"}) {
  std::sort(wanted_.begin(), wanted_.end());
  if (!wanted_.empty() && !build::has_wires(scene.section.law)) {
    refuse(scene.source, "analysis.slip_map_loads_N", "this law knows no wires", "use law = \"return-map\"");
  }
}

void SlipMap::watch(double load) {
  for (; next_ < wanted_.size() && load >= wanted_[next_] * (1 - 1e-9); ++next_) {
    const section::WireState wires =
        span_.built.model.law->wires(span_.system.history(), span_.system.committed_strains(), point_);
    json layers = json::array();
    for (std::size_t j = 0; j < wires.layers.size(); ++j) {
      const section::LayerState& layer = wires.layers[j];
      const auto slipping = static_cast<double>(std::count(layer.slips.begin(), layer.slips.end(), true));
      layers.push_back({{"layer", j + 1}, {"slipping_share", slipping / static_cast<double>(layer.slips.size())}});
      for (std::size_t i = 0; i < wires.theta.size(); ++i) {
        table_.append(std::array{load, static_cast<double>(j + 1), wires.theta[i], layer.force[i], layer.gradient[i],
                                 layer.limit[i], layer.slips[i] ? 1.0 : 0.0});
      }
    }
    list_.push_back({{"load_N", load}, {"layers", layers}});
  }
}

void SlipMap::add_to(CaseResult& result) {
  if (wanted_.empty()) return;
  result.summary["slip_maps"] = list_;
  result.tables.push_back({"slip_maps.csv", std::move(table_)});
  if (next_ < wanted_.size()) {
    result.summary["warnings"].push_back("analysis.slip_map_loads_N asks for loads that the run did not reach");
  }
}

}  // namespace strandyn::study
