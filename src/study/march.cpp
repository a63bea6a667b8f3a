#include "march.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "strandyn/core/side_by_side.hpp"

namespace strandyn::study {

using casefile::DampingMethod;
using self_damping::LossTable;
using self_damping::Point;
using self_damping::PointRow;

std::vector<std::size_t> share_of(const std::vector<Point>& points, const Shard& shard) {
  std::vector<std::size_t> cards, tabled;
  for (std::size_t i = 0; i < points.size(); ++i) {
    (points[i].method == DampingMethod::quadrature ? tabled : cards).push_back(i);
  }
  std::vector<std::size_t> own;
  for (const std::size_t card : dealt(cards.size(), shard)) own.push_back(cards[card]);
  const std::size_t parts = std::min(shard.of, tabled.size());
  for (std::size_t i = 0; i < tabled.size(); ++i) {
    const std::size_t part = i * parts / tabled.size();
    if ((cards.size() + part) % shard.of + 1 == shard.number) own.push_back(tabled[i]);
  }
  std::ranges::sort(own);
  return own;
}

bool March::run(const std::vector<std::size_t>& own) {
  own_ = own.size();
  left_.clear();
  for (const std::size_t place : own) {
    if (!log_.rows().contains(place)) left_.push_back(place);
  }
  done_ = own_ - left_.size();
  try {
    begin();
  } catch (const Interrupted&) {
    return false;  // the tables that were made are kept
  }
  tell();
  side_by_side(left_.size(), [this](std::size_t i) { compute(left_[i]); });
  return true;
}

/// The whole study sums up over all tensions, a shard only over its own.
void March::begin() {
  self_damping::Beginning how{.find =
                                  [this](double tension, const self_damping::CurvatureRange& range) {
                                    const std::lock_guard lock(mutex_);
                                    const auto kept = log_.tables().find(tension);
                                    const bool fits = kept != log_.tables().end() &&
                                                      kept->second.lowest == range.lowest &&
                                                      kept->second.highest == range.highest;
                                    return fits ? std::optional(kept->second) : std::nullopt;
                                  },
                              .keep =
                                  [this](const LossTable& table) {
                                    const std::lock_guard lock(mutex_);
                                    log_.add(table);
                                  },
                              .stop = [this] { return stop(); }};
  for (const auto& [word, method] : methods_) {
    if (hooks_.shard) {
      std::vector<Point> own;
      for (const std::size_t place : left_) {
        if (points_[place].method == word) own.push_back(points_[place]);
      }
      how.tensions = self_damping::distinct_tensions(own);
    }
    method->begin(points_, how);
  }
}

bool March::stop() {
  const std::lock_guard lock(mutex_);
  return hooks_.stop && hooks_.stop();
}

void March::compute(std::size_t place) {
  if (stop()) return;
  const self_damping::Watch watch = {.stop = [this] { return stop(); },
                                     .tell =
                                         [this](const std::string& words) {
                                           const std::lock_guard lock(mutex_);
                                           tell(", " + words);
                                         }};
  const std::optional<PointRow> row = compute_row(scene_, *methods_.at(points_[place].method), points_[place], watch);
  if (!row) return;
  const std::lock_guard lock(mutex_);
  log_.add(place, *row);
  ++done_;
  tell();
}

void March::tell(const std::string& more) const {
  if (!hooks_.progress) return;
  hooks_.progress(static_cast<double>(done_) / static_cast<double>(std::max<std::size_t>(own_, 1)),
                  fmt::format("point {} of {}{}", done_, own_, more));
}

}  // namespace strandyn::study
