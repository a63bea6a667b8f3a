#include "strandyn/results/writing.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <thread>

#include "results/scratch_folder.hpp"
#include "strandyn/results/folder.hpp"

using strandyn::results::Writing;
using strandyn::results::written_so_far;

TEST_CASE("what is written is counted once, and its time once where one writing is inside another") {
  const strandyn::test::ScratchFolder folder;
  const auto before = written_so_far();
  const auto began = std::chrono::steady_clock::now();
  {
    const Writing outer;
    const Writing inner;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    strandyn::results::write_file(folder / "file", "1234567");
  }
  const std::chrono::duration<double> all = std::chrono::steady_clock::now() - began;
  const auto after = written_so_far();
  CHECK(after.bytes - before.bytes == 7);
  CHECK(after.seconds - before.seconds >= 0.02);
  CHECK(after.seconds - before.seconds <= all.count());
}
