#include "strandyn/results/writing.hpp"

#include <atomic>
#include <chrono>

namespace strandyn::results {
namespace {

std::atomic<std::uintmax_t> all_bytes = 0;
std::atomic<std::int64_t> all_time = 0;  // [ns]
thread_local int depth = 0;

std::int64_t now() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Written written_so_far() {
  return {.bytes = all_bytes, .seconds = 1e-9 * static_cast<double>(all_time)};
}

Writing::Writing() {
  if (depth++ == 0) start_ = now();
}

Writing::~Writing() {
  if (--depth == 0) all_time += now() - start_;
}

void Writing::count(std::uintmax_t bytes) {
  all_bytes += bytes;
}

}  // namespace strandyn::results
