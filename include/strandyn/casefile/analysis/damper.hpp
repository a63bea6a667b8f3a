#pragma once
/// \file `type = "damper"`: impedance and power of a Stockbridge damper on a shaker, as IEC 61897 tests it. [conductor]
/// or [section] is its messenger.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "strandyn/casefile/declare.hpp"
#include "strandyn/casefile/periodic.hpp"
#include "strandyn/core/words.hpp"

namespace strandyn::casefile {

enum class ArmModel { chain, reduced, both };
constexpr auto words_of(ArmModel) {
  return std::array{Named{ArmModel::chain, "chain"}, Named{ArmModel::reduced, "reduced"},
                    Named{ArmModel::both, "both"}};
}

/// [[analysis.arm]]
struct ArmKeys {
  double length = 0;        ///< [m]
  double mass = 0;          ///< [kg]
  double inertia = 0;       ///< [kg m^2]
  double eccentricity = 0;  ///< [m] towards the clamp
};

template <class V>
void keys(V& v, ArmKeys& a) {
  v.number("length_m", a.length,
           {.help = "the length of the messenger from the clamp to its end in the weight",
            .unit = units::m,
            .above = 0,
            .required = true});
  v.number("mass_kg", a.mass, {.help = "the mass of the weight", .unit = units::kg, .above = 0, .required = true});
  v.number("inertia_kg_m2", a.inertia,
           {.help = "the moment of inertia of the weight about its own centre, for the rotation in the plane",
            .unit = units::kg_m2,
            .at_least = 0,
            .required = true});
  v.number("centre_to_clamp_mm", a.eccentricity,
           {.help = "how far the centre of the weight lies from the messenger's end, towards the clamp; below 0 away "
                    "from it",
            .unit = units::mm});
}

struct DamperAnalysis {
  static constexpr std::string_view word = "damper";
  static constexpr bool needs_mass = true;
  std::vector<ArmKeys> arms;
  double clamp_mass = 0;                         ///< [kg]
  std::vector<double> velocities = {0.05, 0.1};  ///< [m/s] amplitudes of the clamp
  double from = 5, to = 150;                     ///< [Hz]
  int points_per_octave = 24;
  std::vector<double> frequencies;  ///< [Hz] instead of these
  ArmModel model = ArmModel::chain;
  int elements = 10;  ///< of an arm
  PeriodicKeys periodic{.harmonics = 3, .samples = 64};
};

template <class V>
void keys(V& v, DamperAnalysis& d) {
  v.tables("arm", d.arms, {.help = "an arm, one or two of them", .required = true});
  v.number("clamp_mass_kg", d.clamp_mass, {.help = "the mass of the clamp", .unit = units::kg, .at_least = 0});
  v.numbers("clamp_velocity_m_per_s", d.velocities,
            {.help = "the amplitude of the clamp's velocity, or a list of them (0.05 and 0.1 unless given)",
             .unit = units::m_per_s,
             .above = 0});
  for (const char* of_grid : {"from_Hz", "to_Hz", "points_per_octave"}) v.one_of({"frequencies_Hz", of_grid}, {});
  v.number("from_Hz", d.from, {.help = "the lowest frequency", .unit = units::Hz, .above = 0});
  v.number("to_Hz", d.to, {.help = "the highest frequency", .unit = units::Hz, .above = 0});
  v.number("points_per_octave", d.points_per_octave,
           {.help = "the number of frequencies an octave", .at_least = 1, .at_most = 1000});
  v.numbers("frequencies_Hz", d.frequencies,
            {.help = "the frequencies, ascending, instead of from, to and points", .unit = units::Hz, .above = 0});
  v.choice("model", d.model,
           {.help = "whether an arm is a chain of elements, one element of two unknowns, or both, compared"});
  v.number("elements", d.elements, {.help = "the number of elements of an arm", .at_least = 2, .at_most = 1000});
  v.table("periodic", d.periodic, {.help = "how the periodic response is solved"});
}

}  // namespace strandyn::casefile
