#pragma once
/// \file Which wires slip in one section of a loaded chain, at chosen loads. [FM2016 Figure 18]

#include "parts.hpp"

namespace strandyn::study {

class SlipMap {
 public:
  /// Looks at the section point next to `node`. Refuses laws that have no wires.
  SlipMap(const casefile::Scene& scene, const SpanAtRest& span, std::size_t node);

  /// Takes the committed state if `load` [N] has reached the next one that was asked for.
  void watch(double load);
  void add_to(CaseResult& result);

 private:
  const SpanAtRest& span_;
  std::vector<double> wanted_;  // [N] ascending
  std::size_t next_ = 0;
  std::size_t point_;
  results::Table table_;
  nlohmann::ordered_json list_ = nlohmann::ordered_json::array();
};

}  // namespace strandyn::study
