#include <algorithm>

#include "parts.hpp"
#include "strandyn/section/law_by_place.hpp"
#include "strandyn/section/stiffened_law.hpp"

namespace strandyn::build {

using casefile::Scene;
using casefile::StretchKeys;

namespace {

Scene with_conductor(const Scene& scene, const StretchKeys& stretch) {
  Scene own = scene;
  own.conductor = stretch.conductor;
  return own;
}

section::ArmourRods rods_of(const casefile::ArmourKeys& keys) {
  return {.rods = keys.rods, .diameter = keys.diameter, .young = keys.young};
}

/// [kg/m] more than the conductor of the case has.
double extra_mass(const Scene& scene, const StretchKeys& stretch) {
  if (stretch.armour) return rods_of(*stretch.armour).area() * stretch.armour->density;
  return *stretch.conductor->mass_per_length - *casefile::mass_per_length(scene);
}

std::shared_ptr<const section::Law> law_of(const Scene& scene, const StretchKeys& stretch,
                                           const std::shared_ptr<const section::Law>& all) {
  if (stretch.conductor) return build_law(with_conductor(scene, stretch), all->dimension());
  const section::ArmourRods rods = rods_of(*stretch.armour);
  const double diameter = section_numbers(scene).diameter;
  const double EI = stretch.armour->bonded ? rods.bonded_stiffness(diameter) : rods.loose_stiffness();
  return std::make_shared<section::StiffenedLaw>(all, EI);
}

const StretchKeys* stretch_at(const Scene& scene, double place) {
  const auto& stretches = scene.span->stretches;
  const auto holds = [place](const StretchKeys& s) { return s.from <= place && place < s.to; };
  const auto found = std::ranges::find_if(stretches, holds);
  return found == stretches.end() ? nullptr : &*found;
}

/// The stretch of every element, by its middle; null where the span is as the case says.
std::vector<const StretchKeys*> stretches_of_elements(const Scene& scene, const model::Model& model) {
  const std::vector<double> arc = model::arc_lengths(model);
  std::vector<const StretchKeys*> stretches;
  for (std::size_t e = 0; e + 1 < arc.size(); ++e) stretches.push_back(stretch_at(scene, (arc[e] + arc[e + 1]) / 2));
  return stretches;
}

}  // namespace

double axial_stiffness_at(const Scene& scene, const SectionNumbers& numbers, double place) {
  const StretchKeys* stretch = stretch_at(scene, place);
  if (!stretch || !stretch->conductor) return numbers.EA;
  return section_numbers(with_conductor(scene, *stretch)).EA;
}

void add_stretches(const Scene& scene, model::Model& model) {
  if (scene.span->stretches.empty()) return;
  const std::vector<const StretchKeys*> stretches = stretches_of_elements(scene, model);
  const std::shared_ptr<const section::Law> all = model.law;
  std::vector<section::LawByPlace::Run> runs;
  for (std::size_t e = 0; e < stretches.size(); ++e) {
    if (e == 0 || stretches[e] != stretches[e - 1]) {
      runs.push_back({.law = stretches[e] ? law_of(scene, *stretches[e], all) : all});
    }
    runs.back().points += beam::gauss_points;
    if (!stretches[e]) continue;
    const double extra = extra_mass(scene, *stretches[e]) * model.elements[e].length / 2;
    for (const std::size_t node : {e, e + 1}) model.bodies.push_back({.node = node, .mass = extra});
  }
  model.law = std::make_shared<section::LawByPlace>(std::move(runs));
}

}  // namespace strandyn::build
