#pragma once
/// \file A sum that shows whether bytes are still the ones that were written; no protection against intent.

#include <cstdint>
#include <string_view>

namespace strandyn {

/// FNV-1a, 64 bits. Each byte acts through a one-to-one map of the sum, so no single wrong byte goes unseen.
constexpr std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t sum = 14695981039346656037U;
  for (const char byte : bytes) sum = (sum ^ static_cast<unsigned char>(byte)) * 1099511628211U;
  return sum;
}

/// Whether a sum that does not fit refuses what was read. Not where a fuzzer looks for faults behind it: of all the
/// bytes that it tries, none would have the right one.
#ifdef STRANDYN_FUZZ
constexpr bool checksums_count = false;
#else
constexpr bool checksums_count = true;
#endif

}  // namespace strandyn
