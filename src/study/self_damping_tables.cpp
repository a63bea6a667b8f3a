#include "self_damping_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strandyn/analysis/published_laws.hpp"
#include "strandyn/self_damping/fit.hpp"
#include "strandyn/self_damping/grid_fit.hpp"

namespace strandyn::study {

using casefile::DampingMethod;
using casefile::Scene;
using self_damping::PointRow;
using self_damping::Quadrature;

namespace {

/// Six digits: what was given as one velocity is one line of a figure.
double rounded(double value) {
  if (value == 0) return 0;
  const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 5);
  return std::round(value / unit) * unit;
}

/// Lines that hold more than one point each.
bool makes_lines(const results::Table& table, const std::vector<std::string>& series) {
  std::vector<std::size_t> all(table.rows());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return 2 * results::groups_of(table, series, all).size() <= table.rows();
}

/// [W/m] the least and the largest of the published laws that have a factor for this conductor.
struct Published {
  explicit Published(const Scene& scene) {
    if (!scene.conductor || scene.conductor->strand.rated_strength <= 0) return;
    const analysis::RatedConductor rated = self_damping::rated_conductor(scene);
    for (const analysis::PublishedLaw& law : analysis::published_laws()) {
      if (const auto full = analysis::law_for(law, rated)) laws.push_back(*full);
    }
  }
  std::array<double, 2> at(const analysis::TestCondition& condition) const {
    std::vector<double> powers;
    for (const analysis::PowerLaw& law : laws) powers.push_back(analysis::power(law, condition));
    const auto [low, high] = std::ranges::minmax(powers);
    return {low, high};
  }
  std::vector<analysis::PowerLaw> laws;
};

/// One line for each value of `series`, on logarithmic axes.
results::Figure power_figure(std::string_view name, std::string_view against, const results::NamedTable& of,
                             const char* x, std::vector<std::string> series, const std::string& caption) {
  const auto& powers = of.table.column("self_damping_W_per_m");
  const bool any_loss = std::ranges::any_of(powers, [](double w) { return w > 0; });
  results::Figure figure{.name = fmt::format("self_damping_{}{}", name, against),
                         .title = fmt::format("Self-damping, {}", name),
                         .table = of.file,
                         .x = x,
                         .y = {"self_damping_W_per_m"},
                         .series = std::move(series),
                         .x_scale = "log",
                         .y_scale = any_loss ? "log" : "linear",
                         .caption = caption};
  if (of.table.has("fitted_W_per_m")) {
    figure.y.emplace_back("fitted_W_per_m");
    figure.caption += " Dashed: the fitted power law.";
  }
  return figure;
}

/// The published laws beside the points, at the points.
void add_published_figure(std::string_view name, const results::NamedTable& of, Outcome& outcome) {
  const auto& powers = of.table.column("self_damping_W_per_m");
  if (!of.table.has("published_low_W_per_m") || std::ranges::count_if(powers, [](double w) { return w > 0; }) < 2) {
    return;
  }
  std::vector<std::string> columns = {"published_low_W_per_m", "published_high_W_per_m"};
  if (of.table.has("fitted_W_per_m")) columns.emplace_back("fitted_W_per_m");
  outcome.figures.push_back({.name = fmt::format("self_damping_{}_published", name),
                             .title = "Published laws and the fit, against the points",
                             .kind = "points",
                             .table = of.file,
                             .x = "self_damping_W_per_m",
                             .y = columns,
                             .x_scale = "log",
                             .y_scale = "log",
                             .caption = "At each point: the least and the largest of the published laws that have a "
                                        "factor for this conductor, and the fitted law. They differ among themselves "
                                        "by 3 to 50 times."});
}

/// What of a table of balances fits on a terminal.
std::vector<std::string> shown_columns(const results::Table& table) {
  std::vector<std::string> columns;
  for (const char* name : {"balance", "tension_N", "frequency_Hz", "wind_speed_m_per_s", "amplitude_over_diameter",
                           "bare_amplitude_over_diameter", "dampers_W", "bending_stress_Pa"}) {
    if (table.has(name)) columns.emplace_back(name);
  }
  return columns;
}

}  // namespace

namespace {

/// The points of one method, those of one grid where it is named.
class PointTables {
 public:
  PointTables(const Scene& scene, const std::vector<PointRow>& rows, const std::optional<analysis::PowerLaw>& fitted)
      : scene_(scene), rows_(rows), fitted_(fitted), published_(scene) {}

  results::Table of(std::string_view method, std::optional<std::string_view> grid) const {
    const bool has_fit = fitted_ && method == name_of(scene_.as<casefile::SelfDampingAnalysis>().method);
    const double diameter = scene_.conductor ? scene_.conductor->strand.outer_diameter() : 0;
    std::vector<std::string> names(std::begin(always), std::end(always));
    if (!published_.laws.empty()) names.insert(names.end(), {"published_low_W_per_m", "published_high_W_per_m"});
    if (has_fit) names.emplace_back("fitted_W_per_m");
    results::Table table(names);
    for (const PointRow& row : rows_) {
      if (row.method != method || !row.has_numbers() || (grid && row.grid != *grid)) continue;
      const self_damping::LossParts parts = row.parts.value_or(self_damping::LossParts{.friction = *row.self_damping});
      const analysis::TestCondition at{
          .antinode_amplitude = row.antinode_amplitude, .frequency = row.frequency, .tension = row.tension};
      std::vector<double> values = {row.frequency,
                                    row.antinode_amplitude,
                                    row.tension,
                                    *row.self_damping,
                                    row.free_span.value_or(*row.self_damping),
                                    parts.friction,
                                    parts.material,
                                    parts.air,
                                    diameter > 0 ? rounded(row.antinode_amplitude / diameter) : 0,
                                    rounded(2 * std::numbers::pi * row.frequency * row.antinode_amplitude)};
      if (!published_.laws.empty()) {
        for (const double power : published_.at(at)) values.push_back(power);
      }
      if (has_fit) values.push_back(analysis::power(*fitted_, at));
      table.append(values);
    }
    return table;
  }

  static constexpr const char* always[] = {"frequency_Hz",
                                           "antinode_amplitude_m",
                                           "tension_N",
                                           "self_damping_W_per_m",
                                           "self_damping_free_span_W_per_m",
                                           "friction_W_per_m",
                                           "material_W_per_m",
                                           "air_W_per_m",
                                           "amplitude_over_diameter",
                                           "antinode_velocity_m_per_s"};
  static constexpr std::size_t shown = 8;  // of these

 private:
  const Scene& scene_;
  const std::vector<PointRow>& rows_;
  const std::optional<analysis::PowerLaw>& fitted_;
  Published published_;
};

/// Against frequency a study has lines where its points share velocities, or amplitudes.
void add_by_frequency(const PointTables& tables, std::string_view name, const results::NamedTable& all,
                      Outcome& outcome) {
  const std::vector<std::string> by_velocity = {"tension_N", "antinode_velocity_m_per_s"},
                                 by_amplitude = {"tension_N", "amplitude_over_diameter"};
  const std::string velocities = "Against the frequency, a line for each tension and antinode velocity.";
  results::NamedTable own{.file = fmt::format("points_{}_by_velocity.csv", name),
                          .table = tables.of(name, self_damping::velocity_grid)};
  if (own.table.rows() > 0 && own.table.rows() < all.table.rows() && makes_lines(own.table, by_velocity)) {
    outcome.figures.push_back(power_figure(name, "_frequency", own, "frequency_Hz", by_velocity, velocities));
    outcome.tables.push_back(std::move(own));
  } else if (makes_lines(all.table, by_velocity)) {
    outcome.figures.push_back(power_figure(name, "_frequency", all, "frequency_Hz", by_velocity, velocities));
  } else if (makes_lines(all.table, by_amplitude)) {
    outcome.figures.push_back(power_figure(name, "_frequency", all, "frequency_Hz", by_amplitude,
                                           "Against the frequency, a line for each tension and amplitude."));
  }
}

}  // namespace

void add_point_tables(const Scene& scene, const std::vector<PointRow>& rows,
                      const std::optional<analysis::PowerLaw>& fitted, Outcome& outcome) {
  const PointTables tables(scene, rows, fitted);
  for (const auto& [method, name] : choices<DampingMethod>) {
    results::NamedTable all{.file = fmt::format("points_{}.csv", name), .table = tables.of(name, {})};
    if (all.table.rows() == 0) continue;
    outcome.figures.push_back(power_figure(name, "", all, "amplitude_over_diameter", {"tension_N", "frequency_Hz"},
                                           "Dissipated power per metre of span against the antinode amplitude over "
                                           "the diameter."));
    add_by_frequency(tables, name, all, outcome);
    add_published_figure(name, all, outcome);
    outcome.shown.push_back({.title = fmt::format("Points by {}", name),
                             .table = all.file,
                             .columns = {PointTables::always, PointTables::always + PointTables::shown}});
    outcome.tables.push_back(std::move(all));
  }
}

void add_local_exponents(const Scene& scene, const std::vector<PointRow>& rows, Outcome& outcome) {
  results::Table table(
      {"antinode_velocity_m_per_s", "frequency_Hz", "antinode_amplitude_m", "tension_N", "l", "m", "n"});
  for (const std::string_view grid : {self_damping::velocity_grid, self_damping::amplitude_grid}) {
    for (const auto& local :
         self_damping::local_exponents(self_damping::points_to_fit(scene, rows, self_damping::dissipation_of, grid))) {
      if (!local.l || !local.m || !local.n) continue;
      table.append(std::array{2 * std::numbers::pi * local.at.frequency * local.at.antinode_amplitude,
                              local.at.frequency, local.at.antinode_amplitude, local.at.tension, *local.l, *local.m,
                              *local.n});
    }
  }
  if (table.rows() < 2) return;
  outcome.figures.push_back({.name = "local_exponents",
                             .title = "Exponents from point to point",
                             .kind = "points",
                             .table = "local_exponents.csv",
                             .x = "frequency_Hz",
                             .y = {"l", "m", "n"},
                             .caption =
                                 "Exponents of amplitude (l), frequency (m) and tension (n) of all that is lost, "
                                 "by differences between neighbouring points. One power law would be three lines."});
  outcome.tables.push_back({.file = "local_exponents.csv", .table = std::move(table)});
}

void add_readings(const std::vector<PointRow>& rows, Outcome& outcome) {
  results::Table table({"antinode_amplitude_m", "frequency_Hz", "tension_N", "ledger_W_per_m", "power_W_per_m",
                        "iswr_W_per_m", "decay_W_per_m"});
  for (const PointRow& row : rows) {
    if (!row.bench || !row.bench->iswr || !row.bench->decay) continue;
    table.append(std::array{row.antinode_amplitude, row.frequency, row.tension, row.bench->ledger.power,
                            row.bench->power.power, row.bench->iswr->power, row.bench->decay->power});
  }
  if (table.rows() == 0) return;
  outcome.shown.push_back(
      {.title = "Readings of the test bench", .table = "bench_readings.csv", .columns = table.names()});
  outcome.tables.push_back({.file = "bench_readings.csv", .table = std::move(table)});
  outcome.figures.push_back({.name = "bench_readings",
                             .title = "Readings of the test bench",
                             .table = "bench_readings.csv",
                             .x = "antinode_amplitude_m",
                             .y = {"ledger_W_per_m", "power_W_per_m", "iswr_W_per_m", "decay_W_per_m"},
                             .series = {"tension_N", "frequency_Hz"},
                             .caption = "One vibration read in the four ways of the standards."});
}

void add_loss_table(const Quadrature& quadrature, Outcome& outcome) {
  results::Table table({"tension_N", "curvature_per_m", "loss_J_per_m"});
  for (const Quadrature::Table& entry : quadrature.tables()) {
    outcome.cost.section_evaluations += entry.loss.effort().evaluations;
    outcome.cost.section_sweeps += entry.loss.effort().sweeps;
    for (std::size_t i = 0; i < entry.loss.amplitudes().size(); ++i) {
      table.append(std::array{entry.tension, entry.loss.amplitudes()[i], entry.loss.losses()[i]});
    }
  }
  if (table.rows() >= 2) {
    outcome.figures.push_back({.name = "sectional_loss",
                               .title = "Loss of a section per cycle",
                               .table = "sectional_loss.csv",
                               .x = "curvature_per_m",
                               .y = {"loss_J_per_m"},
                               .series = {"tension_N"},
                               .x_scale = "log",
                               .y_scale = "log",
                               .caption = "What friction takes from a metre in one symmetric cycle of curvature."});
  }
  outcome.tables.push_back({.file = "sectional_loss.csv", .table = std::move(table)});
}

void add_balances(const std::vector<self_damping::BalanceRow>& rows, Outcome& outcome) {
  results::Table table = self_damping::table_of_balances(rows);
  if (table.rows() >= 2) {
    outcome.figures.push_back({.name = "energy_balance",
                               .title = "Vibration of the conductor in the wind",
                               .table = "energy_balance.csv",
                               .x = "frequency_Hz",
                               .y = {"amplitude_over_diameter"},
                               .series = {"balance", "tension_N"},
                               .caption = "Amplitude over diameter at which the power of the wind is what is lost."});
  }
  if (table.rows() >= 1) {
    outcome.shown.push_back({.title = "Vibration of the conductor in the wind",
                             .table = "energy_balance.csv",
                             .columns = shown_columns(table)});
  }
  outcome.tables.push_back({.file = "energy_balance.csv", .table = std::move(table)});
}

}  // namespace strandyn::study
