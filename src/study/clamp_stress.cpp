#include "clamp_stress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "strandyn/build/clamp.hpp"
#include "strandyn/fatigue/recorder.hpp"

namespace strandyn::study {

using casefile::Scene;
using section::Component;
using std::numbers::pi;

namespace {

struct ClampSummary {
  std::vector<ClampRow> clamps;
};
template <class V>
void members(V& v, ClampSummary& s) {
  v.list("clamps", s.clamps, {.what = "clamped supports in the last cycle of the vibration, with [clamps]"});
}

/// Lowest and highest value in a cycle.
struct Swing {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void widen(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  double amplitude() const { return (high - low) / 2; }
  double mean() const { return (high + low) / 2; }
};

/// Of a wire at one place.
struct WireSwing {
  Swing axial, outer, inner;   // [Pa]
  std::optional<double> slip;  // [m] along the layer below, when last looked at
  double travel = 0;           // [m] of it in the cycle
  const Swing& larger() const { return outer.amplitude() >= inner.amplitude() ? outer : inner; }
};

/// Around the lay at the place next to a clamp, and along the span the wire of each layer that swings most.
void add_figures(const results::Table& map, Outcome& outcome) {
  const auto &end = map.column("end"), &at = map.column("at_m"), &layer = map.column("layer");
  const auto &theta = map.column("theta_rad"), &amplitude = map.column("amplitude_Pa");
  std::map<std::array<double, 3>, double> largest;  // by end, layer, place
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < map.rows(); ++i) {
    nearest = std::min(nearest, at[i]);
    double& most = largest[{end[i], layer[i], at[i]}];
    most = std::max(most, amplitude[i]);
  }
  results::Table around({"end", "layer", "theta_rad", "amplitude_Pa"}), along({"end", "layer", "at_m", "largest_Pa"});
  for (std::size_t i = 0; i < map.rows(); ++i) {
    if (at[i] == nearest && layer[i] > 0) around.append(std::array{end[i], layer[i], theta[i], amplitude[i]});
  }
  for (const auto& [key, most] : largest) along.append(std::array{key[0], key[1], key[2], most});
  outcome.figures.push_back({.name = "clamp_wires_around",
                             .title = "Stress of the wires at the clamp",
                             .kind = "section",
                             .table = "clamp_wires_around.csv",
                             .x = "theta_rad",
                             .y = {"amplitude_Pa"},
                             .series = {"end", "layer"},
                             .caption = "Amplitude of the stress of the wires of each layer around the lay, with their "
                                        "own bending, next to the last point of contact (end 0: left)."});
  outcome.figures.push_back({.name = "clamp_wires_along",
                             .title = "Stress of the wires beside the clamp",
                             .table = "clamp_wires_along.csv",
                             .x = "at_m",
                             .y = {"largest_Pa"},
                             .series = {"end", "layer"},
                             .caption =
                                 "The wire of each layer whose stress swings most, by the distance from the last "
                                 "point of contact."});
  outcome.tables.push_back({.file = "clamp_wires_around.csv", .table = std::move(around)});
  outcome.tables.push_back({.file = "clamp_wires_along.csv", .table = std::move(along)});
}

}  // namespace

class ClampObserver::Clamp {
 public:
  Clamp(const Scene& scene, const span::SpanAtRest& span, bool is_right)
      : scene_(&scene),
        span_(&span),
        is_right_(is_right),
        has_wires_(build::has_wires(scene.section.law)),
        is_spatial_(model::is_spatial(span.built.model.freedom)) {
    const model::Model& model = span.built.model;
    const std::vector<double> arc = model::arc_lengths(model);
    const double length = arc.back();
    const auto from_clamp = [&](double s) { return is_right ? length - s : s; };
    for (std::size_t e = 0; e < model.elements.size(); ++e) {
      const double l = arc[e + 1] - arc[e];
      const double a = std::min(from_clamp(arc[e]), from_clamp(arc[e + 1]));
      if (a <= keys().distance && keys().distance <= a + l) {
        element_ = e;
        part_ = is_right ? 1 - (keys().distance - a) / l : (keys().distance - a) / l;
      }
      for (std::size_t g = 0; g < beam::gauss_points; ++g) {
        const double at = from_clamp(arc[e] + beam::gauss_position[g] * l);
        if (at <= keys().within) points_.push_back({.point = e * beam::gauss_points + g, .at = at});
      }
    }
    std::ranges::sort(points_, {}, &Place::at);
  }

  /// Deflection at the distance where the bending amplitude is read: cubic in its element.
  void read_deflection(const observe::StepRecord& record) {
    const double y = deflection(record.u.data());
    now_.deflection.widen(y);
    recorder_.add(record.time, y);
  }

  void look_at_wires(const system::System& system) {
    if (!has_wires_) return;
    const conductor::Strand& strand = scene_->conductor->strand;
    const section::Field& strains = system.committed_strains();
    std::size_t place = 0;
    const auto next = [&]() -> WireSwing& {
      if (place == now_.wires.size()) now_.wires.emplace_back();
      return now_.wires[place++];
    };
    for (const Place& p : points_) {
      const double chi2 = strains[Component::bending2][p.point];
      const double chi3 = is_spatial_ ? strains[Component::bending3][p.point] : 0;
      const section::WireState state = system.model().law->wires(system.history(), strains, p.point);
      theta_ = state.theta;
      const double eps = strains[Component::axial][p.point];
      const conductor::Layer& core = strand.layers.front();
      widen(next(), core.young * eps, core.young * core.diameter / 2 * std::hypot(chi2, chi3));
      std::vector<double> below(theta_.size(), 0.0);  // [m] slip of the layer below
      for (std::size_t j = 0; j < state.layers.size(); ++j) {
        const conductor::Layer& layer = strand.layers[j + 1];
        const double c = std::cos(layer.lay_angle);
        for (std::size_t i = 0; i < theta_.size(); ++i) {
          const double radial = chi2 * std::cos(theta_[i]) + chi3 * std::sin(theta_[i]);
          const double around = chi3 * std::cos(theta_[i]) - chi2 * std::sin(theta_[i]);
          const double own = layer.young * layer.diameter / 2 * c * std::hypot(radial, c * around);
          WireSwing& wire = next();
          widen(wire, state.whole_force(state.layers[j], i) / layer.wire_area, std::copysign(own, -around));
          const double slip = std::copysign(state.layers[j].slip[i], layer.lay_angle * state.layers[j].slip[i]);
          move(wire, slip - below[i]);
          below[i] = slip;
          now_.contact_load = std::max(now_.contact_load, state.layers[j].inner_load[i]);
        }
      }
    }
  }

  void end_cycle() {
    last_ = std::move(now_);
    now_ = {};
    now_.wires.resize(last_.wires.size());
    for (std::size_t i = 0; i < last_.wires.size(); ++i) now_.wires[i].slip = last_.wires[i].slip;
  }

  ClampRow row(double frequency, std::optional<double> antinode_amplitude) const {
    const conductor::Strand& strand = scene_->conductor->strand;
    const analysis::SurfaceWire surface = build::surface_wire(strand);
    const build::SectionNumbers& numbers = span_->built.numbers;
    ClampRow row{.end = is_right_ ? "right" : "left", .bending_amplitude = 2 * last_.deflection.amplitude()};
    row.poffenberger_swart = analysis::bending_stress(
        {.tension = span_->built.tension, .EI_min = numbers.EI_min, .distance = keys().distance}, surface,
        row.bending_amplitude);
    if (antinode_amplitude) {
      row.by_velocity = pi * surface.young * surface.diameter * frequency * *antinode_amplitude *
                        std::sqrt(*casefile::mass_per_length(*scene_) / numbers.EI_min);
    }
    if (row.poffenberger_swart > 0) {
      row.cycles_endured = fatigue::cycles_endured(build::aluminium_layers(strand), row.poffenberger_swart);
    }
    if (last_.wires.empty()) return row;
    row.contact_load = last_.contact_load;
    row.slip_travel = std::ranges::max(last_.wires, {}, &WireSwing::travel).travel;
    for_each_wire([&](const Place& p, std::size_t layer, std::size_t angle, const WireSwing& wire) {
      if (row.worst && wire.larger().amplitude() <= row.worst->amplitude) return;
      row.worst = WorstWire{.layer = layer,
                            .wire = wire_at(layer, angle, p.at),
                            .at = p.at,
                            .amplitude = wire.larger().amplitude(),
                            .mean = wire.larger().mean(),
                            .axial_amplitude = wire.axial.amplitude()};
    });
    return row;
  }

  void add_rows(results::Table& table) const {
    if (last_.wires.empty()) return;
    for_each_wire([&](const Place& p, std::size_t layer, std::size_t angle, const WireSwing& wire) {
      table.append(std::array{is_right_ ? 1.0 : 0.0, p.at, static_cast<double>(layer), layer == 0 ? 0.0 : theta_[angle],
                              static_cast<double>(wire_at(layer, angle, p.at)), wire.larger().amplitude(),
                              wire.larger().mean(), wire.axial.amplitude(), wire.axial.mean(), wire.travel});
    });
  }

  /// As a recorder there would write it.
  results::NamedTable recorder_table() const {
    results::Table table({"bending_amplitude_um", "frequency_Hz", "cycles"});
    for (const fatigue::RecordedCycles& row : recorder_.matrix()) {
      table.append(std::array{1e6 * row.bending_amplitude, row.frequency, row.cycles});
    }
    return {.file = is_right_ ? "recorder_right.csv" : "recorder_left.csv", .table = std::move(table)};
  }

  void archive(Archive& a) {
    recorder_.archive(a);
    for (Cycle* cycle : {&now_, &last_}) {
      std::size_t wires = cycle->wires.size();
      a(wires);
      cycle->wires.resize(wires);
      for (WireSwing& wire : cycle->wires) {
        for (Swing* swing : {&wire.axial, &wire.outer, &wire.inner}) archive(a, *swing);
        a(wire.slip, wire.travel);
      }
      archive(a, cycle->deflection);
      a(cycle->contact_load);
    }
    std::size_t angles = theta_.size();
    a(angles);
    theta_.resize(angles);
    for (double& theta : theta_) a(theta);
  }

 private:
  struct Place {
    std::size_t point = 0;
    double at = 0;  // [m] from the clamp
  };
  struct Cycle {
    Swing deflection;              // [m]
    std::vector<WireSwing> wires;  // place by place: the core, then layer by layer all angles
    double contact_load = 0;       // [N/m]
  };

  const casefile::ClampKeys& keys() const { return *scene_->clamps; }

  /// A swing that has not begun has no finite ends.
  static void archive(Archive& a, Swing& swing) {
    bool begun = swing.high >= swing.low;
    a(begun);
    if (!begun) {
      swing = {};
      return;
    }
    if (a.reads()) swing = {.low = 0, .high = 0};
    a(swing.low, swing.high);
  }

  static void widen(WireSwing& wire, double axial, double own) {
    wire.axial.widen(axial);
    wire.outer.widen(axial + own);
    wire.inner.widen(axial - own);
  }

  static void move(WireSwing& wire, double slip) {
    if (wire.slip) wire.travel += std::abs(slip - *wire.slip);
    wire.slip = slip;
  }

  double deflection(const double* u) const {
    const model::Model& model = span_->built.model;
    const double l = model.elements[element_].span.norm();
    const double y1 = model.displacement(u, element_).y(), y2 = model.displacement(u, element_ + 1).y();
    const double t1 = l * model.rotation(u, element_).z(), t2 = l * model.rotation(u, element_ + 1).z();
    const double s = part_, r = 1 - part_;
    return r * r * (1 + 2 * s) * y1 + s * s * (3 - 2 * s) * y2 + s * r * (r * t1 - s * t2);
  }

  template <class F>
  void for_each_wire(const F& f) const {
    const std::size_t layers = scene_->conductor->strand.layers.size();
    std::size_t place = 0;
    for (const Place& p : points_) {
      f(p, 0, 0, last_.wires[place++]);
      for (std::size_t layer = 1; layer < layers; ++layer) {
        for (std::size_t angle = 0; angle < theta_.size(); ++angle) f(p, layer, angle, last_.wires[place++]);
      }
    }
  }

  /// Which wire passes at this angle, at this distance from the clamp.
  std::size_t wire_at(std::size_t layer, std::size_t angle, double at) const {
    const conductor::Layer& l = scene_->conductor->strand.layers[layer];
    if (layer == 0 || l.wires < 2) return 0;
    const double along = is_right_ ? -at : at;
    const double at_clamp = theta_[angle] - along * std::tan(l.lay_angle) / l.helix_radius;
    const auto number = static_cast<long>(std::lround(at_clamp * l.wires / (2 * pi))) % l.wires;
    return static_cast<std::size_t>(number < 0 ? number + l.wires : number);
  }

  const Scene* scene_;
  const span::SpanAtRest* span_;
  bool is_right_, has_wires_, is_spatial_;
  std::size_t element_ = 0;  // in which the bending amplitude is read
  double part_ = 0;          // [-] of it, from its left node
  std::vector<Place> points_;
  std::vector<double> theta_;  // [rad]
  Cycle now_, last_;
  fatigue::Recorder recorder_;
};

ClampObserver::ClampObserver(const Scene& scene, const span::SpanAtRest& span, double frequency)
    : scene_(scene), frequency_(frequency) {
  if (scene.span->left == casefile::Support::clamped) clamps_.emplace_back(scene, span, false);
  if (scene.span->right == casefile::Support::clamped) clamps_.emplace_back(scene, span, true);
}

ClampObserver::~ClampObserver() = default;

void ClampObserver::begin(const system::System& system, const observe::StepRecord& initial) {
  for (Clamp& clamp : clamps_) {
    clamp.read_deflection(initial);
    clamp.look_at_wires(system);
  }
}

void ClampObserver::step(const system::System& system, const observe::StepRecord& record) {
  const double cycle = record.time * frequency_;
  constexpr double rounding = 1e-6;
  const auto sample = static_cast<std::size_t>(cycle * scene_.clamps->samples_per_cycle + rounding);
  const bool look = sample > samples_;
  const bool ends = cycle + rounding >= static_cast<double>(cycles_ + 1);
  for (Clamp& clamp : clamps_) {
    clamp.read_deflection(record);
    if (look) clamp.look_at_wires(system);
    if (ends) clamp.end_cycle();
  }
  samples_ = std::max(samples_, sample);
  if (ends) ++cycles_;
}

void ClampObserver::archive(Archive& a) {
  a(cycles_, samples_);
  for (Clamp& clamp : clamps_) clamp.archive(a);
}

void ClampObserver::add_to(std::optional<double> antinode_amplitude, Outcome& outcome) const {
  if (cycles_ == 0) return;
  ClampSummary summary;
  results::Table map({"end", "at_m", "layer", "theta_rad", "wire", "amplitude_Pa", "mean_Pa", "axial_amplitude_Pa",
                      "axial_mean_Pa", "slip_travel_m"});
  for (const Clamp& clamp : clamps_) {
    summary.clamps.push_back(clamp.row(frequency_, antinode_amplitude));
    clamp.add_rows(map);
    outcome.tables.push_back(clamp.recorder_table());
  }
  outcome.tell(summary);
  if (map.rows() == 0) {
    outcome.warnings.push_back(
        "[clamps]: this section law knows no wires, so their stresses are not told: use law = "
        "\"return-map\"");
    return;
  }
  add_figures(map, outcome);
  outcome.tables.push_back({.file = "clamp_wires.csv", .table = std::move(map)});
}

std::vector<results::MemberNote> ClampObserver::notes() {
  return results::ReferenceWriter::of<ClampSummary>();
}

void check_clamps(const Scene& scene) {
  if (!scene.clamps) return;
  if (!scene.conductor) {
    refuse(scene.source, "clamps", "speaks of wires, and there is no [conductor]", "give one, or remove the table");
  }
  if (scene.span->left != casefile::Support::clamped && scene.span->right != casefile::Support::clamped) {
    refuse(scene.source, "clamps", "no support of this span is clamped", "give left or right = \"clamped\"");
  }
  if (scene.clamps->distance > scene.span->total_length()) {
    refuse(scene.source, "clamps.bending_amplitude_at_mm", "lies outside the span", "give a smaller distance");
  }
}

}  // namespace strandyn::study
