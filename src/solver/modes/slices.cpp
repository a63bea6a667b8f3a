#include "slices.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "strandyn/core/error.hpp"

namespace strandyn::solver {
namespace {

/// The part of a slice that cuts no group of equal frequencies in two, as its ends may do.
struct Whole {
  std::size_t first = 0, last = 0;  // one after the last

  explicit Whole(const std::vector<RawMode>& slice) : first(1), last(slice.size() - 1) {
    while (first < slice.size() && !are_apart(slice[first - 1], slice[first])) ++first;
    while (last > first && !are_apart(slice[last - 1], slice[last])) --last;
  }
};

double frequency_of(const RawMode& mode) {
  return std::sqrt(std::max(0.0, mode.eigenvalue)) / (2 * std::numbers::pi);
}

/// [Hz] how far the modes lie apart at the upper end.
double spacing(const std::vector<RawMode>& found) {
  const std::size_t back = std::min(found.size() - 1, slice_size / 2);
  if (back == 0) return frequency_of(found.back());
  return (frequency_of(found.back()) - frequency_of(found[found.size() - 1 - back])) / static_cast<double>(back);
}

}  // namespace

std::vector<RawMode> lowest_in_slices(const system::System& system, const Pencil& pencil,
                                      const std::vector<RawMode>& rigid, const Stop& stop,
                                      const std::function<bool(const std::vector<RawMode>&)>& enough) {
  const std::size_t carried = unknowns_with_mass(system);
  std::vector<RawMode> found = nearest_to(system, pencil, {.count = slice_size, .stop = stop}, rigid);
  found.resize(Whole(found).last);
  while (!enough(found) && 2 * (found.size() + slice_size) < carried) {
    // Half of a slice lies below its middle; a few modes are wanted twice.
    double ahead = 0.45 * slice_size;
    for (;; ahead = ahead > 1 ? ahead / 2 : 0) {
      const double middle = frequency_of(found.back()) + ahead * spacing(found);
      std::vector<RawMode> slice =
          nearest_to(system, pencil, {.count = slice_size, .near = middle, .stop = stop}, rigid);
      const Whole whole(slice);
      const std::size_t number = modes_below(pencil, slice[whole.first]);
      const std::size_t next = whole.first + (found.size() - std::min(number, found.size()));
      if (number <= found.size() && next < whole.last && are_apart(found.back(), slice[next])) {
        std::move(slice.begin() + static_cast<std::ptrdiff_t>(next),
                  slice.begin() + static_cast<std::ptrdiff_t>(whole.last), std::back_inserter(found));
        break;
      }
      // Too far up: nearer; at the end itself half of the slice lies above.
      if (ahead == 0) throw ComputationError("the eigenvalue solver left out a mode; use more [span] elements");
    }
  }
  return found;
}

}  // namespace strandyn::solver
