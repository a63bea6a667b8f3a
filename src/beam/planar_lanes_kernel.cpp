// Highway reads this file once per instruction set; the best that the machine has is chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "planar_lanes_kernel.cpp"
#include "planar_lanes_kernel.hpp"

#include <hwy/foreach_target.h>

#include "element_lanes-inl.hpp"
#include "strandyn/beam/planar_element.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::beam::planar_lanes_kernel {
namespace HWY_NAMESPACE {

/// 6 xi - 4 and 6 xi - 2 at a Gauss point: d chi/d rotation, times the length.
constexpr double curvature_slope(std::size_t g, std::size_t node) {
  return 6 * gauss_position[g] - (node == 0 ? 4 : 2);
}

void find_kinematics_here(const Rows& rows, double* eps, double* chi) {
  const std::size_t lanes = hn::Lanes(tag);
  for (std::size_t e = 0; e < rows.elements; e += lanes) {
    const Register at{rows, e};
    const V span_x_ = at[span_x];
    const V span_y_ = at[span_y];
    const V l0 = at[length];
    const V change_x = hn::Sub(at.at_node(x, 1), at[x]);
    const V change_y = hn::Sub(at.at_node(y, 1), at[y]);
    const V dx = hn::Add(span_x_, change_x);
    const V dy = hn::Add(span_y_, change_y);
    const V l = hn::Sqrt(hn::MulAdd(dx, dx, hn::Mul(dy, dy)));
    // See stretch.hpp.
    V more = hn::MulAdd(change_x, hn::MulAdd(set(2), span_x_, change_x), at[excess]);
    more = hn::MulAdd(change_y, hn::MulAdd(set(2), span_y_, change_y), more);
    const V stretch = hn::Div(more, hn::Add(l, l0));
    const V back = hn::Sub(at[rest_angle], direction_of(dy, dx));
    const V t1 = wrapped(hn::Add(at[turn], back));
    const V t2 = wrapped(hn::Add(at.at_node(turn, 1), back));
    const V squares = hn::MulAdd(t1, hn::MulAdd(set(2), t1, hn::Neg(t2)), hn::Mul(set(2), hn::Mul(t2, t2)));
    const V per_length = hn::Div(set(1), l0);
    const V here = hn::MulAdd(stretch, per_length, hn::Mul(squares, set(1.0 / 30)));
    const V bend_1 = hn::MulAdd(set(curvature_slope(0, 0)), t1, hn::Mul(set(curvature_slope(0, 1)), t2));
    const V bend_2 = hn::MulAdd(set(curvature_slope(1, 0)), t1, hn::Mul(set(curvature_slope(1, 1)), t2));
    const V chi_1 = hn::Mul(bend_1, per_length);
    const V chi_2 = hn::Mul(bend_2, per_length);
    at.set(chord, l);
    at.set(along_x, hn::Div(dx, l));
    at.set(along_y, hn::Div(dy, l));
    at.set(rotation_1, t1);
    at.set(rotation_2, t2);
    at.set(strain, here);
    at.set(curvature_1, chi_1);
    at.set(curvature_2, chi_2);
    hn::StoreInterleaved2(here, here, tag, eps + gauss_points * e);
    hn::StoreInterleaved2(chi_1, chi_2, tag, chi + gauss_points * e);
  }
}

void find_internal_force_here(const Rows& rows, const double* N, const double* M) {
  const V half = set(gauss_weight);
  for (std::size_t e = 0; e < rows.elements; e += hn::Lanes(tag)) {
    const Register at{rows, e};
    V N_1, N_2, M_1, M_2;
    hn::LoadInterleaved2(tag, N + gauss_points * e, N_1, N_2);
    hn::LoadInterleaved2(tag, M + gauss_points * e, M_1, M_2);
    const V stretch = hn::Mul(half, hn::Add(N_1, N_2));
    const V inside = hn::Mul(hn::Mul(stretch, at[length]), set(1.0 / 30));
    const V t1 = at[rotation_1];
    const V t2 = at[rotation_2];
    const V m1 = hn::Mul(half, hn::MulAdd(M_1, set(curvature_slope(0, 0)), hn::Mul(M_2, set(curvature_slope(1, 0)))));
    const V m2 = hn::Mul(half, hn::MulAdd(M_1, set(curvature_slope(0, 1)), hn::Mul(M_2, set(curvature_slope(1, 1)))));
    const V moment1 = hn::MulAdd(inside, hn::MulAdd(set(4), t1, hn::Neg(t2)), m1);
    const V moment2 = hn::MulAdd(inside, hn::MulAdd(set(4), t2, hn::Neg(t1)), m2);
    const V across = hn::Div(hn::Add(moment1, moment2), at[chord]);
    const V fx = hn::MulAdd(stretch, at[along_x], hn::Mul(across, at[along_y]));
    const V fy = hn::NegMulAdd(across, at[along_x], hn::Mul(stretch, at[along_y]));
    at.set(force_x_1, hn::Neg(fx));
    at.set(force_y_1, hn::Neg(fy));
    at.set(moment_1, moment1);
    at.set(force_x_2, fx);
    at.set(force_y_2, fy);
    at.set(moment_2, moment2);
  }
}

void find_directions_here(const Rows& rows) {
  for (std::size_t e = 0; e < rows.elements; e += hn::Lanes(tag)) {
    const Register at{rows, e};
    const V angle_1 = hn::Add(at[turned], at[rest_angle]);
    const V angle_2 = hn::Add(at.at_node(turned, 1), at[rest_angle]);
    at.set(cosine_1, hn::Cos(tag, angle_1));
    at.set(sine_1, hn::Sin(tag, angle_1));
    at.set(cosine_2, hn::Cos(tag, angle_2));
    at.set(sine_2, hn::Sin(tag, angle_2));
  }
}

/// The Hermite table of an element (hermite_table.hpp) times one direction of (x_1, t_1, x_2, t_2).
struct Table {
  HWY_INLINE explicit Table(const Register& at) {
    const V c = at[mass];
    const V l0 = at[length];
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

void find_inertia_force_here(const Rows& rows) {
  for (std::size_t e = 0; e < rows.elements; e += hn::Lanes(tag)) {
    const Register at{rows, e};
    const Table table(at);
    const V c1 = at[cosine_1];
    const V s1 = at[sine_1];
    const V c2 = at[cosine_2];
    const V s2 = at[sine_2];
    // t'' = theta'' n - theta'^2 t
    const V turn1 = at[acceleration_turn];
    const V turn2 = at.at_node(acceleration_turn, 1);
    const V square1 = hn::Mul(at[rate_turn], at[rate_turn]);
    const V square2 = hn::Mul(at.at_node(rate_turn, 1), at.at_node(rate_turn, 1));
    const Table::Four P = table.times({.x_1 = at[acceleration_x],
                                       .t_1 = hn::Neg(hn::MulAdd(turn1, s1, hn::Mul(square1, c1))),
                                       .x_2 = at.at_node(acceleration_x, 1),
                                       .t_2 = hn::Neg(hn::MulAdd(turn2, s2, hn::Mul(square2, c2)))});
    const Table::Four Q = table.times({.x_1 = at[acceleration_y],
                                       .t_1 = hn::NegMulAdd(square1, s1, hn::Mul(turn1, c1)),
                                       .x_2 = at.at_node(acceleration_y, 1),
                                       .t_2 = hn::NegMulAdd(square2, s2, hn::Mul(turn2, c2))});
    at.set(force_x_1, P.x_1);
    at.set(force_y_1, Q.x_1);
    at.set(moment_1, hn::NegMulAdd(P.t_1, s1, hn::Mul(Q.t_1, c1)));
    at.set(force_x_2, P.x_2);
    at.set(force_y_2, Q.x_2);
    at.set(moment_2, hn::NegMulAdd(P.t_2, s2, hn::Mul(Q.t_2, c2)));
  }
}

void find_kinetic_energy_here(const Rows& rows) {
  for (std::size_t e = 0; e < rows.elements; e += hn::Lanes(tag)) {
    const Register at{rows, e};
    const Table table(at);
    const V turn1 = at[rate_turn];
    const V turn2 = at.at_node(rate_turn, 1);
    const Table::Four X{.x_1 = at[rate_x],
                        .t_1 = hn::Neg(hn::Mul(turn1, at[sine_1])),
                        .x_2 = at.at_node(rate_x, 1),
                        .t_2 = hn::Neg(hn::Mul(turn2, at[sine_2]))};
    const Table::Four Y{.x_1 = at[rate_y],
                        .t_1 = hn::Mul(turn1, at[cosine_1]),
                        .x_2 = at.at_node(rate_y, 1),
                        .t_2 = hn::Mul(turn2, at[cosine_2])};
    V twice = hn::Zero(tag);
    for (const Table::Four* motion : {&X, &Y}) {
      const Table::Four P = table.times(*motion);
      twice = hn::MulAdd(motion->x_1, P.x_1, hn::MulAdd(motion->t_1, P.t_1, twice));
      twice = hn::MulAdd(motion->x_2, P.x_2, hn::MulAdd(motion->t_2, P.t_2, twice));
    }
    at.set(energy, hn::Mul(set(0.5), twice));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::beam::planar_lanes_kernel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace strandyn::beam::planar_lanes_kernel {

HWY_EXPORT(find_kinematics_here);
HWY_EXPORT(find_internal_force_here);
HWY_EXPORT(find_directions_here);
HWY_EXPORT(find_inertia_force_here);
HWY_EXPORT(find_kinetic_energy_here);

void find_kinematics(const Rows& rows, double* eps, double* chi) {
  HWY_DYNAMIC_DISPATCH(find_kinematics_here)(rows, eps, chi);
}
void find_internal_force(const Rows& rows, const double* N, const double* M) {
  HWY_DYNAMIC_DISPATCH(find_internal_force_here)(rows, N, M);
}
void find_directions(const Rows& rows) {
  HWY_DYNAMIC_DISPATCH(find_directions_here)(rows);
}
void find_inertia_force(const Rows& rows) {
  HWY_DYNAMIC_DISPATCH(find_inertia_force_here)(rows);
}
void find_kinetic_energy(const Rows& rows) {
  HWY_DYNAMIC_DISPATCH(find_kinetic_energy_here)(rows);
}

}  // namespace strandyn::beam::planar_lanes_kernel
#endif
