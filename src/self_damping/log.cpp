#include "strandyn/self_damping/log.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <sstream>

#include "strandyn/casefile/echo.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/results/json.hpp"
#include "strandyn/version.hpp"

namespace strandyn::self_damping {

namespace {

/// FNV-1a, 64 bits.
std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 1099511628211U;
  }
  return hash;
}

/// One line of the file.
struct LogLine {
  std::optional<std::string> study{};
  std::optional<std::size_t> point{};
  std::optional<PointRow> row{};
  std::optional<bool> finished{};
};
template <class V>
void members(V& v, LogLine& l) {
  v.value("study", l.study, {.what = "which study the points belong to"});
  v.value("point", l.point, {.what = "the number of the point"});
  v.record("row", l.row, {.what = "the point"});
  v.value("finished", l.finished, {.what = "the study has come to its end"});
}

std::string text_of(const LogLine& line) {
  return results::to_text(results::to_value(line), -1) + '\n';
}

}  // namespace

std::string study_identity(const casefile::Scene& scene, const std::string& machine) {
  const results::Value as_run = casefile::case_as_run(scene);
  results::Value identity = results::Value::object();
  for (const auto& [key, value] : as_run.members()) {
    if (key == "title" || key == "accept") continue;  // they touch no number of a point
    if (key != "analysis") {
      identity.set(key, value);
      continue;
    }
    results::Value analysis = results::Value::object();
    for (const auto& [inner, entry] : value.members()) {
      if (inner != "energy_balance" && inner != "bands_over_diameter") analysis.set(inner, entry);
    }
    identity.set(key, std::move(analysis));
  }
  const std::string program = fmt::format("{} {} {} {}", program_version, program_revision, program_compiler, machine);
  return fmt::format("{:016x}", hash_of(results::to_text(identity, -1) + program));
}

PointLog::PointLog(const std::filesystem::path& folder, const std::string& study) : study_(study) {
  if (folder.empty()) return;
  path_ = folder / "points.jsonl";
  if (std::filesystem::exists(path_)) read();
  write();
}

void PointLog::read() {
  std::istringstream lines(results::read_file(path_));
  std::string line;
  bool ours = std::getline(lines, line) && line + '\n' == text_of({.study = study_});
  while (ours && std::getline(lines, line)) {
    const auto value = results::from_line(line);
    if (!value) break;  // the line that the end of the program cut
    LogLine entry;
    results::RecordReader::fill(entry, *value);
    if (entry.finished) ours = false;
    if (entry.point && entry.row) rows_[*entry.point] = *entry.row;
  }
  if (!ours) rows_.clear();
}

void PointLog::write() {
  file_.close();
  std::string text = text_of({.study = study_});
  for (const auto& [point, row] : rows_) text += text_of({.point = point, .row = row});
  if (finished_) text += text_of({.finished = true});
  results::write_file(path_, text);
  file_.open(path_, std::ios::app | std::ios::binary);
}

void PointLog::add(std::size_t point, const PointRow& row) {
  rows_[point] = row;
  if (path_.empty()) return;
  file_ << text_of({.point = point, .row = row}) << std::flush;
  if (!file_) throw FileError(fmt::format("{}: a finished point could not be written", path_.string()));
}

void PointLog::finish() {
  finished_ = true;
  if (!path_.empty()) write();
}

}  // namespace strandyn::self_damping
