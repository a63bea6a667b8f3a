#include "motion.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace strandyn::study {

namespace {

/// [m] complex amplitudes of the nodes along one direction; empty where the chain does not move there.
std::vector<std::complex<double>> along(const model::Model& model, const Eigen::VectorXcd& motion,
                                        model::Unknown direction) {
  std::vector<std::complex<double>> amplitudes;
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    const auto i = model.index(node, direction);
    if (!i) return {};
    amplitudes.push_back(motion(static_cast<Eigen::Index>(*i)));
  }
  return amplitudes;
}

double largest(const std::vector<std::complex<double>>& amplitudes) {
  double most = 0;
  for (const std::complex<double>& a : amplitudes) most = std::max(most, std::abs(a));
  return most;
}

}  // namespace

void add_motion(const span::SpanAtRest& span, const observe::Fundamental& fundamental, Outcome& outcome) {
  constexpr int phases = 24;
  constexpr std::size_t most_nodes = 1000;
  const model::Model& model = span.built.model;
  const Eigen::VectorXcd motion = fundamental.motion();
  if (motion.size() != static_cast<Eigen::Index>(model.unknowns())) return;
  const auto up = along(model, motion, model::Unknown::y), out = along(model, motion, model::Unknown::z);
  const auto& amplitudes = largest(out) > largest(up) ? out : up;
  if (amplitudes.empty() || largest(amplitudes) == 0) return;
  const std::vector<double> place = model::arc_lengths(model);
  results::Table table({"phase_deg", "x_m", "displacement_m"});
  for (int phase = 0; phase < phases; ++phase) {
    const std::complex<double> turn = std::polar(1.0, 2 * std::numbers::pi * phase / phases);
    for (const std::size_t node : results::evenly_spaced(place.size(), most_nodes)) {
      table.append(std::array{360.0 * phase / phases, place[node], (amplitudes[node] * turn).real()});
    }
  }
  outcome.tables.push_back({.file = "motion.csv", .table = std::move(table)});
  outcome.figures.push_back({.name = "motion",
                             .title = "One cycle of the vibration",
                             .kind = "motion",
                             .table = "motion.csv",
                             .x = "x_m",
                             .y = {"displacement_m"},
                             .series = {"phase_deg"},
                             .caption = "The fundamental of the last cycle, at twenty-four of its moments."});
}

}  // namespace strandyn::study
