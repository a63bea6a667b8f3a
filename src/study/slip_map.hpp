#pragma once
/// \file Which wires slip in one section of a loaded chain, at chosen loads. [FM2016 Figure 18]

#include "strandyn/results/reference.hpp"
#include "strandyn/span/rest.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

/// Refuses slip maps of laws that have no wires.
void check_slip_map(const casefile::Scene& scene);

struct SlippingLayer {
  std::size_t layer = 0;
  double slipping_share = 0;
};
template <class V>
void members(V& v, SlippingLayer& l) {
  v.value("layer", l.layer, {.what = "counted from 1, outward from the core"});
  v.value("slipping_share", l.slipping_share, {.what = "of the points around the lay"});
}
struct SlipMapRow {
  double load = 0;
  std::vector<SlippingLayer> layers;
};
template <class V>
void members(V& v, SlipMapRow& r) {
  v.value("load_N", r.load, {.what = "the load that was reached"});
  v.list("layers", r.layers, {.what = "each layer at that load"});
}

/// `slip_maps` of summary.json.
struct SlipMapSummary {
  std::vector<SlipMapRow> maps;
};
template <class V>
void members(V& v, SlipMapSummary& s) {
  v.list("slip_maps", s.maps, {.what = "which wires slip at each load that was asked for"});
}

class SlipMap {
 public:
  /// Looks at the section point next to `node`.
  SlipMap(const casefile::Scene& scene, const span::SpanAtRest& span, std::size_t node);

  /// Takes the committed state if `load` [N] has reached the next one that was asked for.
  void watch(double load);
  void add_to(Outcome& outcome);
  static std::vector<results::MemberNote> notes();

 private:
  const span::SpanAtRest& span_;
  std::vector<double> wanted_;  // [N] ascending
  std::size_t next_ = 0;
  std::size_t point_;
  double place_;  // [m] of the node along the span
  const conductor::Strand* strand_;
  section::WireState last_;  // at the last load that was reached
  results::Table table_;
  std::vector<SlipMapRow> rows_;
};

}  // namespace strandyn::study
