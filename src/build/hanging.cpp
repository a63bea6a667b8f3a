#include <fmt/format.h>

#include <cmath>

#include "parts.hpp"
#include "strandyn/exact/elastic_catenary.hpp"

namespace strandyn::build {

using exact::CatenarySpan;
using exact::ElasticCatenary;
using model::Unknown;

namespace {

double weight_of(const casefile::Scene& scene) {
  return *casefile::mass_per_length(scene) * gravity;
}

/// In the plane in which it hangs: under its weight, and the pull of the wind.
CatenarySpan catenary_span(const casefile::Scene& scene) {
  return {.span = *scene.span->length,
          .height_difference = scene.span->height_difference,
          .weight_per_length = std::hypot(weight_of(scene), wind_load(scene))};
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

/// As it hangs, at another temperature, with ice or in the wind.
ElasticCatenary catenary(const casefile::Scene& scene, double EA) {
  const ElasticCatenary before = strung(scene, EA);
  const double strain = casefile::thermal_strain(scene);
  if (strain == 0 && scene.span->ice == 0 && scene.span->wind == 0) return before;
  return ElasticCatenary::from_unstressed_length(catenary_span(scene), EA, before.unstressed_length() * (1 + strain));
}

}  // namespace

double wind_load(const casefile::Scene& scene) {
  constexpr double air = 1.2;  // [kg/m^3]
  const casefile::Span& span = *scene.span;
  if (span.wind == 0) return 0;
  return air / 2 * span.wind * span.wind * span.drag_coefficient * casefile::outer_diameter(scene);
}

Stringing find_stringing(const casefile::Scene& scene, double EA) {
  const casefile::Span& span = *scene.span;
  if (span.gravity) {
    const ElasticCatenary cable = catenary(scene, EA);
    return {.tension = cable.horizontal_tension(),
            .unstressed_length = cable.unstressed_length(),
            .catenary_sag = cable.sag() * weight_of(scene) / catenary_span(scene).weight_per_length};
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

/// One span of a line, as a scene of its own.
struct Part {
  double from = 0, to = 0;  // [m] along the line
  casefile::Scene scene;
};

std::vector<Part> parts_of(const casefile::Scene& scene) {
  std::vector<Part> parts;
  casefile::Scene part = scene;
  part.span->supports.clear();
  double from = 0;
  const auto add = [&](double to) {
    part.span->length = to - from;
    parts.push_back({.from = from, .to = to, .scene = part});
    from = to;
  };
  for (const casefile::SuspensionKeys& support : scene.span->supports) {
    add(support.at);
    if (!support.tension) continue;
    part.span->tension = support.tension;
    part.span->tension_rts.reset();
  }
  add(*scene.span->length);
  return parts;
}

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
  // The plane in which it hangs leans with the wind.
  const double lean = std::atan2(wind_load(scene), weight_of(scene));
  // The straight chain pulls with its own weight: without tension nothing would hold it across.
  const double weight = catenary_span(scene).weight_per_length * cable.unstressed_length();
  const double taut = 1 + weight / numbers.EA;
  double s = 0;  // unstressed
  const Eigen::Vector3d start = model.nodes[first];
  for (std::size_t node = first; node <= last; ++node) {
    const ElasticCatenary::Place place = cable.at(s);
    set(built.hanging, node, Unknown::x, start.x() + place.x - model.nodes[node].x());
    set(built.hanging, node, Unknown::y, start.y() + std::cos(lean) * place.y - model.nodes[node].y());
    set(built.hanging, node, Unknown::z, -std::sin(lean) * place.y);
    set(built.hanging, node, Unknown::rotation_z, std::cos(lean) * (place.angle - chord_angle));
    set(built.hanging, node, Unknown::rotation_y, std::sin(lean) * (place.angle - chord_angle));
    const Eigen::Vector3d straight = start + taut * s * along;
    set(built.straight, node, Unknown::x, straight.x() - model.nodes[node].x());
    set(built.straight, node, Unknown::y, straight.y() - model.nodes[node].y());
    if (node < model.elements.size()) s += model.elements[node].length;
  }
  // A support that holds its direction keeps it.
  for (const model::Support& support : model.supports) {
    if (support.fixed[static_cast<std::size_t>(Unknown::rotation_z)]) {
      set(built.hanging, support.node, Unknown::rotation_z, 0);
      set(built.hanging, support.node, Unknown::rotation_y, 0);
    }
  }
  // The ends are held exactly where they belong.
  for (std::size_t node : {first, last}) {
    set(built.hanging, node, Unknown::x, 0);
    set(built.hanging, node, Unknown::y, 0);
    set(built.hanging, node, Unknown::z, 0);
    if (first == 0 && last + 1 == model.nodes.size()) continue;
    // A line is held there while it is straightened out, too.
    set(built.straight, node, Unknown::x, 0);
    set(built.straight, node, Unknown::y, 0);
  }
}

}  // namespace

std::vector<Stretch> stretches_of(const casefile::Scene& scene, double EA) {
  std::vector<Stretch> stretches;
  for (const Part& part : parts_of(scene)) {
    stretches.push_back({.from = part.from, .to = part.to, .stringing = find_stringing(part.scene, EA)});
  }
  return stretches;
}

void add_hanging_shape(const casefile::Scene& scene, const SectionNumbers& numbers, BuiltSpan& built) {
  built.hanging = built.straight = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(built.model.unknowns()));
  std::size_t first = 0;
  for (const Part& part : parts_of(scene)) {
    const std::size_t last = model::nearest_node(built.model, part.to);
    hang(part.scene, numbers, first, last, built);
    first = last;
  }
}

}  // namespace strandyn::build
