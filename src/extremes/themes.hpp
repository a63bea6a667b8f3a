#pragma once
/// \file The rows of the table, one function a theme. To add a row: a line of the list in the file of its theme.

#include "strandyn/extremes/extreme.hpp"

namespace strandyn::extremes {

std::vector<Extreme> tension_rows();
std::vector<Extreme> amplitude_rows();
std::vector<Extreme> frequency_rows();
std::vector<Extreme> step_rows();
std::vector<Extreme> cycle_rows();
std::vector<Extreme> mesh_rows();
std::vector<Extreme> law_rows();
std::vector<Extreme> friction_rows();
std::vector<Extreme> load_rows();
std::vector<Extreme> rotation_rows();
std::vector<Extreme> core_rows();

}  // namespace strandyn::extremes
