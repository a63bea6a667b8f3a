#pragma once
/// \file What a transient leaves in summary.json and in energies.csv.

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "findings.hpp"
#include "plan.hpp"
#include "strandyn/span/rest.hpp"

namespace strandyn::study {

using span::Components;

/// One row of energies.csv: energies of the state, works and losses since the start.
struct EnergyRow {
  double time = 0;
  double kinetic = 0, elastic = 0, external_work = 0, wind = 0, friction = 0, material = 0, viscous = 0, air = 0,
         attached = 0;
  double numerical = 0, quadrature_error = 0;
};
template <class V>
void members(V& v, EnergyRow& e) {
  v.value("t_s", e.time, {.what = "the end of the step"});
  v.value("kinetic_J", e.kinetic, {.what = "kinetic energy"});
  v.value("elastic_J", e.elastic, {.what = "elastic energy above that of the initial state"});
  v.value("external_work_J", e.external_work, {.what = "work of the loads and of moved supports"});
  v.value("wind_work_J", e.wind, {.what = "work of the wind"});
  v.value("friction_dissipation_J", e.friction, {.what = "friction between the wires"});
  v.value("material_dissipation_J", e.material, {.what = "damping of the metal of the wires"});
  v.value("viscous_dissipation_J", e.viscous, {.what = "all viscous damping"});
  v.value("air_dissipation_J", e.air, {.what = "still air"});
  v.value("damper_dissipation_J", e.attached, {.what = "friction and metal of Stockbridge dampers"});
  v.value("numerical_dissipation_J", e.numerical, {.what = "what the other terms leave over"});
  v.value("quadrature_error_J", e.quadrature_error, {.what = "contained in the numerical part with a minus"});
}

/// `energy` of the summary: the last row, and what belongs to the whole run.
struct EnergySummary {
  EnergyRow end;
  double initial_kinetic = 0, largest_kinetic = 0;
  std::optional<double> numerical_share{};
};
template <class V>
void members(V& v, EnergySummary& e) {
  v.part(e.end);
  v.value("initial_kinetic_J", e.initial_kinetic, {.what = "at the start"});
  v.value("largest_kinetic_J", e.largest_kinetic, {.what = "of all steps"});
  v.value("numerical_share", e.numerical_share,
          {.what = "|numerical| over all physical losses", .shown = "numerical share"});
}

/// Where the energy came from and where it went.
inline std::vector<std::string> findings_of(const EnergySummary& energy) {
  const EnergyRow& end = energy.end;
  std::string came, went;
  const auto list = [](std::string& words, double value, const char* what) {
    if (value != 0) words += fmt::format("{}{} by {}", words.empty() ? "" : ", ", amount(value, "J"), what);
  };
  list(came, end.external_work, "loads and supports");
  list(came, end.wind, "the wind");
  list(went, end.friction, "friction between the wires");
  list(went, end.material, "the metal");
  list(went, end.viscous, "viscous damping");
  list(went, end.air, "still air");
  list(went, end.attached, "dampers");
  std::vector<std::string> found;
  found.push_back(fmt::format("In {:.4g} s came in: {}. Lost: {}. The integrator's own part is {}.", end.time,
                              came.empty() ? "nothing" : came, went.empty() ? "nothing" : went,
                              amount(end.numerical, "J")));
  return found;
}

struct ProbeRange {
  Components min{}, max{}, end{};
};
template <class V>
void members(V& v, ProbeRange& r) {
  v.value("min", r.min, {.what = "the lowest, by component"});
  v.value("max", r.max, {.what = "the highest"});
  v.value("end", r.end, {.what = "at the end"});
}
struct ProbeRow {
  double arc = 0;
  ProbeRange displacement;
  std::optional<double> frequency{};
};
template <class V>
void members(V& v, ProbeRow& p) {
  v.value("arc_m", p.arc, {.what = "where it is, along the span"});
  v.record("displacement_m", p.displacement, {.what = "from the initial state"});
  v.value("frequency_Hz", p.frequency, {.what = "mean over whole cycles of the direction that moves most"});
}

struct MomentumRow {
  Components linear{}, centre_velocity{}, impulse{};
  double largest_deviation = 0;
};
template <class V>
void members(V& v, MomentumRow& m) {
  v.value("linear_kg_m_per_s", m.linear, {.what = "momentum at the end"});
  v.value("centre_velocity_m_per_s", m.centre_velocity, {.what = "of the centre of mass"});
  v.value("impulse_N_s", m.impulse, {.what = "of all that acts from outside"});
  v.value("largest_deviation_N_s", m.largest_deviation, {.what = "of the change of momentum from the impulse"});
}

struct TransientSummary {
  std::optional<span::Rest> rest{};
  PlanRow plan{};
  std::optional<WindRow> wind{};
  double end_time = 0;
  std::vector<ProbeRow> probes{};
  MomentumRow momentum{};
  EnergySummary energy{};
};
template <class V>
void members(V& v, TransientSummary& s) {
  v.record("rest", s.rest, {.what = "how a hanging span hangs"});
  v.record("plan", s.plan, {.what = "how it was integrated"});
  v.record("wind", s.wind, {.what = "the wind, where there is one"});
  v.value("end_time_s", s.end_time, {.what = "that was reached"});
  v.list("probes", s.probes, {.what = "the points whose motion was written"});
  v.record("momentum", s.momentum, {.what = "of the chain, against the impulse"});
  v.record("energy", s.energy, {.what = "the ledger at the end"});
}

}  // namespace strandyn::study
