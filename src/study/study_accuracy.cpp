#include "study_accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace strandyn::study {

using self_damping::PointRow;

std::optional<StudyError> error_of(const casefile::Scene& scene, const std::vector<PointRow>& rows) {
  const std::optional<double> target = casefile::target_error(scene);
  if (!target) return std::nullopt;
  std::optional<StudyError> error;
  double evaluations = 0;
  std::vector<double> tensions;  // whose table has been counted
  std::size_t above = 0, unknown = 0;
  for (const PointRow& row : rows) {
    if (!row.error) continue;
    above += row.error->relative && *row.error->relative > *target ? 1 : 0;
    unknown += row.error->relative ? 0 : 1;
    const bool by_table = row.method == name_of(casefile::DampingMethod::quadrature);
    if (!by_table || std::ranges::find(tensions, row.tension) == tensions.end()) {
      evaluations += static_cast<double>(row.error->section_evaluations);
      if (by_table) tensions.push_back(row.tension);
    }
    const auto size = [](const self_damping::PointError& e) { return e.relative.value_or(INFINITY); };
    if (error && size(*row.error) <= size(error->worst)) continue;
    error = {.target = *target,
             .worst = *row.error,
             .method = row.method,
             .frequency = row.frequency,
             .antinode_amplitude = row.antinode_amplitude,
             .tension = row.tension};
  }
  if (!error) return std::nullopt;
  error->worst.section_evaluations = static_cast<std::uint64_t>(evaluations);
  error->above = above;
  error->unknown = unknown;
  return error;
}

std::optional<std::string> warning_of(const StudyError& error, std::size_t points) {
  if (error.above + error.unknown == 0) return std::nullopt;
  std::string words = fmt::format("{} of {} points may be off by more than the {:.2g} % that were asked for",
                                  error.above + error.unknown, points, 100 * error.target);
  if (error.worst.relative) words += fmt::format(", by {:.2g} % at most", 100 * *error.worst.relative);
  if (error.unknown > 0) words += fmt::format("; of {} no error could be estimated", error.unknown);
  return words + "; each says by what in its error_estimate";
}

}  // namespace strandyn::study
