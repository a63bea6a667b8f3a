#pragma once
/// \file The points of a study on all cores of the machine, and who computes which where it is divided among machines.

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "strandyn/self_damping/log.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

using Methods = std::map<casefile::DampingMethod, std::unique_ptr<self_damping::Method>>;

/// The places of the points of a shard, rising. Points that each cost their own are dealt like cards. Those by
/// quadrature, whose cost is the table that a tension shares, stay together: consecutive ones, in parts of equal size,
/// to the shards that follow the last card.
std::vector<std::size_t> share_of(const std::vector<self_damping::Point>& points, const Shard& shard);

/// Computes points; every one that ends is in the log at once.
class March {
 public:
  March(const casefile::Scene& scene, const Hooks& hooks, const Methods& methods,
        const std::vector<self_damping::Point>& points, self_damping::PointLog& log)
      : scene_(scene), hooks_(hooks), methods_(methods), points_(points), log_(log) {}

  /// Those of `own` that the log does not have, after what they share; false where it was stopped before that was done:
  /// then the methods have not begun.
  bool run(const std::vector<std::size_t>& own);

 private:
  bool stop();
  void begin();
  void compute(std::size_t place);
  void tell(const std::string& more = {}) const;

  const casefile::Scene& scene_;
  const Hooks& hooks_;
  const Methods& methods_;
  const std::vector<self_damping::Point>& points_;
  self_damping::PointLog& log_;
  std::vector<std::size_t> left_{};
  std::size_t own_ = 0, done_ = 0;
  std::mutex mutex_;
};

}  // namespace strandyn::study
