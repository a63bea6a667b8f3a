// Vectors and matrices of space whose entries are registers, and rotations by their vectors (math/stumpff.hpp,
// math/rotation.hpp). Included once per instruction set.
#if defined(STRANDYN_BEAM_SPACE_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_BEAM_SPACE_LANES_INL
#undef STRANDYN_BEAM_SPACE_LANES_INL
#else
#define STRANDYN_BEAM_SPACE_LANES_INL
#endif

#include <array>

#include "element_lanes-inl.hpp"
#include "strandyn/math/stumpff.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::beam::lanes {
namespace HWY_NAMESPACE {

struct Vec {
  V x, y, z;
};

HWY_INLINE Vec operator+(const Vec& a, const Vec& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Vec operator-(const Vec& a, const Vec& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vec operator-(const Vec& a) {
  return {hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)};
}
HWY_INLINE Vec times(V factor, const Vec& a) {
  return {hn::Mul(factor, a.x), hn::Mul(factor, a.y), hn::Mul(factor, a.z)};
}
/// sum + factor a
HWY_INLINE Vec plus(const Vec& sum, V factor, const Vec& a) {
  return {hn::MulAdd(factor, a.x, sum.x), hn::MulAdd(factor, a.y, sum.y), hn::MulAdd(factor, a.z, sum.z)};
}
/// sum - factor a
HWY_INLINE Vec minus(const Vec& sum, V factor, const Vec& a) {
  return {hn::NegMulAdd(factor, a.x, sum.x), hn::NegMulAdd(factor, a.y, sum.y), hn::NegMulAdd(factor, a.z, sum.z)};
}
HWY_INLINE V dot(const Vec& a, const Vec& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
HWY_INLINE Vec cross(const Vec& a, const Vec& b) {
  return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
          hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}
/// sum + a x b
HWY_INLINE Vec plus_cross(const Vec& sum, const Vec& a, const Vec& b) {
  return {hn::MulAdd(a.y, b.z, hn::NegMulAdd(a.z, b.y, sum.x)), hn::MulAdd(a.z, b.x, hn::NegMulAdd(a.x, b.z, sum.y)),
          hn::MulAdd(a.x, b.y, hn::NegMulAdd(a.y, b.x, sum.z))};
}

/// By columns.
struct Mat {
  Vec x, y, z;
};

HWY_INLINE Mat operator+(const Mat& a, const Mat& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE Mat operator-(const Mat& a, const Mat& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE Mat negative(const Mat& a) {
  return {-a.x, -a.y, -a.z};
}
HWY_INLINE Mat times(V factor, const Mat& a) {
  return {times(factor, a.x), times(factor, a.y), times(factor, a.z)};
}
HWY_INLINE Mat plus(const Mat& sum, V factor, const Mat& a) {
  return {plus(sum.x, factor, a.x), plus(sum.y, factor, a.y), plus(sum.z, factor, a.z)};
}
HWY_INLINE Vec times(const Mat& a, const Vec& b) {
  return plus(plus(times(b.x, a.x), b.y, a.y), b.z, a.z);
}
HWY_INLINE Mat times(const Mat& a, const Mat& b) {
  return {times(a, b.x), times(a, b.y), times(a, b.z)};
}
/// a^T b
HWY_INLINE Vec transposed_times(const Mat& a, const Vec& b) {
  return {dot(a.x, b), dot(a.y, b), dot(a.z, b)};
}
HWY_INLINE Mat transposed_times(const Mat& a, const Mat& b) {
  return {transposed_times(a, b.x), transposed_times(a, b.y), transposed_times(a, b.z)};
}
HWY_INLINE Mat transposed(const Mat& a) {
  return {{a.x.x, a.y.x, a.z.x}, {a.x.y, a.y.y, a.z.y}, {a.x.z, a.y.z, a.z.z}};
}
/// a x every column.
HWY_INLINE Mat crossed(const Vec& a, const Mat& b) {
  return {cross(a, b.x), cross(a, b.y), cross(a, b.z)};
}
/// sum + a x every column.
HWY_INLINE Mat plus_crossed(const Mat& sum, const Vec& a, const Mat& b) {
  return {plus_cross(sum.x, a, b.x), plus_cross(sum.y, a, b.y), plus_cross(sum.z, a, b.z)};
}
/// sum + a b^T
HWY_INLINE Mat plus_product(const Mat& sum, const Vec& a, const Vec& b) {
  return {plus(sum.x, b.x, a), plus(sum.y, b.y, a), plus(sum.z, b.z, a)};
}
HWY_INLINE Mat product(const Vec& a, const Vec& b) {
  return {times(b.x, a), times(b.y, a), times(b.z, a)};
}
/// factor 1 + skew(a)
HWY_INLINE Mat diagonal_and_skew(V factor, const Vec& a) {
  return {{factor, a.z, hn::Neg(a.y)}, {hn::Neg(a.z), factor, a.x}, {a.y, hn::Neg(a.x), factor}};
}

/// 1 + b S + c S^2, S = skew(psi).
HWY_INLINE Mat polynomial(const Vec& psi, V b, V c) {
  const Vec c_psi = times(c, psi);
  const Vec b_psi = times(b, psi);
  const V one = set(1);
  const V xx = hn::Mul(c_psi.x, psi.x), yy = hn::Mul(c_psi.y, psi.y), zz = hn::Mul(c_psi.z, psi.z);
  const V xy = hn::Mul(c_psi.x, psi.y), xz = hn::Mul(c_psi.x, psi.z), yz = hn::Mul(c_psi.y, psi.z);
  return {{hn::Sub(one, hn::Add(yy, zz)), hn::Add(xy, b_psi.z), hn::Sub(xz, b_psi.y)},
          {hn::Sub(xy, b_psi.z), hn::Sub(one, hn::Add(xx, zz)), hn::Add(yz, b_psi.x)},
          {hn::Add(xz, b_psi.y), hn::Sub(yz, b_psi.x), hn::Sub(one, hn::Add(xx, yy))}};
}

/// A coefficient, and its derivative by |psi|^2.
struct Coefficient {
  V value, slope;
};
/// Derivative by psi of m + b psi x m + c psi x (psi x m).
HWY_INLINE Mat slope_of_polynomial(const Vec& psi, const Vec& m, const Coefficient& b, const Coefficient& c) {
  const Vec once = cross(psi, m);
  const Vec grows = minus(plus(times(b.slope, once), c.slope, cross(psi, once)), c.value, m);
  const Mat fixed = diagonal_and_skew(hn::Mul(c.value, dot(psi, m)), times(hn::Neg(b.value), m));
  return plus_product(plus_product(fixed, grows + grows, psi), times(c.value, psi), m);
}

/// c_0 to c_7.
using Stumpff = std::array<V, 8>;

/// By so many terms of the two series at the top, where nothing cancels.
template <std::size_t terms>
HWY_INLINE Stumpff stumpff_by_series(V s) {
  constexpr auto series6 = math::detail::stumpff_series(6);
  constexpr auto series7 = math::detail::stumpff_series(7);
  Stumpff c;
  c[6] = set(series6[terms - 1]);
  c[7] = set(series7[terms - 1]);
  for (std::size_t i = terms - 1; i-- > 0;) {
    c[6] = hn::MulAdd(c[6], s, set(series6[i]));
    c[7] = hn::MulAdd(c[7], s, set(series7[i]));
  }
  for (std::size_t k = 6; k-- > 0;) c[k] = hn::NegMulAdd(s, c[k + 2], set(math::detail::reciprocal_factorial[k]));
  return c;
}

/// By sine and cosine of the half angle.
HWY_INLINE Stumpff stumpff_by_angle(V s) {
  const V angle = hn::Sqrt(s);
  const V half = hn::Mul(set(0.5), angle);
  const V sine = hn::Sin(tag, half);
  const V cosine = hn::Cos(tag, half);
  const V per_s = hn::Div(set(1), s);
  Stumpff c;
  c[0] = hn::Mul(hn::Sub(cosine, sine), hn::Add(cosine, sine));
  c[1] = hn::Div(hn::Mul(set(2), hn::Mul(sine, cosine)), angle);
  c[2] = hn::Mul(hn::Mul(set(2), hn::Mul(sine, sine)), per_s);
  for (std::size_t k = 1; k < 6; ++k) {
    c[k + 2] = hn::Mul(hn::Sub(set(math::detail::reciprocal_factorial[k]), c[k]), per_s);
  }
  return c;
}

/// See math::stumpff. Below |psi| = 1/2 half of the terms are as good: the first left out is 3e-17 of c_k.
HWY_INLINE Stumpff stumpff(V s) {
  if (hn::AllTrue(tag, hn::Lt(s, set(0.25)))) return stumpff_by_series<6>(s);
  const hn::Mask<Tag> near = hn::Lt(s, set(math::detail::stumpff_series_limit));
  Stumpff c = stumpff_by_series<math::detail::stumpff_terms>(s);
  if (hn::AllTrue(tag, near)) return c;
  const Stumpff far = stumpff_by_angle(hn::IfThenElse(near, set(math::detail::stumpff_series_limit), s));
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = hn::IfThenElse(near, c[k], far[k]);
  return c;
}

/// k c_{k+2} - c_{k+1}: twice dc_k/ds, and dc_k/dt by psi . psi'.
HWY_INLINE V stumpff_slope(const Stumpff& c, std::size_t k) {
  return hn::MulSub(set(static_cast<double>(k)), c[k + 2], c[k + 1]);
}
/// The same of it: four times d^2c_k/ds^2.
HWY_INLINE V stumpff_second_slope(const Stumpff& c, std::size_t k) {
  return hn::MulSub(set(static_cast<double>(k)), stumpff_slope(c, k + 2), stumpff_slope(c, k + 1));
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::beam::lanes
HWY_AFTER_NAMESPACE();
#endif
