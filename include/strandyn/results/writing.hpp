#pragma once
/// \file What this program has written into results so far, and how long that took: a run that spends its time on its
/// files should be seen to.

#include <cstdint>

namespace strandyn::results {

struct Written {
  std::uintmax_t bytes = 0;
  double seconds = 0;  ///< of all threads, formatting and flushing included
};
Written written_so_far();

/// While it lives, this thread writes. Inside another one it counts bytes only.
class Writing {
 public:
  Writing();
  ~Writing();
  Writing(const Writing&) = delete;
  Writing& operator=(const Writing&) = delete;
  static void count(std::uintmax_t bytes);

 private:
  std::int64_t start_ = 0;  // [ns]
};

}  // namespace strandyn::results
