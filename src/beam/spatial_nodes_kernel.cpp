// Highway reads this file once per instruction set; the best that the machine has is chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spatial_nodes_kernel.cpp"
#include <hwy/foreach_target.h>

#include "spatial_lanes_kernel.hpp"
#include "spatial_registers-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::beam::spatial_lanes_kernel {
namespace HWY_NAMESPACE {

/// One node more than elements.
template <class F>
HWY_INLINE void for_nodes(const Rows& rows, const F& f) {
  for (std::size_t first = 0; first <= rows.elements; first += hn::Lanes(tag)) f(Register{rows, first});
}

/// What the squares in T and Exp bring along with the node's motion; see body_spin.hpp, here seen from space.
struct Coefficients {
  explicit HWY_INLINE Coefficients(const Register& at) {
    for (std::size_t k = 1; k <= 7; ++k) c[k] = at[row(coefficients, k - 1)];
  }
  HWY_INLINE V slope(std::size_t k) const { return stumpff_slope(c, k); }
  HWY_INLINE V second_slope(std::size_t k) const { return stumpff_second_slope(c, k); }
  Stumpff c;
};

void find_turns_here(const Rows& rows) {
  for_nodes(rows, [](const Register& at) HWY_ATTR {
    const Vec psi = vec(at, rotation);
    const Stumpff c = stumpff(dot(psi, psi));
    for (std::size_t k = 1; k <= 7; ++k) at.set(row(coefficients, k - 1), c[k]);
    store(at, turn, polynomial(psi, c[1], c[2]));
    store(at, spin_map, polynomial(psi, c[2], c[3]));
  });
}

/// w = T psi', w' = T psi'' + T' psi' with T = c_1 + c_2 skew(psi) + c_3 psi psi^T.
void find_spins_here(const Rows& rows) {
  for_nodes(rows, [](const Register& at) HWY_ATTR {
    const Coefficients of(at);
    const Vec psi = vec(at, rotation);
    const Vec psi_t = vec(at, rotation_rate);
    const Mat T = mat(at, spin_map);
    const V along = dot(psi, psi_t);
    const Vec grown = plus(times(hn::Add(of.slope(1), of.c[3]), psi_t), of.slope(2), cross(psi, psi_t));
    const V stretched = hn::MulAdd(hn::Mul(of.slope(3), along), along, hn::Mul(of.c[3], dot(psi_t, psi_t)));
    store(at, spin, times(T, psi_t));
    store(at, spin_rate, plus(plus(times(T, vec(at, rotation_acceleration)), along, grown), stretched, psi));
  });
}

/// half psi^T + psi half^T + skew(turning) + factor 1
HWY_INLINE Mat rate_of_map(const Vec& psi, const Vec& half, const Vec& turning, V factor) {
  return plus_product(plus_product(diagonal_and_skew(factor, turning), half, psi), psi, half);
}

/// Seen from the turning node, changes of W and A are, by the factors v of psi' and so on,
///     R dW = v T + p T',   R dA = a T + v (2 T' - w x T) + p (T'' - w x T')
void find_spin_changes_here(const Rows& rows, const InertiaFactors& factors) {
  for_nodes(rows, [&factors](const Register& at) HWY_ATTR {
    const Coefficients of(at);
    const Vec psi = vec(at, rotation);
    const Vec psi_t = vec(at, rotation_rate);
    const Vec psi_tt = vec(at, rotation_acceleration);
    const Mat T = mat(at, spin_map);
    const Vec w = vec(at, spin);
    const V along = dot(psi, psi_t);
    const V along_t = hn::Add(dot(psi_t, psi_t), dot(psi, psi_tt));
    std::array<V, 4> c_t, c_tt;
    for (std::size_t k = 1; k <= 3; ++k) {
      const V slope = of.slope(k);
      c_t[k] = hn::Mul(slope, along);
      c_tt[k] = hn::MulAdd(slope, along_t, hn::Mul(of.second_slope(k), hn::Mul(along, along)));
    }
    const V twice_c_t2 = hn::Add(c_t[2], c_t[2]), twice_c_t3 = hn::Add(c_t[3], c_t[3]), c3 = of.c[3];
    const Vec half = plus(times(hn::Mul(set(0.5), c_t[3]), psi), c3, psi_t);
    const Mat T_t = rate_of_map(psi, half, plus(times(c_t[2], psi), of.c[2], psi_t), c_t[1]);
    const Vec half_t = plus(plus(times(hn::Mul(set(0.5), c_tt[3]), psi), twice_c_t3, psi_t), c3, psi_tt);
    const Vec turning_t = plus(plus(times(c_tt[2], psi), twice_c_t2, psi_t), of.c[2], psi_tt);
    const Mat T_tt = plus_product(rate_of_map(psi, half_t, turning_t, c_tt[1]), times(hn::Add(c3, c3), psi_t), psi_t);
    const Mat w_T = crossed(w, T);
    const V a = set(factors.acceleration), v = set(factors.velocity), p = set(factors.position);
    store(at, spin_change, plus(times(v, T), p, T_t));
    store(at, spin_rate_change, plus(plus(times(a, T), v, T_t + T_t - w_T), p, T_tt - crossed(w, T_t)));
  });
}

/// J times a vector, in the axes of the body.
struct Moment {
  explicit HWY_INLINE Moment(const Register& at)
      : xx(at[row(moment, 0)]),
        yx(at[row(moment, 1)]),
        zx(at[row(moment, 2)]),
        yy(at[row(moment, 3)]),
        zy(at[row(moment, 4)]),
        zz(at[row(moment, 5)]) {}
  HWY_INLINE Vec times(const Vec& v) const {
    return {hn::MulAdd(xx, v.x, hn::MulAdd(yx, v.y, hn::Mul(zx, v.z))),
            hn::MulAdd(yx, v.x, hn::MulAdd(yy, v.y, hn::Mul(zy, v.z))),
            hn::MulAdd(zx, v.x, hn::MulAdd(zy, v.y, hn::Mul(zz, v.z)))};
  }
  V xx, yx, zx, yy, zy, zz;
};

/// R (J A + W x J W), and what it is made of.
struct Torque {
  explicit HWY_INLINE Torque(const Register& at) : R(mat(at, turn)), J(at), W(transposed_times(R, vec(at, spin))) {
    momentum = J.times(W);
    in_space =
        lanes::HWY_NAMESPACE::times(R, plus_cross(J.times(transposed_times(R, vec(at, spin_rate))), W, momentum));
  }
  Mat R;
  Moment J;
  Vec W, momentum, in_space;
};

void find_rotary_torques_here(const Rows& rows) {
  for_nodes(rows, [](const Register& at)
                      HWY_ATTR { store(at, body_torque, transposed_times(mat(at, spin_map), Torque(at).in_space)); });
}

void find_rotary_tangents_here(const Rows& rows, const InertiaFactors& factors) {
  for_nodes(rows, [&factors](const Register& at) HWY_ATTR {
    const Torque torque(at);
    const Mat T = mat(at, spin_map);
    const Mat dw = mat(at, spin_change), dw_t = mat(at, spin_rate_change);
    const auto change = [&torque](const Vec& w, const Vec& w_t) HWY_ATTR {
      const Vec W = transposed_times(torque.R, w);
      const Vec of_rate = torque.J.times(transposed_times(torque.R, w_t));
      const Vec turned = plus_cross(of_rate, torque.W, torque.J.times(W)) - cross(torque.momentum, W);
      return times(torque.R, turned);
    };
    const V p = set(factors.position);
    const Vec m = times(p, torque.in_space);
    const Mat sum = {change(dw.x, dw_t.x), change(dw.y, dw_t.y), change(dw.z, dw_t.z)};
    store(at, body_tangent, transposed_times(T, sum - crossed(m, T)) + slope_of_spin_map_transposed(at, m));
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::beam::spatial_lanes_kernel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace strandyn::beam::spatial_lanes_kernel {

HWY_EXPORT(find_turns_here);
HWY_EXPORT(find_spins_here);
HWY_EXPORT(find_spin_changes_here);
HWY_EXPORT(find_rotary_torques_here);
HWY_EXPORT(find_rotary_tangents_here);

void find_turns(const Rows& rows) {
  HWY_DYNAMIC_DISPATCH(find_turns_here)(rows);
}
void find_spins(const Rows& rows) {
  HWY_DYNAMIC_DISPATCH(find_spins_here)(rows);
}
void find_spin_changes(const Rows& rows, const InertiaFactors& factors) {
  HWY_DYNAMIC_DISPATCH(find_spin_changes_here)(rows, factors);
}
void find_rotary_torques(const Rows& rows) {
  HWY_DYNAMIC_DISPATCH(find_rotary_torques_here)(rows);
}
void find_rotary_tangents(const Rows& rows, const InertiaFactors& factors) {
  HWY_DYNAMIC_DISPATCH(find_rotary_tangents_here)(rows, factors);
}

}  // namespace strandyn::beam::spatial_lanes_kernel
#endif
