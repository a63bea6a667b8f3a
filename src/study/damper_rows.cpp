#include "damper_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::study {

namespace {

std::vector<const DamperRow*> answered_at(double velocity, const std::vector<DamperRow>& rows) {
  std::vector<const DamperRow*> found;
  for (const DamperRow& row : rows) {
    if (row.velocity == velocity) found.push_back(&row);
  }
  return found;
}

/// Maxima of the power, each by the parabola through the three points about it, in the logarithm of the frequency. What
/// is a thousandth of the largest power may be ripple.
std::vector<PeakRow> peaks_of(const std::vector<const DamperRow*>& rows) {
  std::vector<PeakRow> peaks;
  double largest = 0;
  for (const DamperRow* row : rows) largest = std::max(largest, row->power);
  for (std::size_t i = 1; i + 1 < rows.size(); ++i) {
    const double before = rows[i - 1]->power, here = rows[i]->power, after = rows[i + 1]->power;
    if (!(here > before && here >= after && here > 1e-3 * largest)) continue;
    const double x0 = std::log(rows[i - 1]->frequency / rows[i]->frequency);
    const double x2 = std::log(rows[i + 1]->frequency / rows[i]->frequency);
    const double left = (before - here) / x0, right = (after - here) / x2;
    const double bend = (right - left) / (x2 - x0);
    const double slope = left - bend * x0;
    const double top = bend < 0 ? std::clamp(-slope / (2 * bend), x0, x2) : 0;
    peaks.push_back({.frequency = rows[i]->frequency * std::exp(top), .power = here + slope * top + bend * top * top});
  }
  return peaks;
}

/// [W] mean over a band of frequencies, by trapezoids over ln f; nothing where the rows do not reach across it.
std::optional<double> mean_power(const std::vector<const DamperRow*>& rows, double low, double high) {
  if (rows.empty() || rows.front()->frequency > low || rows.back()->frequency < high) return std::nullopt;
  const auto at = [&](double f) {
    const auto next = std::ranges::lower_bound(rows, f, {}, [](const DamperRow* row) { return row->frequency; });
    if (next == rows.begin()) return (*next)->power;
    const DamperRow& a = **(next - 1);
    const DamperRow& b = **next;
    const double part = std::log(f / a.frequency) / std::log(b.frequency / a.frequency);
    return (1 - part) * a.power + part * b.power;
  };
  double sum = 0, f = low, power = at(low);
  const auto go_to = [&](double next, double then) {
    sum += (power + then) / 2 * std::log(next / f);
    f = next;
    power = then;
  };
  for (const DamperRow* row : rows) {
    if (row->frequency > low && row->frequency < high) go_to(row->frequency, row->power);
  }
  go_to(high, at(high));
  return sum / std::log(high / low);
}

}  // namespace

void DamperRows::add(const std::vector<damper::ArmAnswer>& arms, double clamp_mass) {
  const damper::Shake& shake = arms.front().shake;
  DamperRow row{.velocity = shake.velocity, .frequency = shake.frequency};
  damper::Complex Z{0, shake.omega() * clamp_mass};
  for (const damper::ArmAnswer& arm : arms) {
    if (!arm.converged) {
      failed.push_back({.velocity = shake.velocity, .frequency = shake.frequency, .why = arm.failure});
      return;
    }
    Z += arm.impedance();
    row.friction += arm.friction;
    row.material += arm.material;
    row.curvature = std::max(row.curvature, arm.clamp_curvature);
  }
  row.impedance = std::abs(Z);
  row.phase = std::arg(Z) * 180 / std::numbers::pi;
  row.power = shake.velocity * shake.velocity * Z.real() / 2;
  row.energy = row.power / shake.frequency;
  rows.push_back(row);
}

ShakenRow shaken_at(double velocity, const std::vector<DamperRow>& main, const std::vector<DamperRow>& reduced) {
  ShakenRow shaken{.velocity = velocity};
  const auto rows = answered_at(velocity, main);
  const auto others = answered_at(velocity, reduced);
  shaken.peaks = peaks_of(rows);
  shaken.reduced_peaks = peaks_of(others);
  const double half = std::exp2(1.0 / 6);
  for (int band = -24; band <= 0; ++band) {  // 3.9 Hz to 1000 Hz
    const double centre = 1000 * std::exp2(band / 3.0);
    const auto power = mean_power(rows, centre / half, centre * half);
    if (!power) continue;
    shaken.bands.push_back(
        {.centre = centre, .power = *power, .reduced = mean_power(others, centre / half, centre * half)});
  }
  return shaken;
}

void add_damper_tables(const std::vector<DamperRow>& chain, const std::vector<DamperRow>& reduced, Outcome& outcome) {
  const std::vector<DamperRow>& main = chain.empty() ? reduced : chain;
  if (main.empty()) return;
  outcome.tables.push_back({.file = "damper.csv", .table = results::table_of(main)});
  if (!chain.empty() && !reduced.empty()) {
    outcome.tables.push_back({.file = "reduced.csv", .table = results::table_of(reduced)});
  }
  const auto draw = [&](const char* name, const char* title, const char* column, const char* caption) {
    outcome.figures.push_back({.name = name,
                               .title = title,
                               .table = "damper.csv",
                               .x = "frequency_Hz",
                               .y = {column},
                               .series = {"clamp_velocity_m_per_s"},
                               .caption = caption});
  };
  draw("impedance", "Impedance", "impedance_N_s_per_m", "Force over velocity at the clamp.");
  draw("phase", "Phase", "phase_deg", "Of the force ahead of the velocity; 0 where all of it feeds power.");
  draw("power", "Power", "power_W", "That the clamp feeds.");
  outcome.shown.push_back(
      {.title = "Impedance and power",
       .table = "damper.csv",
       .columns = {"clamp_velocity_m_per_s", "frequency_Hz", "impedance_N_s_per_m", "phase_deg", "power_W"}});
}

}  // namespace strandyn::study
