#include <fmt/format.h>

#include "resolve.hpp"

namespace strandyn::casefile {

void check_losses(const Scene& scene) {
  const bool moves = !scene.is<SectionAnalysis>() && !scene.is<AxialTorsionAnalysis>();
  for (const auto& [there, key, what] :
       {std::tuple{scene.air.has_value(), "air", "no part of it moves through air"},
        std::tuple{scene.material.has_value(), "material", "the loss of metal needs time"}}) {
    if (!there || moves) continue;
    refuse(scene.source, key, fmt::format("means nothing to analysis.type = \"{}\": {}", word_of(scene.analysis), what),
           "remove the table, or choose an analysis of a span");
  }
  if (scene.air && !scene.air->diameter && !scene.conductor) {
    refuse(scene.source, "air.diameter_mm", "is missing, and there is no conductor to take it from",
           "give the diameter in millimetres");
  }
  if (!scene.material || needs_strand(scene.section.law)) return;
  const Material& m = *scene.material;
  const char* of_wires = m.loss_factor_aluminium ? "material.loss_factor_aluminium"
                         : m.loss_factor_steel   ? "material.loss_factor_steel"
                         : m.thermoelastic       ? "material.thermoelastic"
                                                 : nullptr;
  if (!of_wires) return;
  refuse(scene.source, of_wires,
         fmt::format("belongs to wires, and section.law = \"{}\" has none", name_of(scene.section.law)),
         "remove it, and give material.loss_factor for the whole section");
}

}  // namespace strandyn::casefile
