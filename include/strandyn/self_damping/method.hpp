#pragma once
/// \file The points of a self-damping study, and the methods that compute one.
///
/// A point is a frequency, an antinode amplitude and a tension; a method computes its self-damping. To add a method: a
/// word in the case file's list of methods, a class, a line in the table of method.cpp. Every method passes the
/// battery of tests/self_damping/method_battery_test.cpp.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "strandyn/build/point.hpp"
#include "strandyn/casefile/scene.hpp"
#include "strandyn/core/stop.hpp"
#include "strandyn/results/record.hpp"
#include "strandyn/self_damping/readings.hpp"
#include "strandyn/self_damping/sectional_loss.hpp"

namespace strandyn::self_damping {

/// The grids of a study, by what gave their amplitudes.
inline constexpr const char* velocity_grid = "velocity";
inline constexpr const char* amplitude_grid = "amplitude";

struct Point {
  casefile::DampingMethod method = casefile::DampingMethod::quadrature;
  double frequency = 0;           ///< [Hz]
  double antinode_amplitude = 0;  ///< [m] half of peak to peak
  double tension = 0;             ///< [N]
  std::optional<int> mode{};      ///< where the case named the frequency by a mode of the span, from 1
  const char* grid = nullptr;     ///< one of these two; null for a single point

  build::PointAsk ask() const { return {.frequency = frequency, .tension = tension, .mode = mode}; }
};

/// All points of the study: the grid (tensions, in them frequencies, in them amplitudes), then [[analysis.at]].
std::vector<Point> points_of(const casefile::Scene& scene);
std::vector<double> distinct_tensions(const std::vector<Point>& points);

struct PointResult {
  double self_damping = 0;                   ///< [W/m] of the span, by its length
  std::optional<double> free_span{};         ///< [W/m] without the end loops; nothing where there is no free span
  std::optional<LossParts> parts{};          ///< what makes it up, and the air beside it
  std::optional<SpanVibration> vibration{};  ///< of a whole span in steady vibration
  std::optional<BenchReadings> bench{};      ///< of a test bench
  results::Value details = {};               ///< numbers of the method's own
  std::optional<PointError> error{};         ///< where the case asks for an accuracy, like the next
  std::optional<PointChoice> chosen{};       ///< the knobs that the case leaves open
  section::Effort effort{};                  ///< what it took beyond what the points of a method share
  std::string failure{};                     ///< why there are no numbers; empty otherwise
  bool stopped = false;                      ///< ended by `stop`: it will be computed again
};

/// Section evaluations that something will take, at least and at most.
struct Expected {
  double least = 0, most = 0;
  double seconds = 0;  ///< [s] of a processor, where a trial tells them; else 0
  Expected& operator+=(const Expected& other) {
    least += other.least;
    most += other.most;
    seconds += other.seconds;
    return *this;
  }
};

/// How a method takes part in a run; called from any thread.
struct Watch {
  Stop stop = {};                                     ///< asked now and then by a point of many seconds
  std::function<void(const std::string&)> tell = {};  ///< how far it is
};

/// How a method begins: for which of the points, and what of their shared work is there already.
struct Beginning {
  std::optional<std::vector<double>> tensions = {};  ///< [N] for the points of these only; else for all
  /// The kept table of a tension [N] for a range of curvatures, or nothing. Called from any thread.
  std::function<std::optional<LossTable>(double tension, const CurvatureRange& range)> find = {};
  std::function<void(const LossTable&)> keep = {};  ///< hears of each table that was made. Called from any thread
  Stop stop = {};  ///< asked several times a second, from any thread: Interrupted is thrown
};

/// Pure once begun: called from several threads at once, one point per call.
class Method {
 public:
  virtual ~Method() = default;
  /// Does what the points share; what that is depends on all points of the study, whichever of them are to follow.
  virtual void begin(const std::vector<Point>& points, const Beginning& how);
  void begin(const std::vector<Point>& points) { begin(points, {}); }
  /// A ComputationError thrown is a failure of the point, not of the study.
  virtual PointResult at(const Point& point, const Watch& watch) const = 0;
  virtual Expected expected(const std::vector<Point>& points) const = 0;
  /// Where the case asks for an accuracy: what a point begins with, of the knobs that the case leaves open.
  virtual std::optional<PointChoice> first_choice(const Point& point) const;
  /// The same as `expected`, nearer, by a coarse computation of some of the points: of what may take so long.
  virtual std::optional<Expected> expected_by_trial(const std::vector<Point>& /*points*/) const { return std::nullopt; }
};

/// Refuses (InputError) what the method cannot do with this scene, which must outlive it.
std::unique_ptr<Method> make_method(casefile::DampingMethod word, const casefile::Scene& scene);

/// A point as the summary, the tables and the log of a study have it: the numbers, or `failed` with the reason.
struct PointRow {
  double frequency = 0;
  double antinode_amplitude = 0;
  double tension = 0;
  std::string method;
  std::optional<std::string> grid{};
  std::optional<double> amplitude_over_diameter{};
  std::optional<std::uint64_t> section_evaluations{}, section_sweeps{};
  std::optional<std::string> failed{};
  std::optional<double> self_damping{}, free_span{};
  std::optional<LossParts> parts{};
  std::optional<SpanVibration> vibration{};
  std::optional<BenchReadings> bench{};
  std::optional<PointError> error{};
  std::optional<PointChoice> chosen{};
  results::Value details{};

  bool has_numbers() const { return self_damping.has_value(); }
};
template <class V>
void members(V& v, PointRow& r) {
  v.value("frequency_Hz", r.frequency, {.what = "the frequency"});
  v.value("antinode_amplitude_m", r.antinode_amplitude, {.what = "half of peak to peak at the antinode"});
  v.value("tension_N", r.tension, {.what = "the tension at rest"});
  v.value("method", r.method, {.what = "how the point was computed"});
  v.value("road", r.method, {.what = "the same word, by its old name"});
  v.value("grid", r.grid, {.what = "velocity or amplitude: what the grid gave; absent for a single point"});
  v.value("amplitude_over_diameter", r.amplitude_over_diameter,
          {.what = "the amplitude over the conductor's diameter"});
  v.value("section_evaluations", r.section_evaluations, {.what = "what the point took"});
  v.value("section_sweeps", r.section_sweeps, {.what = "of these, the ones that marched through the layers"});
  v.value("failed", r.failed, {.what = "why there are no numbers"});
  v.value("self_damping_W_per_m", r.self_damping, {.what = "dissipated power over the length of the span"});
  v.value("self_damping_free_span_W_per_m", r.free_span, {.what = "the same without the end loops"});
  v.part(r.parts);
  v.part(r.vibration);
  v.record("bench", r.bench, {.what = "the readings of the test bench"});
  v.record("error_estimate", r.error, {.what = "where `accuracy` is given: what the point is off by"});
  v.record("chosen", r.chosen, {.what = "where `accuracy` is given: what the program has chosen for it, by key"});
  v.rest(r.details);
}

/// Computes the point. Nothing where the method was stopped.
std::optional<PointRow> compute_row(const casefile::Scene& scene, const Method& method, const Point& point,
                                    const Watch& watch);

}  // namespace strandyn::self_damping
