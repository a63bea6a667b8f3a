#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "document.hpp"
#include "refusals.hpp"
#include "resolve.hpp"

namespace strandyn::casefile {
namespace {

// What an analysis says of itself in its header; false where it says nothing.
bool needs_span(const Analysis& analysis) {
  return std::visit(
      []<class A>(const A&) {
        return requires {
          requires A::needs_span;
        };
      },
      analysis);
}
bool needs_mass(const Analysis& analysis) {
  return std::visit(
      []<class A>(const A&) {
        return requires {
          requires A::needs_mass;
        };
      },
      analysis);
}
bool needs_conductor(const Analysis& analysis) {
  return std::visit(
      []<class A>(const A&) {
        return requires {
          requires A::needs_conductor;
        };
      },
      analysis);
}
bool needs_drive(const Analysis& analysis) {
  return std::visit(
      []<class A>(const A&) {
        return requires {
          requires A::needs_drive;
        };
      },
      analysis);
}
bool sets_tension(const Analysis& analysis) {
  return std::visit(
      []<class A>(const A&) {
        return requires {
          requires A::sets_tension;
        };
      },
      analysis);
}

void check_tables(const Scene& scene) {
  const std::string type = fmt::format("analysis.type = \"{}\"", word_of(scene.analysis));
  if (!scene.conductor && needs_strand(scene.section.law)) {
    refuse(scene.source, "conductor",
           fmt::format("is missing, and section.law = \"{}\" needs one", name_of(scene.section.law)),
           "give [conductor] with a catalogue name or [[conductor.layer]] tables, or the law \"elastic\"");
  }
  if (!scene.conductor && needs_conductor(scene.analysis)) {
    refuse(scene.source, "conductor", fmt::format("is missing, and {} needs one", type),
           "give [conductor] with a catalogue name or [[conductor.layer]] tables");
  }
  if (!scene.span && needs_span(scene.analysis)) {
    refuse(scene.source, "span", fmt::format("is missing, and {} needs one", type),
           "give [span] with length_m and a tension");
  }
}

void check_rated_strength(const Scene& scene, const char* key_path) {
  if (scene.conductor && scene.conductor->strand.rated_strength > 0) return;
  refuse(scene.source, key_path, "needs the rated strength of the conductor",
         "give conductor.rated_strength_kN, or tension_kN instead");
}

Vector3 leg(const Span& span, std::size_t i) {
  return {span.nodes[i + 1][0] - span.nodes[i][0], span.nodes[i + 1][1] - span.nodes[i][1],
          span.nodes[i + 1][2] - span.nodes[i][2]};
}

/// Whether two legs run on in the same direction, to a microradian: corners are written with few digits.
bool runs_on(const Vector3& a, const Vector3& b) {
  const double sine = std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  return sine <= 1e-6 * cosine;
}

/// What is left out of the motion must not be what carries it.
void check_what_is_left_out(const Scene& scene) {
  const Span& span = *scene.span;
  for (std::size_t i = 1; !span.torsion && i + 1 < span.nodes.size(); ++i) {
    if (runs_on(leg(span, i - 1), leg(span, i))) continue;
    refuse(scene.source, "span.torsion",
           fmt::format("leaves out torsion, and span.nodes_m[{}] is a bend: a bend needs torsion", i),
           "remove it, or give corners on a straight line");
  }
  if (!span.condense_axial) return;
  const char* excluded = !span.nodes.empty()           ? "span.nodes_m"
                         : span.gravity                ? "span.gravity"
                         : span.height_difference != 0 ? "span.height_difference_m"
                                                       : nullptr;
  if (!excluded) return;
  refuse(scene.source, "span.condense_axial", fmt::format("excludes `{}`, and both are given", excluded),
         "remove one of the two: axial unknowns are condensed for transverse motion about a straight level span only");
}

/// A law of given stiffness that the tension would stretch beyond what beams of small strain can tell.
void check_strain(const Scene& scene) {
  constexpr double most = 0.5;
  const std::optional<double> EA = scene.section.EA, tension = scene.span->tension;
  if (!EA || !tension || *tension <= most * *EA) return;
  refuse(scene.source, "section.EA_N",
         fmt::format("the tension of {:g} N would stretch the span by {:g} of its length", *tension, *tension / *EA),
         fmt::format("give at least {:g} N, or a smaller tension", *tension / most));
}

/// A line of several spans.
void check_suspensions(const Scene& scene) {
  const Span& span = *scene.span;
  if (span.supports.empty()) return;
  const auto refuse_beside = [&](bool given, const char* key, const char* why, const char* remedy) {
    if (given) refuse(scene.source, key, why, remedy);
  };
  const char* one_span = "belongs to one span, and span.support makes a line of several";
  refuse_beside(!span.nodes.empty(), "span.nodes_m", one_span, "give length_m");
  refuse_beside(span.height_difference != 0, "span.height_difference_m", one_span, "leave it out");
  refuse_beside(span.condense_axial, "span.condense_axial",
                "one tension for all, and the spans of a line have their own", "leave it out");
  refuse_beside(span.unstressed_length.has_value(), "span.unstressed_length_m", one_span, "give tension_kN");
  double last = 0;
  for (std::size_t i = 0; i < span.supports.size(); ++i) {
    const SuspensionKeys& support = span.supports[i];
    const std::string path = fmt::format("span.support[{}]", i);
    if (support.at <= last || support.at >= *span.length) {
      refuse(scene.source, path + ".at_m", "does not lie between its neighbours",
             "give the suspensions from left to right, between the ends");
    }
    last = support.at;
  }
}

void check_span(const Scene& scene) {
  const Span& span = *scene.span;
  if (span.tension_rts) check_rated_strength(scene, "span.tension_rts");
  if (!span.nodes.empty()) {
    if (span.height_difference != 0) {
      refuse(scene.source, "span.height_difference_m", "excludes `span.nodes_m`, which holds the heights",
             "remove it, or give length_m instead of nodes_m");
    }
    if (span.nodes.size() < 2) {
      refuse(scene.source, "span.nodes_m", "must hold at least two corners",
             "give [[x, y, z], [x, y, z], ...] in metres");
    }
    for (std::size_t i = 0; i < span.nodes.size(); ++i) {
      const std::string path = fmt::format("span.nodes_m[{}]", i);
      if (i > 0 && span.nodes[i] == span.nodes[i - 1]) {
        refuse(scene.source, path, "lies on the corner before it", "remove one of the two");
      }
      if (span.dimension == Dimension::planar && span.nodes[i][2] != 0) {
        refuse(scene.source, path, "leaves the plane of x and y", "set z to 0, or give dimension = \"spatial\"");
      }
    }
  } else if (!span.tension && !span.tension_rts && !span.unstressed_length && !sets_tension(scene.analysis)) {
    refuse(scene.source, "span", "its tension is missing",
           "give exactly one of tension_kN (0 for none), tension_rts, unstressed_length_m");
  }
  if (span.wind > 0 && (!span.gravity || span.dimension == Dimension::planar || span.height_difference != 0)) {
    refuse(scene.source, "span.wind_m_per_s", "swings a hanging, level span out of its plane",
           "give gravity = true, dimension = \"spatial\" and no height_difference_m, or remove it");
  }
  if (span.wind > 0 && !scene.conductor) {
    refuse(scene.source, "span.wind_m_per_s", "meets the diameter of a conductor, and there is none",
           "give [conductor], or remove it");
  }
  check_suspensions(scene);
  check_strain(scene);
  check_what_is_left_out(scene);
  if ((needs_mass(scene.analysis) || span.gravity) && !mass_per_length(scene)) {
    const char* path =
        scene.conductor && needs_strand(scene.section.law) ? "conductor.mass_kg_per_m" : "section.mass_kg_per_m";
    refuse(scene.source, path, "is missing, and the span needs a mass",
           "give the mass per length in kilograms per metre");
  }
  if (!needs_strand(scene.section.law) && span.dimension == Dimension::spatial && span.torsion && !scene.section.GJ) {
    refuse(scene.source, "section.GJ_N_m2", "is missing, and the span twists",
           "give the torsional stiffness in N m^2, or span.torsion = false");
  }
}

/// `key_path` needs a force at a point as the first static-force load.
void check_first_force(const Scene& scene, const char* key_path) {
  const auto first = first_static_force(scene);
  if (!first) refuse(scene.source, key_path, "needs a load", "give a [[load]] with type = \"static-force\"");
  const Load& load = scene.loads[*first];
  const char* fault = !load.at            ? "has no point"
                      : load.is_moment()  ? "is a moment"
                      : load.value() == 0 ? "is 0"
                                          : nullptr;
  if (!fault) return;
  refuse(scene.source, fmt::format("load[{}]", *first),
         fmt::format("{}, and `{}` needs a force at a point as the first static-force load", fault, key_path),
         "give at_m and a force_N other than 0, or such a load before it");
}

void check_static(const Scene& scene) {
  if (!scene.is<StaticAnalysis>()) return;
  const auto grows = [](const Load& load) { return load.type == LoadType::static_force && load.value() != 0; };
  if (scene.static_.control != Control::load && std::ranges::none_of(scene.loads, grows)) {
    refuse(scene.source, "static.control", "needs a load that is not 0",
           "give a [[load]] with type = \"static-force\", or control = \"load\"");
  }
  if (scene.static_.control == Control::displacement) check_first_force(scene, "static.control");
  if (scene.as<StaticAnalysis>().slip_map_loads.empty()) return;
  if (!needs_strand(scene.section.law)) {
    refuse(scene.source, "analysis.slip_map_loads_N",
           fmt::format("asks for wires, and section.law = \"{}\" has none", name_of(scene.section.law)),
           "remove it, or choose a law of strands such as \"return-map\"");
  }
  check_first_force(scene, "analysis.slip_map_loads_N");
}

void check_transient(const Scene& scene) {
  if (!scene.is<TransientAnalysis>()) return;
  if (scene.integrator.step == StepRule::fixed && !scene.integrator.step_size) {
    refuse(scene.source, "integrator.step_s", "is missing, and analysis.type = \"transient\" has no cycle to divide",
           "give the time step in seconds");
  }
  const std::vector<double>& probes = scene.as<TransientAnalysis>().probes;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (probes[i] <= scene.span->total_length() * (1 + 1e-12)) continue;
    refuse(scene.source, fmt::format("analysis.probes_m[{}]", i), "lies outside the span",
           fmt::format("give a distance from the left support between 0 and {} metres", scene.span->total_length()));
  }
}

void check_analysis(const Scene& scene) {
  if (const auto* section = std::get_if<SectionAnalysis>(&scene.analysis)) {
    const bool tension = !section->tensions.empty() || !section->tensions_rts.empty();
    if (!section->tensions_rts.empty()) check_rated_strength(scene, "analysis.tension_rts");
    if (!tension && !section->path) {
      refuse(scene.source, "analysis", "the tension of the section is missing",
             "give tension_kN or tension_rts, a number or a list");
    }
  }
  if (const auto* decay = std::get_if<DecayAnalysis>(&scene.analysis);
      decay && decay->antinode_amplitude.has_value() == scene.initial.has_value()) {
    refuse(scene.source, "analysis.antinode_amplitude_mm",
           scene.initial ? "excludes [initial], and both are given" : "is missing, and nothing else starts the motion",
           "give exactly one: antinode_amplitude_mm, or [initial] with a velocity");
  }
  const bool cycle = std::ranges::any_of(scene.loads, &Load::is_harmonic) ||
                     std::ranges::any_of(scene.motions, &Motion::is_harmonic) || !scene.winds.empty();
  if (needs_drive(scene.analysis) && !cycle) {
    refuse(scene.source, "analysis.type", "has no load that sets the cycle",
           "give a [[load]] with type = \"harmonic-force\", or a [[motion]] with type = \"harmonic-motion\", and its "
           "frequency");
  }
}

void check_criterion(const Criterion& criterion, const Source& source) {
  const std::string path = "accept." + spell_key(criterion.path);
  if (const auto fault = find_path_fault(criterion.path)) {
    refuse(source, path, *fault, "write a path into summary.json, for example \"cycles[-1].kinetic_J\"");
  }
  const bool tolerance = criterion.relative || criterion.absolute;
  const bool number = criterion.expected && std::holds_alternative<double>(*criterion.expected);
  if (tolerance && !number) {
    refuse(source, path, "has a deviation but no expected number", "remove relative or absolute, or give expected");
  }
  if (number && !tolerance && criterion.path != "exit_code") {
    refuse(source, path, "does not say how far the value may be from the expected one",
           "give relative (a part of the expected value) or absolute (in its unit)");
  }
  if (criterion.relative && std::get<double>(*criterion.expected) == 0) {
    refuse(source, path + ".relative", "allows nothing where 0 is expected",
           "give absolute, in the unit of the quantity");
  }
}

/// What is varied is another case: all that is modelled stands there.
void check_tradeoff(const Scene& scene) {
  for (const auto& [path, entry] : scene.source.entries) {
    const std::string table = path.substr(0, path.find_first_of(".["));
    if (table == "title" || table == "analysis" || table == "accept") continue;
    refuse(scene.source, table, "belongs into the base of analysis.type = \"tradeoff\"",
           "move it to the file that analysis.base names, or name its keys as knobs");
  }
  const TradeoffAnalysis& tradeoff = scene.as<TradeoffAnalysis>();
  for (std::size_t i = 0; i < tradeoff.knobs.size(); ++i) {
    if (tradeoff.knobs[i].values.size() > 1) continue;
    refuse(scene.source, fmt::format("analysis.knob[{}].values", i), "has one value, and nothing to compare it to",
           "give at least two, from coarse to fine; the last is that of the reference");
  }
  if (const auto fault = find_path_fault(tradeoff.quantity)) {
    refuse(scene.source, "analysis.quantity", *fault,
           "write a path into the summary of the base, for example \"steady.friction_dissipation_J\"");
  }
}

void check_accuracy(const Scene& scene) {
  if (!scene.accuracy) return;
  if (!scene.is<DecayAnalysis>() && !scene.is<ForcedAnalysis>() && !scene.is<SweepAnalysis>() &&
      !scene.is<SelfDampingAnalysis>()) {
    refuse(scene.source, "accuracy", fmt::format("is no key of analysis.type = \"{}\" yet", word_of(scene.analysis)),
           "remove it: decay, forced, sweep and self-damping take it");
  }
  const std::optional<double> target = target_error(scene);
  if (!target || *target < least_target_error || *target > largest_target_error) {
    refuse(scene.source, "accuracy", "names no error of the dissipation",
           fmt::format("write \"fast\", \"balanced\", \"reference\", or a part of the dissipation from {:g} to {:g}",
                       least_target_error, largest_target_error));
  }
  if (scene.integrator.step != StepRule::fixed || scene.integrator.step_size) {
    refuse(scene.source, scene.integrator.step_size ? "integrator.step_s" : "integrator.step",
           "and accuracy would both choose the time step", "remove one of them, or give integrator.steps_per_cycle");
  }
}

void check_criteria(const Scene& scene) {
  Refusals refusals;
  for (const Criterion& criterion : scene.accept.criteria) {
    refusals.hold([&] { check_criterion(criterion, scene.source); });
  }
  refusals.pass_on();
}

void check_output(const Scene& scene) {
  if (!scene.output) return;
  if (scene.is<DecayAnalysis>() || scene.is<ForcedAnalysis>() || scene.is<TransientAnalysis>()) return;
  refuse(scene.source, "output",
         fmt::format("writes a span that moves in time, not that of analysis.type = \"{}\"", word_of(scene.analysis)),
         "remove the table, or choose \"decay\", \"forced\" or \"transient\"");
}

/// What needs a sound conductor and a sound span to be told from a consequence of either.
void check_on_span(Scene& scene, Refusals& refusals) {
  refusals.hold([&] { resolve_loads(scene); });
  refusals.hold([&] { resolve_dampers(scene); });
  refusals.hold([&] { resolve_stretches(scene); });
  refusals.hold([&] { fill_laboratory_grid(scene); });
  for (const auto check : {check_analysis, check_static, check_transient, check_periodic, check_sweep, check_losses,
                           check_wind, check_self_damping, check_accuracy, check_output}) {
    refusals.hold([&] { check(scene); });
  }
}

}  // namespace

void resolve_scene(Scene& scene) {
  Refusals refusals;
  if (scene.is<TradeoffAnalysis>()) {
    refusals.hold([&] { check_tradeoff(scene); });
    refusals.hold([&] { check_criteria(scene); });
    refusals.tell();
    return;
  }
  bool sound = refusals.hold([&] { check_tables(scene); });
  if (scene.conductor) sound = refusals.hold([&] { resolve_conductor(*scene.conductor, scene.source); }) && sound;
  if (sound && scene.span) sound = refusals.hold([&] { check_span(scene); });
  if (sound) check_on_span(scene, refusals);
  refusals.hold([&] { check_criteria(scene); });
  refusals.tell();
  Integrator& integrator = scene.integrator;
  // A bench compares small losses: it takes the method that damps least, unless the case names one.
  if (scene.is<SelfDampingAnalysis>() && !scene.source.find("integrator.method")) {
    integrator.method = Method::generalized_alpha;
  }
  if (integrator.step == StepRule::fixed && !integrator.step_size && !integrator.steps_per_cycle) {
    integrator.steps_per_cycle = default_steps_per_cycle;
  }
  check_plausible(scene);
}

}  // namespace strandyn::casefile
