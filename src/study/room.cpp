#include "room.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

namespace strandyn::study {
namespace {

// [B] by peak memory of runs of Curlew: over 1000 and 8000 elements, over 36 and 360 000 points of one section (3600 of
// compliant contacts). A point is one of a section; an element has several sections, and each has all points.
constexpr double per_element = 4e3;
constexpr double per_point = 120, per_point_of_element = 50;
constexpr double per_compliant_point = 1200, per_compliant_point_of_element = 760;
constexpr double per_study_point = 2e3;  // a row, its line, and its entry in the tables
constexpr double usual_elements = 100;   // where the program chooses
// Rows that stay in memory until they are written: by peak memory of runs of 450 000 steps of a loop, 20 000 static
// ones, 200 000 in time with one probe and with five.
constexpr double per_loop_step = 90, per_static_step = 1300;
constexpr double per_time_step = 420, per_probe_and_step = 85;

/// [B] what the machine has, or what the shell allows.
double memory_there_is() {
#ifdef STRANDYN_FUZZ
  return 16e6;  // a fuzzer asks for the most that is allowed, thousands of times
#endif
  const double pages = static_cast<double>(::sysconf(_SC_PHYS_PAGES));
  double memory = pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    memory = std::min(memory, static_cast<double>(limit.rlim_cur));
  }
  return memory;
}

/// `count` of what the key counts, or of its seconds.
void require(const casefile::Scene& scene, std::string_view key, double count, double bytes_each,
             std::string_view less) {
  const double memory = memory_there_is();
  if (count * bytes_each <= memory) return;
  const double most = memory / bytes_each;
  casefile::refuse(scene.source, key,
                   fmt::format("would take about {:.3g} GB of memory, and there are {:.3g} GB",
                               count * bytes_each / 1e9, memory / 1e9),
                   most < 1000 ? fmt::format("{} {:.3g}", less, most) : fmt::format("{} {:.0f}", less, most));
}

double count_of(std::initializer_list<std::size_t> lists) {
  double count = 0;
  for (const std::size_t size : lists) count += static_cast<double>(size);
  return count;
}

/// What a run keeps of its steps until its end.
void require_rows(const casefile::Scene& scene) {
  if (const auto* section = std::get_if<casefile::SectionAnalysis>(&scene.analysis)) {
    const double tensions = std::max(count_of({casefile::section_tensions(scene).size()}), 1.0);
    const double loops = tensions * std::max(count_of({section->frictions.size()}), 1.0) *
                         count_of({section->curvature_amplitudes.size(), section->relative_amplitudes.size()}) *
                         (section->compare_residual_forces ? 2 : 1);
    // A cycle and a quarter before the one that is measured.
    require(scene, "analysis.steps_per_cycle", section->steps_per_cycle, 2.25 * loops * per_loop_step, "give at most");
  }
  if (const auto* path = std::get_if<casefile::StaticAnalysis>(&scene.analysis)) {
    require(scene, "analysis.steps", path->steps, per_static_step, "give at most");
  }
  if (const auto* transient = std::get_if<casefile::TransientAnalysis>(&scene.analysis)) {
    if (!scene.integrator.step_size) return;
    const double probes = std::max(count_of({transient->probes.size()}), 2.0);
    require(scene, "analysis.duration_s", transient->duration,
            (per_time_step + probes * per_probe_and_step) / *scene.integrator.step_size,
            "give a larger step, or at most");
  }
}

}  // namespace

void refuse_without_room(const casefile::Scene& scene) {
  const bool compliant = scene.section.law == casefile::Law::compliant;
  const double points = scene.section.points;
  const double of_point = compliant ? per_compliant_point : per_point;
  require(scene, "section.points", points, of_point, "give at most");
  if (scene.span) {
    const double elements = scene.span->elements ? *scene.span->elements : usual_elements;
    const double of_both = compliant ? per_compliant_point_of_element : per_point_of_element;
    if (elements > points) {
      require(scene, "span.elements", elements, per_element + points * of_both, "give at most");
    } else {
      require(scene, "section.points", points, of_point + elements * of_both, "give at most");
    }
  }
  require_rows(scene);
  if (!scene.is<casefile::SelfDampingAnalysis>()) return;
  const auto& a = scene.as<casefile::SelfDampingAnalysis>();
  const double grid =
      count_of({a.frequencies.size(), a.modes.size()}) * count_of({a.tensions.size(), a.tensions_rts.size()}) *
      count_of({a.amplitudes_over_diameter.size(), a.antinode_amplitudes.size(), a.antinode_velocities.size()});
  require(scene, "analysis", grid, per_study_point, "its grid has too many points: give at most");
}

}  // namespace strandyn::study
