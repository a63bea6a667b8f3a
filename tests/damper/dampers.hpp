#pragma once
/// \file The two dampers of the cases, and messengers that slip.

#include <array>
#include <vector>

#include "strandyn/damper/damper.hpp"
#include "strandyn/section/linear_law.hpp"
#include "strandyn/section/multilinear.hpp"

namespace strandyn::test {

struct Stockbridge {
  std::array<damper::Arm, 2> arms;
  double mass_per_length;             // [kg/m]
  double EI;                          // [N m^2]
  std::array<double, 4> frequencies;  // [Hz] of the exact beam: both of arm 1, both of arm 2
};

inline const std::array<Stockbridge, 2>& stockbridges() {
  static const std::array<Stockbridge, 2> both = {
      {{.arms = {{{.length = 0.157, .weight = {.mass = 0.8633, .inertia = 1.815e-3, .eccentricity = 0.020}},
                  {.length = 0.113, .weight = {.mass = 0.7652, .inertia = 9.614e-4, .eccentricity = 0.010}}}},
        .mass_per_length = 7800 * 9.85e-5,
        .EI = 4.903,
        .frequencies = {11.260257, 38.108654, 18.334478, 66.245571}},
       {.arms = {{{.length = 0.150, .weight = {.mass = 2.65, .inertia = 8.41e-3, .eccentricity = 0.0163}},
                  {.length = 0.197, .weight = {.mass = 3.115, .inertia = 1.65e-2, .eccentricity = 0.0222}}}},
        .mass_per_length = 7800 * 1.327e-4,
        .EI = 7.7945,
        .frequencies = {7.968180, 25.266759, 4.931313, 15.566014}}}};
  return both;
}

inline damper::Messenger elastic_messenger(double EI, double mass_per_length, double loss_factor) {
  constexpr double EA = 2e7;
  return {.law = std::make_shared<section::LinearLaw>("elastic", section::Dimension::planar,
                                                      section::LinearStiffness{.EA = EA, .GJ = 0, .C_AT = 0, .EI = EI}),
          .mass_per_length = mass_per_length,
          .material = section::material_loss({EA, 0, EI, EI}, loss_factor)};
}

/// Springs that yield one after the other between 0.02 and 2 per metre: 4.9 N m^2 at rest, 2.4 when all have yielded.
inline damper::Messenger slipping_messenger() {
  section::MultilinearSection own{.EA = 2e7, .GJ = 0, .EI = 2.4, .springs = {}};
  for (const double yield : {0.02, 0.06, 0.2, 0.6, 2.0}) own.springs.push_back({.stiffness = 0.5, .yield = yield});
  return {.law = std::make_shared<section::MultilinearLaw>(std::move(own), section::Dimension::planar),
          .mass_per_length = 0.768};
}

}  // namespace strandyn::test
