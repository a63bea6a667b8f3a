#pragma once
/// \file Rows of a run of any length: as many as a file should have, evenly spaced over all steps.

#include <cstddef>
#include <optional>
#include <vector>

namespace strandyn {

/// Keeps every row until there are `most`; from then on each second one goes, and half as many are kept of what comes.
/// With a time between rows all of those are kept, however many. The first and the last row are there always.
template <class Row>
class KeptRows {
 public:
  explicit KeptRows(std::optional<double> every_s = {}, std::size_t most = 40000) : every_(every_s), most_(most) {}

  /// `time` [s] ascends from row to row.
  void add(double time, Row row) {
    constexpr double rounding = 1e-6;  // of the time between rows: steps do not meet it exactly
    const std::size_t step = count_++;
    last_ = {step, std::move(row)};
    if (every_) {
      if (step > 0 && time < due_ - rounding * *every_) return;
      if (step == 0) due_ = time;
      while (due_ - rounding * *every_ <= time) due_ += *every_;
    } else if (step % stride_ != 0) {
      return;
    }
    kept_.push_back(last_);
    if (every_ || kept_.size() <= most_) return;
    for (std::size_t i = 0; 2 * i < kept_.size(); ++i) kept_[i] = kept_[2 * i];
    kept_.resize((kept_.size() + 1) / 2);
    stride_ *= 2;
  }

  struct Kept {
    std::size_t step = 0;  ///< counted from 0, over all that were added
    Row row;
  };
  std::vector<Kept> rows() const {
    std::vector<Kept> all = kept_;
    if (!all.empty() && all.back().step != last_.step) all.push_back(last_);
    return all;
  }
  const Row& last() const { return last_.row; }
  std::size_t count() const { return count_; }    ///< of all that were added
  std::size_t stride() const { return stride_; }  ///< steps between rows, without a time of one's own

 private:
  std::optional<double> every_;
  std::size_t most_;
  double due_ = 0;
  std::size_t count_ = 0, stride_ = 1;
  std::vector<Kept> kept_;
  Kept last_{};
};

}  // namespace strandyn
