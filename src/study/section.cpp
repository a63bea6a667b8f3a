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
    outlook.seconds_per_evaluation = 1e-6;  // a march around the lay, most of them slipping
    return outlook;
  }

  void run(const Hooks&, Outcome& outcome) override {
    path_ ? run_path(scene_, *path_, outcome) : run_cycles(scene_, outcome);
    list_wires(scene_, outcome);
  }

 private:
  const Scene& scene_;
  std::optional<results::Table> path_;
};

}  // namespace

std::unique_ptr<Analysis> prepare_section(const Scene& scene) {
  return std::make_unique<Section>(scene);
}

}  // namespace strandyn::study
