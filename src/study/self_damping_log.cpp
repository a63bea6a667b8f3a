#include <fmt/format.h>

#include <cstdint>
#include <sstream>

#include "self_damping_parts.hpp"
#include "strandyn/casefile/echo.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/section/return_map.hpp"
#include "strandyn/version.hpp"

namespace strandyn::study {

using json = nlohmann::ordered_json;

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

std::string line_of(std::size_t point, const json& row) {
  return json{{"point", point}, {"row", row}}.dump() + '\n';
}

}  // namespace

std::string study_identity(const casefile::Scene& scene) {
  json identity = casefile::case_as_run(scene);
  for (const char* key : {"title", "accept"}) identity.erase(key);
  for (const char* key : {"energy_balance", "bands_over_diameter"}) identity["analysis"].erase(key);
  identity["program"] = {program_version, program_revision, program_compiler, section::vector_target().name};
  return fmt::format("{:016x}", hash_of(identity.dump()));
}

PointLog::PointLog(const std::filesystem::path& folder, const std::string& study) : study_(study) {
  if (folder.empty()) return;
  path_ = folder / "points.jsonl";
  if (std::filesystem::exists(path_)) {
    std::istringstream lines(results::read_file(path_));
    std::string line;
    bool ours = std::getline(lines, line) && line + '\n' == header();
    while (ours && std::getline(lines, line)) {
      const json entry = json::parse(line, nullptr, false);
      if (entry.is_discarded()) break;  // the line that the end of the program cut
      if (entry.contains("finished")) ours = false;
      if (entry.contains("row")) rows_[entry["point"]] = entry["row"];
    }
    if (!ours) rows_.clear();
  }
  write();
}

std::string PointLog::header() const {
  return json{{"study", study_}}.dump() + '\n';
}

void PointLog::write() {
  file_.close();
  std::string text = header();
  for (const auto& [point, row] : rows_) text += line_of(point, row);
  if (finished_) text += json{{"finished", true}}.dump() + '\n';
  results::write_file(path_, text);
  file_.open(path_, std::ios::app | std::ios::binary);
}

void PointLog::add(std::size_t point, const json& row) {
  rows_[point] = row;
  if (path_.empty()) return;
  file_ << line_of(point, row) << std::flush;
  if (!file_) throw FileError(fmt::format("{}: a finished point could not be written", path_.string()));
}

void PointLog::finish() {
  finished_ = true;
  if (!path_.empty()) write();
}

}  // namespace strandyn::study
