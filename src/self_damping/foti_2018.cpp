#include "foti_2018.hpp"

#include "strandyn/exact/foti_2018.hpp"
#include "strandyn/exact/full_slip.hpp"

namespace strandyn::self_damping {

ClosedForm::ClosedForm(const casefile::Scene& scene)
    : scene_(scene),
      numbers_(build::section_numbers(scene)),
      mass_(*casefile::mass_per_length(scene)),
      given_(scene.as<casefile::SelfDampingAnalysis>().simplified) {}

PointResult ClosedForm::at(const Point& point, const Watch&) const {
  exact::Foti2018 conductor = {.EI = given_.EI.value_or(numbers_.EI_max - numbers_.EI_min),
                               .chi_0 = 0,
                               .mass_per_length = mass_,
                               .tension = point.tension};
  conductor.chi_0 = given_.chi_0_at_rated_strength
                        ? *given_.chi_0_at_rated_strength * point.tension / scene_.conductor->strand.rated_strength
                        : exact::full_slip(scene_.conductor->strand, point.tension).chi_0;
  if (conductor.chi_0 == 0) return {.self_damping = 0, .free_span = 0};  // no friction
  const double power =
      exact::self_damping(conductor, {.antinode_amplitude = point.antinode_amplitude, .frequency = point.frequency});
  return {.self_damping = power, .free_span = power};
}

}  // namespace strandyn::self_damping
