#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "document.hpp"
#include "resolve.hpp"

namespace strandyn::casefile {
namespace {

bool is_strand_law(Law law) {
  return law != Law::elastic && law != Law::multilinear;
}

bool needs_span(AnalysisType type) {
  return type != AnalysisType::section && type != AnalysisType::axial_torsion;
}

bool is_dynamic(AnalysisType type) {
  return type == AnalysisType::modes || type == AnalysisType::decay || type == AnalysisType::forced;
}

void check_tables(const Scene& scene) {
  const std::string type = fmt::format("analysis.type = \"{}\"", name_of(scene.analysis.type));
  if (!scene.conductor && is_strand_law(scene.section.law)) {
    refuse(scene.source, "conductor",
           fmt::format("is missing, and section.law = \"{}\" needs one", name_of(scene.section.law)),
           "give [conductor] with a catalogue name or [[conductor.layer]] tables, or the law \"elastic\"");
  }
  if (!scene.conductor && scene.analysis.type == AnalysisType::axial_torsion) {
    refuse(scene.source, "conductor", fmt::format("is missing, and {} needs one", type),
           "give [conductor] with a catalogue name or [[conductor.layer]] tables");
  }
  if (!scene.span && needs_span(scene.analysis.type)) {
    refuse(scene.source, "span", fmt::format("is missing, and {} needs one", type),
           "give [span] with length_m and a tension");
  }
}

void check_rated_strength(const Scene& scene, const char* key_path) {
  if (scene.conductor && scene.conductor->strand.rated_strength > 0) return;
  refuse(scene.source, key_path, "needs the rated strength of the conductor",
         "give conductor.rated_strength_kN, or tension_kN instead");
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
  } else if (!span.tension && !span.tension_rts && !span.unstressed_length) {
    refuse(scene.source, "span", "its tension is missing",
           "give exactly one of tension_kN (0 for none), tension_rts, unstressed_length_m");
  }
  if ((is_dynamic(scene.analysis.type) || span.gravity) && !mass_per_length(scene)) {
    const char* path =
        scene.conductor && is_strand_law(scene.section.law) ? "conductor.mass_kg_per_m" : "section.mass_kg_per_m";
    refuse(scene.source, path, "is missing, and the span needs a mass",
           "give the mass per length in kilograms per metre");
  }
  if (!is_strand_law(scene.section.law) && span.dimension == Dimension::spatial && span.torsion && !scene.section.GJ) {
    refuse(scene.source, "section.GJ_N_m2", "is missing, and the span twists",
           "give the torsional stiffness in N m^2, or span.torsion = false");
  }
}

void resolve_direction(Load& load, const std::string& path, const Scene& scene) {
  if (!load.direction) load.direction = load.is_moment() ? Vector3{0, 0, 1} : Vector3{0, 1, 0};
  auto& [x, y, z] = *load.direction;
  const double norm = std::hypot(x, y, z);
  if (norm == 0) refuse(scene.source, path + ".direction", "has no length", "give for example [0, 1, 0]");
  x /= norm;
  y /= norm;
  z /= norm;
  if (!scene.span || scene.span->dimension == Dimension::spatial) return;
  if (!load.is_moment() && z != 0) {
    refuse(scene.source, path + ".direction", "leaves the plane of x and y",
           "give a direction with z = 0, or span.dimension = \"spatial\"");
  }
  if (load.is_moment() && y != 0) {
    refuse(scene.source, path + ".direction", "turns the span out of the plane of x and y",
           "give the axis [0, 0, 1], or span.dimension = \"spatial\"");
  }
}

void resolve_load(Load& load, const std::string& path, const Scene& scene) {
  if (scene.span && load.at && *load.at > scene.span->total_length()) {
    refuse(scene.source, path + ".at_m", "lies outside the span",
           fmt::format("give a distance from the left support between 0 and {} metres", scene.span->total_length()));
  }
  resolve_direction(load, path, scene);
  for (std::size_t i = 1; i < load.history.size(); ++i) {
    if (load.history[i][0] <= load.history[i - 1][0]) {
      refuse(scene.source, fmt::format("{}.history[{}]", path, i), "its time does not come after the one before",
             "give rows of rising time");
    }
  }
}

void check_analysis(const Scene& scene) {
  const Analysis& analysis = scene.analysis;
  if (analysis.type == AnalysisType::section) {
    const bool tension = !analysis.section.tensions.empty() || !analysis.section.tensions_rts.empty();
    if (!analysis.section.tensions_rts.empty()) check_rated_strength(scene, "analysis.tension_rts");
    if (!tension && !analysis.section.path) {
      refuse(scene.source, "analysis", "the tension of the section is missing",
             "give tension_kN or tension_rts, a number or a list");
    }
  }
  if (analysis.type == AnalysisType::decay &&
      analysis.decay.antinode_amplitude.has_value() == scene.initial.has_value()) {
    refuse(scene.source, "analysis.antinode_amplitude_mm",
           scene.initial ? "excludes [initial], and both are given" : "is missing, and nothing else starts the motion",
           "give exactly one: antinode_amplitude_mm, or [initial] with a velocity");
  }
  const auto is_harmonic = [](const Load& load) { return load.type == LoadType::harmonic_force; };
  if (analysis.type == AnalysisType::forced && std::ranges::none_of(scene.loads, is_harmonic)) {
    refuse(scene.source, "analysis.type", "has no load that sets the cycle",
           "give a [[load]] with type = \"harmonic-force\" and its frequency");
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

}  // namespace

void resolve_scene(Scene& scene) {
  check_tables(scene);
  if (scene.conductor) resolve_conductor(*scene.conductor, scene.source);
  if (scene.span) check_span(scene);
  for (std::size_t i = 0; i < scene.loads.size(); ++i) resolve_load(scene.loads[i], fmt::format("load[{}]", i), scene);
  check_analysis(scene);
  Integrator& integrator = scene.integrator;
  if (integrator.step == StepRule::fixed && !integrator.step_size && !integrator.steps_per_cycle) {
    integrator.steps_per_cycle = 200;
  }
  for (const Criterion& criterion : scene.accept.criteria) check_criterion(criterion, scene.source);
}

}  // namespace strandyn::casefile
