#pragma once
/// \file [[wind]]: the wind across a span, in a run in time.

#include <array>
#include <optional>
#include <vector>

#include "strandyn/air/wake_oscillator.hpp"
#include "strandyn/casefile/declare.hpp"
#include "strandyn/core/words.hpp"

namespace strandyn::casefile {

/// Which measured curve of wind power.
enum class WindCurve { cigre, diana_falco, brika_laneville };
constexpr auto words_of(WindCurve) {
  return std::array{Named{WindCurve::cigre, "cigre"}, Named{WindCurve::diana_falco, "diana-falco"},
                    Named{WindCurve::brika_laneville, "brika-laneville"}};
}

enum class WindModel { power_curve, wake_oscillator };
constexpr auto words_of(WindModel) {
  return std::array{Named{WindModel::power_curve, "power-curve"}, Named{WindModel::wake_oscillator, "wake-oscillator"}};
}

struct WindKeys {
  WindModel model = WindModel::power_curve;
  std::optional<double> speed;     ///< [m/s] this, or
  std::optional<int> mode;         ///< `power-curve`: the mode to which the vortices are locked
  double strouhal = 0.2;           ///< [-]
  std::optional<double> diameter;  ///< [m] empty: that of the conductor
  // power-curve
  WindCurve curve = WindCurve::cigre;
  double turbulence_intensity = 0;  ///< [-]
  // wake-oscillator
  air::WakeModel wake;                         ///< all but the diameter and the Strouhal number
  std::vector<std::array<double, 2>> history;  ///< [s], [m/s] instead of one speed
  std::vector<std::array<double, 2>> shear;    ///< [m], [-] factors along the span
  double turbulence_length = 100;              ///< [m]
  double start_amplitude = 2;                  ///< [-] of q
  std::optional<int> seed;
};

template <class V>
void keys(V& v, WindKeys& w) {
  v.choice("model", w.model,
           {.help = "whether vortices are locked to a mode and feed it what was measured, or wakes are integrated "
                    "with the span",
            .required = true});
  v.one_of({"speed_m_per_s", "mode", "history"}, {.required = true});
  v.number("speed_m_per_s", w.speed, {.help = "the speed of the wind", .unit = units::m_per_s, .above = 0});
  v.number("strouhal", w.strouhal,
           {.help = "the Strouhal number, which ties the wind speed to the frequency", .above = 0});
  v.number(
      "diameter_mm", w.diameter,
      {.help = "the diameter that the wind meets (that of the conductor unless given)", .unit = units::mm, .above = 0});
  v.when("model", w.model, {WindModel::power_curve}, [&] {
    v.number("mode", w.mode,
             {.help = "the mode to which the vortices are locked (that nearest to the shedding frequency of a speed)",
              .at_least = 1});
    v.choice("curve", w.curve, {.help = "the curve of wind power"});
  });
  v.number("turbulence_intensity", w.turbulence_intensity,
           {.help = "the turbulence intensity of the wind, deviation over mean: what it takes from the curve, or the "
                    "gusts of a record that the wakes feel",
            .at_least = 0,
            .below = 1});
  v.when("model", w.model, {WindModel::wake_oscillator}, [&] {
    v.rows("history", w.history,
           {{{.help = "time", .unit = units::s}, {.help = "speed", .unit = units::m_per_s, .at_least = 0}}},
           {.help = "the speed of the wind over time, rows of seconds and metres per second"});
    v.rows("shear", w.shear, {{{.help = "place", .unit = units::m, .at_least = 0}, {.help = "factor", .at_least = 0}}},
           {.help = "the speed along the span, rows of metres from the left support and factors of the speed, linear "
                    "between (1 everywhere unless given)"});
    v.number("density_kg_per_m3", w.wake.density,
             {.help = "the density of the air", .unit = units::kg_per_m3, .above = 0});
    v.number("epsilon", w.wake.epsilon, {.help = "van der Pol's parameter of the wake", .above = 0});
    v.number("coupling", w.wake.coupling,
             {.help = "the factor A by which the acceleration of the cylinder drives its wake", .at_least = 0});
    v.number("lift_coefficient", w.wake.lift, {.help = "the lift coefficient of a cylinder at rest", .above = 0});
    v.number(
        "stall", w.wake.stall,
        {.help = "the stall parameter gamma, the fluid's own damping; drag coefficient over 4 pi St", .at_least = 0});
    v.number("added_mass", w.wake.added_mass,
             {.help = "the coefficient of the mass of air that moves along", .at_least = 0});
    v.number("turbulence_length_m", w.turbulence_length,
             {.help = "the length scale of the gusts along the wind", .unit = units::m, .above = 0});
    v.number(
        "start_amplitude", w.start_amplitude,
        {.help = "the amplitude of the wake variable q at the start; that of a cylinder at rest is 2", .at_least = 0});
    v.number(
        "seed", w.seed,
        {.help = "the seed of the gusts, and of the phases of the wakes at the start (one phase for all unless given)",
         .at_least = 0});
  });
}

}  // namespace strandyn::casefile
