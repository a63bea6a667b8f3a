#include "cycle_log.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "strandyn/results/folder.hpp"

namespace strandyn::study {

using observe::Cycle;
using results::ColumnReader;

namespace {

constexpr std::size_t most_kept = 1000;  // at either end

std::string header() {
  return fmt::format("cycle,{}\n", fmt::join(ColumnReader::of(Cycle{}).names, ","));
}

std::string line_of(std::size_t number, const std::vector<double>& values) {
  return fmt::format("{},{}\n", static_cast<double>(number), fmt::join(values, ","));
}

}  // namespace

CycleLog::CycleLog(const std::filesystem::path& folder, DampingRatio damping_ratio)
    : damping_ratio_(std::move(damping_ratio)) {
  if (folder.empty()) return;
  path_ = folder / "cycles.csv";
}

void CycleLog::reopen() {
  if (count_ == 0 || !std::filesystem::exists(path_)) {
    std::string text = header();
    if (count_ > first_.size()) {
      throw FileError(
          fmt::format("cannot resume: {} with the {} cycles up to the checkpoint is missing; run without "
                      "--resume",
                      path_.string(), count_));
    }
    for (std::size_t i = 0; i < count_; ++i) text += line_of(i + 1, ColumnReader::of(first_[i]).values);
    results::write_file(path_, text);
  } else {
    const std::string text = results::read_file(path_);
    std::size_t end = 0;
    for (std::size_t lines = 0; lines < count_ + 1; ++lines) {
      end = text.find('\n', end);
      if (end == std::string::npos) {
        throw FileError(
            fmt::format("cannot resume: {} does not hold the {} cycles up to the checkpoint; run without "
                        "--resume",
                        path_.string(), count_));
      }
      ++end;
    }
    std::filesystem::resize_file(path_, end);
  }
  file_.open(path_, std::ios::app | std::ios::binary);
}

void CycleLog::add(const Cycle& cycle) {
  const std::vector<double> values = ColumnReader::of(cycle).values;
  if (count_ == 0) least_ = largest_ = values, sum_.assign(values.size(), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    least_[i] = std::min(least_[i], values[i]);
    largest_[i] = std::max(largest_[i], values[i]);
    sum_[i] += values[i];
  }
  if (!path_.empty() && !file_.is_open()) reopen();
  ++count_;
  if (first_.size() < most_kept) {
    first_.push_back(cycle);
  } else {
    last_.push_back(cycle);
    if (last_.size() > most_kept) last_.pop_front();
  }
  if (path_.empty()) return;
  file_ << line_of(count_, values) << std::flush;
  if (!file_) throw FileError(fmt::format("{}: a cycle could not be written", path_.string()));
}

void CycleLog::archive(Archive& a) {
  a(count_, first_, last_, least_, largest_, sum_);
  if (a.reads() && !path_.empty()) reopen();
}

namespace {

struct CycleRow {
  Cycle cycle;
  std::optional<double> damping_ratio{};
};
template <class V>
void members(V& v, CycleRow& r) {
  v.part(r.cycle);
  v.value("damping_ratio", r.damping_ratio, {.what = "of a decay, by the ledger, of the antinode's velocity"});
}

/// What the summary has of the cycles.
struct CyclesOfSummary {
  std::vector<CycleRow> cycles;
  std::size_t count = 0;
};
template <class V>
void members(V& v, CyclesOfSummary& s) {
  v.list("cycles", s.cycles, {.what = "the first and the last thousand; all are in cycles.csv"});
  v.value("cycle_count", s.count, {.what = "of all cycles"});
}

}  // namespace

std::vector<results::MemberNote> CycleLog::notes() {
  return results::ReferenceWriter::of<CyclesOfSummary>();
}

std::vector<NumberedCycle> CycleLog::rows() const {
  std::vector<NumberedCycle> rows;
  for (const Cycle& cycle : first_) rows.push_back({.number = rows.size() + 1, .cycle = cycle});
  std::size_t number = count_ - last_.size();
  for (const Cycle& cycle : last_) rows.push_back({.number = ++number, .cycle = cycle});
  return rows;
}

void CycleLog::add_to(Outcome& outcome) const {
  const std::vector<NumberedCycle> kept = rows();
  std::vector<CycleRow> entries;
  for (const NumberedCycle& row : kept) {
    CycleRow& entry = entries.emplace_back(CycleRow{.cycle = row.cycle});
    if (damping_ratio_) entry.damping_ratio = damping_ratio_(row.cycle);
  }
  results::Value list = results::to_value(entries);
  const std::vector<std::string> names = ColumnReader::of(Cycle{}).names;
  results::Reductions all{.count = count_};
  for (std::size_t i = 0; i < sum_.size(); ++i) {
    all.members[names[i]] = {.least = least_[i], .largest = largest_[i], .sum = sum_[i]};
  }
  if (count_ > kept.size()) list.say_of_all(std::move(all));
  outcome.summary.set("cycles", std::move(list));
  outcome.summary.set("cycle_count", count_);

  std::vector<std::string> columns = {"cycle"};
  columns.insert(columns.end(), names.begin(), names.end());
  results::Table table(std::move(columns));
  for (const NumberedCycle& entry : kept) {
    std::vector<double> row = {static_cast<double>(entry.number)};
    std::ranges::copy(ColumnReader::of(entry.cycle).values, std::back_inserter(row));
    table.append(row);
  }
  outcome.tables.push_back({.file = "cycles.csv", .table = std::move(table)});
  if (file_.is_open()) outcome.streamed.emplace_back("cycles.csv");
}

}  // namespace strandyn::study
