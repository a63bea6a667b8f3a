#include "strandyn/self_damping/mode_loss.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "strandyn/analysis/methods.hpp"

namespace strandyn::self_damping {
namespace {

using std::numbers::pi;

/// Gauss-Legendre on [0, 1].
template <std::size_t N>
struct Gauss {
  std::array<double, N> place{}, weight{};

  Gauss() {
    for (std::size_t i = 0; i < N; ++i) {
      double x = std::cos(pi * (static_cast<double>(i) + 0.75) / (N + 0.5));
      double slope = 1;
      for (int pass = 0; pass < 8; ++pass) {  // Newton on P_N by its recurrence
        double before = 1, p = x;
        for (std::size_t k = 2; k <= N; ++k) {
          const double n = static_cast<double>(k);
          const double next = ((2 * n - 1) * x * p - (n - 1) * before) / n;
          before = p;
          p = next;
        }
        slope = N * (x * p - before) / (x * x - 1);
        x -= p / slope;
      }
      place[i] = (1 - x) / 2;
      weight[i] = 1 / ((1 - x * x) * slope * slope);
    }
  }

  double integrate(double from, double to, const std::function<double(double)>& f) const {
    double sum = 0;
    for (std::size_t i = 0; i < N; ++i) sum += weight[i] * f(from + (to - from) * place[i]);
    return sum * (to - from);
  }
};

/// f changes sign between the two; the place to rounding of the interval.
double bisect(double from, double to, const std::function<double(double)>& f) {
  const bool positive = f(from) > 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (from + to) / 2;
    ((f(middle) > 0) == positive ? from : to) = middle;
  }
  return (from + to) / 2;
}

/// Where the curvature of the left half is zero, from the clamp on.
std::vector<double> curvature_nodes(const exact::TensionedBeamMode& shape, double half_span) {
  const auto curvature = [&](double x) { return shape.at(x).curvature; };
  constexpr double samples_per_loop = 16;
  const auto samples = static_cast<int>(std::ceil(half_span * shape.wavenumber() / pi * samples_per_loop));
  std::vector<double> nodes;
  double x0 = 0, c0 = curvature(0);
  for (int i = 1; i <= samples; ++i) {
    const double x1 = half_span * i / samples;
    const double c1 = curvature(x1);
    if ((c0 > 0) != (c1 > 0)) nodes.push_back(bisect(x0, x1, curvature));
    x0 = x1;
    c0 = c1;
  }
  return nodes;
}

}  // namespace

double mean_loss_of_sine(const SectionalLoss& loss, double amplitude) {
  static const Gauss<48> gauss;
  if (amplitude <= loss.onset()) return 0;
  const double first = std::asin(loss.onset() / amplitude);
  return 2 / pi * gauss.integrate(first, pi / 2, [&](double phi) { return loss.at(amplitude * std::sin(phi)); });
}

Loop string_loop(const Wave& w) {
  const double omega = 2 * pi * w.frequency;
  const double square = w.mass_per_length * omega * omega / w.tension;
  return {.wavenumber = std::sqrt(square), .curvature = square * w.antinode_amplitude, .EI = 0};
}

Loop stiff_loop(const SectionalLoss& loss, const Wave& w) {
  Loop loop{.EI = loss.secant(0)};
  for (int i = 0; i < 100; ++i) {
    loop.wavenumber =
        analysis::wavenumber({.tension = w.tension, .mass_per_length = w.mass_per_length, .EI = loop.EI}, w.frequency);
    loop.curvature = loop.wavenumber * loop.wavenumber * w.antinode_amplitude;
    const double EI = loss.secant(loop.curvature);
    if (std::abs(EI - loop.EI) <= 1e-13 * loop.EI) break;
    loop.EI = EI;
  }
  return loop;
}

ClampedMode clamped_mode_at(const exact::TensionedBeam& beam, double frequency) {
  const double k = analysis::wavenumber(
      {.tension = beam.tension, .mass_per_length = beam.mass_per_length, .EI = beam.EI}, frequency);
  // k L = n pi + 2 atan(k/q) where the boundary layers of the two ends do not meet, q^2 = k^2 + T/EI.
  const double turn = 2 * std::atan(k / std::sqrt(k * k + beam.tension / beam.EI));
  ClampedMode mode{.beam = beam, .number = std::max(1, static_cast<int>(std::lround((k * beam.length - turn) / pi)))};
  mode.beam.length = (mode.number * pi + turn) / k;
  for (int i = 0; i < 50; ++i) {
    const double ratio =
        exact::TensionedBeamMode(mode.beam, exact::BeamEnds::clamped, mode.number).frequency() / frequency;
    mode.beam.length *= ratio;  // f L is nearly constant
    if (std::abs(ratio - 1) < 1e-13) break;
  }
  return mode;
}

ClampedCurvature curvature_of(const ClampedMode& mode) {
  const exact::TensionedBeamMode shape(mode.beam, exact::BeamEnds::clamped, mode.number);
  const double at_clamp = std::abs(shape.at(0).curvature);
  const double k = shape.wavenumber();
  return {.free_span = k * k, .largest = std::max(at_clamp, k * k)};
}

namespace {

/// `panel` integrates between two places of the half span.
SpanLoss sum_over_mode(const ClampedMode& mode, const exact::TensionedBeamMode& shape,
                       const std::function<double(double, double)>& panel) {
  const double half = mode.beam.length / 2;
  // Between two nodes the curvature rises to about the middle and falls; near the clamp it falls like exp(-q x).
  std::vector<double> cuts = curvature_nodes(shape, half);
  SpanLoss result;
  double end_loop = 0, inner = 0, from = 0;
  const double first = cuts.empty() ? half : cuts.front();
  for (double part : {0.02, 0.05, 0.1, 0.2, 0.35, 0.6, 1.0}) {
    end_loop += panel(from, part * first);
    from = part * first;
  }
  if (!cuts.empty()) cuts.push_back(half);
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    // The last one ends at the middle of the span: an antinode of an odd mode, a node of an even one.
    const bool whole_loop = cuts[i] - cuts[i - 1] > 0.75 * pi / shape.wavenumber();
    const double middle = whole_loop ? (cuts[i - 1] + cuts[i]) / 2 : cuts[i];
    double sum = panel(cuts[i - 1], middle);
    if (whole_loop) sum += panel(middle, cuts[i]);
    (i == 1 ? end_loop : inner) += sum;
  }
  result.mean = (end_loop + inner) / half;
  if (mode.number >= 3) result.free_span = inner / (half - cuts[1]);
  return result;
}

}  // namespace

SpanLoss loss_of_mode(const SectionalLoss& loss, const ClampedMode& mode, double antinode_amplitude) {
  static const Gauss<16> gauss;
  const exact::TensionedBeamMode shape(mode.beam, exact::BeamEnds::clamped, mode.number);
  const auto amplitude = [&](double x) { return antinode_amplitude * std::abs(shape.at(x).curvature); };
  const auto above_onset = [&](double x) { return amplitude(x) - loss.onset(); };
  return sum_over_mode(mode, shape, [&](double from, double to) {
    const auto lost = [&](double x) { return loss.at(amplitude(x)); };
    if ((above_onset(from) > 0) == (above_onset(to) > 0)) return gauss.integrate(from, to, lost);
    const double cut = bisect(from, to, above_onset);
    return above_onset(from) > 0 ? gauss.integrate(from, cut, lost) : gauss.integrate(cut, to, lost);
  });
}

SpanLoss mean_over_mode(const ClampedMode& mode, double antinode_amplitude,
                        const std::function<double(double, double)>& f) {
  static const Gauss<16> gauss;
  const exact::TensionedBeamMode shape(mode.beam, exact::BeamEnds::clamped, mode.number);
  return sum_over_mode(mode, shape, [&](double from, double to) {
    return gauss.integrate(from, to, [&](double x) {
      const auto at = shape.at(x);
      return f(antinode_amplitude * std::abs(at.curvature), antinode_amplitude * std::abs(at.value));
    });
  });
}

}  // namespace strandyn::self_damping
