#include <algorithm>
#include <iterator>

#include "entries.hpp"
#include "outlook.hpp"
#include "section_parts.hpp"
#include "strandyn/exact/full_slip.hpp"

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

  void run(const Hooks& hooks, Outcome& outcome) override {
    path_ ? run_path(scene_, *path_, hooks, outcome) : run_cycles(scene_, hooks, outcome);
    if (outcome.exit_code == ExitCode::done) list_wires(scene_, hooks.stop, outcome);
  }

 private:
  /// [s] the mean over the curvatures that are asked for, at the highest tension.
  double seconds_of_evaluation() const {
    const auto& keys = scene_.as<casefile::SectionAnalysis>();
    const std::vector<double> tensions = casefile::section_tensions(scene_);
    const double tension = tensions.empty() ? 0 : std::ranges::max(tensions);
    std::vector<double> amplitudes = keys.curvature_amplitudes;
    for (double over : keys.relative_amplitudes) {
      amplitudes.push_back(over * exact::full_slip(scene_.conductor->strand, tension).chi_0);
    }
    if (amplitudes.empty()) amplitudes = {0.05};
    const auto law = build::build_law(scene_, dimension_of(scene_));
    // All loops are led together, as the kernels want it.
    const std::size_t loops = amplitudes.size() * std::max<std::size_t>(1, tensions.size());
    double sum = 0;
    for (double amplitude : amplitudes) {
      sum += slipping_time(*law, loops,
                           {.axial_strain = tension / build::section_numbers(scene_).EA,
                            .amplitude = amplitude,
                            .steps = keys.steps_per_cycle});
    }
    return sum / static_cast<double>(amplitudes.size());
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
