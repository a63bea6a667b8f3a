#include "scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "strandyn/casefile/read.hpp"

namespace strandyn::extremes {

Run::Run(const std::string& text, const std::vector<std::string>& overrides)
    : Run(casefile::read_scene_text(text, "extremes.toml", overrides)) {}

Run::Run(const casefile::Scene& scene) : result_(study::run_case(scene)) {
  if (result_.exit_code != ExitCode::done) throw ComputationError(result_.message);
}

double Run::at(const std::string& path) const {
  const casefile::Acceptance wish{{{.path = path, .above = -std::numeric_limits<double>::infinity()}}};
  const auto verdicts = casefile::judge(wish, result_.summary, static_cast<int>(result_.exit_code));
  if (!verdicts.front().got) throw ComputationError(path + ": " + verdicts.front().found);
  return *verdicts.front().got;
}

const results::Table& Run::table(const std::string& file) const {
  const auto named = std::ranges::find(result_.tables, file, &results::NamedTable::file);
  if (named == result_.tables.end()) throw ComputationError("the run has left no " + file);
  return named->table;
}

double Run::energy_drift() const {
  const results::Table& t = table("energies.csv");
  const auto &kinetic = t.column("kinetic_J"), &elastic = t.column("elastic_J");
  const auto& work = t.column("external_work_J");
  const double start = kinetic.front() + elastic.front();
  double drift = 0;
  for (std::size_t i = 1; i < t.rows(); ++i)
    drift = std::max(drift, std::abs(kinetic[i] + elastic[i] - start - work[i]));
  return drift / start;
}

double Run::energy_above_input(double least_scale) const {
  const results::Table& t = table("energies.csv");
  const auto &kinetic = t.column("kinetic_J"), &elastic = t.column("elastic_J");
  const auto& work = t.column("external_work_J");
  const double start = kinetic.front() + elastic.front();
  double excess = -std::numeric_limits<double>::infinity(), largest = least_scale;
  for (std::size_t i = 1; i < t.rows(); ++i) {
    const double energy = kinetic[i] + elastic[i];
    if (!std::isfinite(energy)) return energy;
    excess = std::max(excess, energy - start - work[i]);
    largest = std::max({largest, std::abs(energy), std::abs(start + work[i])});
  }
  return excess / largest;
}

Cost evaluations(const Run& extreme, const Run& ordinary) {
  return {.extreme = extreme.evaluations(), .ordinary = ordinary.evaluations(), .unit = "section evaluations"};
}

Cost evaluations_per_step(const Run& extreme, const Run& ordinary) {
  return {.extreme = extreme.evaluations() / extreme.steps(),
          .ordinary = ordinary.evaluations() / ordinary.steps(),
          .unit = "section evaluations of a step"};
}

std::string curlew_span(const std::string& tables) {
  return "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.7\n[section]\nlaw = \"return-map\"\n"
         "[span]\nlength_m = 10\ntension_rts = 0.15\nelements = 40\n" +
         tables;
}

std::string elastic_span(const std::string& tables) {
  return "[section]\nlaw = \"elastic\"\nEA_N = 1e7\nEI_N_m2 = 10\nmass_kg_per_m = 1\n"
         "[span]\nlength_m = 10\ntension_kN = 4\nelements = 20\ngrading = \"uniform\"\nleft = \"pinned\"\n"
         "right = \"pinned\"\nmass = \"consistent\"\nrotary_inertia = false\ncondense_axial = true\n" +
         tables;
}

}  // namespace strandyn::extremes
