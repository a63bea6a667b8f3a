#include "strandyn/core/side_by_side.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace strandyn;

namespace {

/// The environment's STRANDYN_CORES for as long as this lives.
class Cores {
 public:
  explicit Cores(const char* text) {
    if (const char* before = std::getenv("STRANDYN_CORES")) before_ = before;
    ::setenv("STRANDYN_CORES", text, 1);
  }
  ~Cores() { before_.empty() ? ::unsetenv("STRANDYN_CORES") : ::setenv("STRANDYN_CORES", before_.c_str(), 1); }
  Cores(const Cores&) = delete;
  Cores& operator=(const Cores&) = delete;

 private:
  std::string before_;
};

}  // namespace

TEST_CASE("side by side: every piece is done once, whatever their number and that of the cores") {
  for (const char* cores : {"1", "2", "1000"}) {
    const Cores bound(cores);
    for (std::size_t count : {0, 1, 2, 3, 100}) {
      std::vector<std::atomic<int>> done(count);
      side_by_side(count, [&](std::size_t i) { ++done[i]; });
      for (const std::atomic<int>& times : done) CHECK(times == 1);
    }
  }
}

TEST_CASE("side by side: the environment bounds the cores and nothing else in it does") {
  std::size_t all = 0;
  {
    const Cores unbound("");
    all = cores_at_hand();
  }
  CHECK(all >= 1);
  for (const char* odd : {"0", "-1", "2x", "many", "1000000"}) {
    const Cores bound(odd);
    CHECK(cores_at_hand() == all);
  }
  const Cores one("1");
  CHECK(cores_at_hand() == 1);
}

TEST_CASE("side by side: pieces inside of pieces share the cores that there are") {
  const std::size_t all = cores_at_hand();
  side_by_side(1, [&](std::size_t) { CHECK(cores_at_hand() == all); });
  std::mutex mutex;
  std::vector<std::size_t> inside;
  side_by_side(2 * all, [&](std::size_t) {
    side_by_side(3, [&](std::size_t) {
      const std::lock_guard lock(mutex);
      inside.push_back(cores_at_hand());
    });
  });
  CHECK(inside == std::vector<std::size_t>(6 * all, 1));
  CHECK(cores_at_hand() == all);
}

TEST_CASE("side by side: the first failure ends the handing out and comes back") {
  std::atomic<int> done = 0;
  CHECK_THROWS_WITH_AS(side_by_side(1000,
                                    [&](std::size_t i) {
                                      ++done;
                                      if (i == 3) throw std::runtime_error("piece 3");
                                      // Seconds of work are left, on however many cores: a failure is heard sooner.
                                      std::this_thread::sleep_for(std::chrono::milliseconds(i < 3 ? 0 : 20));
                                    }),
                       "piece 3", std::runtime_error);
  CHECK(done < 1000);
}
