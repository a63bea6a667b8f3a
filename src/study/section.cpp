#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <numbers>

#include "entries.hpp"
#include "outlook.hpp"
#include "section_parts.hpp"

namespace strandyn::study {

using casefile::Scene;

AxialState axial_state(const build::SectionNumbers& n, casefile::Twist twist, double tension) {
  if (twist == casefile::Twist::held || n.C_AT == 0) return {.strain = tension / n.EA, .twist = 0};
  // Free to twist: M1 = C_AT eps + GJ chi1 = 0.
  const double strain = tension / (n.EA - n.C_AT * n.C_AT / n.GJ);
  return {.strain = strain, .twist = -n.C_AT * strain / n.GJ};
}

section::Dimension dimension_of(const Scene& scene) {
  const bool twists = scene.as<casefile::SectionAnalysis>().twist == casefile::Twist::free;
  return twists || scene.section.axial_resultants ? section::Dimension::spatial : section::Dimension::planar;
}

namespace {

class Section final : public Analysis {
 public:
  explicit Section(const Scene& scene) : scene_(scene) {
    if (scene.as<casefile::SectionAnalysis>().path) {
      path_ = check_path(scene);
    } else {
      check_cycles(scene);
    }
    check_wires(scene);
  }

  Outlook outlook() override {
    Outlook outlook;
    expect(outlook, path_ ? 2.0 * static_cast<double>(path_->rows()) : expected_of_cycles(scene_), 1);
    outlook.seconds_per_evaluation = seconds_of_evaluation();
    return outlook;
  }

  void run(const Hooks&, Outcome& outcome) override {
    path_ ? run_path(scene_, *path_, outcome) : run_cycles(scene_, outcome);
    list_wires(scene_, outcome);
  }

 private:
  /// [s] around a cycle in which wires slip.
  double seconds_of_evaluation() const {
    constexpr int steps = 64;
    const auto law = build::build_law(scene_, dimension_of(scene_));
    const std::vector<double> tensions = casefile::section_tensions(scene_);
    const auto& amplitudes = scene_.as<casefile::SectionAnalysis>().curvature_amplitudes;
    const double amplitude = amplitudes.empty() ? 0.05 : std::ranges::max(amplitudes);
    const AxialState axial =
        axial_state(build::section_numbers(scene_), casefile::Twist::held, tensions.empty() ? 0 : tensions.front());
    section::Field strains(law->dimension(), 1);
    section::Field stresses(law->dimension(), 1);
    section::StepEnergy energy(1);
    strains[section::Component::axial][0] = axial.strain;
    section::History history = law->start(strains);
    const auto start = std::chrono::steady_clock::now();
    for (int step = 1; step <= steps; ++step) {
      strains[section::Component::bending2][0] = amplitude * std::sin(2 * std::numbers::pi * step / steps);
      law->commit(history, strains, energy);
      law->respond(history, strains, stresses, nullptr);
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / (2 * steps);
  }

  const Scene& scene_;
  std::optional<results::Table> path_;
};

}  // namespace

std::vector<results::MemberNote> notes_of_section() {
  std::vector<results::MemberNote> notes = notes_of_cycles();
  std::ranges::move(notes_of_path(), std::back_inserter(notes));
  std::ranges::move(notes_of_wires(), std::back_inserter(notes));
  return notes;
}

std::unique_ptr<Analysis> prepare_section(const Scene& scene) {
  return std::make_unique<Section>(scene);
}

}  // namespace strandyn::study
