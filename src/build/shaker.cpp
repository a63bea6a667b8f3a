#include "strandyn/build/shaker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace strandyn::build {

using casefile::refuse;
using casefile::Scene;

namespace {

bool is_along_y(const std::optional<casefile::Vector3>& direction) {
  return direction && std::abs((*direction)[1]) > 1 - 1e-9;
}

void check(const Scene& scene, bool fits, const std::string& path, const char* wrong) {
  if (fits) return;
  refuse(scene.source, path, fmt::format("{}, and a shaker moves one point across the span", wrong),
         "give one harmonic force at a point (at_m), or one harmonic displacement of a support, along [0, 1, 0]");
}

void check_shaker(const Scene& scene, const ShakerKey& shaker) {
  if (shaker.load) {
    const casefile::Load& load = scene.loads[*shaker.load];
    const std::string path = fmt::format("load[{}]", *shaker.load);
    check(scene, load.at.has_value(), path, "acts on the whole span");
    check(scene, !load.is_moment(), path, "is a moment");
    check(scene, is_along_y(load.direction), path, "does not act along y");
  }
  if (shaker.motion) {
    const casefile::Motion& motion = scene.motions[*shaker.motion];
    const std::string path = fmt::format("motion[{}]", *shaker.motion);
    check(scene, !motion.is_rotation(), path, "is a rotation");
    check(scene, is_along_y(motion.direction), path, "does not go along y");
  }
}

}  // namespace

ShakerKey shaker_of(const Scene& scene) {
  ShakerKey shaker;
  int drives = 0;
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    if (!scene.loads[i].is_harmonic()) continue;
    shaker.load = i;
    ++drives;
  }
  for (std::size_t i = 0; i < scene.motions.size(); ++i) {
    if (!scene.motions[i].is_harmonic()) continue;
    shaker.motion = i;
    ++drives;
  }
  if (drives > 1) {
    refuse(scene.source,
           shaker.load ? fmt::format("load[{}]", *shaker.load) : fmt::format("motion[{}]", *shaker.motion),
           "is a second shaker, and a span has one",
           "give one [[load]] of type \"harmonic-force\" or one [[motion]] of type \"harmonic-motion\"");
  }
  check_shaker(scene, shaker);
  return shaker;
}

Shaker find_shaker(const Scene& scene, const BuiltSpan& span) {
  const ShakerKey key = shaker_of(scene);
  if (!key.is_given()) {
    refuse(scene.source, "analysis.type", "has no shaker",
           "give one [[load]] of type \"harmonic-force\" or one [[motion]] of type \"harmonic-motion\"");
  }
  Shaker shaker{.moves = key.motion.has_value()};
  const std::vector<std::size_t>& from = shaker.moves ? span.motion_of : span.load_of;
  const std::size_t number = shaker.moves ? *key.motion : *key.load;
  shaker.entry = static_cast<std::size_t>(std::ranges::find(from, number) - from.begin());
  const auto& direction = shaker.moves ? scene.motions[number].direction : scene.loads[number].direction;
  shaker.sign = (*direction)[1] > 0 ? 1 : -1;
  shaker.size = std::abs(shaker.moves ? scene.motions[number].value() : scene.loads[number].value());
  shaker.node = shaker.moves ? span.model.motions[shaker.entry].node : span.model.loads[shaker.entry].node;
  return shaker;
}

}  // namespace strandyn::build
