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

}  // namespace strandyn::test
