#pragma once
/// \file The finished points of a study, in a file of one JSON line each:
///
///     {"checksum":"0f3a...","point":3,"row":{...}}
///
///     {"checksum":"77b1...","table":{...}}
///
/// A table is a sectional loss that the quadrature has made for a tension. The first line names the study; the checksum
/// goes over the line behind it and over that name, so that a resumed study takes up its own points as they were
/// written and no others. A last line without its end is what a kill leaves and is dropped in silence; every other line
/// that does not hold is told, and its point computed again.

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include "strandyn/self_damping/method.hpp"

namespace strandyn::self_damping {

inline constexpr const char* log_name = "points.jsonl";

struct LogOptions {
  std::filesystem::path folder;  ///< empty: no file
  std::string study;             ///< study_identity
  bool resume = false;           ///< take up what is there; else it is replaced
  bool read_only = false;        ///< with `resume`: reads, and writes nothing
};

class PointLog {
 public:
  /// Reads what is there of this study where it is to be resumed, and opens the file for more.
  PointLog(const LogOptions& options, const std::vector<Point>& points);

  const std::map<std::size_t, PointRow>& rows() const { return rows_; }
  /// What was found wrong with the file, in words for the user.
  const std::optional<std::string>& fault() const { return fault_; }
  /// Lines that were there and did not hold; nothing where no file was taken up.
  std::optional<std::size_t> dropped() const { return dropped_; }
  /// The tables by their tensions [N].
  const std::map<double, LossTable>& tables() const { return tables_; }
  /// Adds a finished point; it is in the file when this returns. Throws FileError.
  void add(std::size_t point, const PointRow& row);
  /// Adds a table likewise.
  void add(const LossTable& table);
  /// Writes all points in order and marks the study as finished: the next run computes anew.
  void finish();

 private:
  void read(const std::vector<Point>& points);
  void write();
  void append(const std::string& line, const char* what);

  std::filesystem::path path_;
  std::string study_;
  std::ofstream file_;  ///< open for more
  bool finished_ = false;
  std::map<std::size_t, PointRow> rows_;
  std::map<double, LossTable> tables_;
  std::optional<std::string> fault_;
  std::optional<std::size_t> dropped_;
};

/// What the numbers of a point depend on: the program, its vector target (`machine`), and the case without what only
/// judges or sums up.
std::string study_identity(const casefile::Scene& scene, const std::string& machine);

}  // namespace strandyn::self_damping
