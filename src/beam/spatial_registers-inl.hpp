// Vectors and matrices in the rows of a spatial chain. Included once per instruction set.
#if defined(STRANDYN_BEAM_SPATIAL_REGISTERS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_BEAM_SPATIAL_REGISTERS_INL
#undef STRANDYN_BEAM_SPATIAL_REGISTERS_INL
#else
#define STRANDYN_BEAM_SPATIAL_REGISTERS_INL
#endif

#include "space_lanes-inl.hpp"
#include "spatial_lanes_kernel.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::beam::spatial_lanes_kernel {
namespace HWY_NAMESPACE {

using namespace lanes::HWY_NAMESPACE;
using Register = RegisterOf<Row>;

constexpr Row row(Row first, std::size_t further) {
  return static_cast<Row>(first + further);
}
HWY_INLINE Vec vec(const Register& at, Row first) {
  return {at[first], at[row(first, 1)], at[row(first, 2)]};
}
HWY_INLINE Mat mat(const Register& at, Row first) {
  return {vec(at, first), vec(at, row(first, 3)), vec(at, row(first, 6))};
}
/// The same of one of an element's nodes, 0 or 1.
HWY_INLINE Vec vec_of_node(const Register& at, Row first, std::size_t node) {
  return {at.at_node(first, node), at.at_node(row(first, 1), node), at.at_node(row(first, 2), node)};
}
HWY_INLINE Mat mat_of_node(const Register& at, Row first, std::size_t node) {
  return {vec_of_node(at, first, node), vec_of_node(at, row(first, 3), node), vec_of_node(at, row(first, 6), node)};
}
HWY_INLINE void store(const Register& at, Row first, const Vec& v) {
  at.set(first, v.x);
  at.set(row(first, 1), v.y);
  at.set(row(first, 2), v.z);
}
HWY_INLINE void store(const Register& at, Row first, const Mat& m) {
  store(at, first, m.x);
  store(at, row(first, 3), m.y);
  store(at, row(first, 6), m.z);
}

/// d(T^T m)/dpsi of one of an element's nodes, or of the node itself.
HWY_INLINE Mat slope_of_spin_map_transposed(const Register& at, const Vec& m, std::size_t node = 0) {
  Stumpff c;
  for (std::size_t k = 2; k <= 5; ++k) c[k] = at.at_node(row(coefficients, k - 1), node);
  const V half = set(0.5);
  return slope_of_polynomial(vec_of_node(at, rotation, node), m,
                             {.value = hn::Neg(c[2]), .slope = hn::Neg(hn::Mul(half, stumpff_slope(c, 2)))},
                             {.value = c[3], .slope = hn::Mul(half, stumpff_slope(c, 3))});
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::beam::spatial_lanes_kernel
HWY_AFTER_NAMESPACE();
#endif
