#include "strandyn/report/cycle_table.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "strandyn/report/text_table.hpp"

namespace strandyn::report {
namespace {

std::optional<double> number(const nlohmann::ordered_json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

std::optional<double> scaled(std::optional<double> value, double factor) {
  return value ? std::optional(*value / factor) : std::nullopt;
}

}  // namespace

std::vector<CycleRow> cycle_rows(const nlohmann::ordered_json& cycles) {
  std::vector<CycleRow> rows;
  for (const auto& cycle : cycles) {
    CycleRow row;
    row.cycle = rows.size() + 1;
    row.t = number(cycle, "t_s");
    row.antinode_amplitude = number(cycle, "antinode_amplitude_m");
    row.external = number(cycle, "external_work_J");
    row.friction = number(cycle, "friction_dissipation_J");
    row.viscous = number(cycle, "viscous_dissipation_J");
    row.numerical = number(cycle, "numerical_dissipation_J");
    row.elements_slipping = number(cycle, "elements_slipping");
    const double lost = row.friction.value_or(0) + row.viscous.value_or(0);
    if (row.external && row.friction && row.numerical) row.stored = *row.external - lost - *row.numerical;
    if (row.numerical && lost > 0) row.numerical_share = std::abs(*row.numerical) / lost;
    rows.push_back(row);
  }
  return rows;
}

Prefix energy_prefix(const std::vector<CycleRow>& rows) {
  double largest = 0;
  for (const CycleRow& row : rows) {
    for (const auto& energy : {row.external, row.stored, row.friction, row.viscous, row.numerical}) {
      largest = std::max(largest, std::abs(energy.value_or(0)));
    }
  }
  return prefix_for(largest);
}

std::vector<std::size_t> evenly_spaced(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  const std::size_t n = std::min(count, most);
  for (std::size_t i = 0; i < n; ++i) chosen.push_back(n == 1 ? count - 1 : (i * (count - 1) + (n - 1) / 2) / (n - 1));
  return chosen;
}

std::string cycle_table(const nlohmann::ordered_json& cycles, std::size_t most_rows) {
  const std::vector<CycleRow> rows = cycle_rows(cycles);
  if (rows.empty()) return {};
  const Prefix prefix = energy_prefix(rows);
  const std::string energy_unit = (prefix.symbol == "µ" ? "u" : std::string(prefix.symbol)) + "J";
  TextTable table({{.header = "cycle"},
                   {.header = "time", .unit = "s"},
                   {.header = "amplitude", .unit = "mm"},
                   {.header = "ext. work", .unit = energy_unit},
                   {.header = "stored", .unit = energy_unit},
                   {.header = "viscous", .unit = energy_unit},
                   {.header = "friction", .unit = energy_unit},
                   {.header = "numerical", .unit = energy_unit},
                   {.header = "share", .unit = "%", .digits = 3},
                   {.header = "slipping", .unit = "elements", .digits = 1}});
  for (const std::size_t i : evenly_spaced(rows.size(), most_rows)) {
    const CycleRow& row = rows[i];
    table.add_row({row.cycle, row.t, scaled(row.antinode_amplitude, 1e-3), scaled(row.external, prefix.factor),
                   scaled(row.stored, prefix.factor), scaled(row.viscous, prefix.factor),
                   scaled(row.friction, prefix.factor), scaled(row.numerical, prefix.factor),
                   scaled(row.numerical_share, 1e-2), row.elements_slipping});
  }
  return table.str();
}

}  // namespace strandyn::report
