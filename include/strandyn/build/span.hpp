#pragma once
/// \file From a validated scene to its chain. Whatever this version cannot model is an InputError at the key that asks
/// for it.

#include <optional>

#include "strandyn/build/section_law.hpp"
#include "strandyn/model/model.hpp"

namespace strandyn::build {

/// Viscous damping that is made of the span itself, about its state of rest.
struct ProportionalDamping {
  struct Mode {
    int number = 1;    ///< of the modes across the span, in its plane
    double ratio = 0;  ///< [-] damping ratio
  };
  std::vector<Mode> modes;
  double mass = 0;       ///< [1/s] Rayleigh: factor of the mass matrix
  double stiffness = 0;  ///< [s] and of the stiffness matrix
};

/// The frequency at which a harmonic [[load]] or [[motion]] is to shake: given in Hz, or that of a mode.
struct DriveAsk {
  std::optional<double> frequency;  ///< [Hz] this, or
  std::optional<int> mode;          ///< its number, from 1
};

/// A span and what was decided on the way. Constant once it is built.
struct BuiltSpan {
  model::Model model;
  SectionNumbers numbers;
  double tension = 0;                  ///< [N] of a straight span, the horizontal component of a hanging one
  double length = 0;                   ///< [m] between the supports, along the corners if there are any
  double end_size = 0;                 ///< [m] wanted size of the elements at graded ends; 0: uniform
  std::vector<std::size_t> load_of;    ///< for each entry of model.loads, the [[load]] it came from
  std::vector<std::size_t> motion_of;  ///< for each entry of model.motions, the [[motion]]
  std::vector<DriveAsk> drives;        ///< one for each harmonic [[load]], then each [[motion]]: `model::Driven`
  /// All unknowns near the shape in which the span hangs, and of the straight chain; empty where it does
  /// not hang: then it is at rest with all unknowns zero.
  Eigen::VectorXd hanging, straight;
  std::optional<double> catenary_sag;  ///< [m] of the flexible cable that has given `hanging`
  ProportionalDamping damping;

  /// Speed of transverse waves [m/s], tension and mass only; and half a wave length [m] at a frequency [Hz].
  double wave_speed() const;
  double loop_length(double frequency) const { return wave_speed() / (2 * frequency); }
  std::size_t section_points() const { return model.elements.size() * beam::gauss_points; }
};

/// The chain of a scene with [span]. Frequencies of modes are found later: whoever integrates names its drives.
BuiltSpan build_span(const casefile::Scene& scene);

/// A chain has no more modes across the span, in its plane, than nodes that are free to move there. Refuses the `key`
/// that asks for mode `number` where there are fewer.
void require_modes(const casefile::Scene& scene, const BuiltSpan& span, int number, const std::string& key);

/// Half a wave length [m] of a taut string with the scene's mass, at a tension [N] and a frequency [Hz].
double loop_length(const casefile::Scene& scene, double tension, double frequency);

}  // namespace strandyn::build
