#include "cycle_log.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "strandyn/results/folder.hpp"

namespace strandyn::study {

using observe::Cycle;
using results::ColumnReader;

namespace {

constexpr std::size_t kept = 1000;  // at either end

std::string header() {
  return fmt::format("cycle,{}\n", fmt::join(ColumnReader::of(Cycle{}).names, ","));
}

std::string line_of(std::size_t number, const std::vector<double>& values) {
  return fmt::format("{},{}\n", static_cast<double>(number), fmt::join(values, ","));
}

}  // namespace

CycleLog::CycleLog(const std::filesystem::path& folder) {
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
  if (first_.size() < kept) {
    first_.push_back(cycle);
  } else {
    last_.push_back(cycle);
    if (last_.size() > kept) last_.pop_front();
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

/// What the summary has of the cycles.
struct CyclesOfSummary {
  std::vector<Cycle> cycles;
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

void CycleLog::add_to(Outcome& outcome) const {
  std::vector<Cycle> rows = first_;
  rows.insert(rows.end(), last_.begin(), last_.end());
  results::Value list = results::to_value(rows);
  const std::vector<std::string> names = ColumnReader::of(Cycle{}).names;
  results::Reductions all{.count = count_};
  for (std::size_t i = 0; i < sum_.size(); ++i) {
    all.members[names[i]] = {.least = least_[i], .largest = largest_[i], .sum = sum_[i]};
  }
  if (count_ > rows.size()) list.say_of_all(std::move(all));
  outcome.summary.set("cycles", std::move(list));
  outcome.summary.set("cycle_count", count_);

  std::vector<std::string> columns = {"cycle"};
  columns.insert(columns.end(), names.begin(), names.end());
  results::Table table(std::move(columns));
  const std::size_t left_out = count_ - rows.size();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::vector<double> row = {static_cast<double>(i + 1 + (i < first_.size() ? 0 : left_out))};
    std::ranges::copy(ColumnReader::of(rows[i]).values, std::back_inserter(row));
    table.append(row);
  }
  outcome.tables.push_back({.file = "cycles.csv", .table = std::move(table)});
  if (file_.is_open()) outcome.streamed.emplace_back("cycles.csv");
}

}  // namespace strandyn::study
