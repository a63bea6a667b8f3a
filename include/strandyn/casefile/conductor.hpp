#pragma once
/// \file [conductor]: a strand, layer by layer, by a name of the catalogue or by a file.

#include <optional>
#include <string>
#include <vector>

#include "strandyn/casefile/choices.hpp"
#include "strandyn/conductor/strand.hpp"

namespace strandyn::casefile {

/// [[conductor.layer]], also of a catalogue entry. After reading: lay_angle, helix_radius, friction_inner hold values,
/// lay_length and friction are empty.
struct LayerKeys {
  int wires = 1;
  double diameter = 0;                 ///< [m]
  std::optional<double> lay_angle;     ///< [rad] signed
  std::optional<double> lay_length;    ///< [m] signed
  std::optional<double> lay_ratio;     ///< [-] signed, lay length over the outer diameter of the layer
  double young = 0;                    ///< [Pa]
  double poisson = 0.3;                ///< [-]
  double density = 0;                  ///< [kg/m^3] 0: not given
  double residual_force = 0;           ///< [N/m]
  std::optional<double> helix_radius;  ///< [m]
  WireShape shape = WireShape::round;
  std::optional<double> area;            ///< [m^2] trapezoidal wires only
  std::optional<double> friction;        ///< [-] inner contact, and the outer one unless the next layer says otherwise
  std::optional<double> friction_inner;  ///< [-] inner contact
};

struct Conductor {
  std::optional<std::string> catalogue;
  std::optional<std::string> file;  ///< as written: beside the case
  std::optional<std::string> title;
  std::optional<std::string> source;
  std::vector<LayerKeys> layers;
  double friction = 0.5;  ///< [-] of every contact that no layer speaks of
  bool residual_forces = true;
  std::optional<double> mass_per_length;  ///< [kg/m]
  std::optional<double> rated_strength;   ///< [N]

  conductor::Strand strand;  ///< all of the above, resolved
};

}  // namespace strandyn::casefile
