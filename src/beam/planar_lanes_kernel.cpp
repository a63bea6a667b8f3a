// Highway reads this file once per instruction set; the best that the machine has is chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "planar_lanes_kernel.cpp"
#include "planar_lanes_kernel.hpp"

#include <hwy/foreach_target.h>

#include "element_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::beam::planar_lanes_kernel {
namespace HWY_NAMESPACE {

using namespace lanes::HWY_NAMESPACE;
using Register = RegisterOf<Row>;

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

/// What works on the chord's stretch and on the two rotations in the chord's frame.
struct LocalForce {
  V stretch, moment1, moment2;
};

HWY_INLINE LocalForce local_force(const Register& at, const double* N, const double* M) {
  const V stretch = mean_of(N, at.first, 1, 1);
  const V inside = hn::Mul(hn::Mul(stretch, at[length]), set(1.0 / 30));
  const V t1 = at[rotation_1];
  const V t2 = at[rotation_2];
  return {.stretch = stretch,
          .moment1 = hn::MulAdd(inside, hn::MulAdd(set(4), t1, hn::Neg(t2)), moment_of(M, at.first, 0)),
          .moment2 = hn::MulAdd(inside, hn::MulAdd(set(4), t2, hn::Neg(t1)), moment_of(M, at.first, 1))};
}

void find_internal_force_here(const Rows& rows, const double* N, const double* M) {
  for (std::size_t e = 0; e < rows.elements; e += hn::Lanes(tag)) {
    const Register at{rows, e};
    const LocalForce f = local_force(at, N, M);
    const V across = hn::Div(hn::Add(f.moment1, f.moment2), at[chord]);
    const V fx = hn::MulAdd(f.stretch, at[along_x], hn::Mul(across, at[along_y]));
    const V fy = hn::NegMulAdd(across, at[along_x], hn::Mul(f.stretch, at[along_y]));
    at.set(force_x_1, hn::Neg(fx));
    at.set(force_y_1, hn::Neg(fy));
    at.set(moment_1, f.moment1);
    at.set(force_x_2, fx);
    at.set(force_y_2, fy);
    at.set(moment_2, f.moment2);
  }
}

/// Two numbers along and across the chord.
struct Pair {
  V along, across;
};
/// The same by global axes, and back: the chord's axes mirrored, so that one matrix does both.
HWY_INLINE Pair turned_axes(const Register& at, const Pair& p) {
  return {.along = hn::MulAdd(p.along, at[along_x], hn::Mul(p.across, at[along_y])),
          .across = hn::NegMulAdd(p.across, at[along_x], hn::Mul(p.along, at[along_y]))};
}

/// Entries of the matrices of a register of elements.
struct Tile {
  double* at;
  HWY_INLINE Tile(double* tiles, std::size_t first, std::size_t entries)
      : at(tiles + place_in_tile(first, 0, entries)) {}
  HWY_INLINE void set(std::size_t entry, V value) const { hn::Store(value, tag, at + entry * most_lanes); }
  HWY_INLINE void set(std::size_t entry, const Pair& value) const {
    set(entry, value.along);
    set(entry + 1, value.across);
  }
};

void find_stiffness_here(const Rows& rows, const double* N, const double* M, const PointTangents& t, double* tiles) {
  for (std::size_t e = 0; e < rows.elements; e += hn::Lanes(tag)) {
    const Register at{rows, e};
    const Tile out(tiles, e, stiffness_entries);
    const LocalForce f = local_force(at, N, M);
    const V l0 = at[length];
    const V per_l0 = hn::Div(set(1), l0);
    const V per_l = hn::Div(set(1), at[chord]);
    // By stretch and rotations in the chord's frame: eps moves by (1/l0, s_1, s_2), chi by (0, c_1, c_2)/l0.
    const V t1 = at[rotation_1];
    const V t2 = at[rotation_2];
    const V s1 = hn::Mul(hn::MulAdd(set(4), t1, hn::Neg(t2)), set(1.0 / 30));
    const V s2 = hn::Mul(hn::MulAdd(set(4), t2, hn::Neg(t1)), set(1.0 / 30));
    const V A = mean_of(t.N_eps, e, 1, 1);
    const V B1 = moment_of(t.N_chi, e, 0);
    const V B2 = moment_of(t.N_chi, e, 1);
    const V C1 = moment_of(t.M_eps, e, 0);
    const V C2 = moment_of(t.M_eps, e, 1);
    constexpr double c11 = curvature_slope(0, 0), c12 = curvature_slope(0, 1);
    constexpr double c21 = curvature_slope(1, 0), c22 = curvature_slope(1, 1);
    const V D11 = mean_of(t.M_chi, e, c11 * c11, c21 * c21);
    const V D12 = mean_of(t.M_chi, e, c11 * c12, c21 * c22);
    const V D22 = mean_of(t.M_chi, e, c12 * c12, c22 * c22);
    const V k00 = hn::Mul(A, per_l0);
    const V k01 = hn::MulAdd(A, s1, hn::Mul(B1, per_l0));
    const V k02 = hn::MulAdd(A, s2, hn::Mul(B2, per_l0));
    const V k10 = hn::MulAdd(A, s1, hn::Mul(C1, per_l0));
    const V k20 = hn::MulAdd(A, s2, hn::Mul(C2, per_l0));
    const V inside = hn::Mul(hn::Mul(f.stretch, l0), set(1.0 / 30));
    const V row1 = hn::MulAdd(hn::Mul(l0, A), s1, C1);
    const V row2 = hn::MulAdd(hn::Mul(l0, A), s2, C2);
    const V k11 = hn::MulAdd(row1, s1, hn::MulAdd(s1, B1, hn::MulAdd(set(4), inside, hn::Mul(D11, per_l0))));
    const V k12 = hn::MulAdd(row1, s2, hn::MulAdd(s1, B2, hn::MulSub(D12, per_l0, inside)));
    const V k21 = hn::MulAdd(row2, s1, hn::MulAdd(s2, B1, hn::MulSub(D12, per_l0, inside)));
    const V k22 = hn::MulAdd(row2, s2, hn::MulAdd(s2, B2, hn::MulAdd(set(4), inside, hn::Mul(D22, per_l0))));
    // By the chord's end along and across: across turns the chord by 1/l. And what turns with it under the force held.
    const V turning = hn::Mul(hn::Mul(hn::Add(f.moment1, f.moment2), per_l), per_l);
    const V sum1 = hn::Add(k11, k21);
    const V sum2 = hn::Add(k12, k22);
    const V q01 = hn::MulSub(hn::Add(k01, k02), per_l, turning);
    const V q10 = hn::MulSub(hn::Add(k10, k20), per_l, turning);
    const V q11 = hn::Mul(hn::MulAdd(hn::Add(sum1, sum2), per_l, f.stretch), per_l);
    const Pair along = turned_axes(at, {k00, q01});
    const Pair across = turned_axes(at, {q10, q11});
    const Pair by_x = turned_axes(at, {along.along, across.along});
    const Pair by_y = turned_axes(at, {along.across, across.across});
    out.set(ends_xx, by_x.along);
    out.set(ends_xy, by_y.along);
    out.set(ends_yx, by_x.across);
    out.set(ends_yy, by_y.across);
    out.set(by_turn_x_1, turned_axes(at, {k01, hn::Mul(sum1, per_l)}));
    out.set(by_turn_x_2, turned_axes(at, {k02, hn::Mul(sum2, per_l)}));
    out.set(of_turn_x_1, turned_axes(at, {k10, hn::Mul(hn::Add(k11, k12), per_l)}));
    out.set(of_turn_x_2, turned_axes(at, {k20, hn::Mul(hn::Add(k21, k22), per_l)}));
    out.set(turns_11, k11);
    out.set(turns_12, k12);
    out.set(turns_21, k21);
    out.set(turns_22, k22);
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

/// The table times the second time derivative of (x_1, t_1, x_2, t_2), in both directions.
struct MomentumRate {
  HWY_INLINE explicit MomentumRate(const Register& at, const HermiteTable& table) {
    // t'' = theta'' n - theta'^2 t
    const V turn1 = at[acceleration_turn];
    const V turn2 = at.at_node(acceleration_turn, 1);
    const V square1 = hn::Mul(at[rate_turn], at[rate_turn]);
    const V square2 = hn::Mul(at.at_node(rate_turn, 1), at.at_node(rate_turn, 1));
    X = table.times({.x_1 = at[acceleration_x],
                     .t_1 = hn::Neg(hn::MulAdd(turn1, at[sine_1], hn::Mul(square1, at[cosine_1]))),
                     .x_2 = at.at_node(acceleration_x, 1),
                     .t_2 = hn::Neg(hn::MulAdd(turn2, at[sine_2], hn::Mul(square2, at[cosine_2])))});
    Y = table.times({.x_1 = at[acceleration_y],
                     .t_1 = hn::NegMulAdd(square1, at[sine_1], hn::Mul(turn1, at[cosine_1])),
                     .x_2 = at.at_node(acceleration_y, 1),
                     .t_2 = hn::NegMulAdd(square2, at[sine_2], hn::Mul(turn2, at[cosine_2]))});
  }
  HermiteTable::Four X, Y;
};

void find_inertia_force_here(const Rows& rows) {
  for (std::size_t e = 0; e < rows.elements; e += hn::Lanes(tag)) {
    const Register at{rows, e};
    const MomentumRate P(at, HermiteTable(at[mass], at[length]));
    at.set(force_x_1, P.X.x_1);
    at.set(force_y_1, P.Y.x_1);
    at.set(moment_1, hn::NegMulAdd(P.X.t_1, at[sine_1], hn::Mul(P.Y.t_1, at[cosine_1])));
    at.set(force_x_2, P.X.x_2);
    at.set(force_y_2, P.Y.x_2);
    at.set(moment_2, hn::NegMulAdd(P.X.t_2, at[sine_2], hn::Mul(P.Y.t_2, at[cosine_2])));
  }
}

HWY_INLINE Pair scaled(V factor, const Pair& p) {
  return {.along = hn::Mul(factor, p.along), .across = hn::Mul(factor, p.across)};
}
HWY_INLINE V dot(const Pair& p, const Pair& q) {
  return hn::MulAdd(p.along, q.along, hn::Mul(p.across, q.across));
}

/// Derivatives of theta'' n - theta'^2 t by all three of a rotation, each times its factor: dn/dtheta = -t,
/// dt/dtheta = n.
HWY_INLINE Pair by_rotation(const InertiaFactors& factors, V rate, V acceleration, const Pair& along,
                            const Pair& normal) {
  const V of_normal = hn::NegMulAdd(hn::Mul(set(factors.position), rate), rate, set(factors.acceleration));
  const V of_along = hn::MulAdd(set(2 * factors.velocity), rate, hn::Mul(set(factors.position), acceleration));
  return {.along = hn::NegMulAdd(of_along, along.along, hn::Mul(of_normal, normal.along)),
          .across = hn::NegMulAdd(of_along, along.across, hn::Mul(of_normal, normal.across))};
}

void find_inertia_tangent_here(const Rows& rows, const InertiaFactors& factors, double* tiles) {
  for (std::size_t e = 0; e < rows.elements; e += hn::Lanes(tag)) {
    const Register at{rows, e};
    const Tile out(tiles, e, inertia_entries);
    const HermiteTable table(at[mass], at[length]);
    const MomentumRate P(at, table);
    const Pair along1{at[cosine_1], at[sine_1]};
    const Pair along2{at[cosine_2], at[sine_2]};
    const Pair normal1{hn::Neg(along1.across), along1.along};
    const Pair normal2{hn::Neg(along2.across), along2.along};
    const Pair by1 = by_rotation(factors, at[rate_turn], at[acceleration_turn], along1, normal1);
    const Pair by2 = by_rotation(factors, at.at_node(rate_turn, 1), at.at_node(acceleration_turn, 1), along2, normal2);
    const V second = set(factors.acceleration);
    const V near_turn = hn::Mul(second, table.near_turn);
    const V far_turn = hn::Mul(second, table.far_turn);
    out.set(near_node, hn::Mul(second, table.near));
    out.set(far_node, hn::Mul(second, table.far));
    out.set(node_1_by_turn_x_1, scaled(table.near_turn, by1));
    out.set(node_1_by_turn_x_2, scaled(hn::Neg(table.far_turn), by2));
    out.set(node_2_by_turn_x_1, scaled(table.far_turn, by1));
    out.set(node_2_by_turn_x_2, scaled(hn::Neg(table.near_turn), by2));
    out.set(turn_1_by_node_x_1, scaled(near_turn, normal1));
    out.set(turn_1_by_node_x_2, scaled(far_turn, normal1));
    out.set(turn_2_by_node_x_1, scaled(hn::Neg(far_turn), normal2));
    out.set(turn_2_by_node_x_2, scaled(hn::Neg(near_turn), normal2));
    // The normal that the force is taken along turns as well.
    const V held = set(factors.position);
    out.set(inertia_turns_11,
            hn::NegMulAdd(held, dot(along1, {P.X.t_1, P.Y.t_1}), hn::Mul(table.turn, dot(normal1, by1))));
    out.set(inertia_turns_12, hn::Mul(table.turns, dot(normal1, by2)));
    out.set(inertia_turns_21, hn::Mul(table.turns, dot(normal2, by1)));
    out.set(inertia_turns_22,
            hn::NegMulAdd(held, dot(along2, {P.X.t_2, P.Y.t_2}), hn::Mul(table.turn, dot(normal2, by2))));
  }
}

void find_kinetic_energy_here(const Rows& rows) {
  for (std::size_t e = 0; e < rows.elements; e += hn::Lanes(tag)) {
    const Register at{rows, e};
    const HermiteTable table(at[mass], at[length]);
    const V turn1 = at[rate_turn];
    const V turn2 = at.at_node(rate_turn, 1);
    const HermiteTable::Four X{.x_1 = at[rate_x],
                               .t_1 = hn::Neg(hn::Mul(turn1, at[sine_1])),
                               .x_2 = at.at_node(rate_x, 1),
                               .t_2 = hn::Neg(hn::Mul(turn2, at[sine_2]))};
    const HermiteTable::Four Y{.x_1 = at[rate_y],
                               .t_1 = hn::Mul(turn1, at[cosine_1]),
                               .x_2 = at.at_node(rate_y, 1),
                               .t_2 = hn::Mul(turn2, at[cosine_2])};
    V twice = hn::Zero(tag);
    for (const HermiteTable::Four* motion : {&X, &Y}) {
      const HermiteTable::Four P = table.times(*motion);
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
HWY_EXPORT(find_stiffness_here);
HWY_EXPORT(find_directions_here);
HWY_EXPORT(find_inertia_force_here);
HWY_EXPORT(find_inertia_tangent_here);
HWY_EXPORT(find_kinetic_energy_here);

void find_kinematics(const Rows& rows, double* eps, double* chi) {
  HWY_DYNAMIC_DISPATCH(find_kinematics_here)(rows, eps, chi);
}
void find_internal_force(const Rows& rows, const double* N, const double* M) {
  HWY_DYNAMIC_DISPATCH(find_internal_force_here)(rows, N, M);
}
void find_stiffness(const Rows& rows, const double* N, const double* M, const PointTangents& t, double* tiles) {
  HWY_DYNAMIC_DISPATCH(find_stiffness_here)(rows, N, M, t, tiles);
}
void find_directions(const Rows& rows) {
  HWY_DYNAMIC_DISPATCH(find_directions_here)(rows);
}
void find_inertia_force(const Rows& rows) {
  HWY_DYNAMIC_DISPATCH(find_inertia_force_here)(rows);
}
void find_inertia_tangent(const Rows& rows, const InertiaFactors& factors, double* tiles) {
  HWY_DYNAMIC_DISPATCH(find_inertia_tangent_here)(rows, factors, tiles);
}
void find_kinetic_energy(const Rows& rows) {
  HWY_DYNAMIC_DISPATCH(find_kinetic_energy_here)(rows);
}

}  // namespace strandyn::beam::planar_lanes_kernel
#endif
