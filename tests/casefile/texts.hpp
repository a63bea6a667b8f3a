#pragma once
/// \file Small cases that the tests of the case file share, and what a refusal says.

#include <string>
#include <vector>

#include "strandyn/casefile/read.hpp"
#include "strandyn/core/error.hpp"

namespace strandyn::test {

/// A forced span of the paper's conductor.
inline const std::string lab_span = R"(title = "lab span"
[conductor]
catalogue = "curlew"
friction = 0.7
[section]
points = 36
[span]
length_m = 30
tension_kN = 24.4
elements = 80
[[load]]
type = "harmonic-force"
at_m = 0.7
amplitude_N = 20
frequency_Hz = 24
[analysis]
type = "forced"
cycles = 200
)";

/// A beam that needs no conductor.
inline const std::string beam = R"([section]
law = "elastic"
EA_N = 40e6
EI_N_m2 = 1000
mass_kg_per_m = 1.98
[span]
length_m = 30
tension_kN = 30
[analysis]
type = "modes"
)";

/// A strand of three layers; the test appends to it.
inline const std::string three_layers = R"([analysis]
type = "axial-torsion"
[[conductor.layer]]
wires = 1
diameter_mm = 4
young_GPa = 200
[[conductor.layer]]
wires = 6
diameter_mm = 3
young_GPa = 200
lay_angle_deg = 10
[[conductor.layer]]
wires = 12
diameter_mm = 2
young_GPa = 70
lay_angle_deg = -12
)";

/// A bend of that strand in space, with everything that may act on it.
inline const std::string bend = three_layers + R"([damping]
modal = [[1, 0.01], [2, 0.02]]
rayleigh = { mass = 0.1, stiffness = 1e-5 }
[span]
nodes_m = [[0, 0, 0], [1, 2, 3]]
dimension = "spatial"
right = "guided"
[[load]]
type = "table"
per_length = true
moment = true
history = [[0, 0], [1.5, 2.5]]
[[motion]]
type = "static-motion"
at = "left"
rotation_deg = 2.5
direction = [-2, 0, 0]
[[motion]]
type = "harmonic-motion"
at_m = 0.5
amplitude_mm = 3
frequency = "mode 2"
[[motion]]
type = "table"
at = "right"
rotation = true
history = [[0, 0], [1.5, 2.5]]
[[body]]
at_m = 0.5
mass_kg = 2
inertia_kg_m2 = 0.1
stiffness_N_per_m = 300
damping_N_s_per_m = 4
direction = [3, 0, 4]
[static]
control = "arc-length"
arc_step_mm = 0.7
[accept]
"fixed_end[0].k1_N" = { expected = 1.25, absolute = 0.5, reason = "r", source = "s" }
"status" = { expected = "done", reason = "r" }
)";

/// A strand pushed aside by a force at a point.
inline const std::string pushed = R"([conductor]
catalogue = "curlew"
[span]
length_m = 30
tension_kN = 24.4
[[load]]
type = "static-force"
at_m = 15
force_N = -200
[[motion]]
type = "static-motion"
at = "right"
displacement_mm = 0.3
direction = [1, 0, 0]
[[motion]]
type = "harmonic-motion"
at = "right"
amplitude_deg = 0.3
frequency_Hz = 7
[static]
control = "displacement"
displacement_mm = -3
[analysis]
type = "static"
slip_map_loads_N = [10, 20]
)";

inline casefile::Scene read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return casefile::read_scene_text(text, "case.toml", overrides);
}

/// The message of the refusal, or "accepted".
inline std::string refusal(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    read(text, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

inline bool contains(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

}  // namespace strandyn::test
