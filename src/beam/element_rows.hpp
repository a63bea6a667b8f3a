#pragma once
/// \file Elements of a chain side by side: rows of numbers, one number for each element or node, and tiles of matrices.

#include <cstddef>

namespace strandyn::beam::lanes {

/// Lanes of a register at most: rows are read and written in whole registers.
inline constexpr std::size_t most_lanes = 4;

/// All rows of a chain; whole registers of elements, and one node more than elements.
struct Rows {
  double* data;
  std::size_t stride;
  std::size_t elements;
};

/// Rows hold whole registers and one node more, and begin on lines of the cache.
constexpr std::size_t stride_for(std::size_t elements) {
  constexpr std::size_t line = 8;
  static_assert(line % most_lanes == 0);
  return (elements + 1 + most_lanes + line - 1) / line * line;
}

/// Where an entry of an element lies: tiles of `most_lanes` elements, entry by entry.
constexpr std::size_t place_in_tile(std::size_t element, std::size_t entry, std::size_t entries) {
  return (element / most_lanes * entries + entry) * most_lanes + element % most_lanes;
}

}  // namespace strandyn::beam::lanes
