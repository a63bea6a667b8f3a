#include "strandyn/build/clamp.hpp"

#include <algorithm>

namespace strandyn::build {

analysis::SurfaceWire surface_wire(const conductor::Strand& strand) {
  return {.diameter = strand.layers.back().diameter, .young = strand.layers.back().young};
}

fatigue::AluminiumLayers aluminium_layers(const conductor::Strand& strand) {
  const auto soft = std::ranges::count_if(
      strand.layers, [](const conductor::Layer& layer) { return layer.young < casefile::steel_from; });
  return soft > 1 ? fatigue::AluminiumLayers::several : fatigue::AluminiumLayers::one;
}

}  // namespace strandyn::build
