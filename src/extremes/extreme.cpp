#include "strandyn/extremes/extreme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>

#include "themes.hpp"

namespace strandyn::extremes {

std::string Measure::words() const {
  if (std::isinf(at_least)) return fmt::format("{} {:.3g} <= {:.3g}", what, value, at_most);
  if (std::isinf(at_most)) return fmt::format("{} {:.3g} >= {:.3g}", what, value, at_least);
  return fmt::format("{} {:.5g} in [{:.5g}, {:.5g}]", what, value, at_least, at_most);
}

Found& Found::close(const std::string& what, double value, double expected, double relative) {
  return most(fmt::format("{} {:.8g} against {:.8g}, off by", what, value, expected), std::abs(value / expected - 1),
              relative);
}

bool Row::passed() const {
  return error.empty() && !found.measures.empty() &&
         std::all_of(found.measures.begin(), found.measures.end(), [](const Measure& m) { return m.holds(); });
}

std::vector<Extreme> all_extremes() {
  std::vector<Extreme> all;
  for (const auto theme : {tension_rows, amplitude_rows, frequency_rows, step_rows, cycle_rows, mesh_rows, law_rows,
                           friction_rows, load_rows, rotation_rows, core_rows}) {
    for (Extreme& row : theme()) all.push_back(std::move(row));
  }
  return all;
}

Row run_extreme(const Extreme& extreme) {
  Row row{.extreme = extreme, .found = {}, .error = {}};
  const std::clock_t start = std::clock();
  try {
    row.found = extreme.run();
  } catch (const std::exception& error) {
    // Whatever it is: a hard case that ends in an error has failed.
    row.error = error.what();
  }
  row.cpu_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return row;
}

std::vector<Row> run_extremes(const std::vector<std::string>& names,
                              const std::function<void(const std::string&)>& started) {
  std::vector<Row> rows;
  for (const Extreme& extreme : all_extremes()) {
    const bool asked = names.empty() || std::any_of(names.begin(), names.end(), [&](const std::string& part) {
                         return extreme.name.find(part) != std::string::npos;
                       });
    if (!asked) continue;
    if (started) started(extreme.name);
    rows.push_back(run_extreme(extreme));
  }
  return rows;
}

}  // namespace strandyn::extremes
