// Where a section point cannot slip: the test before a march, and the kite that a commit finds for it. Once per
// instruction set.
#if defined(STRANDYN_SPATIAL_KITE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_SPATIAL_KITE_INL
#undef STRANDYN_SPATIAL_KITE_INL
#else
#define STRANDYN_SPATIAL_KITE_INL
#endif

#include <algorithm>

#include "spatial_return_map_march-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::spatial_kernel {
namespace HWY_NAMESPACE {

/// True where no angle of the point can slip between the reference state and this one.
HWY_INLINE Mask sticks(const SpatialCoefficients& c, const Rows& row, const Point& p, const Bending& b) {
  const V zero = hn::Zero(tag);
  const V one = set(1);
  // All that can lower a limit, as a loss of axial strain: less tension, twist, and the turn of the neutral plane.
  const V chi2 = p[Component::bending2];
  const V chi3 = p[Component::bending3];
  const V cross = hn::MulSub(row[reference_chi2], chi3, hn::Mul(row[reference_chi3], chi2));
  const V before2 =
      hn::MulAdd(row[reference_chi2], row[reference_chi2], hn::Mul(row[reference_chi3], row[reference_chi3]));
  const V product = hn::Mul(before2, hn::MulAdd(chi2, chi2, hn::Mul(chi3, chi3)));
  const Mask defined = hn::Gt(product, set(1e-46));
  const V turn = hn::Sqrt(hn::Div(hn::Mul(cross, cross), hn::IfThenElse(defined, product, one)));
  V loss = hn::Mul(row[offset_drop], hn::IfThenElse(defined, turn, one));
  loss = hn::Add(loss, hn::Max(zero, hn::Sub(row[reference_eps], p[Component::axial])));
  loss = hn::MulAdd(set(c.twist_drop), hn::Abs(hn::Sub(p[Component::torsion], row[reference_twist])), loss);

  // A pyramid over the kite: its base sticks at the reference tension, its tip after the loss 1/inverse_drop.
  const V along = hn::MulAdd(row[axis2], b.d2, hn::Mul(row[axis3], b.d3));
  const V across = hn::MulSub(row[axis2], b.d3, hn::Mul(row[axis3], b.d2));
  V share = hn::Mul(hn::Abs(hn::Sub(along, row[stick_middle])), row[inverse_length]);
  share = hn::MulAdd(hn::Abs(across), row[inverse_width], share);
  share = hn::MulAdd(loss, row[inverse_drop], share);
  return hn::Lt(share, one);
}

/// The kite of curvature increments in which a state sticks: its extent along the axis first, then across, and down to
/// the strain loss, at the middle. Each angle gives two half-planes: |q + k e| <= limit + slope dF_b - lost.
struct Kite {
  V low, high, width, drop;

  static Kite whole() { return {set(-without_bound), set(without_bound), set(without_bound), set(without_bound)}; }

  /// A half-plane that the axis meets under less than this share of the steepest slope bounds nothing but rounding.
  static constexpr double parallel = 1e-12;

  HWY_INLINE void narrow_along(double steepest, V along, V room) {
    const Mask meets = hn::Gt(hn::Abs(along), set(parallel * steepest));
    const V bound = hn::Div(room, hn::IfThenElse(meets, along, set(1)));
    const Mask up = hn::And(meets, hn::Gt(along, hn::Zero(tag)));
    const Mask down = hn::And(meets, hn::Lt(along, hn::Zero(tag)));
    high = hn::IfThenElse(up, hn::Min(high, bound), high);
    low = hn::IfThenElse(down, hn::Max(low, bound), low);
  }
  HWY_INLINE V middle() const { return hn::Mul(set(0.5), hn::Add(low, high)); }
  HWY_INLINE void narrow_at_middle(const Layer& layer, V along, V across, V room) {
    const V left = hn::Max(hn::Zero(tag), hn::NegMulAdd(along, middle(), room));
    width = hn::Min(width, hn::Div(left, hn::Max(hn::Abs(across), set(parallel * layer.k))));
    drop = hn::Min(drop, hn::Mul(left, set(1 / std::max(layer.limit_per_strain, 1 / without_bound))));
  }
};

/// Visits the two half-planes of one angle: `narrow(along, across, room)`.
template <class Narrow>
HWY_INLINE void half_planes(const SpatialCoefficients& c, const Layer& layer, std::size_t quarter, std::size_t i,
                            V axis2, V axis3, V limit, V q, Narrow narrow) {
  const double cosines[] = {c.cosine[i], -c.sine[i], -c.cosine[i], c.sine[i]};
  const double sines[] = {c.sine[i], c.cosine[i], -c.sine[i], -c.cosine[i]};
  const V cosine = set(cosines[quarter]);
  const V sine = set(sines[quarter]);
  const V e = hn::MulAdd(cosine, axis2, hn::Mul(sine, axis3));  // of a unit along; across it is g
  const V g = hn::MulSub(sine, axis2, hn::Mul(cosine, axis3));
  const V k = set(layer.k);
  const V follow = set(layer.slope * layer.stick_force);
  // A state that was just clipped misses its own limit by rounding.
  const V zero = hn::Zero(tag);
  narrow(hn::NegMulAdd(follow, g, hn::Mul(k, e)), hn::MulAdd(follow, e, hn::Mul(k, g)),
         hn::Max(zero, hn::Sub(limit, q)));
  narrow(hn::NegMulAdd(follow, g, hn::Neg(hn::Mul(k, e))), hn::MulSub(follow, e, hn::Mul(k, g)),
         hn::Max(zero, hn::Add(limit, q)));
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::spatial_kernel
HWY_AFTER_NAMESPACE();
#endif
