#pragma once
/// \file What the files of the self-damping study share.

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include "strandyn/analysis/power_law.hpp"
#include "strandyn/study/run_case.hpp"
#include "strandyn/study/self_damping.hpp"

namespace strandyn::study {

/// The finished points of a study, in a file of one JSON line each: {"point": 3, "row": {...}}. The first line names
/// the study, so that a restarted one takes up its own points and no others; a last line that was cut is dropped.
class PointLog {
 public:
  /// Reads what is there of this study and opens the file for more; a folder that is empty means no file.
  PointLog(const std::filesystem::path& folder, const std::string& study);

  const std::map<std::size_t, nlohmann::ordered_json>& rows() const { return rows_; }
  /// Adds a finished point; it is in the file when this returns. Throws FileError.
  void add(std::size_t point, const nlohmann::ordered_json& row);
  /// Writes all points in order and marks the study as finished: the next run computes anew.
  void finish();

 private:
  std::string header() const;
  void write();

  std::filesystem::path path_;
  std::string study_;
  std::ofstream file_;  ///< open for more
  bool finished_ = false;
  std::map<std::size_t, nlohmann::ordered_json> rows_;
};

/// What the numbers of a point depend on: program and case, without what only judges or sums up.
std::string study_identity(const casefile::Scene& scene);

/// The rows of one road as points to fit: whole span, or free span.
enum class DampingOf { whole_span, free_span };
std::vector<analysis::SelfDampingPoint> points_to_fit(const nlohmann::ordered_json& rows, casefile::DampingRoad road,
                                                      DampingOf what);

nlohmann::ordered_json fit_json(const analysis::PowerLawFit& fit);
/// `fit`, `fit_free_span`, `bands`, `published` of the summary; returns the law of the fit, if there is one.
std::optional<analysis::PowerLaw> add_fits(const casefile::Scene& scene, nlohmann::ordered_json& summary);

/// `no_slip_below` of the summary: the antinode amplitude at which the first contact slips, by tension and frequency.
void add_onsets(const casefile::Scene& scene, const Quadrature& quadrature, const std::vector<Point>& points,
                nlohmann::ordered_json& summary);

/// `roads` of the summary: points that were reached by several roads, each road beside the dearest of them, and what is
/// behind a difference of the free span. A warning where they differ by more than a twentieth.
void add_road_comparison(const Quadrature& quadrature, nlohmann::ordered_json& summary);

struct BalanceInputs {
  const casefile::Scene& scene;
  const std::vector<Point>& points;
  const Quadrature* quadrature = nullptr;      ///< where a balance asks for it
  std::optional<analysis::PowerLaw> fit = {};  ///< of the study
};
/// `energy_balance` of the summary.
void add_energy_balances(const BalanceInputs& inputs, CaseResult& result);

/// `study` of what `describe` tells.
void describe_self_damping(const casefile::Scene& scene, nlohmann::ordered_json& out);

/// Whether a table of sectional losses is wanted at all.
bool needs_quadrature(const casefile::SelfDampingAnalysis& analysis);

std::vector<double> distinct_tensions(const std::vector<Point>& points);

}  // namespace strandyn::study
