// What libFuzzer calls. With STRANDYN_FUZZ_SEEDS=FOLDER the seeds are written there, and that is all.
#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>

#include "answer.hpp"
#include "target.hpp"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  const char* folder = std::getenv("STRANDYN_FUZZ_SEEDS");
  if (!folder) return 0;
  int number = 0;
  for (const std::string& seed : strandyn::fuzz::seeds()) {
    strandyn::fuzz::put(fmt::format("{}/seed_{:03}", folder, number++), seed);
  }
  std::exit(0);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  strandyn::fuzz::take({reinterpret_cast<const char*>(data), size});
  return 0;
}
