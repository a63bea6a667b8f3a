#include "strandyn/section/spatial_compliant.hpp"

#include <cmath>
#include <numbers>

#include "spatial_compliant_kernel.hpp"
#include "strandyn/conductor/constants.hpp"

namespace strandyn::section {

using enum Component;

SpatialCompliantLaw::SpatialCompliantLaw(const conductor::Strand& strand, const CompliantOptions& options) {
  c_.angle = compliant_coefficients(strand, options);
  c_.points = options.points;
  for (int i = 0; i < options.points / 2; ++i) {
    const double theta = (i + 0.5) * 2 * std::numbers::pi / options.points;
    // The same cosines as in the plane, to the bit.
    const std::vector<double>& quarter = c_.angle.planar.cosine;
    const auto at = static_cast<std::size_t>(i);
    c_.cosine.push_back(at < quarter.size() ? quarter[at] : -quarter[2 * quarter.size() - 1 - at]);
    c_.sine.push_back(std::sin(theta));
  }
  const conductor::SectionConstants constants = conductor::section_constants(strand);
  c_.EA = constants.EA;
  c_.GJ = constants.GJ;
  c_.C_AT = constants.C_AT;
  c_.EI_min = constants.EI_min;
}

History SpatialCompliantLaw::start(const Field& strains) const {
  using namespace spatial_compliant_kernel;
  History history = compliant_kernel::pressed_history(
      c_.angle, {.rows_of_block = rows_of_block(c_), .peak_strain = peak_strain, .stiffness = stiffness}, strains);
  // As in the plane: getting to a curvature is no step.
  StepEnergy ignored(strains.points());
  commit(history, strains, ignored);
  return history;
}

Effort SpatialCompliantLaw::respond(const History& history, const Field& strains, Field& stresses,
                                    TangentField* tangents) const {
  spatial_compliant_kernel::respond(c_, history.data.data(), kernel::spatial_view(strains),
                                    kernel::spatial_view(stresses, tangents));
  return {.evaluations = strains.points(), .sweeps = strains.points()};
}

Effort SpatialCompliantLaw::commit(History& history, const Field& strains, StepEnergy& energy) const {
  spatial_compliant_kernel::commit(c_, history.data.data(), kernel::spatial_view(strains), kernel::view(energy));
  return {.evaluations = strains.points(), .sweeps = strains.points()};
}

}  // namespace strandyn::section
