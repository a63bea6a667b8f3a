#include "cycle_log.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "strandyn/results/folder.hpp"
#include "strandyn/results/writing.hpp"

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

struct Cut {
  std::uintmax_t end = 0;  ///< [B] where the wanted lines end, as far as there are any
  std::size_t lines = 0;   ///< that the whole file has
};

/// Piece by piece: a file of a million cycles is larger than all else that a run holds.
Cut cut_after(std::size_t wanted, const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(fmt::format("cannot read {}", path.string()));
  Cut cut;
  std::uintmax_t at = 0;
  std::vector<char> piece(1U << 16U);
  do {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    for (std::streamsize i = 0; i < file.gcount(); ++i) {
      ++at;
      if (piece[static_cast<std::size_t>(i)] == '\n' && ++cut.lines <= wanted) cut.end = at;
    }
  } while (file);
  if (file.bad()) throw FileError(fmt::format("cannot read {} to its end", path.string()));
  return cut;
}

}  // namespace

CycleLog::CycleLog(const std::filesystem::path& folder, DampingRatio damping_ratio)
    : damping_ratio_(std::move(damping_ratio)) {
  if (folder.empty()) return;
  path_ = folder / "cycles.csv";
}

void CycleLog::reopen() {
  const bool there = std::filesystem::exists(path_);
  if (count_ == 0 || !there) {
    if (recomputed_ && there) recomputed_ = std::max<std::size_t>(cut_after(1, path_).lines, 1) - 1;
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
    const Cut cut = cut_after(count_ + 1, path_);
    if (cut.lines <= count_) {
      throw FileError(
          fmt::format("cannot resume: {} does not hold the {} cycles up to the checkpoint; run without "
                      "--resume",
                      path_.string(), count_));
    }
    recomputed_ = cut.lines - (count_ + 1);
    std::filesystem::resize_file(path_, cut.end);
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
  const results::Writing writing;
  const std::string line = line_of(count_, values);
  results::Writing::count(line.size());
  file_ << line << std::flush;
  if (!file_) throw FileError(fmt::format("{}: a cycle could not be written", path_.string()));
}

void CycleLog::archive(Archive& a) {
  a(count_, first_, last_, least_, largest_, sum_);
  if (!a.reads()) return;
  const std::size_t columns = count_ > 0 ? ColumnReader::of(Cycle{}).names.size() : 0;
  const bool whole = first_.size() == std::min(count_, most_kept) &&
                     last_.size() == std::min(count_ - first_.size(), most_kept) && least_.size() == columns &&
                     largest_.size() == columns && sum_.size() == columns;
  if (!whole) throw InputError("the cycles in it are not as many as it counts");
  recomputed_ = 0;
  if (!path_.empty()) reopen();
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

struct Recomputed {
  std::size_t cycles = 0;
};
template <class V>
void members(V& v, Recomputed& r) {
  v.value("cycles", r.cycles, {.what = "that had ended between the checkpoint and the end of the run that wrote it"});
}

/// What the summary has of the cycles.
struct CyclesOfSummary {
  std::vector<CycleRow> cycles;
  std::size_t count = 0;
  std::optional<Recomputed> recomputed{};
};
template <class V>
void members(V& v, CyclesOfSummary& s) {
  v.list("cycles", s.cycles, {.what = "the first and the last thousand; all are in cycles.csv"});
  v.value("cycle_count", s.count, {.what = "of all cycles"});
  v.record("recomputed", s.recomputed, {.what = "where a run has gone on from a checkpoint: what was computed twice"});
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
  if (recomputed_) outcome.summary.set("recomputed", results::to_value(Recomputed{.cycles = *recomputed_}));

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
