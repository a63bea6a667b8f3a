#include "strandyn/self_damping/method.hpp"

#include <algorithm>
#include <array>

#include "foti_2018.hpp"
#include "methods.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/self_damping/quadrature.hpp"

namespace strandyn::self_damping {

using casefile::DampingMethod;
using casefile::Scene;

namespace {

struct Entry {
  DampingMethod word;
  std::unique_ptr<Method> (*make)(const Scene& scene);
};

template <class M>
std::unique_ptr<Method> make(const Scene& scene) {
  return std::make_unique<M>(scene);
}

/// All methods there are.
constexpr std::array entries = {
    Entry{DampingMethod::quadrature, make<Quadrature>}, Entry{DampingMethod::periodic, make<PeriodicMethod>},
    Entry{DampingMethod::transient, make<TransientMethod>}, Entry{DampingMethod::foti_2018, make<ClosedForm>}};

}  // namespace

void Method::begin(const std::vector<Point>&, const Beginning&) {}

std::optional<PointChoice> Method::first_choice(const Point&) const {
  return std::nullopt;
}

std::unique_ptr<Method> make_method(DampingMethod word, const Scene& scene) {
  return std::ranges::find(entries, word, &Entry::word)->make(scene);
}

std::optional<PointRow> compute_row(const Scene& scene, const Method& method, const Point& point, const Watch& watch) {
  PointResult result;
  try {
    result = method.at(point, watch);
  } catch (const ComputationError& error) {
    result.failure = error.what();
  }
  if (result.stopped) return std::nullopt;
  PointRow row{.frequency = point.frequency,
               .antinode_amplitude = point.antinode_amplitude,
               .tension = point.tension,
               .method = std::string(name_of(point.method))};
  if (point.grid) row.grid = point.grid;
  if (scene.conductor) {
    row.amplitude_over_diameter = point.antinode_amplitude / scene.conductor->strand.outer_diameter();
  }
  if (result.effort.evaluations > 0) {
    row.section_evaluations = result.effort.evaluations;
    row.section_sweeps = result.effort.sweeps;
  }
  if (!result.failure.empty()) {
    row.failed = result.failure;
    return row;
  }
  row.self_damping = result.self_damping;
  row.free_span = result.free_span;
  row.parts = result.parts;
  row.vibration = std::move(result.vibration);
  row.bench = std::move(result.bench);
  row.error = result.error;
  row.chosen = result.chosen;
  row.details = std::move(result.details);
  return row;
}

}  // namespace strandyn::self_damping
