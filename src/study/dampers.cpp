#include "dampers.hpp"

#include "strandyn/build/dampers.hpp"

namespace strandyn::study {

void hang_dampers(const casefile::Scene& scene, double frequency, span::SpanAtRest& span) {
  for (const casefile::DamperKeys& keys : scene.dampers) {
    span.system.attach(damper::make_hanging_damper(span.built.model, build::arms_of(keys), build::messenger_of(keys),
                                                   {.node = model::nearest_node(span.built.model, keys.at),
                                                    .elements = static_cast<std::size_t>(keys.elements),
                                                    .frequency = frequency}));
  }
}

}  // namespace strandyn::study
