#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "section_parts.hpp"

namespace strandyn::study {

using casefile::Scene;
using section::Component;
using section::Field;

namespace {

constexpr std::array<const char*, 5> known_columns = {"axial_strain", "tension_N", "torsion_per_m", "curvature_2_per_m",
                                                      "curvature_3_per_m"};

results::Table read_path(const Scene& scene) {
  const std::filesystem::path beside = std::filesystem::path(scene.source.file).parent_path();
  results::Table path = results::read_csv(beside / *scene.as<casefile::SectionAnalysis>().path);
  std::string names;
  for (const char* name : known_columns) names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
  for (const std::string& name : path.names()) {
    if (std::find(known_columns.begin(), known_columns.end(), name) == known_columns.end()) {
      refuse(scene.source, "analysis.path", fmt::format("the file has an unknown column `{}`", name),
             "use the columns " + names);
    }
  }
  if (path.has("axial_strain") && path.has("tension_N")) {
    refuse(scene.source, "analysis.path", "the file gives both axial_strain and tension_N", "keep one of the two");
  }
  if (path.rows() == 0) refuse(scene.source, "analysis.path", "the file has no rows", "give one row per step");
  return path;
}

/// Strains of one row. What the file leaves out is zero; a tension is turned into strain by the linear part, which is
/// all there is unless bending forces of the wires count in N.
class Rows {
 public:
  Rows(const Scene& scene, const results::Table& path) : scene_(scene), path_(path) {
    const std::vector<double> tensions = casefile::section_tensions(scene);
    if (!tensions.empty()) tension_ = tensions.front();
  }

  std::array<double, section::component_count> operator[](std::size_t row) const {
    const double torsion = value("torsion_per_m", row, 0);
    double strain = value("axial_strain", row, 0);
    if (!path_.has("axial_strain")) {
      const build::SectionNumbers n = build::section_numbers(scene_);
      strain = (value("tension_N", row, tension_) - n.C_AT * torsion) / n.EA;
    }
    return {strain, torsion, value("curvature_2_per_m", row, 0), value("curvature_3_per_m", row, 0)};
  }
  /// [N] that the row asks for; nothing where it gives the strain.
  std::optional<double> tension(std::size_t row) const {
    if (path_.has("axial_strain")) return std::nullopt;
    return value("tension_N", row, tension_);
  }

 private:
  double value(const char* name, std::size_t row, double otherwise) const {
    return path_.has(name) ? path_.column(name)[row] : otherwise;
  }

  const Scene& scene_;
  const results::Table& path_;
  double tension_ = 0;  // [N] of the analysis, for a file without its own
};

/// The strain at which the section, after what its wires have done so far, carries the tension. N goes with the strain
/// by EA and a little more: a few steps of the secant.
void meet_tension(const section::Law& law, const section::History& memory, double tension, double EA, Field& strains,
                  Field& stresses) {
  constexpr int most = 50;
  constexpr double precision = 1e-11;
  double& strain = strains[Component::axial][0];
  for (int round = 0; round < most; ++round) {
    law.respond(memory, strains, stresses, nullptr);
    const double missing = tension - stresses[Component::axial][0];
    if (std::abs(missing) <= precision * std::max(std::abs(tension), 1.0)) return;
    strain += missing / EA;
  }
}

/// Work of the resultants between two states, by the trapezoidal rule. [J/m]
double work_between(const std::vector<double>& from, const std::vector<double>& to) {
  double work = 0;
  for (std::size_t c = 0; c < section::component_count; ++c) {
    work += (from[section::component_count + c] + to[section::component_count + c]) / 2 * (to[c] - from[c]);
  }
  return work;
}

/// The last state of the path and what it took.
struct PathRow {
  std::size_t steps = 0;
  double stored = 0, dissipated = 0, quadrature_error = 0, work = 0, unaccounted = 0;
};
template <class V>
void members(V& v, PathRow& p) {
  v.value("steps", p.steps, {.what = "rows of the file"});
  v.value("stored_J_per_m", p.stored, {.what = "energy of the last state"});
  v.value("dissipated_J_per_m", p.dissipated, {.what = "along the path", .shown = "dissipated"});
  v.value("quadrature_error_J_per_m", p.quadrature_error, {.what = "error of the steps"});
  v.value("work_J_per_m", p.work, {.what = "of the resultants along the path, by the trapezoidal rule over its rows"});
  v.value(
      "unaccounted_work_J_per_m", p.unaccounted,
      {.what = "work that is neither stored nor dissipated: what `axial_resultants` adds to N and M1 has no energy in "
               "the law"});
}
struct PathSummary {
  PathRow path;
};
template <class V>
void members(V& v, PathSummary& s) {
  v.record("path", s.path, {.what = "the path as a whole"});
}

section::Dimension dimension_of_path(const Scene& scene, const results::Table& path) {
  const bool planar = !path.has("torsion_per_m") && !path.has("curvature_3_per_m") && !scene.section.axial_resultants;
  return planar ? section::Dimension::planar : section::Dimension::spatial;
}

}  // namespace

std::vector<results::MemberNote> notes_of_path() {
  return results::ReferenceWriter::of<PathSummary>();
}

results::Table check_path(const Scene& scene) {
  results::Table path = read_path(scene);
  build::build_law(scene, dimension_of_path(scene, path));
  return path;
}

void run_path(const Scene& scene, const results::Table& path, const Hooks& hooks, Outcome& outcome) {
  const Rows rows(scene, path);
  const section::Dimension dimension = dimension_of_path(scene, path);
  const auto law = build::build_law(scene, dimension);
  Field strains(dimension, 1);
  Field stresses(dimension, 1);
  section::StepEnergy energy(1);
  const auto move_to = [&](std::size_t row) {
    const auto values = rows[row];
    for (std::size_t c = 0; c < section::component_count; ++c) {
      if (carries(dimension, Component{c})) strains[Component{c}][0] = values[c];
    }
  };

  results::Table history({"axial_strain", "torsion_per_m", "curvature_2_per_m", "curvature_3_per_m", "N_N", "M1_N_m",
                          "M2_N_m", "M3_N_m", "stored_J_per_m", "dissipated_J_per_m", "quadrature_error_J_per_m"});
  move_to(0);
  section::History memory = law->start(strains);
  section::Effort effort;
  double dissipated = 0;
  double quadrature_error = 0;
  double work = 0, first_stored = 0, dissipated_at_start = 0;
  std::vector<double> before;
  const double EA = build::section_numbers(scene).EA;
  for (std::size_t row = 0; row < path.rows(); ++row) {
    move_to(row);
    const auto tension = rows.tension(row);
    if (scene.section.axial_resultants && tension) meet_tension(*law, memory, *tension, EA, strains, stresses);
    effort += law->commit(memory, strains, energy);
    effort += law->respond(memory, strains, stresses, nullptr);
    dissipated += energy.dissipated[0];
    quadrature_error += energy.quadrature_error[0];
    std::vector<double> line;
    for (std::size_t c = 0; c < section::component_count; ++c) {
      line.push_back(carries(dimension, Component{c}) ? strains[Component{c}][0] : 0.0);
    }
    for (std::size_t c = 0; c < section::component_count; ++c) {
      line.push_back(carries(dimension, Component{c}) ? stresses[Component{c}][0] : 0.0);
    }
    if (before.empty()) {
      first_stored = energy.stored[0];
      dissipated_at_start = dissipated;
    } else {
      work += work_between(before, line);
    }
    before = line;
    line.insert(line.end(), {energy.stored[0], dissipated, quadrature_error});
    history.append(line);
    if (row + 1 == path.rows() || !hooks.stop || !hooks.stop()) continue;
    outcome.exit_code = ExitCode::interrupted;
    outcome.message = fmt::format("interrupted after {} of {} rows of the path; they are kept", row + 1, path.rows());
    break;
  }
  outcome.tell(PathSummary{.path = {.steps = history.rows(),
                                    .stored = energy.stored[0],
                                    .dissipated = dissipated,
                                    .quadrature_error = quadrature_error,
                                    .work = work,
                                    .unaccounted = work - (energy.stored[0] - first_stored) -
                                                   (dissipated - dissipated_at_start) + quadrature_error}});
  outcome.cost.steps = history.rows();
  outcome.cost.section_evaluations = effort.evaluations;
  outcome.cost.section_sweeps = effort.sweeps;
  outcome.tables.push_back({.file = "path.csv", .table = std::move(history)});
  outcome.figures.push_back({.name = "path",
                             .title = "Moment along the path",
                             .table = "path.csv",
                             .x = "curvature_2_per_m",
                             .y = {"M2_N_m"},
                             .caption = "Bending moment against curvature about the same axis."});
  outcome.figures.push_back({.name = "path_dissipated",
                             .title = "Dissipated along the path",
                             .table = "path.csv",
                             .x = "curvature_2_per_m",
                             .y = {"dissipated_J_per_m"},
                             .caption = "What friction has taken from a metre since the start."});
}

}  // namespace strandyn::study
