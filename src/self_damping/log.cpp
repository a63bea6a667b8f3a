#include "strandyn/self_damping/log.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "strandyn/casefile/echo.hpp"
#include "strandyn/core/checksum.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/results/json.hpp"
#include "strandyn/version.hpp"

namespace strandyn::self_damping {

namespace {

/// One line of the file.
struct LogLine {
  std::optional<std::string> study{};
  std::optional<std::size_t> point{};
  std::optional<PointRow> row{};
  std::optional<LossTable> table{};
  std::optional<bool> finished{};
};
template <class V>
void members(V& v, LogLine& l) {
  v.value("study", l.study, {.what = "which study the points belong to"});
  v.value("point", l.point, {.what = "the number of the point"});
  v.record("row", l.row, {.what = "the point"});
  v.record("table", l.table, {.what = "the losses of a section at a tension"});
  v.value("finished", l.finished, {.what = "the study has come to its end"});
}

/// What is written in place of the opening brace of a line whose rest this is.
std::string seal_of(std::string_view rest, const std::string& study) {
  return fmt::format("{{\"checksum\":\"{:016x}\",", checksum(study + std::string(rest)));
}

/// A line with its checksum and its end.
std::string text_of(const LogLine& line, const std::string& study) {
  const std::string rest = results::to_text(results::to_value(line), -1).substr(1);
  return seal_of(rest, study) + rest + '\n';
}

/// The line again, if it is as it was written.
std::optional<LogLine> line_of(std::string_view text, const std::string& study) {
  const std::string_view rest = text.substr(std::min(text.size(), seal_of("", study).size()));
  if (checksums_count && !text.starts_with(seal_of(rest, study))) return std::nullopt;
  const auto value = results::from_line('{' + std::string(rest));
  LogLine line;
  if (!value || results::RecordReader::fill(line, *value) > 0) return std::nullopt;
  return line;
}

/// Whether the row is of this point, whatever wrote it.
bool belongs(const PointRow& row, const Point& point) {
  return row.frequency == point.frequency && row.antinode_amplitude == point.antinode_amplitude &&
         row.tension == point.tension && row.method == name_of(point.method) &&
         row.failed.has_value() != row.has_numbers();
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
  return fmt::format("{:016x}", checksum(results::to_text(identity, -1) + program));
}

PointLog::PointLog(const LogOptions& options, const std::vector<Point>& points) : study_(options.study) {
  if (options.folder.empty()) return;
  path_ = options.folder / log_name;
  if (options.resume && std::filesystem::exists(path_)) read(points);
  if (options.read_only) {
    path_.clear();
  } else {
    write();
  }
}

void PointLog::read(const std::vector<Point>& points) {
  const std::string file = results::read_file(path_);
  std::string_view rest = file;
  std::size_t number = 0, first_bad = 0, bad = 0;
  dropped_ = 0;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) break;  // cut by the end of the program
    const std::optional<LogLine> line = line_of(rest.substr(0, end), study_);
    rest.remove_prefix(end + 1);
    ++number;
    const bool head = line && line->study == study_;
    if (number == 1 && !head) {
      rows_.clear();
      tables_.clear();
      dropped_ = static_cast<std::size_t>(std::ranges::count(rest, '\n'));
      fault_ = fmt::format(
          "{}: its first line does not name this study as this program would: all points are computed "
          "again; resume with the case and the program that began it",
          path_.string());
      return;
    }
    if (line && line->finished) {
      rows_.clear();
      tables_.clear();
      return;
    }
    const bool whole =
        line && line->point && *line->point < points.size() && line->row && belongs(*line->row, points[*line->point]);
    const bool whole_table = line && line->table && line->table->is_sound();
    if (whole) rows_[*line->point] = *line->row;
    if (whole_table) tables_[line->table->tension] = *line->table;
    if (whole || whole_table || (number == 1 && head)) continue;
    if (bad++ == 0) first_bad = number;
  }
  dropped_ = bad;
  if (bad > 0) {
    fault_ = fmt::format(
        "{}: {} of its lines, the first of them line {}, {} not as {} written: what they held is "
        "computed again",
        path_.string(), bad, first_bad, bad == 1 ? "is" : "are", bad == 1 ? "it was" : "they were");
  }
}

void PointLog::write() {
  file_.close();
  std::string text = text_of({.study = study_}, study_);
  for (const auto& [point, row] : rows_) text += text_of({.point = point, .row = row}, study_);
  for (const auto& [tension, table] : tables_) text += text_of({.table = table}, study_);
  if (finished_) text += text_of({.finished = true}, study_);
  results::write_file(path_, text);
  file_.open(path_, std::ios::app | std::ios::binary);
}

void PointLog::add(std::size_t point, const PointRow& row) {
  rows_[point] = row;
  if (!path_.empty()) append(text_of({.point = point, .row = row}, study_), "a finished point");
}

void PointLog::add(const LossTable& table) {
  tables_[table.tension] = table;
  if (!path_.empty()) append(text_of({.table = table}, study_), "a table");
}

void PointLog::append(const std::string& line, const char* what) {
  file_ << line << std::flush;
  if (!file_) throw FileError(fmt::format("{}: {} could not be written", path_.string(), what));
}

void PointLog::finish() {
  finished_ = true;
  if (!path_.empty()) write();
}

}  // namespace strandyn::self_damping
