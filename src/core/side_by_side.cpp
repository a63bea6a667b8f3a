#include "strandyn/core/side_by_side.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <string_view>
#include <thread>
#include <vector>

#ifdef __linux__
#include <sched.h>
#endif

namespace strandyn {
namespace {

/// Of the machine's cores, those that this process is bound to.
std::size_t bound_cores() {
  const std::size_t all = std::max(1U, std::thread::hardware_concurrency());
#ifdef __linux__
  cpu_set_t set;
  CPU_ZERO(&set);
  // A machine of more cores than the set has places refuses; then all of them are taken.
  if (sched_getaffinity(0, sizeof set, &set) == 0) return std::max<std::size_t>(1, CPU_COUNT(&set));
#endif
  return all;
}

/// What the bodies beside this thread's leave to it; 0 outside of any.
thread_local std::size_t granted = 0;

}  // namespace

std::size_t cores_at_hand() {
  if (granted > 0) return granted;
  std::size_t cores = bound_cores();
  if (const char* asked = std::getenv("STRANDYN_CORES")) {
    const std::string_view text = asked;
    std::size_t most = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), most);
    if (error == std::errc{} && end == text.data() + text.size() && most > 0) cores = std::min(cores, most);
  }
  return cores;
}

void side_by_side(std::size_t count, const std::function<void(std::size_t)>& body) {
  const std::size_t cores = cores_at_hand();
  const std::size_t at_once = std::clamp<std::size_t>(count, 1, cores);
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    const std::size_t before = granted;
    granted = cores / at_once;
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        body(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
    granted = before;
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < at_once; ++i) threads.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace strandyn
