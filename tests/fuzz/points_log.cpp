// The finished points of a study, and what a resumed study makes of them: fits, balances, tables.
#include "answer.hpp"
#include "results/scratch_folder.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/section/return_map.hpp"
#include "strandyn/self_damping/log.hpp"
#include "strandyn/study/run_case.hpp"
#include "target.hpp"

namespace strandyn::fuzz {
namespace {

using self_damping::Point;
using self_damping::PointRow;

constexpr const char* study = R"([conductor]
catalogue = "drake"
[section]
law = "return-map"
points = 12
[analysis]
type = "self-damping"
method = "foti-2018"
frequencies_Hz = [10, 20, 40]
amplitude_over_diameter = [0.02, 0.05, 0.1]
tensions_rts = [0.15, 0.25]
[[analysis.energy_balance]]
wind = "cigre"
self_damping = "fit"
)";

const casefile::Scene& scene() {
  static const casefile::Scene scene = casefile::read_scene_text(study, "case.toml");
  return scene;
}

const test::ScratchFolder& scratch() {
  static const test::ScratchFolder folder;
  return folder;
}

/// A row that has all that a row may have.
PointRow row_of(const Point& point) {
  const double power = 1e-3 * point.antinode_amplitude * point.frequency * 1e6 / point.tension;
  PointRow row{.frequency = point.frequency,
               .antinode_amplitude = point.antinode_amplitude,
               .tension = point.tension,
               .method = std::string(name_of(point.method)),
               .grid = "amplitude",
               .amplitude_over_diameter = 0.05,
               .section_evaluations = 12,
               .section_sweeps = 3,
               .self_damping = power,
               .free_span = 0.9 * power};
  row.parts = self_damping::LossParts{.friction = power, .material = 0, .viscous = 0, .air = 0.1 * power};
  row.vibration.emplace();
  row.bench.emplace();
  row.bench->iswr.emplace();
  row.bench->decay.emplace();
  return row;
}

}  // namespace

void take(std::string_view bytes) {
  put((scratch() / self_damping::log_name).string(), bytes);
  const study::Hooks hooks{.stop = [] { return true; }, .progress = {}, .folder = scratch().path(), .resume = true};
  answered([&] { study::run_case(scene(), hooks); });
}

std::vector<std::string> seeds() {
  const std::vector<Point> points = self_damping::points_of(scene());
  const std::string identity = self_damping::study_identity(scene(), section::vector_target().name);
  std::vector<std::string> files;
  for (const std::size_t count : {std::size_t{0}, std::size_t{2}, points.size()}) {
    const test::ScratchFolder folder;
    self_damping::PointLog log({.folder = folder.path(), .study = identity}, points);
    if (count > 0) {
      log.add({.tension = points.front().tension,
               .lowest = 1e-3,
               .highest = 0.1,
               .onset = 1e-4,
               .sticking = 900,
               .places = {-9, -7, -5, -2},
               .losses = {1e-6, 1e-4, 1e-3, 0.1},
               .secants = {890, 800, 600, 300},
               .evaluations = 1000,
               .sweeps = 900});
    }
    for (std::size_t i = 0; i < count; ++i) {
      PointRow row = row_of(points[i]);
      if (i == 1) {
        row = {.frequency = row.frequency,
               .antinode_amplitude = row.antinode_amplitude,
               .tension = row.tension,
               .method = row.method};
        row.failed = "it did not converge";
      } else if (i > 2) {
        row.vibration.reset();
        row.bench.reset();
      }
      log.add(i, row);
    }
    files.push_back(bytes_of((folder / self_damping::log_name).string()));
    // Tables are for the quadrature; that they are read is seen here.
    if (self_damping::PointLog({.folder = folder.path(), .study = identity, .resume = true, .read_only = true}, points)
            .tables()
            .empty() != (count == 0)) {
      throw std::logic_error("a table is lost");
    }
    log.finish();
    files.push_back(bytes_of((folder / self_damping::log_name).string()));
  }
  return files;
}

}  // namespace strandyn::fuzz
