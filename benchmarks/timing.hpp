#pragma once
/// \file Timing that the benchmarks share: of any call, and of a section law.
/// Single times depend on the machine and its load; compare the rows of one output with each other.

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>

#include "strandyn/section/law.hpp"

namespace strandyn::bench {

/// [s] of one call, the shortest mean of several rounds.
inline double seconds_per_call(const std::function<void()>& call) {
  constexpr int rounds = 7;
  constexpr int calls = 200;
  double best = 1e9;
  for (int round = 0; round < rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < calls; ++i) call();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count() / calls);
  }
  return best;
}

inline constexpr std::size_t law_batch = 160;  ///< section points in a call of `time_law`

/// Where the points of a batch stand: all alike, so that every point slips, or none does.
struct LawState {
  double eps = 0;   ///< [-]
  double chi2 = 0;  ///< [1/m]
  double chi3 = 0;  ///< [1/m] spatial laws only
};

/// [s] per point; `sweeps` are those of a response with tangent, per point.
struct LawTimes {
  double response = 0;
  double with_tangent = 0;
  double commit = 0;  ///< to and fro between the curvature and its opposite, so that each commit slips anew, or none
  double sweeps = 0;
};

inline LawTimes time_law(const section::Law& law, const LawState& state) {
  using section::Component;
  section::Field strains(law.dimension(), law_batch);
  section::Field stresses(law.dimension(), law_batch);
  section::TangentField tangents(law.dimension(), law_batch);
  section::StepEnergy energy(law_batch);
  std::fill_n(strains[Component::axial].begin(), law_batch, state.eps);
  section::History history = law.start(strains);
  const auto bend = [&](double sign) {
    std::fill_n(strains[Component::bending2].begin(), law_batch, sign * state.chi2);
    if (law.dimension() == section::Dimension::spatial) {
      std::fill_n(strains[Component::bending3].begin(), law_batch, sign * state.chi3);
    }
  };
  bend(1);
  LawTimes times;
  times.response = seconds_per_call([&] { law.respond(history, strains, stresses, nullptr); });
  section::Effort effort;
  times.with_tangent = seconds_per_call([&] { effort += law.respond(history, strains, stresses, &tangents); });
  times.sweeps = static_cast<double>(effort.sweeps) / static_cast<double>(effort.evaluations);
  double sign = 1;
  times.commit = seconds_per_call([&] {
    sign = -sign;
    bend(sign);
    law.commit(history, strains, energy);
  });
  for (double* time : {&times.response, &times.with_tangent, &times.commit}) *time /= law_batch;
  return times;
}

}  // namespace strandyn::bench
