#include "shaken_span.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace strandyn::study {

using casefile::refuse;
using casefile::Scene;
using Eigen::Index;
using model::Unknown;

namespace {

/// Points that converge took ten at most; one that does not is tried again in smaller steps of amplitude.
constexpr int most_iterations = 20;

bool is_along_y(const std::optional<casefile::Vector3>& direction) {
  return direction && std::abs((*direction)[1]) > 1 - 1e-9;
}

void check_free(const Scene& scene, const Shaker& shaker, const SpanAtRest& span, const solver::Place& drive) {
  if (!shaker.load || !span.system.is_held(*span.built.model.index(drive.node, drive.unknown))) return;
  refuse(scene.source, fmt::format("load[{}].at_m", *shaker.load), "is a place that a support holds",
         "give a distance from the supports, or a [[motion]] of the support");
}

void check_shaker(const Scene& scene, const Shaker& shaker) {
  const auto check = [&](bool fits, const std::string& path, const char* wrong) {
    if (fits) return;
    refuse(scene.source, path, fmt::format("{}, and a shaker moves one point across the span", wrong),
           "give one harmonic force at a point (at_m), or one harmonic displacement of a support, along [0, 1, 0]");
  };
  if (shaker.load) {
    const casefile::Load& load = scene.loads[*shaker.load];
    const std::string path = fmt::format("load[{}]", *shaker.load);
    check(load.at.has_value(), path, "acts on the whole span");
    check(!load.is_moment(), path, "is a moment");
    check(is_along_y(load.direction), path, "does not act along y");
  }
  if (shaker.motion) {
    const casefile::Motion& motion = scene.motions[*shaker.motion];
    const std::string path = fmt::format("motion[{}]", *shaker.motion);
    check(!motion.is_rotation(), path, "is a rotation");
    check(is_along_y(motion.direction), path, "does not go along y");
  }
}

struct NumberedMode {
  solver::Mode mode;
  int number = 0;
};

NumberedMode nearest_mode(const SpanAtRest& span, double frequency, double loop_length) {
  const auto away = [frequency](const solver::Mode& mode) { return std::abs(mode.frequency - frequency); };
  auto count = static_cast<std::size_t>(std::ceil(span.built.length / loop_length)) + 1;
  for (;; count *= 2) {
    const std::vector<solver::Mode> modes = solver::transverse_modes(span.system, span.u, count);
    if (modes.back().frequency < frequency) continue;
    const auto nearest = std::ranges::min_element(modes, {}, away);
    return {.mode = *nearest, .number = static_cast<int>(nearest - modes.begin()) + 1};
  }
}

solver::Place drive_place(const SpanAtRest& span, const Shaker& shaker) {
  const model::Model& model = span.built.model;
  std::size_t node = 0;
  for (std::size_t i = 0; i < model.loads.size() && shaker.load; ++i) {
    if (span.built.load_of[i] == *shaker.load) node = model.loads[i].node;
  }
  for (std::size_t i = 0; i < model.motions.size() && shaker.motion; ++i) {
    if (span.built.motion_of[i] == *shaker.motion) node = model.motions[i].node;
  }
  return {.node = node, .unknown = Unknown::y};
}

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

}  // namespace

Shaker shaker_of(const Scene& scene) {
  Shaker shaker;
  int drives = 0;
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    if (scene.loads[i].type != casefile::LoadType::harmonic_force) continue;
    shaker.load = i;
    ++drives;
  }
  for (std::size_t i = 0; i < scene.motions.size(); ++i) {
    if (scene.motions[i].type != casefile::MotionType::harmonic_motion) continue;
    shaker.motion = i;
    ++drives;
  }
  if (drives > 1) {
    refuse(scene.source,
           shaker.load ? fmt::format("load[{}]", *shaker.load) : fmt::format("motion[{}]", *shaker.motion),
           "is a second shaker, and a span has one",
           "give one [[load]] of type \"harmonic-force\" or one [[motion]] of type \"harmonic-motion\"");
  }
  check_shaker(scene, shaker);
  return shaker;
}

ShakenSpan::ShakenSpan(const Scene& scene, double frequency, const casefile::PeriodicKeys& keys)
    : span_(scene), axial_stiffness_(build::section_numbers(scene).EA) {
  const Shaker shaker = shaker_of(scene);
  span_.apply_static_loads();
  set_proportional_damping(scene, span_);
  const double loop = build::loop_length(scene, span_.built.tension, frequency);
  NumberedMode found = nearest_mode(span_, frequency, loop);
  mode_ = std::move(found.mode);
  mode_number_ = found.number;
  places_.emplace(span_.built.model, build::loop_length(scene, span_.built.tension, mode_.frequency));
  setup_ = {.kind = shaker.load ? solver::DriveKind::force : solver::DriveKind::motion,
            .drive = drive_place(span_, shaker),
            .control = control_place(span_, mode_, mode_number_ >= 3 ? span_.built.length / mode_number_ : 0)};
  check_free(scene, shaker, span_, setup_.drive);
  solver_.emplace(
      span_.system, span_.u, setup_,
      solver::PeriodicOptions{.harmonics = keys.harmonics, .samples = keys.samples, .max_iterations = most_iterations});
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

ResonanceAt ShakenSpan::from_mode(double control, const std::function<bool()>& stop) const {
  ResonanceAt result;
  for (const int parts : {1, 8}) {
    if (stop && stop()) {
      result.stopped = true;
      return result;
    }
    std::vector<double> amplitudes;
    for (int i = 1; i <= parts; ++i) amplitudes.push_back(control * i / parts);
    for (const solver::PeriodicSolution& solution : solver_->backbone(amplitudes, mode_)) {
      result.effort += solution.effort;
      result.solution = solution;
    }
    if (result.solution.converged) break;
  }
  return result;
}

ResonanceAt ShakenSpan::resonance(double antinode_amplitude, const std::function<bool()>& stop) const {
  // The control is a node of the mesh, the antinode lies beside it: their ratio hardly changes with amplitude.
  constexpr double tolerance = 1e-5;
  constexpr int most_passes = 6;
  solver::PeriodicState unit = solver_->from_mode(mode_, 1);
  ResonanceAt result = from_mode(antinode_amplitude / this->antinode_amplitude(unit), stop);
  for (int pass = 0; pass < most_passes && !result.stopped && result.solution.converged; ++pass) {
    result.antinode_amplitude = this->antinode_amplitude(result.solution.state);
    const double ratio = antinode_amplitude / result.antinode_amplitude;
    if (std::abs(ratio - 1) < tolerance) break;
    if (stop && stop()) {
      result.stopped = true;
      break;
    }
    solver::PeriodicState start = result.solution.state;
    start.harmonics *= ratio;
    result.solution = solver_->resonance(ratio * result.solution.amplitude, start);
    result.effort += result.solution.effort;
  }
  return result;
}

std::optional<FreeSpan> ShakenSpan::free_span(const solver::PeriodicSolution& solution,
                                              const StrainRange& strains) const {
  if (mode_number_ < 3) return std::nullopt;
  const std::vector<double> arc = model::arc_lengths(span_.built.model);
  const double half_loop = arc.back() / mode_number_ / 2;
  std::vector<double> nodes;
  for (const solver::LoopPoint& point : solver_->loop_points(solution.state)) {
    const bool inner = point.position > half_loop && point.position < arc.back() - half_loop;
    if (!point.antinode && inner) nodes.push_back(point.position);
  }
  if (nodes.size() < 2) return std::nullopt;
  FreeSpan free{.from = nodes.front(), .to = nodes.back()};
  double squares = 0, length = 0;
  for (std::size_t p = 0; p < solution.sections.friction.size(); ++p) {
    // Each section point stands for its part of the element.
    const std::size_t e = p / beam::gauss_points;
    const double part = (arc[e + 1] - arc[e]) / beam::gauss_points;
    const double begin = arc[e] + static_cast<double>(p % beam::gauss_points) * part;
    const double inside = std::min(begin + part, free.to) - std::max(begin, free.from);
    if (inside <= 0) continue;
    const double weight = span_.system.point_length(p) * inside / part;
    if (solution.sections.friction[p] > 0) free.friction += weight * solution.sections.loop_work[p];
    squares += weight * solution.sections.curvature_amplitude[p] * solution.sections.curvature_amplitude[p];
    length += weight;
    free.highest = std::max(free.highest, strains.curvature[p]);
  }
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
    const double tension = axial_stiffness_ * stretch / length;
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
  return friction_of(solution) + solution.viscous.total();
}

}  // namespace strandyn::study
