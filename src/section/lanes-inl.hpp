// Lanes are section points: registers of doubles, where they lie in a batch, and where their rows lie in a history.
#if defined(STRANDYN_SECTION_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_SECTION_LANES_INL
#undef STRANDYN_SECTION_LANES_INL
#else
#define STRANDYN_SECTION_LANES_INL
#endif

#include <hwy/highway.h>

#include "strandyn/section/batch.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::kernel {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, block_lanes>;
using V = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;
constexpr Tag tag;

HWY_INLINE V set(double x) {
  return hn::Set(tag, x);
}

HWY_INLINE V clip(V x, V low, V high) {
  return hn::Min(hn::Max(x, low), high);
}

/// The return map of a spring: |x| <= limit.
HWY_INLINE V clip(V x, V limit) {
  return clip(x, hn::Neg(limit), limit);
}

/// The rows of a block that one register of lanes sees.
struct Rows {
  const double* at;
  HWY_INLINE V operator[](std::size_t row) const { return hn::Load(tag, at + row * block_lanes); }
};

HWY_INLINE void replace(double* row_of_lanes, Mask keep, V value) {
  hn::Store(hn::IfThenElse(keep, hn::Load(tag, row_of_lanes), value), tag, row_of_lanes);
}

/// One register of a batch: as many points as it has lanes, beginning at `first`.
struct Register {
  std::size_t first;

  HWY_INLINE V load(const double* batch) const { return hn::Load(tag, batch + first); }
  HWY_INLINE void store(V value, double* batch) const { hn::Store(value, tag, batch + first); }
  /// The first of its rows in a history whose blocks have `block_rows`.
  template <class T>
  HWY_INLINE T* rows(T* history, std::size_t block_rows) const {
    return history + first / block_lanes * block_rows * block_lanes + first % block_lanes;
  }
  /// Lanes that are padding. They are at rest and count as stuck.
  HWY_INLINE Mask padding(std::size_t points) const {
    return hn::Not(hn::FirstN(tag, points > first ? points - first : 0));
  }

  // A range of registers counts through a batch.
  HWY_INLINE Register operator*() const { return *this; }
  HWY_INLINE void operator++() { first += hn::Lanes(tag); }
  HWY_INLINE bool operator!=(const Register& end) const { return first < end.first; }
};

/// All registers of a batch: for (const Register at : Registers{points}).
struct Registers {
  std::size_t points;
  HWY_INLINE Register begin() const { return {0}; }
  HWY_INLINE Register end() const { return {padded(points)}; }
};

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::kernel
HWY_AFTER_NAMESPACE();
#endif
