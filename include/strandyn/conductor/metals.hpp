#pragma once
/// \file The metals of wires by the names that standards give them: what the catalogue and the import of wires take.
///
///     AL1           aluminium, EN 60889 (1350-H19)           68 GPa, 0.33, 2703 kg/m^3
///     AL2 ... AL7   aluminium alloy, EN 50183                 68 GPa, 0.33, 2703 kg/m^3 (taken as AL1)
///     ST...         zinc-coated steel, EN 50189, any grade    207 GPa, 0.3, 7780 kg/m^3
///     20SA          aluminium-clad steel, IEC 61232           162 GPa, 0.3, 6590 kg/m^3

#include <string_view>

namespace strandyn::conductor {

/// Elastic constants and density of the metal of a wire.
struct Metal {
  double young;    ///< [Pa]
  double poisson;  ///< [-]
  double density;  ///< [kg/m^3]
};

/// The metal of a grade ("AL1", "ST6C", "20SA"; letters large or small), nullptr where the name is none.
const Metal* find_metal(std::string_view grade);

/// The grades, for a message.
inline constexpr std::string_view metal_grades = "AL1, AL2 to AL7, ST and what follows it (ST1A, ST6C), 20SA";

}  // namespace strandyn::conductor
