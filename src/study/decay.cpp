#include "decay.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strandyn/analysis/decay_curve.hpp"
#include "strandyn/analysis/methods.hpp"

namespace strandyn::study {

using analysis::DampingAtAmplitude;

namespace {

/// A row of decay.csv.
struct DecayRow {
  std::size_t cycle = 0;
  double amplitude = 0, log_decrement = 0, loss_factor_by_decrement = 0;
  double damping_ratio = 0, loss_factor = 0, self_damping = 0;
};
template <class V>
void members(V& v, DecayRow& r) {
  v.value("cycle", r.cycle, {.what = "from 1"});
  v.value("antinode_amplitude_m", r.amplitude, {.what = "half of peak to peak in the cycle"});
  v.value("log_decrement", r.log_decrement, {.what = "of the amplitudes of the cycle before and the one after"});
  v.value("loss_factor_by_decrement", r.loss_factor_by_decrement,
          {.what = "the decrement over pi: it contains what the integrator takes, and swings where modes beat"});
  v.value("damping_ratio", r.damping_ratio, {.what = "by the ledger, of the antinode's velocity"});
  v.value("loss_factor", r.loss_factor, {.what = "by the ledger: twice the damping ratio"});
  v.value("self_damping_W_per_m", r.self_damping, {.what = "by the ledger, over the length"});
}

struct DecayRecord {
  std::optional<double> exponent{};
  std::vector<DecayRow> at{};
};
template <class V>
void members(V& v, DecayRecord& d) {
  v.value("amplitude_exponent", d.exponent,
          {.what = "l of self-damping ~ amplitude^l over the cycles that lose anything, a least-squares line",
           .shown = "self-damping goes with the amplitude to the power"});
  v.list("at", d.at, {.what = "damping at five amplitudes, evenly spaced in their logarithm; all are in decay.csv"});
}

struct DecaySummary {
  DecayRecord decay;
};
template <class V>
void members(V& v, DecaySummary& s) {
  v.record("decay", s.decay, {.what = "damping against amplitude"});
}

DecayRow row_of(const DampingAtAmplitude& at) {
  return {.cycle = static_cast<std::size_t>(at.number),
          .amplitude = at.amplitude,
          .log_decrement = at.log_decrement,
          .loss_factor_by_decrement = at.log_decrement / std::numbers::pi,
          .damping_ratio = at.damping_ratio,
          .loss_factor = at.loss_factor,
          .self_damping = at.power};
}

/// Those nearest to amplitudes evenly spaced in their logarithm, in the order of time.
std::vector<DecayRow> some_of(const std::vector<DecayRow>& rows) {
  constexpr int count = 5;
  std::vector<DecayRow> some;
  const double first = std::log(rows.front().amplitude);
  const double step = (std::log(rows.back().amplitude) - first) / (count - 1);
  for (int i = 0; i < count; ++i) {
    const auto away = [&](const DecayRow& row) { return std::abs(std::log(row.amplitude) - first - i * step); };
    const DecayRow& nearest = *std::ranges::min_element(rows, {}, away);
    if (some.empty() || nearest.cycle > some.back().cycle) some.push_back(nearest);
  }
  return some;
}

}  // namespace

double damping_ratio_of(const observe::Cycle& cycle, const analysis::SpanNumbers& span) {
  return analysis::damping_ratio_at(cycle.self_damping() * span.frequency / span.length, cycle.antinode_amplitude,
                                    span);
}

std::vector<results::MemberNote> notes_of_decay() {
  return results::ReferenceWriter::of<DecaySummary>();
}

void add_decay(const std::vector<NumberedCycle>& cycles, const analysis::SpanNumbers& span, Outcome& outcome) {
  constexpr const char* file = "decay.csv";
  std::vector<analysis::DecayingCycle> decaying;
  for (const NumberedCycle& c : cycles) {
    decaying.push_back({.number = static_cast<double>(c.number),
                        .amplitude = c.cycle.antinode_amplitude,
                        .lost = c.cycle.self_damping()});
  }
  const std::vector<DampingAtAmplitude> curve = analysis::damping_against_amplitude(decaying, span);
  if (curve.empty()) return;
  std::vector<DecayRow> rows;
  for (const DampingAtAmplitude& at : curve) rows.push_back(row_of(at));
  outcome.tell(DecaySummary{.decay = {.exponent = analysis::exponent_of_amplitude(curve), .at = some_of(rows)}});
  outcome.tables.push_back({.file = file, .table = results::table_of(rows)});
  outcome.figures.push_back(
      {.name = "damping_against_amplitude",
       .title = "Damping against amplitude",
       .table = file,
       .x = "antinode_amplitude_m",
       .y = {"loss_factor", "loss_factor_by_decrement"},
       .x_scale = "log",
       .y_scale = "log",
       .caption =
           "Loss factor of each cycle of the decay, by the ledger, and by the decrement of the amplitudes, which "
           "also has what the integrator takes and the beats of other modes."});
  outcome.shown.push_back({.title = "Damping against amplitude",
                           .table = file,
                           .columns = {"cycle", "antinode_amplitude_m", "log_decrement", "loss_factor_by_decrement",
                                       "loss_factor", "self_damping_W_per_m"}});
}

}  // namespace strandyn::study
