#pragma once
/// \file What a damper analysis leaves: a row a frequency and velocity, peaks and third octaves, its tables.

#include <optional>
#include <string>
#include <vector>

#include "strandyn/damper/damper.hpp"
#include "strandyn/results/record.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

/// A row of damper.csv.
struct DamperRow {
  double velocity = 0, frequency = 0;
  double impedance = 0, phase = 0, power = 0, energy = 0, friction = 0, material = 0, curvature = 0;
};
template <class V>
void members(V& v, DamperRow& r) {
  v.value("clamp_velocity_m_per_s", r.velocity, {.what = "amplitude of the clamp's velocity"});
  v.value("frequency_Hz", r.frequency, {.what = "of the clamp"});
  v.value("impedance_N_s_per_m", r.impedance, {.what = "amplitude of the force over that of the velocity"});
  v.value("phase_deg", r.phase, {.what = "of the force, ahead of the velocity"});
  v.value("power_W", r.power, {.what = "that the clamp feeds"});
  v.value("energy_J", r.energy, {.what = "the same per cycle"});
  v.value("friction_J", r.friction, {.what = "of it, friction between the wires of the messenger, per cycle"});
  v.value("material_J", r.material, {.what = "of it, the metal of the messenger, per cycle"});
  v.value("clamp_curvature_per_m", r.curvature,
          {.what = "largest amplitude of the messengers' curvature at the clamp, of the fundamental"});
}

struct PeakRow {
  double frequency = 0, power = 0;
};
template <class V>
void members(V& v, PeakRow& p) {
  v.value("frequency_Hz", p.frequency, {.what = "where the power has a maximum"});
  v.value("power_W", p.power, {.what = "there"});
}

/// Mean power over a third of an octave.
struct BandRow {
  double centre = 0, power = 0;
  std::optional<double> reduced{};
};
template <class V>
void members(V& v, BandRow& b) {
  v.value("centre_Hz", b.centre, {.what = "of the third octave, 1000 Hz times a power of 2^(1/3)"});
  v.value("power_W", b.power, {.what = "mean over the band"});
  v.value("reduced_power_W", b.reduced, {.what = "the same by arms of two unknowns"});
}

struct ShakenRow {
  double velocity = 0;
  std::vector<PeakRow> peaks{}, reduced_peaks{};
  std::vector<BandRow> bands{};
};
template <class V>
void members(V& v, ShakenRow& s) {
  v.value("clamp_velocity_m_per_s", s.velocity, {.what = "amplitude of the clamp's velocity"});
  v.list("peaks", s.peaks, {.what = "maxima of the power, ascending in frequency"});
  v.list("reduced_peaks", s.reduced_peaks, {.what = "the same by arms of two unknowns"});
  v.list("third_octaves", s.bands, {.what = "mean power in whole third octaves"});
}

struct FailedRow {
  double velocity = 0, frequency = 0;
  std::string why{};
};
template <class V>
void members(V& v, FailedRow& f) {
  v.value("clamp_velocity_m_per_s", f.velocity, {.what = "amplitude of the clamp's velocity"});
  v.value("frequency_Hz", f.frequency, {.what = "of the clamp"});
  v.value("why", f.why, {.what = "no answer was found"});
}

struct ArmRow {
  std::vector<double> frequencies{};
};
template <class V>
void members(V& v, ArmRow& a) {
  v.value("natural_frequencies_Hz", a.frequencies, {.what = "held at the clamp, all wires sticking"});
}

struct DamperSummary {
  std::vector<ArmRow> arms{};
  std::vector<ShakenRow> velocities{};
  std::vector<FailedRow> failed{};
};
template <class V>
void members(V& v, DamperSummary& s) {
  v.list("arms", s.arms, {.what = "each arm, in the order of the case"});
  v.list("clamp_velocities", s.velocities, {.what = "for each velocity of the clamp"});
  v.list("failed", s.failed, {.what = "frequencies at which an arm has no answer: no rows of the tables"});
}

/// Rows of some frequencies and velocities, and those that are missing.
struct DamperRows {
  std::vector<DamperRow> rows{};
  std::vector<FailedRow> failed{};

  /// Both arms and the clamp's own mass [kg] together.
  void add(const std::vector<damper::ArmAnswer>& arms, double clamp_mass);
};
/// Peaks and bands of the rows of one velocity, beside those of `reduced`, which may be empty.
ShakenRow shaken_at(double velocity, const std::vector<DamperRow>& main, const std::vector<DamperRow>& reduced);
/// `reduced` beside `chain`, or either of them alone.
void add_damper_tables(const std::vector<DamperRow>& chain, const std::vector<DamperRow>& reduced, Outcome& outcome);

}  // namespace strandyn::study
