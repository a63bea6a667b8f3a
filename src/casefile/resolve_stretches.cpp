#include <fmt/format.h>

#include "refusals.hpp"
#include "resolve.hpp"

namespace strandyn::casefile {

namespace {

/// What this version does not know of a span with two conductors.
void check_two_conductors(const Scene& scene, const std::string& path) {
  struct Excluded {
    bool given;
    const char* what;
  };
  const Span& span = *scene.span;
  for (const auto& [given, what] :
       {Excluded{span.gravity, "span.gravity"}, Excluded{span.temperature.has_value(), "span.temperature_C"},
        Excluded{span.unstressed_length.has_value(), "span.unstressed_length_m"},
        Excluded{span.condense_axial, "span.condense_axial"}, Excluded{scene.air.has_value(), "air"},
        Excluded{!scene.winds.empty(), "wind"}, Excluded{scene.material.has_value(), "material"},
        Excluded{scene.clamps.has_value(), "clamps"}}) {
    if (!given) continue;
    refuse(scene.source, path + ".conductor",
           fmt::format("`{}` knows one conductor in a span, and this is another", what),
           "remove one of the two; armour_rods go with all of them");
  }
  if (!needs_strand(scene.section.law)) {
    refuse(scene.source, path + ".conductor",
           fmt::format("is a strand, and section.law = \"{}\" has none", name_of(scene.section.law)),
           "use a law of strands such as \"return-map\"");
  }
}

}  // namespace

void resolve_stretches(Scene& scene) {
  if (!scene.span || scene.span->stretches.empty()) return;
  const Span& span = *scene.span;
  if (!span.nodes.empty()) {
    refuse(scene.source, "span.stretch", "belongs to a straight span", "give length_m in place of nodes_m");
  }
  if (scene.is<SelfDampingAnalysis>()) {
    refuse(scene.source, "span.stretch",
           "makes the loss of a metre depend on where it is, and a point of self-damping "
           "is that of one conductor",
           "remove it, or vibrate the span by \"decay\" or \"forced\"");
  }
  double last = 0;
  for (std::size_t i = 0; i < span.stretches.size(); ++i) {
    StretchKeys& stretch = scene.span->stretches[i];
    const std::string path = fmt::format("span.stretch[{}]", i);
    if (stretch.from < last) {
      refuse(scene.source, path + ".from_m", "lies within the stretch before it",
             "give the stretches from left to right, apart from each other");
    }
    if (stretch.to <= stretch.from || stretch.to > *span.length) {
      refuse(scene.source, path + ".to_m", "does not lie between from_m and the end of the span",
             fmt::format("give a distance above {} and at most {} metres", stretch.from, *span.length));
    }
    last = stretch.to;
    if (stretch.armour && stretch.armour->bonded && !scene.conductor) {
      refuse(scene.source, path + ".armour_rods.bonded", "needs the diameter of the conductor, and there is none",
             "give [conductor], or leave it out: loose rods");
    }
    if (!stretch.conductor) continue;
    check_two_conductors(scene, path);
    resolve_conductor(*stretch.conductor, scene.source, path + ".conductor");
    if (stretch.conductor->mass_per_length) continue;
    refuse(scene.source, path + ".conductor.mass_kg_per_m", "is missing, and the span needs a mass",
           "give the mass per length in kilograms per metre");
  }
}

}  // namespace strandyn::casefile
