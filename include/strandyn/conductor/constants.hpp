#pragma once
/// \file Linear constants of the strand section.
///
///     EA      = sum n cos^3 a EA_w                                                             [FM2016 (A.1)]
///     GJ      = sum n { EI_w/(1+nu) [cos^3 a + (1+nu) sin^2 a cos a] + sin^2 a cos a R^2 EA_w }        (A.2)
///     C_AT    = sum n R sin a cos^2 a EA_w                                                             (A.3)
///     EI_min  = sum n/2 cos a EI_w [1 + cos^2 a + sin^2 a/(1+nu)]                 (22) in (27); (32) misprints sin a
///     EI_max  = EI_min + sum n/2 cos^3 a EA_w R^2                                                      (37)
///
/// Limits: all lay angles zero and one wire gives EA_w, GJ = EI_w/(1+nu), EI_min = EI_max = EI_w.

#include <vector>

#include "strandyn/conductor/strand.hpp"

namespace strandyn::conductor {

struct SectionConstants {
  double EA = 0;                    ///< [N]
  double GJ = 0;                    ///< [N m^2]
  double C_AT = 0;                  ///< [N m]
  double EI_min = 0;                ///< [N m^2] every wire slips
  double EI_max = 0;                ///< [N m^2] every wire sticks
  std::vector<double> EI_friction;  ///< [N m^2] per layer, core first: what sticking adds; sums to EI_max - EI_min

  /// [N] axial stiffness when the strand is free to twist.
  double EA_free_end() const { return EA - C_AT * C_AT / GJ; }
};

SectionConstants section_constants(const Strand& strand);

}  // namespace strandyn::conductor
