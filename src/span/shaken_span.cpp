#include "strandyn/span/shaken_span.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "strandyn/span/carry_over.hpp"
#include "strandyn/span/damping.hpp"
#include "strandyn/span/free_span.hpp"

namespace strandyn::span {

using Eigen::Index;
using model::Unknown;

namespace {

/// Points that converge took ten at most; one that does not is tried again in smaller steps of amplitude.
constexpr int most_iterations = 20;
/// What is but the beginning of another solution ends with this correction [-], by so many samples.
constexpr double rough = 1e-3;
constexpr int few_samples = 32;

/// The node that swings widest, away from the ends where the span has three loops and more.
solver::Place control_place(const SpanAtRest& span, const solver::Mode& mode, double margin) {
  const model::Model& model = span.built.model;
  const std::vector<double> arc = model::arc_lengths(model);
  solver::Place best{.node = 0, .unknown = Unknown::y};
  double largest = 0;
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    if (arc[node] < margin || arc[node] > arc.back() - margin) continue;
    const double swing = std::abs(mode.shape(static_cast<Index>(*model.index(node, Unknown::y))));
    if (swing <= largest) continue;
    largest = swing;
    best.node = node;
  }
  return best;
}

/// Samples of a trigonometric sum of the coefficients mean, cos 1, sin 1, ...; their largest less their smallest value,
/// by the vertices of parabolas.
double peak_to_peak(const Eigen::RowVectorXd& coefficients) {
  constexpr int samples = 64;
  std::array<double, samples> value{};
  for (int j = 0; j < samples; ++j) {
    const double angle = 2 * std::numbers::pi * j / samples;
    for (Index a = 1; a < coefficients.size(); ++a) {
      const double k = static_cast<double>((a + 1) / 2);
      value[static_cast<std::size_t>(j)] += coefficients(a) * (a % 2 == 1 ? std::cos(k * angle) : std::sin(k * angle));
    }
  }
  const auto vertex = [&](std::size_t i) {
    const double before = value[(i + samples - 1) % samples], after = value[(i + 1) % samples];
    const double bend = before - 2 * value[i] + after;
    return bend == 0 ? value[i] : value[i] - (after - before) * (after - before) / (8 * bend);
  };
  const auto [low, high] = std::ranges::minmax_element(value);
  return vertex(static_cast<std::size_t>(high - value.begin())) - vertex(static_cast<std::size_t>(low - value.begin()));
}

/// The state with so many harmonics: the others are zero.
solver::PeriodicState with_harmonics(solver::PeriodicState state, int harmonics) {
  const Index had = state.harmonics.cols(), columns = 2 * harmonics + 1;
  state.harmonics.conservativeResize(Eigen::NoChange, columns);
  if (columns > had) state.harmonics.rightCols(columns - had).setZero();
  return state;
}

}  // namespace

ShakenSpan::ShakenSpan(build::BuiltSpan built, const build::Shaker& shaker, double frequency,
                       const ResponseOptions& options)
    : span_(std::move(built)) {
  span_.apply_static_loads();
  set_proportional_damping(span_);
  mode_ = mode_near(span_, frequency, options.stop);
  mode_number_ = static_cast<int>(mode_.number);
  places_.emplace(span_.built.model, span_.built.loop_length(mode_.frequency));
  setup_ = {.kind = shaker.moves ? solver::DriveKind::motion : solver::DriveKind::force,
            .drive = {.node = shaker.node, .unknown = Unknown::y},
            .control = control_place(span_, mode_, mode_number_ >= 3 ? span_.built.length / mode_number_ : 0)};
  options_ = {.harmonics = options.harmonics,
              .samples = options.samples,
              .tolerance = options.tolerance,
              .max_iterations = most_iterations,
              .stop = options.stop};
  solver_.emplace(span_.system, span_.u, setup_, options_);
}

double ShakenSpan::antinode_amplitude(const solver::PeriodicState& state) const {
  const Eigen::MatrixXd& x = state.harmonics;
  Eigen::RowVectorXd coefficients(x.cols());
  const auto read = [&](std::size_t place) {
    for (Index a = 0; a < x.cols(); ++a) coefficients(a) = places_->at(x.col(a).data(), place);
  };
  std::vector<double> fundamental(places_->size());
  for (std::size_t i = 0; i < fundamental.size(); ++i) {
    fundamental[i] = std::hypot(places_->at(x.col(1).data(), i), places_->at(x.col(2).data(), i));
  }
  // The antinode is near a crest of the fundamental; the other harmonics are small beside it.
  constexpr double near = 0.95;
  const double crest = std::ranges::max(fundamental);
  double largest = 0;
  for (std::size_t i = 0; i < fundamental.size(); ++i) {
    if (fundamental[i] < near * crest) continue;
    read(i);
    largest = std::max(largest, peak_to_peak(coefficients) / 2);
  }
  return largest;
}

double ShakenSpan::phase(const solver::PeriodicState& state) const {
  const solver::Place& place = setup_.kind == solver::DriveKind::force ? setup_.drive : setup_.control;
  const double behind = -std::arg(state.phasor(*span_.built.model.index(place.node, place.unknown)));
  constexpr double turn = 2 * std::numbers::pi;
  return behind - turn * std::floor(behind / turn + 0.25);
}

void ShakenSpan::from_mode(const solver::PeriodicSolver& solver, double control, int parts, ResonanceAt& result) const {
  std::vector<double> amplitudes;
  for (int i = 1; i <= parts; ++i) amplitudes.push_back(control * i / parts);
  for (const solver::PeriodicSolution& solution : solver.backbone(amplitudes, mode_)) {
    result.effort += solution.effort;
    result.solution = solution;
  }
}

void ShakenSpan::from(const solver::PeriodicSolver& solver, double control, solver::PeriodicState start,
                      ResonanceAt& result) const {
  result.solution = solver.resonance(control, start);
  result.effort += result.solution.effort;
}

/// Of the fundamental alone a vibration is found from far away and at little cost; the others come to it. Where they
/// do not, since one of them lies near a mode of its own, the amplitude is raised step by step.
void ShakenSpan::approach(double antinode_amplitude, ResonanceAt& result) const {
  constexpr int small_steps = 8;
  solver::PeriodicOptions few = options_;
  few.tolerance = std::max(rough, options_.tolerance);
  double control = antinode_amplitude / this->antinode_amplitude(solver_->from_mode(mode_, 1));
  std::optional<solver::PeriodicState> start;
  for (const int harmonics : {1, 3, options_.harmonics}) {
    if (harmonics > options_.harmonics) continue;
    const bool is_last = harmonics == options_.harmonics;
    few.harmonics = harmonics;
    few.samples = is_last ? options_.samples : std::min(options_.samples, few_samples);
    const solver::PeriodicSolver solver(span_.system, span_.u, setup_, few);
    if (start) {
      from(solver, control, with_harmonics(std::move(*start), harmonics), result);
    } else {
      from_mode(solver, control, 1, result);
    }
    if (!result.solution.converged) from_mode(solver, control, small_steps, result);
    if (is_last) break;
    start.reset();
    if (!result.solution.converged) continue;
    start = result.solution.state;
    const double ratio = antinode_amplitude / this->antinode_amplitude(*start);
    start->harmonics *= ratio;
    control = ratio * result.solution.amplitude;
  }
  if (result.solution.converged) from(*solver_, control, result.solution.state, result);
  settle(antinode_amplitude, result);
}

void ShakenSpan::settle(double antinode_amplitude, ResonanceAt& result) const {
  // The control is a node of the mesh, the antinode lies beside it: their ratio hardly changes with amplitude.
  constexpr double tolerance = 1e-5;
  constexpr int most_passes = 6;
  for (int pass = 0; pass < most_passes && result.solution.converged; ++pass) {
    result.antinode_amplitude = this->antinode_amplitude(result.solution.state);
    const double ratio = antinode_amplitude / result.antinode_amplitude;
    if (std::abs(ratio - 1) < tolerance) break;
    solver::PeriodicState start = result.solution.state;
    start.harmonics *= ratio;
    result.solution = solver_->resonance(ratio * result.solution.amplitude, start);
    result.effort += result.solution.effort;
  }
}

ResonanceAt ShakenSpan::resonance(double antinode_amplitude) const {
  ResonanceAt result;
  try {
    approach(antinode_amplitude, result);
  } catch (const Interrupted&) {
    result.stopped = true;
  }
  return result;
}

ResonanceAt ShakenSpan::resonance(double antinode_amplitude, const ShakenSpan& other,
                                  const solver::PeriodicState& found) const {
  ResonanceAt result;
  try {
    const Eigen::MatrixXd carried = carry_over(other.span_.built.model, found.harmonics, span_.built.model);
    solver::PeriodicState start{.frequency = found.frequency * mode_.frequency / other.mode_.frequency,
                                .drive = found.drive,
                                .harmonics = carried,
                                .sections = found.sections};
    start = with_harmonics(std::move(start), options_.harmonics);
    const auto control = *span_.built.model.index(setup_.control.node, setup_.control.unknown);
    const double ratio = antinode_amplitude / this->antinode_amplitude(start);
    start.harmonics *= ratio;
    result.solution = solver_->resonance(std::abs(start.phasor(control)), start);
    result.effort += result.solution.effort;
    if (!result.solution.converged) approach(antinode_amplitude, result);
    settle(antinode_amplitude, result);
  } catch (const Interrupted&) {
    result.stopped = true;
  }
  return result;
}

std::optional<FreeSpan> ShakenSpan::free_span(const solver::PeriodicSolution& solution,
                                              const StrainRange& strains) const {
  if (mode_number_ < 3) return std::nullopt;
  const double length_of_span = model::arc_lengths(span_.built.model).back();
  const double loop_length = length_of_span / mode_number_;
  const auto piece = between_inner_nodes(solver_->loop_points(solution.state), length_of_span, loop_length);
  if (!piece) return std::nullopt;
  FreeSpan free{.from = piece->from, .to = piece->to};
  double squares = 0, length = 0;
  const std::vector<double> weights = section_lengths(span_, *piece);
  for (std::size_t p = 0; p < weights.size(); ++p) {
    const double weight = weights[p];
    if (weight <= 0) continue;
    if (solution.sections.friction[p] > 0) free.friction += weight * solution.sections.loop_work[p];
    free.material += weight * solution.sections.material[p];
    squares += weight * solution.sections.curvature_amplitude[p] * solution.sections.curvature_amplitude[p];
    length += weight;
    free.highest = std::max(free.highest, strains.curvature[p]);
  }
  free.air = of_nodes(span_.built.model, solution.air_by_node, *piece);
  free.curvature = std::sqrt(2 * squares / length);
  return free;
}

StrainRange ShakenSpan::strains(const solver::PeriodicState& state) const {
  using section::Component;
  constexpr int samples = 64;
  StrainRange range;
  section::Field now = span_.system.committed_strains();
  const std::size_t points = now.points();
  std::vector<double> low(points, INFINITY), high(points, -INFINITY);
  for (int j = 0; j < samples; ++j) {
    system::Vector u = span_.u + state.harmonics.col(0);
    for (Index a = 1; a < state.harmonics.cols(); ++a) {
      const double angle = 2 * std::numbers::pi * j / samples * static_cast<double>((a + 1) / 2);
      u += (a % 2 == 1 ? std::cos(angle) : std::sin(angle)) * state.harmonics.col(a);
    }
    span_.system.strains(u.data(), now);
    double stretch = 0, length = 0;
    for (std::size_t p = 0; p < points; ++p) {
      stretch += span_.system.point_length(p) * now[Component::axial][p];
      length += span_.system.point_length(p);
      low[p] = std::min(low[p], now[Component::bending2][p]);
      high[p] = std::max(high[p], now[Component::bending2][p]);
    }
    const double tension = span_.built.numbers.EA * stretch / length;
    range.mean_tension += tension / samples;
    range.highest_tension = std::max(range.highest_tension, tension);
  }
  for (std::size_t p = 0; p < points; ++p) range.curvature.push_back((high[p] - low[p]) / 2);
  return range;
}

double friction_of(const solver::PeriodicSolution& solution) {
  return solution.friction > 0 ? solution.loop_work : 0;
}

double losses_of(const solver::PeriodicSolution& solution) {
  return friction_of(solution) + solution.material + solution.viscous.total();
}

}  // namespace strandyn::span
