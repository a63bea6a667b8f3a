#pragma once
/// \file [air] and [material]: what a vibration loses beside friction between the wires.

#include <optional>

#include "strandyn/air/still_air.hpp"
#include "strandyn/casefile/declare.hpp"

namespace strandyn::casefile {

struct Air {
  air::StillAir still;
  std::optional<double> diameter;   ///< [m] empty: that of the conductor
  std::optional<double> frequency;  ///< [Hz] of runs in time; empty: that of the drive or the mode
};

template <class V>
void keys(V& v, Air& a) {
  v.number("density_kg_per_m3", a.still.density,
           {.help = "the density of the air (0: no air)", .unit = units::kg_per_m3, .at_least = 0});
  v.number("viscosity_m2_per_s", a.still.viscosity,
           {.help = "the kinematic viscosity of the air", .unit = units::m2_per_s, .above = 0});
  v.number(
      "drag_coefficient", a.still.drag_coefficient,
      {.help = "a drag coefficient beside the attached flow, for a force that goes with the square of the velocity",
       .at_least = 0});
  v.number(
      "drag_per_K", a.still.drag_per_K,
      {.help = "a drag coefficient that grows with the Keulegan-Carpenter number K = 2 pi A/D, per K; 0.2 is quoted "
               "for circular cylinders, above A/D of some 0.15",
       .at_least = 0});
  v.number(
      "diameter_mm", a.diameter,
      {.help = "the diameter that the air feels (that of the conductor unless given)", .unit = units::mm, .above = 0});
  v.number(
      "frequency_Hz", a.frequency,
      {.help = "the frequency at which a run in time takes the air's force (that of its drive or mode unless given)",
       .unit = units::Hz,
       .above = 0});
}

struct Material {
  double loss_factor = 0;                       ///< [-] of all metals that the next two do not speak of
  std::optional<double> loss_factor_aluminium;  ///< [-] wires of a Young's modulus below `steel_from`
  std::optional<double> loss_factor_steel;      ///< [-] the others
  bool thermoelastic = false;
  double temperature = 20;  ///< [degrees Celsius]
};
/// [Pa] wires that are stiffer count as steel.
inline constexpr double steel_from = 120e9;
/// [1/K] of aluminium 1350 and of carbon steel.
inline constexpr double expansion_of_aluminium = 23e-6, expansion_of_steel = 11.5e-6;

template <class V>
void keys(V& v, Material& m) {
  v.number("loss_factor", m.loss_factor,
           {.help = "the loss factor of the metal of all wires; of a section that is given as a whole, of all that it "
                    "loses",
            .at_least = 0,
            .at_most = 0.5});
  v.number("loss_factor_aluminium", m.loss_factor_aluminium,
           {.help = "the loss factor of wires with a Young's modulus below 120 GPa; sources support 1e-4 to 3e-4",
            .at_least = 0,
            .at_most = 0.1});
  v.number(
      "loss_factor_steel", m.loss_factor_steel,
      {.help = "the loss factor of all other wires; sources support 0.2e-4 to 3e-4", .at_least = 0, .at_most = 0.1});
  v.flag("thermoelastic", m.thermoelastic,
         {.help = "whether the heat that flows across a bent wire is lost: the floor of any material damping"});
  v.number("temperature_C", m.temperature,
           {.help = "the temperature, for the thermoelastic loss", .unit = units::celsius, .above = -273.15});
}

}  // namespace strandyn::casefile
