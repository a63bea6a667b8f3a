#pragma once
/// \file The plots of a results folder.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "strandyn/report/cycle_table.hpp"
#include "strandyn/report/svg_plot.hpp"
#include "strandyn/results/table.hpp"

namespace strandyn::report {

struct Figure {
  std::string name;     ///< of the file: "loops" for loops.svg
  std::string caption;  ///< what to see in it, plain text
  Plot plot;
};

/// Each returns nothing where its data are missing or hold less than two points.
/// Columns loop, tension_N, curvature_per_m, moment_N_m.
std::optional<Figure> loops_figure(const results::Table& loops);
std::optional<Figure> energy_figure(const std::vector<CycleRow>& cycles);
std::optional<Figure> amplitude_figure(const std::vector<CycleRow>& cycles);
/// Columns x_m, friction_J_per_m.
std::optional<Figure> dissipation_figure(const results::Table& profile);
/// The same beside the first support, where the loss is so concentrated there that the whole span hides its shape.
std::optional<Figure> dissipation_near_support_figure(const results::Table& profile);
/// Columns x_m, curvature_amplitude_per_m.
std::optional<Figure> curvature_figure(const results::Table& profile);
/// Columns x_m and one per mode.
std::optional<Figure> modes_figure(const results::Table& modes);
/// `points` of a self-damping run: power against frequency, one line per tension and amplitude.
std::optional<Figure> self_damping_figure(const nlohmann::ordered_json& points);
/// `steps` of a static run: load against displacement.
std::optional<Figure> static_figure(const nlohmann::ordered_json& steps);

}  // namespace strandyn::report
