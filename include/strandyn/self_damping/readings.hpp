#pragma once
/// \file What a method that vibrates a whole span tells of a point: records of the steady vibration and of the test
/// bench.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace strandyn::self_damping {

/// What a point loses, part by part. Self-damping is the first three: still air is none.
struct LossParts {
  double friction = 0, material = 0, viscous = 0, air = 0;      ///< [W/m] by the length of the span
  std::optional<double> material_free_span{}, air_free_span{};  ///< [W/m] without the end loops
  double self_damping() const { return friction + material + viscous; }
};
template <class V>
void members(V& v, LossParts& p) {
  double all = p.self_damping() + p.air;
  v.value("friction_W_per_m", p.friction, {.what = "by friction between the wires, over the length"});
  v.value("material_W_per_m", p.material, {.what = "by the metal of the wires, over the length"});
  v.value("viscous_W_per_m", p.viscous, {.what = "by viscous forces, over the length"});
  v.value("air_W_per_m", p.air, {.what = "by still air, over the length: no part of the self-damping"});
  v.value("dissipation_W_per_m", all, {.what = "all of these"});
  v.value("material_free_span_W_per_m", p.material_free_span, {.what = "by the metal, without the end loops"});
  v.value("air_free_span_W_per_m", p.air_free_span, {.what = "by still air, without the end loops"});
}

/// A span in steady vibration at phase resonance.
struct SpanVibration {
  int mode = 0;
  double span_length = 0;
  std::size_t elements = 0;
  double sticking_frequency = 0, resonance = 0;  ///< [Hz]
  double reached_amplitude = 0;                  ///< [m]
  double drive_power = 0;                        ///< [W]
  std::optional<double> drive_force{}, drive_motion{};
  std::optional<double> imbalance{};
  double loss_factor = 0;
  double effective_EI = 0;  ///< [-] over EI_max
  double mean_tension = 0, highest_tension = 0;
  std::optional<double> free_span_from{}, free_span_to{}, free_span_curvature{}, highest_curvature{};
  int harmonics = 0;
  int iterations = 0, loop_cycles = 0;
  double loop_closure = 0;
};
template <class V>
void members(V& v, SpanVibration& s) {
  v.value("mode", s.mode, {.what = "the mode that vibrates"});
  v.value("span_length_m", s.span_length, {.what = "the length at which it has the frequency"});
  v.value("elements", s.elements, {.what = "of the mesh"});
  v.value("sticking_frequency_Hz", s.sticking_frequency, {.what = "of the mode, all wires sticking"});
  v.value("resonance_Hz", s.resonance, {.what = "where force and velocity are in phase"});
  v.value("reached_amplitude_m", s.reached_amplitude, {.what = "of the antinode"});
  v.value("drive_power_W", s.drive_power, {.what = "of the shaker"});
  v.value("drive_force_N", s.drive_force, {.what = "amplitude of the shaker's force"});
  v.value("drive_motion_m", s.drive_motion, {.what = "amplitude of the shaker's motion"});
  v.value("imbalance", s.imbalance, {.what = "drive power less losses, relative"});
  v.value("loss_factor", s.loss_factor, {.what = "twice the damping ratio"});
  v.value("effective_EI_over_EI_max", s.effective_EI,
          {.what = "bending stiffness of the tensioned beam that has this resonance"});
  v.value("mean_tension_N", s.mean_tension, {.what = "over a cycle"});
  v.value("highest_tension_N", s.highest_tension, {.what = "in a cycle"});
  v.value("free_span_from_m", s.free_span_from, {.what = "the first inner node"});
  v.value("free_span_to_m", s.free_span_to, {.what = "the last inner node"});
  v.value("free_span_curvature_per_m", s.free_span_curvature,
          {.what = "amplitude of the sine that has the same mean square"});
  v.value("highest_curvature_per_m", s.highest_curvature, {.what = "in the free span, all harmonics counted"});
  v.value("harmonics", s.harmonics, {.what = "of the motion that was solved for"});
  v.value("iterations", s.iterations, {.what = "of Newton's method"});
  v.value("loop_cycles", s.loop_cycles, {.what = "until the sections' loops were closed"});
  v.value("loop_closure", s.loop_closure, {.what = "what they were open by"});
}

/// The four readings of a test bench, each a record.
struct LedgerRow {
  double friction = 0, material = 0, viscous = 0, air = 0;  ///< [J] per cycle
  double numerical = 0, quadrature_error = 0;               ///< [J] per cycle
  double power = 0;                                         ///< [W/m]
  std::optional<double> numerical_share{}, numerical_over_friction{};
};
template <class V>
void members(V& v, LedgerRow& r) {
  v.value("friction_dissipation_J", r.friction, {.what = "per cycle"});
  v.value("material_dissipation_J", r.material, {.what = "per cycle"});
  v.value("viscous_dissipation_J", r.viscous, {.what = "per cycle"});
  v.value("air_dissipation_J", r.air, {.what = "per cycle, no part of the self-damping"});
  v.value("numerical_dissipation_J", r.numerical, {.what = "per cycle: what the others leave over"});
  v.value("quadrature_error_J", r.quadrature_error, {.what = "per cycle, contained in the numerical part"});
  v.value("self_damping_W_per_m", r.power, {.what = "friction, material and viscous damping over the length"});
  v.value("numerical_share", r.numerical_share, {.what = "|numerical| over all physical losses"});
  v.value("numerical_over_friction", r.numerical_over_friction, {.what = "|numerical| over friction"});
}
struct PowerRow {
  double power = 0, from_work = 0;  ///< [W/m]
  std::optional<double> over_ledger{};
  double phase = 0;  ///< [deg]
};
template <class V>
void members(V& v, PowerRow& r) {
  v.value("self_damping_W_per_m", r.power, {.what = "force times velocity of the shaker, by their fundamentals"});
  v.value("from_work_W_per_m", r.from_work, {.what = "by the work of whole cycles"});
  v.value("over_ledger", r.over_ledger, {.what = "relative to the ledger, air included"});
  v.value("phase_deg", r.phase, {.what = "from the velocity to the force"});
}
struct IswrRow {
  double power = 0, ledger = 0;  ///< [W/m]
  std::optional<double> over_ledger{};
  double by_string = 0;  ///< [W/m]
  std::array<double, 2> nodes{};
  int loops = 0;
  std::array<double, 2> node_amplitudes{}, antinode_amplitudes{};
  double wave_EI = 0, wave_tension = 0;
};
template <class V>
void members(V& v, IswrRow& r) {
  v.value("self_damping_W_per_m", r.power, {.what = "inverse standing wave ratio between two nodes"});
  v.value("ledger_W_per_m", r.ledger, {.what = "the ledger by position, between the same nodes, without the air"});
  v.value("over_ledger", r.over_ledger, {.what = "the first over the second and the air"});
  v.value("by_string_W_per_m", r.by_string, {.what = "the form of the standards, sqrt(T m)"});
  v.value("nodes_m", r.nodes, {.what = "their places, the one nearer to the shaker first"});
  v.value("loops", r.loops, {.what = "between them"});
  v.value("node_amplitudes_m", r.node_amplitudes, {.what = "the smallest amplitudes there"});
  v.value("antinode_amplitudes_m", r.antinode_amplitudes, {.what = "of the antinodes beside them"});
  v.value("wave_EI_N_m2", r.wave_EI, {.what = "bending stiffness that the waves feel"});
  v.value("wave_tension_N", r.wave_tension, {.what = "tension that they run under"});
}
struct DecayRow {
  double power = 0;  ///< [W/m]
  std::optional<double> over_ledger{};
  double by_sine = 0, ledger = 0;  ///< [W/m]
  double decrement = 0, modal_energy = 0;
  std::vector<double> amplitudes{};
};
template <class V>
void members(V& v, DecayRow& r) {
  v.value("self_damping_W_per_m", r.power, {.what = "decrement times twice the modal energy"});
  v.value("over_ledger", r.over_ledger, {.what = "relative to the ledger of the steady vibration, air included"});
  v.value("by_sine_W_per_m", r.by_sine, {.what = "with m L V^2/4 as the energy, the form of the standards"});
  v.value("ledger_W_per_m", r.ledger, {.what = "the ledger of the decaying cycles at the same amplitude"});
  v.value("decrement", r.decrement, {.what = "the logarithmic one at the measured amplitude"});
  v.value("modal_energy_J", r.modal_energy, {.what = "kinetic energy of the fundamental at its crest"});
  v.value("amplitudes_m", r.amplitudes, {.what = "of the mode's coordinate, cycle by cycle"});
}
struct BenchReadings {
  int mode = 0;
  double span_length = 0, frequency = 0;
  double antinode_amplitude = 0, fundamental_amplitude = 0;
  std::optional<double> shaker_amplitude{}, shaker_force{};
  double shaker_at = 0;
  std::string tuned_at;
  double loss_exponent = 0;  ///< [-]
  LedgerRow ledger;
  PowerRow power;
  std::optional<IswrRow> iswr{};
  std::optional<DecayRow> decay{};
  int steps_per_cycle = 0;
  std::size_t cycles_until_steady = 0;
  std::uint64_t evaluations_until_steady = 0, section_evaluations = 0;
  std::size_t steps = 0;
};
template <class V>
void members(V& v, BenchReadings& b) {
  v.value("mode", b.mode, {.what = "the mode that vibrates"});
  v.value("span_length_m", b.span_length, {.what = "the length at which it has the frequency"});
  v.value("frequency_Hz", b.frequency, {.what = "of the drive in steady state"});
  v.value("antinode_amplitude_m", b.antinode_amplitude, {.what = "mean of the measured cycles"});
  v.value("fundamental_amplitude_m", b.fundamental_amplitude, {.what = "of the largest antinode, fundamental alone"});
  v.value("shaker_amplitude_m", b.shaker_amplitude, {.what = "of the shaker's motion"});
  v.value("shaker_force_N", b.shaker_force, {.what = "amplitude of the shaker's force"});
  v.value("shaker_at_m", b.shaker_at, {.what = "from the left support"});
  v.value("tuned_at", b.tuned_at, {.what = "shaker or antinode: where resonance was looked for"});
  v.value("loss_exponent", b.loss_exponent, {.what = "of the loss over the amplitude, by trial cycles of the mode"});
  v.record("ledger", b.ledger, {.what = "the energy ledger"});
  v.record("power", b.power, {.what = "the power method"});
  v.record("iswr", b.iswr, {.what = "inverse standing wave ratio"});
  v.record("decay", b.decay, {.what = "the decay method"});
  v.value("steps_per_cycle", b.steps_per_cycle, {.what = "of the integration"});
  v.value("cycles_until_steady", b.cycles_until_steady, {.what = "before the measured ones"});
  v.value("section_evaluations_until_steady", b.evaluations_until_steady, {.what = "before the measured cycles"});
  v.value("section_evaluations", b.section_evaluations, {.what = "in all"});
  v.value("steps", b.steps, {.what = "of the integration in all"});
}

}  // namespace strandyn::self_damping
