#pragma once
/// \file The dampers of a span in an energy balance: what they take while the free span vibrates.
///
/// Near each end stands one damper at the most (analysis/damped_end.hpp); it moves and turns with the
/// conductor (damper/clamp_stiffness.hpp); its messenger is elastic, the same at every amplitude. Per metre of the span
/// L they add sum P/L to what damps.

#include <map>
#include <optional>
#include <vector>

#include "strandyn/air/wind_power.hpp"
#include "strandyn/analysis/damped_end.hpp"
#include "strandyn/casefile/scene.hpp"

namespace strandyn::self_damping {

class Protection {
 public:
  /// Of a balance that names dampers; `first_at` [m] puts the first one somewhere else.
  Protection(const casefile::Scene& scene, const casefile::EnergyBalanceKeys& keys,
             std::optional<double> first_at = {});

  /// What the vibration of the free span makes of the dampers at a tension [N].
  struct Taken {
    double power = 0;                  ///< [W] of all dampers
    double damper_velocity = 0;        ///< [m/s] amplitude of the one that is shaken hardest
    double largest_end_amplitude = 0;  ///< [m] antinode amplitude at a clamp: of the end loop, or of the free span
    double reflection = 1;             ///< [-] of the better damped end
  };
  Taken at(const air::Vibration& vibration, double tension) const;
  double per_metre(const air::Vibration& vibration, double tension) const {
    return at(vibration, tension).power / length_;
  }

 private:
  const analysis::PointStiffness& stiffness(std::size_t damper, double frequency) const;

  std::vector<casefile::DamperKeys> dampers_;
  double length_ = 0;           // [m]
  double mass_per_length_ = 0;  // [kg/m]
  double EI_ = 0;               // [N m^2] of sticking wires, which small vibrations find
  mutable std::vector<std::map<double, analysis::PointStiffness>> found_;  // by frequency
};

}  // namespace strandyn::self_damping
