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

/// As it was strung.
ElasticCatenary strung(const casefile::Scene& scene, double EA) {
  CatenarySpan span = catenary_span(scene);
  span.weight_per_length = *casefile::strung_mass_per_length(scene) * gravity;
  if (const auto tension = casefile::span_tension(scene)) {
    if (*tension == 0) {
      casefile::refuse(scene.source, scene.span->tension ? "span.tension_kN" : "span.tension_rts",
                       "a span that hangs has a horizontal tension", "give it, or unstressed_length_m in its place");
    }
    return ElasticCatenary::from_horizontal_tension(span, EA, *tension);
  }
  return ElasticCatenary::from_unstressed_length(span, EA, *scene.span->unstressed_length);
}

/// As it hangs, at another temperature or with ice.
ElasticCatenary catenary(const casefile::Scene& scene, double EA) {
  const ElasticCatenary before = strung(scene, EA);
  const double strain = casefile::thermal_strain(scene);
  if (strain == 0 && scene.span->ice == 0) return before;
  return ElasticCatenary::from_unstressed_length(catenary_span(scene), EA, before.unstressed_length() * (1 + strain));
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
  const auto tension = casefile::span_tension(scene);
  const double strain = casefile::thermal_strain(scene);
  if (tension && strain == 0) {
    return {.tension = *tension, .unstressed_length = chord / (1 + *tension / EA), .catenary_sag = {}};
  }
  const double length = (tension ? chord / (1 + *tension / EA) : *span.unstressed_length) * (1 + strain);
  if (length > chord) {
    casefile::refuse(
        scene.source, tension ? "span.temperature_C" : "span.unstressed_length_m",
        "it is longer than the distance of the supports, and without weight a slack span has no shape of its own",
        fmt::format("give gravity = true{}", tension ? "" : fmt::format(", or at most {} m", chord / (1 + strain))));
  }
  return {.tension = EA * (chord / length - 1), .unstressed_length = length, .catenary_sag = {}};
}

namespace {

/// The scene of one span of a line.
casefile::Scene scene_of(const casefile::Scene& scene, double length, std::optional<double> tension) {
  casefile::Scene part = scene;
  part.span->supports.clear();
  part.span->length = length;
  if (tension) {
    part.span->tension = tension;
    part.span->tension_rts.reset();
  }
  return part;
}

}  // namespace

std::vector<Stretch> stretches_of(const casefile::Scene& scene, double EA) {
  std::vector<Stretch> stretches;
  double from = 0;
  std::optional<double> tension;
  const auto add = [&](double to) {
    stretches.push_back({.from = from, .to = to, .stringing = find_stringing(scene_of(scene, to - from, tension), EA)});
    from = to;
  };
  for (const casefile::SuspensionKeys& support : scene.span->supports) {
    add(support.at);
    if (support.tension) tension = support.tension;
  }
  add(*scene.span->length);
  return stretches;
}

namespace {

/// The nodes of one span of a line, in the catenary of that span.
void hang(const casefile::Scene& scene, const SectionNumbers& numbers, std::size_t first, std::size_t last,
          BuiltSpan& built) {
  const ElasticCatenary cable = catenary(scene, numbers.EA);
  const model::Model& model = built.model;
  const Eigen::Vector3d along = model.elements.front().triad.col(0);
  const double chord_angle = std::atan2(along.y(), along.x());
  const auto set = [&](Eigen::VectorXd& u, std::size_t node, Unknown unknown, double value) {
    if (const auto i = model.index(node, unknown)) u(static_cast<Eigen::Index>(*i)) = value;
  };
  // The straight chain pulls with its own weight: without tension nothing would hold it across.
  const double weight = catenary_span(scene).weight_per_length * cable.unstressed_length();
  const double taut = 1 + weight / numbers.EA;
  double s = 0;  // unstressed
  const Eigen::Vector3d start = model.nodes[first];
  for (std::size_t node = first; node <= last; ++node) {
    const ElasticCatenary::Place place = cable.at(s);
    set(built.hanging, node, Unknown::x, start.x() + place.x - model.nodes[node].x());
    set(built.hanging, node, Unknown::y, start.y() + place.y - model.nodes[node].y());
    set(built.hanging, node, Unknown::rotation_z, place.angle - chord_angle);
    const Eigen::Vector3d straight = start + taut * s * along;
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
  for (std::size_t node : {first, last}) {
    set(built.hanging, node, Unknown::x, 0);
    set(built.hanging, node, Unknown::y, 0);
    if (first == 0 && last + 1 == model.nodes.size()) continue;
    // A line is held there while it is straightened out, too.
    set(built.straight, node, Unknown::x, 0);
    set(built.straight, node, Unknown::y, 0);
  }
}

}  // namespace

void add_hanging_shape(const casefile::Scene& scene, const SectionNumbers& numbers, BuiltSpan& built) {
  const model::Model& model = built.model;
  built.hanging = built.straight = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.unknowns()));
  std::size_t first = 0;
  std::optional<double> tension;
  double from = 0;
  const auto add = [&](double to) {
    const std::size_t last = model::nearest_node(model, to);
    hang(scene_of(scene, to - from, tension), numbers, first, last, built);
    first = last;
    from = to;
  };
  for (const casefile::SuspensionKeys& support : scene.span->supports) {
    add(support.at);
    if (support.tension) tension = support.tension;
  }
  add(*scene.span->length);
}

}  // namespace strandyn::build
