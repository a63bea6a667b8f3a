// Highway reads this file once per instruction set; the best that the machine has is chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spatial_stiffness_kernel.cpp"
#include <hwy/foreach_target.h>

#include "element_blocks-inl.hpp"
#include "spatial_forces-inl.hpp"
#include "spatial_lanes_kernel.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::beam::spatial_lanes_kernel {
namespace HWY_NAMESPACE {

using Two = std::array<Mat, 2>;
using TwoByTwo = std::array<Two, 2>;

/// Forces on (stretch, theta_1, theta_2), or on the stretch and the spins against the frame, by these.
struct LocalStiffness {
  V stretch;
  std::array<Vec, 2> by_node;  ///< row of the stretch
  std::array<Vec, 2> of_node;  ///< column of the stretch
  TwoByTwo nodes;              ///< nodes[i][j]: of node i by node j
};

/// One entry of the section's tangent at the two points, and its means.
struct Entry {
  HWY_INLINE Entry(const double* points, std::size_t first) {
    hn::LoadInterleaved2(tag, points + gauss_points * first, one, two);
  }
  HWY_INLINE V mean(double weight_1, double weight_2) const {
    return hn::MulAdd(set(gauss_weight * weight_1), one, hn::Mul(set(gauss_weight * weight_2), two));
  }
  HWY_INLINE V mean() const { return hn::Mul(set(gauss_weight), hn::Add(one, two)); }
  /// Weighed by what bends.
  HWY_INLINE V bent(std::size_t node) const { return mean(curvature_slope(0, node), curvature_slope(1, node)); }
  HWY_INLINE V bent(std::size_t i, std::size_t j) const {
    return mean(curvature_slope(0, i) * curvature_slope(0, j), curvature_slope(1, i) * curvature_slope(1, j));
  }
  V one, two;
};
static_assert(gauss_weight == 0.5, "both points weigh the same");

/// With B = d(eps, chi_1, chi_2, chi_3)/d(stretch, theta_1, theta_2) = [1/l0, s_1, s_2; -+1/l0 of twist; c_i/l0 of the
/// two bendings] it is l0 B^T C B, summed over the points, and the tension's stiffening.
HWY_INLINE LocalStiffness section_stiffness(const ElementKinematics& k, V tension, const SpatialLanes::PointTangents& t,
                                            std::size_t first) {
  const V l0 = k.l0;
  const V per_l0 = hn::Div(set(1), l0);
  const std::array<std::array<V, 2>, 2> s = {{{k.strain_slope_y(0), k.strain_slope_z(0)},  // [node][axis - 2]
                                              {k.strain_slope_y(1), k.strain_slope_z(1)}}};
  const V A = Entry(t[0].axial, first).mean();
  const V N_chi1 = Entry(t[0].torsion, first).mean();
  const V M1_eps = Entry(t[1].axial, first).mean();
  const V twists = hn::Mul(Entry(t[1].torsion, first).mean(), per_l0);
  const std::array<Entry, 2> N_chi = {Entry(t[0].bending2, first), Entry(t[0].bending3, first)};
  const std::array<Entry, 2> M1_chi = {Entry(t[1].bending2, first), Entry(t[1].bending3, first)};
  const std::array<Entry, 2> M_eps = {Entry(t[2].axial, first), Entry(t[3].axial, first)};
  const std::array<Entry, 2> M_chi1 = {Entry(t[2].torsion, first), Entry(t[3].torsion, first)};
  const std::array<std::array<Entry, 2>, 2> M_chi = {{{Entry(t[2].bending2, first), Entry(t[2].bending3, first)},
                                                      {Entry(t[3].bending2, first), Entry(t[3].bending3, first)}}};

  const V A_l0 = hn::Mul(A, l0);
  // Derivatives of N by the bendings of node j about an axis, of that moment on node i by eps; both times l0.
  std::array<std::array<V, 2>, 2> N_by, M_by_eps, by, of;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      N_by[i][axis] = N_chi[axis].bent(i);
      M_by_eps[i][axis] = M_eps[axis].bent(i);
      by[i][axis] = hn::MulAdd(A, s[i][axis], hn::Mul(N_by[i][axis], per_l0));
      of[i][axis] = hn::MulAdd(A, s[i][axis], hn::Mul(M_by_eps[i][axis], per_l0));
    }
  }
  LocalStiffness K;
  K.stretch = hn::Mul(A, per_l0);
  const V stiffening = hn::Mul(hn::Mul(tension, l0), set(1.0 / 30));
  for (std::size_t i = 0; i < 2; ++i) {
    const double sign_i = i == 0 ? -1 : 1;
    K.by_node[i] = {hn::Mul(set(sign_i), hn::Mul(N_chi1, per_l0)), by[i][0], by[i][1]};
    K.of_node[i] = {hn::Mul(set(sign_i), hn::Mul(M1_eps, per_l0)), of[i][0], of[i][1]};
    for (std::size_t j = 0; j < 2; ++j) {
      const double sign_j = j == 0 ? -1 : 1;
      std::array<std::array<V, 2>, 2> bend;
      std::array<V, 2> twist_by, bend_by_twist;
      for (std::size_t p = 0; p < 2; ++p) {
        twist_by[p] = hn::Mul(set(sign_i), hn::MulAdd(M1_eps, s[j][p], hn::Mul(M1_chi[p].bent(j), per_l0)));
        bend_by_twist[p] = hn::Mul(set(sign_j), hn::MulAdd(N_chi1, s[i][p], hn::Mul(M_chi1[p].bent(i), per_l0)));
        for (std::size_t q = 0; q < 2; ++q) {
          const V of_i = hn::MulAdd(A_l0, s[i][p], M_by_eps[i][p]);
          bend[p][q] =
              hn::MulAdd(of_i, s[j][q], hn::MulAdd(s[i][p], N_by[j][q], hn::Mul(M_chi[p][q].bent(i, j), per_l0)));
        }
        bend[p][p] = hn::MulAdd(set(i == j ? 4 : -1), stiffening, bend[p][p]);
      }
      const V turning = hn::Mul(set(sign_i * sign_j), twists);
      K.nodes[i][j] = {{turning, bend_by_twist[0], bend_by_twist[1]},
                       {twist_by[0], bend[0][0], bend[1][0]},
                       {twist_by[1], bend[0][1], bend[1][1]}};
    }
  }
  return K;
}

/// By the stretch and the spins against the frame. Forces go back through the transpose of T^-1, which changes with
/// theta.
HWY_INLINE LocalStiffness spin_stiffness(const Register& at, const ElementKinematics& k, const LocalForce& f,
                                         const LocalStiffness& by_theta) {
  const Two H = {polynomial(k.angle[0], set(-0.5), k.inverse[0]), polynomial(k.angle[1], set(-0.5), k.inverse[1])};
  const std::array<V, 2> slope = {at[inverse_slope_1], at[inverse_slope_2]};
  LocalStiffness K;
  K.stretch = by_theta.stretch;
  for (std::size_t i = 0; i < 2; ++i) {
    K.by_node[i] = transposed_times(H[i], by_theta.by_node[i]);
    K.of_node[i] = transposed_times(H[i], by_theta.of_node[i]);
    for (std::size_t j = 0; j < 2; ++j) {
      Mat inner = transposed_times(H[i], by_theta.nodes[i][j]);
      if (i == j) {
        inner = inner + slope_of_polynomial(k.angle[i], f.theta[i], {.value = set(0.5), .slope = hn::Zero(tag)},
                                            {.value = k.inverse[i], .slope = slope[i]});
      }
      K.nodes[i][j] = times(inner, H[j]);
    }
  }
  return K;
}

/// W, the frame's spin by the motion, 3 x 9: the chord turns it about e2 and e3, the mean of the nodes about e1.
struct FrameTurn {
  explicit HWY_INLINE FrameTurn(const ElementKinematics& k) : tilt(k.per_l), lean(hn::Neg(hn::Mul(k.lean, k.per_l))) {
    const V half_per_upright = hn::Mul(set(0.5), k.per_upright);
    for (std::size_t i = 0; i < 2; ++i) {
      about_2[i] = hn::Mul(k.direction[i].y, half_per_upright);
      about_3[i] = hn::Neg(hn::Mul(k.direction[i].x, half_per_upright));
    }
  }
  V tilt, lean;
  std::array<V, 2> about_2, about_3;
};

/// A row of nine: by the change of the chord and by the spins of the nodes.
using Nine = std::array<Vec, 3>;

HWY_INLINE void add(Nine& sum, V factor, const Nine& row) {
  for (std::size_t block = 0; block < 3; ++block) sum[block] = plus(sum[block], factor, row[block]);
}
HWY_INLINE void subtract(Nine& sum, V factor, const Nine& row) {
  for (std::size_t block = 0; block < 3; ++block) sum[block] = minus(sum[block], factor, row[block]);
}
/// row -= m W, m a row of three.
HWY_INLINE void subtract_turned(Nine& row, const Vec& m, const FrameTurn& W) {
  row[0].y = hn::NegMulAdd(W.tilt, m.z, row[0].y);
  row[0].z = hn::NegMulAdd(W.lean, m.x, hn::MulAdd(W.tilt, m.y, row[0].z));
  for (std::size_t i = 0; i < 2; ++i) {
    row[1 + i].x = hn::NegMulAdd(W.about_2[i], m.x, row[1 + i].x);
    row[1 + i].y = hn::NegMulAdd(W.about_3[i], m.x, row[1 + i].y);
  }
}

using MotionStiffness = std::array<Nine, 9>;

/// What the change of the lever arms adds under the force held.
HWY_INLINE void add_lever_arms(const ElementKinematics& k, const LocalForce& f, const FrameTurn& W,
                               MotionStiffness& K) {
  const Vec sum = f.spin[0] + f.spin[1];
  const V per_l_squared = hn::Mul(k.per_l, k.per_l);
  K[1][0].x = hn::MulAdd(sum.z, per_l_squared, K[1][0].x);
  K[2][0].x = hn::NegMulAdd(hn::MulAdd(k.lean, sum.x, sum.y), per_l_squared, K[2][0].x);

  // The directions of the nodes turn with the nodes, against the frame: n x (W - the node's spin). Their first two
  // rows; p is the mean.
  const V zero = hn::Zero(tag);
  const Vec none{zero, zero, zero};
  std::array<std::array<Nine, 2>, 2> direction;
  std::array<Nine, 2> p;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec& n = k.direction[i];
    const std::array<Vec, 2> minus_n_cross = {{{zero, n.z, hn::Neg(n.y)}, {hn::Neg(n.z), zero, n.x}}};
    for (std::size_t r = 0; r < 2; ++r) {
      direction[i][r] = {none, none, none};
      direction[i][r][1 + i] = minus_n_cross[r];
      subtract_turned(direction[i][r], minus_n_cross[r], W);
    }
  }
  for (std::size_t r = 0; r < 2; ++r) {
    for (std::size_t block = 0; block < 3; ++block) {
      p[r][block] = times(set(0.5), direction[0][r][block] + direction[1][r][block]);
    }
  }
  const V roll = hn::Mul(sum.x, k.per_upright);
  add(K[2], hn::Mul(roll, k.per_l), p[0]);
  subtract(K[2], hn::Mul(hn::Mul(roll, k.per_l), k.lean), p[1]);
  const V half_roll = hn::Mul(set(0.5), roll);
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec& n = k.direction[i];
    const V scaled = hn::Mul(half_roll, k.per_upright);
    subtract(K[3 + 3 * i], half_roll, direction[i][1]);
    add(K[3 + 3 * i], hn::Mul(scaled, n.y), p[1]);
    add(K[4 + 3 * i], half_roll, direction[i][0]);
    subtract(K[4 + 3 * i], hn::Mul(scaled, n.x), p[1]);
  }
}

/// Derivative of the force on the motion by the motion, both along the frame. With E the stretch and the spins of the
/// nodes, those against the frame are E - W; S is their stiffness. The frame carries the force with it.
///     K = (E - W)^T S (E - W) + lever arms - force x W
HWY_INLINE void find_motion_stiffness(const ElementKinematics& k, const LocalForce& f, const MotionForce& force,
                                      const LocalStiffness& S, MotionStiffness& K) {
  const FrameTurn W(k);
  const V zero = hn::Zero(tag);
  K[0] = {Vec{S.stretch, zero, zero}, S.by_node[0], S.by_node[1]};
  K[1] = K[2] = {Vec{zero, zero, zero}, Vec{zero, zero, zero}, Vec{zero, zero, zero}};
  for (std::size_t i = 0; i < 2; ++i) {
    const Mat by_1 = transposed(S.nodes[i][0]), by_2 = transposed(S.nodes[i][1]);
    const Vec& of = S.of_node[i];
    K[3 + 3 * i] = {Vec{of.x, zero, zero}, by_1.x, by_2.x};
    K[4 + 3 * i] = {Vec{of.y, zero, zero}, by_1.y, by_2.y};
    K[5 + 3 * i] = {Vec{of.z, zero, zero}, by_1.z, by_2.z};
  }

  // -W^T (both nodes' rows of S) (E - W)
  std::array<Nine, 3> against;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t block = 0; block < 3; ++block) against[r][block] = K[3 + r][block] + K[6 + r][block];
    subtract_turned(against[r], against[r][1] + against[r][2], W);
  }
  // -(E^T (both nodes' columns of S) + force x) W
  const std::array<Vec, 3> forces = {force.chord, force.node[0], force.node[1]};
  for (std::size_t block = 0; block < 3; ++block) {
    const Vec& F = forces[block];
    const std::array<Vec, 3> crossed = {
        {{zero, hn::Neg(F.z), F.y}, {F.z, zero, hn::Neg(F.x)}, {hn::Neg(F.y), F.x, zero}}};
    for (std::size_t r = 0; r < 3; ++r) {
      Nine& row = K[3 * block + r];
      subtract_turned(row, crossed[r] + row[1] + row[2], W);
    }
  }
  subtract(K[1], W.tilt, against[2]);
  subtract(K[2], W.lean, against[0]);
  add(K[2], W.tilt, against[1]);
  for (std::size_t i = 0; i < 2; ++i) {
    subtract(K[3 + 3 * i], W.about_2[i], against[0]);
    subtract(K[4 + 3 * i], W.about_3[i], against[0]);
  }
  add_lever_arms(k, f, W, K);
}

void add_stiffness_here(const Rows& rows, const SpatialLanes::Points& r, const SpatialLanes::PointTangents& t,
                        const SpatialLanes::Blocks& K_of_chain) {
  ElementMatrices out;
  for (std::size_t first = 0; first < rows.elements; first += hn::Lanes(tag)) {
    const Register at{rows, first};
    const ElementKinematics k(at);
    const LocalForce f = local_force(k, r, first);
    const MotionForce force(k, f);
    MotionStiffness K;
    find_motion_stiffness(k, f, force, spin_stiffness(at, k, f, section_stiffness(k, f.stretch, t, first)), K);

    // From the frame's axes to global ones, from spins to rotation vectors.
    const Mat F = mat(at, frame);
    const std::array<Mat, 3> to = {transposed(F), transposed_times(F, mat(at, spin_map)),
                                   transposed_times(F, mat_of_node(at, spin_map, 1))};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const Mat by_rows = {transposed_times(to[j], K[3 * i][j]), transposed_times(to[j], K[3 * i + 1][j]),
                             transposed_times(to[j], K[3 * i + 2][j])};
        Mat block = transposed(times(by_rows, to[i]));
        if (i == j && i > 0) block = block + slope_of_spin_map_transposed(at, times(F, force.node[i - 1]), i - 1);
        // Ends move as one against the other.
        const std::size_t rotations[] = {0, 3, 9};
        if (i > 0 && j > 0) out.set(rotations[i], rotations[j], block);
        if (i == 0 && j > 0) {
          out.set(0, rotations[j], negative(block));
          out.set(6, rotations[j], block);
        }
        if (i > 0 && j == 0) {
          out.set(rotations[i], 0, negative(block));
          out.set(rotations[i], 6, block);
        }
        if (i == 0 && j == 0) {
          const Mat opposed = negative(block);
          out.set(0, 0, block);
          out.set(0, 6, opposed);
          out.set(6, 0, opposed);
          out.set(6, 6, block);
        }
      }
    }
    out.add_to(K_of_chain, first, std::min(hn::Lanes(tag), rows.elements - first));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::beam::spatial_lanes_kernel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace strandyn::beam::spatial_lanes_kernel {

HWY_EXPORT(add_stiffness_here);

void add_stiffness(const Rows& rows, const SpatialLanes::Points& resultants,
                   const SpatialLanes::PointTangents& tangents, const SpatialLanes::Blocks& K) {
  HWY_DYNAMIC_DISPATCH(add_stiffness_here)(rows, resultants, tangents, K);
}

}  // namespace strandyn::beam::spatial_lanes_kernel
#endif
