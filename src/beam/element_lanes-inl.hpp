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

#include "element_rows.hpp"
#include "strandyn/beam/planar_element.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::beam::lanes {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, most_lanes>;
using V = hn::Vec<Tag>;
constexpr Tag tag;

HWY_INLINE V set(double value) {
  return hn::Set(tag, value);
}

/// One register of elements, or of nodes, of a chain whose rows have the names `Row`.
template <class Row>
struct RegisterOf {
  const Rows& rows;
  std::size_t first;

  HWY_INLINE V operator[](Row row) const { return hn::Load(tag, rows.data + row * rows.stride + first); }
  /// The same of the node behind: `node` is 0 or 1.
  HWY_INLINE V at_node(Row row, std::size_t node) const {
    return hn::LoadU(tag, rows.data + row * rows.stride + first + node);
  }
  HWY_INLINE void set(Row row, V value) const { hn::Store(value, tag, rows.data + row * rows.stride + first); }
};

/// 6 xi - 4 and 6 xi - 2 at a Gauss point: d chi/d rotation, times the length.
constexpr double curvature_slope(std::size_t g, std::size_t node) {
  return 6 * gauss_position[g] - (node == 0 ? 4 : 2);
}

/// Of two Gauss points for each element, side by side.
HWY_INLINE V mean_of(const double* points, std::size_t first, double weight_1, double weight_2) {
  V one, two;
  hn::LoadInterleaved2(tag, points + gauss_points * first, one, two);
  return hn::MulAdd(set(gauss_weight * weight_1), one, hn::Mul(set(gauss_weight * weight_2), two));
}
/// Of what works on a rotation by bending.
HWY_INLINE V moment_of(const double* points, std::size_t first, std::size_t node) {
  return mean_of(points, first, curvature_slope(0, node), curvature_slope(1, node));
}

/// The Hermite table of an element (hermite_table.hpp) times one direction of (x_1, t_1, x_2, t_2).
/// `c` is mass/420.
struct HermiteTable {
  HWY_INLINE HermiteTable(V c, V l0) {
    const V cl = hn::Mul(c, l0);
    const V cll = hn::Mul(cl, l0);
    near = hn::Mul(set(156), c);
    far = hn::Mul(set(54), c);
    near_turn = hn::Mul(set(22), cl);
    far_turn = hn::Mul(set(13), cl);
    turn = hn::Mul(set(4), cll);
    turns = hn::Mul(set(-3), cll);
  }
  V near, far, near_turn, far_turn, turn, turns;

  struct Four {
    V x_1, t_1, x_2, t_2;
  };
  HWY_INLINE Four times(const Four& X) const {
    Four P;
    P.x_1 = hn::MulAdd(near, X.x_1, hn::Mul(near_turn, X.t_1));
    P.x_1 = hn::MulAdd(far, X.x_2, hn::NegMulAdd(far_turn, X.t_2, P.x_1));
    P.t_1 = hn::MulAdd(near_turn, X.x_1, hn::Mul(turn, X.t_1));
    P.t_1 = hn::MulAdd(far_turn, X.x_2, hn::MulAdd(turns, X.t_2, P.t_1));
    P.x_2 = hn::MulAdd(far, X.x_1, hn::Mul(far_turn, X.t_1));
    P.x_2 = hn::MulAdd(near, X.x_2, hn::NegMulAdd(near_turn, X.t_2, P.x_2));
    P.t_2 = hn::NegMulAdd(far_turn, X.x_1, hn::Mul(turns, X.t_1));
    P.t_2 = hn::NegMulAdd(near_turn, X.x_2, hn::MulAdd(turn, X.t_2, P.t_2));
    return P;
  }
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
}  // namespace strandyn::beam::lanes
HWY_AFTER_NAMESPACE();
#endif
