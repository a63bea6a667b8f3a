#include <algorithm>
#include <cmath>

#include "strandyn/build/section_law.hpp"
#include "strandyn/study/run_case.hpp"

namespace strandyn::study {

using casefile::Scene;
using results::Value;

namespace {

struct LayerFacts {
  int wires = 0;
  double diameter = 0, lay_angle = 0, helix_radius = 0, young = 0, residual_force = 0, friction_inner = 0;
};
template <class V>
void members(V& v, LayerFacts& l) {
  v.value("wires", l.wires, {.what = "of the layer"});
  v.value("wire_diameter_m", l.diameter, {.what = "of a wire"});
  v.value("lay_angle_rad", l.lay_angle, {.what = "right-hand lay positive"});
  v.value("helix_radius_m", l.helix_radius, {.what = "of the wires' centre line"});
  v.value("young_Pa", l.young, {.what = "Young's modulus"});
  v.value("residual_force_N_per_m", l.residual_force, {.what = "of the inner contact"});
  v.value("friction_inner", l.friction_inner, {.what = "of the inner contact"});
}
struct ConductorFacts {
  std::string name;
  double diameter = 0, mass = 0, rated_strength = 0;
  std::optional<double> geometric_mass{};
  std::vector<LayerFacts> layers;
};
template <class V>
void members(V& v, ConductorFacts& c) {
  v.value("name", c.name, {.what = "of the conductor"});
  v.value("outer_diameter_m", c.diameter, {.what = "of the strand"});
  v.value("mass_kg_per_m", c.mass, {.what = "as given or by the wires"});
  v.value("rated_strength_N", c.rated_strength, {.what = "rated tensile strength"});
  v.value("geometric_mass_kg_per_m", c.geometric_mass, {.what = "by the densities of the wires"});
  v.list("layers", c.layers, {.what = "core first"});
}

ConductorFacts facts_of(const conductor::Strand& strand) {
  ConductorFacts facts{.name = strand.name,
                       .diameter = strand.outer_diameter(),
                       .mass = strand.mass_per_length,
                       .rated_strength = strand.rated_strength,
                       .geometric_mass = strand.geometric_mass(),
                       .layers = {}};
  for (const conductor::Layer& layer : strand.layers) {
    facts.layers.push_back({.wires = layer.wires,
                            .diameter = layer.diameter,
                            .lay_angle = layer.lay_angle,
                            .helix_radius = layer.helix_radius,
                            .young = layer.young,
                            .residual_force = layer.residual_force,
                            .friction_inner = layer.friction_inner});
  }
  return facts;
}

/// What it is expected to cost: counts from least to most, and their geometric mean.
struct ExpectedCost {
  double evaluations = 0, least = 0, most = 0;
  double seconds = 0, memory = 0;
};
template <class V>
void members(V& v, ExpectedCost& c) {
  v.value("section_evaluations", c.evaluations, {.what = "one section point, one call of its law"});
  v.value("section_evaluations_at_least", c.least, {.what = "the fewest that are expected"});
  v.value("section_evaluations_at_most", c.most, {.what = "the most"});
  v.value("cpu_s", c.seconds, {.what = "time of one processor"});
  v.value("memory_B", c.memory, {.what = "that the program will hold"});
}

}  // namespace

Value describe_case(const Scene& scene) {
  const std::unique_ptr<Analysis> analysis = prepare(scene);
  Value out = Value::object();
  out.set("title", scene.title);
  out.set("analysis", casefile::word_of(scene.analysis));
  const Scene& modelled = analysis->base() ? *analysis->base() : scene;
  out.set("section_law", name_of(modelled.section.law));
  if (modelled.conductor) out.set("conductor", results::to_value(facts_of(modelled.conductor->strand)));
  out.set("section", results::to_value(build::section_numbers(modelled)));
  const Outlook outlook = analysis->outlook();
  out.merge(outlook.modelled);
  // Records of all kinds and their text; by peak memory of random cases.
  constexpr double of_results = 2.5e6;
  const double mean = std::sqrt(outlook.evaluations_least * outlook.evaluations_most);
  out.set("expected_cost", results::to_value(ExpectedCost{.evaluations = mean,
                                                          .least = outlook.evaluations_least,
                                                          .most = outlook.evaluations_most,
                                                          .seconds = mean * outlook.seconds_per_evaluation,
                                                          .memory = outlook.memory + of_results}));
  return out;
}

}  // namespace strandyn::study
