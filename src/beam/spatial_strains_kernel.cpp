// Highway reads this file once per instruction set; the best that the machine has is chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spatial_strains_kernel.cpp"
#include <hwy/foreach_target.h>

#include "spatial_forces-inl.hpp"
#include "spatial_lanes_kernel.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::beam::spatial_lanes_kernel {
namespace HWY_NAMESPACE {

/// Four times the products of the components (w, x, y, z) of a rotation's quaternion with one of them.
struct QuaternionRow {
  V w;
  Vec v;
  V square;  // of that one
};

HWY_INLINE QuaternionRow larger(const QuaternionRow& a, const QuaternionRow& b) {
  const hn::Mask<Tag> second = hn::Gt(b.square, a.square);
  const auto chosen = [second](V x, V y) HWY_ATTR { return hn::IfThenElse(second, y, x); };
  return {
      chosen(a.w, b.w), {chosen(a.v.x, b.v.x), chosen(a.v.y, b.v.y), chosen(a.v.z, b.v.z)}, chosen(a.square, b.square)};
}

/// atan2(s, w)/s where s^2 + w^2 = 1, w >= 0.
HWY_INLINE V half_angle_per_sine(V squared, V w) {
  if (hn::AllTrue(tag, hn::Lt(squared, set(0.01)))) {
    // asin(s)/s; the first term left out is 1e-18.
    constexpr std::array series = {1.0,         1.0 / 6,     3.0 / 40,      5.0 / 112,
                                   35.0 / 1152, 63.0 / 2816, 231.0 / 13312, 143.0 / 10240};
    V sum = set(series.back());
    for (std::size_t i = series.size() - 1; i-- > 0;) sum = hn::MulAdd(sum, squared, set(series[i]));
    return sum;
  }
  const V s = hn::Sqrt(squared);
  const hn::Mask<Tag> tiny = hn::Lt(squared, set(1e-16));
  return hn::IfThenElse(tiny, set(1), hn::Div(hn::Atan(tag, hn::Div(s, w)), s));
}

/// The shortest rotation vector of R, by the largest of its quaternion's components: good at all angles.
HWY_INLINE Vec rotation_vector(const Mat& R) {
  const V one = set(1);
  const Vec turning = {hn::Sub(R.y.z, R.z.y), hn::Sub(R.z.x, R.x.z), hn::Sub(R.x.y, R.y.x)};
  const V trace = hn::Add(R.x.x, hn::Add(R.y.y, R.z.z));
  QuaternionRow best{hn::Add(one, trace), turning, hn::Add(one, trace)};
  if (!hn::AllTrue(tag, hn::Gt(trace, hn::Zero(tag)))) {
    const V xy = hn::Add(R.x.y, R.y.x), xz = hn::Add(R.x.z, R.z.x), yz = hn::Add(R.y.z, R.z.y);
    const auto square = [one, trace](V diagonal)
                            HWY_ATTR { return hn::Add(hn::Sub(one, trace), hn::Add(diagonal, diagonal)); };
    const V xx = square(R.x.x), yy = square(R.y.y), zz = square(R.z.z);
    best = larger(best, {turning.x, {xx, xy, xz}, xx});
    best = larger(best, {turning.y, {xy, yy, yz}, yy});
    best = larger(best, {turning.z, {xz, yz, zz}, zz});
  }
  const V half_per_root = hn::Div(set(0.5), hn::Sqrt(best.square));
  const Vec v = times(half_per_root, best.v);
  const V w = hn::Mul(half_per_root, best.w);
  const V per_sine = half_angle_per_sine(dot(v, v), hn::Abs(w));
  return times(hn::CopySign(hn::Add(per_sine, per_sine), w), v);
}

/// Coefficient of S^2 in T^-1, e = -c_2'/c_2, and its derivative.
HWY_INLINE Coefficient inverse_coefficient(const Vec& angle) {
  const Stumpff c = stumpff(dot(angle, angle));
  const V minus_half_per_c2 = hn::Div(set(-0.5), c[2]);
  const V e = hn::Mul(stumpff_slope(c, 2), minus_half_per_c2);
  return {.value = e,
          .slope = hn::MulAdd(e, e, hn::Mul(hn::Mul(set(0.5), stumpff_second_slope(c, 2)), minus_half_per_c2))};
}

void find_kinematics_here(const Rows& rows) {
  for (std::size_t first = 0; first < rows.elements; first += hn::Lanes(tag)) {
    const Register at{rows, first};
    const Vec straight = vec(at, span);
    const V l0 = at[length];
    const Vec change = vec_of_node(at, position, 1) - vec(at, position);
    const Vec d = straight + change;
    const V l = hn::Sqrt(dot(d, d));
    const V per_l = hn::Div(set(1), l);
    const Mat unbent = mat(at, triad);
    const Mat axes_1 = times(mat(at, turn), unbent);
    const Mat axes_2 = times(mat_of_node(at, turn, 1), unbent);
    const Vec e1 = times(per_l, d);
    const Vec p = times(set(0.5), axes_1.y + axes_2.y);
    const Vec across = cross(e1, p);
    const V height = hn::Sqrt(dot(across, across));
    const V per_height = hn::Div(set(1), height);
    const Vec e3 = times(per_height, across);
    const Mat F = {e1, cross(e3, e1), e3};
    at.set(chord, l);
    store(at, frame, F);
    at.set(upright, height);
    at.set(lean, hn::Mul(dot(e1, p), per_height));
    const Mat local_1 = transposed_times(F, axes_1);
    const Mat local_2 = transposed_times(F, axes_2);
    const Vec a = rotation_vector(local_1);
    const Vec b = rotation_vector(local_2);
    store(at, angle_1, a);
    store(at, angle_2, b);
    store(at, direction_1, local_1.y);
    store(at, direction_2, local_2.y);
    const Coefficient inverse_a = inverse_coefficient(a), inverse_b = inverse_coefficient(b);
    at.set(inverse_1, inverse_a.value);
    at.set(inverse_slope_1, inverse_a.slope);
    at.set(inverse_2, inverse_b.value);
    at.set(inverse_slope_2, inverse_b.slope);

    // See stretch.hpp.
    const V per_l0 = hn::Div(set(1), l0);
    const V more = hn::Add(at[excess], dot(change, straight + straight + change));
    const auto squares = [](V t1, V t2) HWY_ATTR {
      return hn::MulAdd(t1, hn::MulAdd(set(2), t1, hn::Neg(t2)), hn::Mul(set(2), hn::Mul(t2, t2)));
    };
    const V bent = hn::Add(squares(a.y, b.y), squares(a.z, b.z));
    at.set(strain, hn::MulAdd(hn::Div(more, hn::Add(l, l0)), per_l0, hn::Mul(bent, set(1.0 / 30))));
    at.set(twist, hn::Mul(hn::Sub(b.x, a.x), per_l0));
    for (std::size_t g = 0; g < gauss_points; ++g) {
      const V c1 = set(curvature_slope(g, 0)), c2 = set(curvature_slope(g, 1));
      at.set(row(bend_2, g), hn::Mul(hn::MulAdd(c1, a.y, hn::Mul(c2, b.y)), per_l0));
      at.set(row(bend_3, g), hn::Mul(hn::MulAdd(c1, a.z, hn::Mul(c2, b.z)), per_l0));
    }
  }
}

void give_strains_here(const Rows& rows, const SpatialLanes::Strains& to) {
  for (std::size_t first = 0; first < rows.elements; first += hn::Lanes(tag)) {
    const Register at{rows, first};
    const std::size_t point = gauss_points * first;
    hn::StoreInterleaved2(at[strain], at[strain], tag, to.eps + point);
    hn::StoreInterleaved2(at[twist], at[twist], tag, to.chi1 + point);
    hn::StoreInterleaved2(at[bend_2], at[row(bend_2, 1)], tag, to.chi2 + point);
    hn::StoreInterleaved2(at[bend_3], at[row(bend_3, 1)], tag, to.chi3 + point);
  }
}

void find_internal_force_here(const Rows& rows, const SpatialLanes::Points& r) {
  for (std::size_t first = 0; first < rows.elements; first += hn::Lanes(tag)) {
    const Register at{rows, first};
    const ElementKinematics k(at);
    const MotionForce f(k, local_force(k, r, first));
    const Mat F = mat(at, frame);
    const Vec end = times(F, f.chord);
    store(at, force_1, -end);
    store(at, moment_1, transposed_times(mat(at, spin_map), times(F, f.node[0])));
    store(at, force_2, end);
    store(at, moment_2, transposed_times(mat_of_node(at, spin_map, 1), times(F, f.node[1])));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::beam::spatial_lanes_kernel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace strandyn::beam::spatial_lanes_kernel {

HWY_EXPORT(find_kinematics_here);
HWY_EXPORT(give_strains_here);
HWY_EXPORT(find_internal_force_here);

void find_kinematics(const Rows& rows) {
  HWY_DYNAMIC_DISPATCH(find_kinematics_here)(rows);
}
void give_strains(const Rows& rows, const SpatialLanes::Strains& strains) {
  HWY_DYNAMIC_DISPATCH(give_strains_here)(rows, strains);
}
void find_internal_force(const Rows& rows, const SpatialLanes::Points& resultants) {
  HWY_DYNAMIC_DISPATCH(find_internal_force_here)(rows, resultants);
}

}  // namespace strandyn::beam::spatial_lanes_kernel
#endif
