// Lanes are elements of a chain: registers of their rows, and angles of theirs. Included once per instruction set.
#if defined(STRANDYN_BEAM_ELEMENT_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_BEAM_ELEMENT_LANES_INL
#undef STRANDYN_BEAM_ELEMENT_LANES_INL
#else
#define STRANDYN_BEAM_ELEMENT_LANES_INL
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <numbers>

#include "planar_lanes_kernel.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::beam::planar_lanes_kernel {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, most_lanes>;
using V = hn::Vec<Tag>;
constexpr Tag tag;

HWY_INLINE V set(double value) {
  return hn::Set(tag, value);
}

/// One register of elements.
struct Register {
  const Rows& rows;
  std::size_t first;

  HWY_INLINE V operator[](Row row) const { return hn::Load(tag, rows.data + row * rows.stride + first); }
  /// The same of the node behind: `node` is 0 or 1.
  HWY_INLINE V at_node(Row row, std::size_t node) const {
    return hn::LoadU(tag, rows.data + row * rows.stride + first + node);
  }
  HWY_INLINE void set(Row row, V value) const { hn::Store(value, tag, rows.data + row * rows.stride + first); }
};

/// atan2(y, x)
HWY_INLINE V direction_of(V y, V x) {
  const V half_turn = hn::CopySign(set(std::numbers::pi), y);
  const V angle = hn::Atan(tag, hn::Div(y, x));
  return hn::Add(angle, hn::IfThenElseZero(hn::Lt(x, hn::Zero(tag)), half_turn));
}

/// The angle less whole turns.
HWY_INLINE V wrapped(V angle) {
  const V turns = hn::Round(hn::Mul(angle, set(1 / (2 * std::numbers::pi))));
  const hn::Mask<Tag> within = hn::Le(hn::Abs(angle), set(std::numbers::pi));
  return hn::IfThenElse(within, angle, hn::NegMulAdd(turns, set(2 * std::numbers::pi), angle));
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::beam::planar_lanes_kernel
HWY_AFTER_NAMESPACE();
#endif
