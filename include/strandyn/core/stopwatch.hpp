#pragma once
/// \file Where the time of a run goes. Off unless asked for: then a part costs one branch.

#include <array>
#include <chrono>
#include <cstddef>

namespace strandyn {

enum class Part : std::size_t { section, element, inertia, factorization, solve, commit, observers };
inline constexpr std::size_t part_count = 7;
inline constexpr std::array<const char*, part_count> part_names = {"section", "element", "inertia",  "factorization",
                                                                   "solve",   "commit",  "observers"};

/// Seconds per part of a step. One per run, owned by the System.
class Stopwatch {
 public:
  bool enabled = false;
  std::array<double, part_count> seconds{};

  /// Adds the time until its end of life to a part.
  class Lap {
   public:
    Lap(Stopwatch& watch, Part part) : watch_(watch), part_(part) {
      if (watch_.enabled) start_ = std::chrono::steady_clock::now();
    }
    ~Lap() {
      if (!watch_.enabled) return;
      const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start_;
      watch_.seconds[static_cast<std::size_t>(part_)] += time.count();
    }
    Lap(const Lap&) = delete;
    Lap& operator=(const Lap&) = delete;

   private:
    Stopwatch& watch_;
    Part part_;
    std::chrono::steady_clock::time_point start_;
  };
};

}  // namespace strandyn
