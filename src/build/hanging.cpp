#include <fmt/format.h>

#include <cmath>

#include "parts.hpp"
#include "strandyn/exact/elastic_catenary.hpp"

namespace strandyn::build {

using exact::CatenarySpan;
using exact::ElasticCatenary;
using model::Unknown;

namespace {

CatenarySpan catenary_span(const casefile::Scene& scene) {
  return {.span = *scene.span->length,
          .height_difference = scene.span->height_difference,
          .weight_per_length = *casefile::mass_per_length(scene) * gravity};
}

ElasticCatenary catenary(const casefile::Scene& scene, double EA) {
  if (const auto tension = casefile::span_tension(scene)) {
    if (*tension == 0) {
      casefile::refuse(scene.source, scene.span->tension ? "span.tension_kN" : "span.tension_rts",
                       "a span that hangs has a horizontal tension", "give it, or unstressed_length_m in its place");
    }
    return ElasticCatenary::from_horizontal_tension(catenary_span(scene), EA, *tension);
  }
  return ElasticCatenary::from_unstressed_length(catenary_span(scene), EA, *scene.span->unstressed_length);
}

}  // namespace

Stringing find_stringing(const casefile::Scene& scene, double EA) {
  const casefile::Span& span = *scene.span;
  if (span.gravity) {
    const ElasticCatenary cable = catenary(scene, EA);
    return {.tension = cable.horizontal_tension(),
            .unstressed_length = cable.unstressed_length(),
            .catenary_sag = cable.sag()};
  }
  const double chord = std::hypot(*span.length, span.height_difference);
  if (const auto tension = casefile::span_tension(scene)) {
    return {.tension = *tension, .unstressed_length = chord / (1 + *tension / EA), .catenary_sag = {}};
  }
  if (*span.unstressed_length > chord) {
    casefile::refuse(
        scene.source, "span.unstressed_length_m",
        "it is longer than the distance of the supports, and without weight a slack span has no shape of its own",
        fmt::format("give gravity = true, or at most {} m", chord));
  }
  return {.tension = EA * (chord / *span.unstressed_length - 1),
          .unstressed_length = *span.unstressed_length,
          .catenary_sag = {}};
}

void add_hanging_shape(const casefile::Scene& scene, const SectionNumbers& numbers, BuiltSpan& built) {
  const ElasticCatenary cable = catenary(scene, numbers.EA);
  const model::Model& model = built.model;
  const Eigen::Vector3d along = model.elements.front().triad.col(0);
  const double chord_angle = std::atan2(along.y(), along.x());
  built.hanging = built.straight = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.unknowns()));
  const auto set = [&](Eigen::VectorXd& u, std::size_t node, Unknown unknown, double value) {
    if (const auto i = model.index(node, unknown)) u(static_cast<Eigen::Index>(*i)) = value;
  };
  // The straight chain pulls with its own weight: without tension nothing would hold it across.
  const double weight = catenary_span(scene).weight_per_length * cable.unstressed_length();
  const double taut = 1 + weight / numbers.EA;
  double s = 0;  // unstressed
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    const ElasticCatenary::Place place = cable.at(s);
    set(built.hanging, node, Unknown::x, place.x - model.nodes[node].x());
    set(built.hanging, node, Unknown::y, place.y - model.nodes[node].y());
    set(built.hanging, node, Unknown::rotation_z, place.angle - chord_angle);
    const Eigen::Vector3d straight = model.nodes.front() + taut * s * along;
    set(built.straight, node, Unknown::x, straight.x() - model.nodes[node].x());
    set(built.straight, node, Unknown::y, straight.y() - model.nodes[node].y());
    if (node < model.elements.size()) s += model.elements[node].length;
  }
  // A support that holds its direction keeps it.
  for (const model::Support& support : model.supports) {
    if (support.fixed[static_cast<std::size_t>(Unknown::rotation_z)]) {
      set(built.hanging, support.node, Unknown::rotation_z, 0);
    }
  }
  // The ends are held exactly where they belong.
  for (std::size_t node : {std::size_t{0}, model.nodes.size() - 1}) {
    set(built.hanging, node, Unknown::x, 0);
    set(built.hanging, node, Unknown::y, 0);
  }
}

}  // namespace strandyn::build
