#pragma once
/// \file What a clamped support feels in the last cycle of a vibration: the bending amplitude that recorders read, the
/// stresses that are made of it, and beside them the stress of every wire.
///
/// The stress of a wire is that of its axial force, as the section law has it, and that of its own bending:
///     sigma = F_w/A_w +- E (d/2) cos a sqrt(chi_r^2 + cos^2 a chi_t^2)
/// chi_r and chi_t are the parts of the strand's curvature about the radius to the wire and about the tangent of its
/// circle; the last factor is the curvature of a helix whose strand is bent, as in EI_min (conductor/constants.hpp).
/// The upper sign is the fibre away from the strand's neutral plane, the lower one the fibre towards it. The contact
/// forces' own stresses and the notch that fretting makes are not in it.
///
/// Wires are numbered by where they stand at the last point of contact: wire i of n at the angle 2 pi i/n, counted from
/// axis 2 towards axis 3, and turn with their lay from there.

#include <optional>
#include <string>
#include <vector>

#include "strandyn/observe/step_record.hpp"
#include "strandyn/results/reference.hpp"
#include "strandyn/span/rest.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

struct WorstWire {
  std::size_t layer = 0, wire = 0;
  double at = 0, amplitude = 0, mean = 0, axial_amplitude = 0;
};
template <class V>
void members(V& v, WorstWire& w) {
  v.value("layer", w.layer, {.what = "from the core, which is 0"});
  v.value("wire", w.wire, {.what = "of the layer, by its place at the last point of contact"});
  v.value("at_m", w.at, {.what = "from the last point of contact"});
  v.value("amplitude_Pa", w.amplitude, {.what = "half of peak to peak, with the wire's own bending"});
  v.value("mean_Pa", w.mean, {.what = "half-way between both ends of that swing"});
  v.value("axial_amplitude_Pa", w.axial_amplitude, {.what = "of it, by the axial force alone"});
}

/// One entry of `clamps` of summary.json.
struct ClampRow {
  std::string end;
  double bending_amplitude = 0, poffenberger_swart = 0;
  std::optional<double> by_velocity{};
  std::optional<double> cycles_endured{};
  std::optional<WorstWire> worst{};
  std::optional<double> contact_load{};
  std::optional<double> slip_travel{};
};
template <class V>
void members(V& v, ClampRow& c) {
  v.value("end", c.end, {.what = "left or right"});
  v.value("bending_amplitude_m", c.bending_amplitude,
          {.what = "peak to peak, at the distance from the last point of contact", .shown = "bending amplitude"});
  v.value("poffenberger_swart_Pa", c.poffenberger_swart,
          {.what = "amplitude in a surface wire, from the bending amplitude", .shown = "Poffenberger-Swart stress"});
  v.value("f_ymax_Pa", c.by_velocity,
          {.what = "the same from frequency and antinode amplitude, pi E d f y_max sqrt(m/EI_min)"});
  v.value("cycles_endured", c.cycles_endured,
          {.what = "of the Poffenberger-Swart stress, by CIGRE's safe border line"});
  v.record("worst_wire", c.worst, {.what = "the wire whose stress swings most"});
  v.value("largest_contact_load_N_per_m", c.contact_load,
          {.what = "of a wire on the layer below it, in the stretch beside the clamp"});
  v.value("largest_slip_travel_m", c.slip_travel,
          {.what = "in a cycle, to and fro, of a wire along the layer below it, as it would be in a strand bent evenly "
                   "over a lay length: beside a clamp, which holds the wires, it is less"});
}

/// Watches the clamped ends of a span that vibrates at `frequency` [Hz].
class ClampObserver final : public observe::Observer {
 public:
  ClampObserver(const casefile::Scene& scene, const span::SpanAtRest& span, double frequency);
  ~ClampObserver() override;

  void begin(const system::System& system, const observe::StepRecord& initial) override;
  void step(const system::System& system, const observe::StepRecord& record) override;
  void archive(Archive& a) override;

  /// Of the last whole cycle, which had this antinode amplitude [m] if it is known, and what a recorder would have
  /// counted in all of them; nothing before one has ended.
  void add_to(std::optional<double> antinode_amplitude, Outcome& outcome) const;
  static std::vector<results::MemberNote> notes();

 private:
  class Clamp;
  const casefile::Scene& scene_;
  double frequency_;
  std::vector<Clamp> clamps_;
  std::size_t cycles_ = 0, samples_ = 0;  // that have ended, that were taken
};

/// Refuses [clamps] where nothing is clamped.
void check_clamps(const casefile::Scene& scene);

}  // namespace strandyn::study
