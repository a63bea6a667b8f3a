#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "refusals.hpp"
#include "resolve.hpp"
#include "strandyn/math/low_pass.hpp"
#include "strandyn/results/table.hpp"

namespace strandyn::casefile {
namespace {

using History = std::vector<std::array<double, 2>>;

constexpr Vector3 across = {0, 1, 0};        // a force or a displacement that names no direction
constexpr Vector3 out_of_plane = {0, 0, 1};  // a moment or a rotation that names no axis

void check_place(std::optional<double> at, const std::string& path, const Scene& scene) {
  if (!scene.span || !at || *at <= scene.span->total_length()) return;
  refuse(scene.source, path + ".at_m", "lies outside the span",
         fmt::format("give a distance from the left support between 0 and {} metres", scene.span->total_length()));
}

void check_history(const History& history, bool from_file, const std::string& path, const Scene& scene) {
  for (std::size_t i = 1; i < history.size(); ++i) {
    if (history[i][0] > history[i - 1][0]) continue;
    const std::string key = from_file ? path + ".history_file" : fmt::format("{}.history[{}]", path, i);
    refuse(scene.source, key,
           fmt::format("{} time does not come after the one before",
                       from_file ? fmt::format("row {}: its", i + 1) : "its"),
           "give rows of rising time");
  }
}

struct ValueColumn {
  const char* name = "";
  Unit unit = {};
};

/// What a reader should know of a measured history: steps that are not even, gaps, a clock that does not begin at 0.
void note_what_is_odd(const History& history, const std::string& path, Scene& scene) {
  constexpr std::size_t fewest = 8;  // a few rows are written by hand
  if (history.size() < fewest) return;
  std::vector<double> steps;
  for (std::size_t i = 1; i < history.size(); ++i) steps.push_back(history[i][0] - history[i - 1][0]);
  std::vector<double> sorted = steps;
  std::ranges::sort(sorted);
  const double usual = sorted[sorted.size() / 2];
  constexpr double even = 1e-3, gap = 5;  // of the usual step
  const auto largest = std::ranges::max_element(steps);
  const auto gaps = std::ranges::count_if(steps, [&](double step) { return step > gap * usual; });
  if (gaps > 0) {
    scene.notes.push_back(
        fmt::format("{}: {} {} in the rows, the longest of {:.4g} s after {:.6g} s, where {:.4g} s are "
                    "usual; the curve goes across",
                    path, gaps, gaps == 1 ? "gap" : "gaps", *largest,
                    history[static_cast<std::size_t>(largest - steps.begin())][0], usual));
  } else if (*largest - sorted.front() > even * usual) {
    scene.notes.push_back(fmt::format("{}: steps of {:.4g} to {:.4g} s, not even; the curve goes through every row",
                                      path, sorted.front(), *largest));
  }
  if (history.front()[0] > usual) {
    scene.notes.push_back(
        fmt::format("{}: begins at {:.6g} s and holds its first value before; history_begins_at_s "
                    "says which time of the file is the beginning of the run",
                    path, history.front()[0]));
  }
}

/// The rows of a file are from here on the case's own.
void read_history(std::optional<std::string>& file, std::optional<double>& begins, const ValueColumn& value,
                  History& history, const std::string& load_path, Scene& scene) {
  if (!file) {
    for (std::array<double, 2>& row : history) row[0] -= begins.value_or(0);
    begins.reset();
    return;
  }
  const std::string path = load_path + ".history_file";
  const std::string remedy = fmt::format("give the columns time_s and {}, one row a time", value.name);
  const results::Table table = results::read_csv(std::filesystem::path(scene.source.file).parent_path() / *file);
  if (table.names().size() != 2 || !table.has("time_s") || !table.has(value.name)) {
    refuse(scene.source, path, fmt::format("the file has the columns {}", fmt::join(table.names(), ", ")), remedy);
  }
  if (table.rows() == 0) refuse(scene.source, path, "the file has no rows", remedy);
  const std::vector<double>& time = table.column("time_s");
  const std::vector<double>& values = table.column(value.name);
  for (std::size_t i = 0; i < time.size(); ++i) {
    history.push_back({time[i] - begins.value_or(0), value.unit.to_si(values[i])});
  }
  begins.reset();
  check_history(history, true, load_path, scene);
  note_what_is_odd(history, path, scene);
  file.reset();
}

/// Leaves out what is too fast for the steps of a run.
template <class Acting>
void cut_off(Acting& acting, const std::string& path, Scene& scene) {
  std::optional<double>& low_pass = acting.low_pass;
  History& history = acting.history;
  if (history.size() < 2) return;
  double shortest = history.back()[0] - history.front()[0];
  for (std::size_t i = 1; i < history.size(); ++i) shortest = std::min(shortest, history[i][0] - history[i - 1][0]);
  const std::optional<double> step = scene.integrator.step_size;
  constexpr std::size_t sampled = 100;
  if (!low_pass && step && shortest < *step / 1.5 && history.size() > sampled) {
    scene.warnings.push_back(fmt::format(
        "{}: its rows are up to {:.4g} times closer than the steps of {:.4g} s, and what is faster than {:.4g} "
        "Hz turns up at frequencies where it is not: give low_pass_Hz, or shorter steps",
        path, *step / shortest, *step, 0.5 / *step));
  }
  if (!low_pass) return;
  if (*low_pass * shortest > 0.5) {
    refuse(scene.source, path + ".low_pass_Hz",
           fmt::format("is more than the rows hold, which are {:.4g} s apart at least", shortest),
           fmt::format("give less than {:.4g} Hz, or remove it", 0.5 / shortest));
  }
  const math::Tabulated smooth = math::low_pass(tabulated(history), *low_pass);
  history.clear();
  for (std::size_t i = 0; i < smooth.time.size(); ++i) history.push_back({smooth.time[i], smooth.value[i]});
  low_pass.reset();
  if (!acting.interpolation) acting.interpolation = Interpolation::smooth;
}

/// Makes a unit vector of the direction, which must stay in the plane of a planar span.
void resolve_direction(std::optional<Vector3>& direction, bool is_rotation, const std::string& path,
                       const Scene& scene) {
  if (!direction) direction = is_rotation ? out_of_plane : across;
  auto& [x, y, z] = *direction;
  const double norm = std::hypot(x, y, z);
  if (norm == 0) refuse(scene.source, path + ".direction", "has no length", "give for example [0, 1, 0]");
  for (double& component : *direction) component /= norm;
  if (!scene.span || scene.span->dimension == Dimension::spatial) return;
  if (!is_rotation && z != 0) {
    refuse(scene.source, path + ".direction", "leaves the plane of x and y",
           "give a direction with z = 0, or span.dimension = \"spatial\"");
  }
  if (is_rotation && (x != 0 || y != 0)) {
    refuse(scene.source, path + ".direction", "turns the span out of the plane of x and y",
           "give the axis [0, 0, 1], or span.dimension = \"spatial\"");
  }
}

void resolve_load(Load& load, const std::string& path, Scene& scene) {
  check_place(load.at, path, scene);
  resolve_direction(load.direction, load.is_moment(), path, scene);
  const ValueColumn force{.name = "force_N", .unit = units::N}, moment{.name = "moment_N_m", .unit = units::N_m};
  read_history(load.history_file, load.history_begins, load.history_is_moment ? moment : force, load.history, path,
               scene);
  check_history(load.history, false, path, scene);
  cut_off(load, path, scene);
  if (load.type == LoadType::table && !load.interpolation) load.interpolation = Interpolation::linear;
}

/// Samples: as many and as evenly spaced as nobody writes corners.
bool is_sampled(const History& history) {
  constexpr std::size_t fewest = 8;
  constexpr double even = 1e-3;  // of the spacing: times are written with few digits
  if (history.size() < fewest) return false;
  const double spacing = (history.back()[0] - history.front()[0]) / static_cast<double>(history.size() - 1);
  for (std::size_t i = 1; i < history.size(); ++i) {
    if (std::abs(history[i][0] - history[i - 1][0] - spacing) > even * spacing) return false;
  }
  return true;
}

void resolve_motion(Motion& motion, const std::string& path, Scene& scene) {
  check_place(motion.at, path, scene);
  resolve_direction(motion.direction, motion.is_rotation(), path, scene);
  if (std::ranges::count(*motion.direction, 0.0) != 2) {
    refuse(scene.source, path + ".direction", "does not lie along x, y or z", "give one [[motion]] per axis");
  }
  const ValueColumn shift{.name = "displacement_mm", .unit = units::mm},
      turn{.name = "rotation_deg", .unit = units::deg};
  read_history(motion.history_file, motion.history_begins, motion.history_is_rotation ? turn : shift, motion.history,
               path, scene);
  check_history(motion.history, false, path, scene);
  cut_off(motion, path, scene);
  if (motion.type == MotionType::table && !motion.interpolation) {
    motion.interpolation = is_sampled(motion.history) ? Interpolation::smooth : Interpolation::linear;
  }
  const bool in_time = scene.is<TransientAnalysis>() || scene.is<DecayAnalysis>() || scene.is<ForcedAnalysis>();
  if (motion.ease > 0 && !in_time) {
    refuse(scene.source, path + ".ease_s", "eases a motion that begins, and this analysis has no beginning",
           "leave it out, or choose a transient, decay or forced analysis");
  }
}

void resolve_body(Body& body, const std::string& path, const Scene& scene) {
  check_place(body.at, path, scene);
  resolve_direction(body.direction, false, path, scene);
  if (body.mass > 0 || body.inertia > 0 || body.stiffness > 0 || body.damping > 0) return;
  refuse(scene.source, path, "has neither mass nor spring nor damper",
         "give one of mass_kg, inertia_kg_m2, stiffness_N_per_m, damping_N_s_per_m above 0");
}

template <class T, class Resolve>
void resolve_each(std::vector<T>& list, const char* name, Scene& scene, Refusals& refusals, const Resolve& resolve) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    refusals.hold([&] { resolve(list[i], fmt::format("{}[{}]", name, i), scene); });
  }
}

}  // namespace

void resolve_loads(Scene& scene) {
  Refusals refusals;
  resolve_each(scene.loads, "load", scene, refusals, resolve_load);
  resolve_each(scene.motions, "motion", scene, refusals, resolve_motion);
  resolve_each(scene.bodies, "body", scene, refusals, resolve_body);
  refusals.pass_on();
}

}  // namespace strandyn::casefile
