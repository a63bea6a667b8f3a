#pragma once
/// \file The finished points of a study, in a file of one JSON line each: {"point": 3, "row": {...}}. The first line
/// names the study, so that a restarted one takes up its own points and no others; a last line that was cut is dropped.

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "strandyn/self_damping/method.hpp"

namespace strandyn::self_damping {

class PointLog {
 public:
  /// Reads what is there of this study and opens the file for more; a folder that is empty means no file.
  PointLog(const std::filesystem::path& folder, const std::string& study);

  const std::map<std::size_t, PointRow>& rows() const { return rows_; }
  /// Adds a finished point; it is in the file when this returns. Throws FileError.
  void add(std::size_t point, const PointRow& row);
  /// Writes all points in order and marks the study as finished: the next run computes anew.
  void finish();

 private:
  void read();
  void write();

  std::filesystem::path path_;
  std::string study_;
  std::ofstream file_;  ///< open for more
  bool finished_ = false;
  std::map<std::size_t, PointRow> rows_;
};

/// What the numbers of a point depend on: the program, its vector target (`machine`), and the case without what only
/// judges or sums up.
std::string study_identity(const casefile::Scene& scene, const std::string& machine);

}  // namespace strandyn::self_damping
