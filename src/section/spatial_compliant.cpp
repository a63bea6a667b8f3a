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
  namespace kernel_of = spatial_compliant_kernel;
  const std::size_t block_size = kernel_of::rows_of_block(c_) * block_lanes;
  History history = kernel::blank_history(strains.points(), kernel_of::rows_of_block(c_));
  for (std::size_t i = 0; i < strains.points(); ++i) {
    double* at = history.data.data() + i / block_lanes * block_size + i % block_lanes;
    at[kernel_of::peak_strain * block_lanes] = strains[axial][i];
    compliant_kernel::contact_stiffness(c_.angle, strains[axial][i],
                                        {.value = at + kernel_of::stiffness * block_lanes});
  }
  // A strand that is brought straight to a curvature slips on the way; that is part of getting there, not of a step.
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
