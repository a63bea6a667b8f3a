// Highway reads this file once per instruction set; the best that the machine has is chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spatial_inertia_kernel.cpp"
#include <hwy/foreach_target.h>

#include "element_blocks-inl.hpp"
#include "spatial_lanes_kernel.hpp"
#include "spatial_registers-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::beam::spatial_lanes_kernel {
namespace HWY_NAMESPACE {

constexpr double sign_of(std::size_t node) {
  return node == 0 ? -1 : 1;
}

/// A node of the element in motion: its tangent t = R a turns with the spin w.
struct Tangent {
  HWY_INLINE Tangent(const Register& at, std::size_t node)
      : t(times(mat_of_node(at, turn, node), vec(at, triad))),
        w(vec_of_node(at, spin, node)),
        w_t(vec_of_node(at, spin_rate, node)),
        w_t_cross(cross(w, t)),
        t_tt(plus_cross(cross(w_t, t), w, w_t_cross)) {}
  Vec t, w, w_t;
  Vec w_t_cross;  ///< t' = w x t
  Vec t_tt;
};

HWY_INLINE HermiteTable table_of(const Register& at) {
  return {at[mass], at[length]};
}

struct FourVectors {
  Vec x_1, t_1, x_2, t_2;
};
/// The table times (x_1, t_1, x_2, t_2), direction by direction.
HWY_INLINE FourVectors times_table(const HermiteTable& table, const FourVectors& X) {
  const HermiteTable::Four x = table.times({X.x_1.x, X.t_1.x, X.x_2.x, X.t_2.x});
  const HermiteTable::Four y = table.times({X.x_1.y, X.t_1.y, X.x_2.y, X.t_2.y});
  const HermiteTable::Four z = table.times({X.x_1.z, X.t_1.z, X.x_2.z, X.t_2.z});
  return {{x.x_1, y.x_1, z.x_1}, {x.t_1, y.t_1, z.t_1}, {x.x_2, y.x_2, z.x_2}, {x.t_2, y.t_2, z.t_2}};
}

/// What both nodes do, the force on the centre line and the torques that work on the spins.
struct Motion {
  explicit HWY_INLINE Motion(const Register& at) : node{Tangent(at, 0), Tangent(at, 1)}, c(at[twist_inertia]) {
    const FourVectors P = times_table(table_of(at), {.x_1 = vec(at, acceleration),
                                                     .t_1 = node[0].t_tt,
                                                     .x_2 = vec_of_node(at, acceleration, 1),
                                                     .t_2 = node[1].t_tt});
    force = {P.x_1, P.x_2};
    along = {P.t_1, P.t_2};
    // The mean of a linear twist: the energy -c/2 (t_2 . w_2 - t_1 . w_1)^2.
    difference = hn::Mul(c, hn::Sub(dot(node[1].t, node[1].w), dot(node[0].t, node[0].w)));
    const V rate = hn::Mul(c, hn::Sub(dot(node[1].t, node[1].w_t), dot(node[0].t, node[0].w_t)));
    for (std::size_t i = 0; i < 2; ++i) {
      const V s = set(-sign_of(i));
      twisting[i] = plus(times(hn::Mul(s, rate), node[i].t), hn::Mul(s, difference), node[i].w_t_cross);
      torque[i] = plus_cross(twisting[i], node[i].t, along[i]);
    }
  }
  std::array<Tangent, 2> node;
  V c, difference;  ///< [kg m^2], [kg m^2/s] c a . (W_2 - W_1)
  std::array<Vec, 2> force, along, twisting, torque;
};

void find_inertia_force_here(const Rows& rows) {
  for (std::size_t first = 0; first < rows.elements; first += hn::Lanes(tag)) {
    const Register at{rows, first};
    const Motion m(at);
    store(at, force_1, m.force[0]);
    store(at, moment_1, transposed_times(mat(at, spin_map), m.torque[0]));
    store(at, force_2, m.force[1]);
    store(at, moment_2, transposed_times(mat_of_node(at, spin_map, 1), m.torque[1]));
  }
}

/// By the rotation of one node, its changes of w and w' as the node sees them.
struct Change {
  HWY_INLINE Change(const Register& at, std::size_t i, const Tangent& node, V position)
      : T(mat_of_node(at, spin_map, i)),
        by_psi(negative(crossed(node.t, T))),
        dw(mat_of_node(at, spin_change, i)),
        dw_t(mat_of_node(at, spin_rate_change, i)) {
    // The derivative of w x (w x t) is (w . t) dw - t (w . dw) - (w x t) x dw.
    const Mat turned = times(position, crossed(node.t_tt, T)) + crossed(node.w_t_cross, dw) + crossed(node.t, dw_t);
    t_tt = plus_product(times(dot(node.w, node.t), dw) - turned, -node.t, transposed_times(dw, node.w));
  }
  Mat T;
  Mat by_psi;  ///< of t
  Mat dw, dw_t;
  Mat t_tt;
};

void add_inertia_tangent_here(const Rows& rows, const InertiaFactors& factors, const SpatialLanes::Blocks& K) {
  ElementMatrices out;
  const V zero = hn::Zero(tag);
  const V position = set(factors.position);
  const V second = set(factors.acceleration);
  for (std::size_t first = 0; first < rows.elements; first += hn::Lanes(tag)) {
    const Register at{rows, first};
    const Motion m(at);
    const HermiteTable table = table_of(at);
    const std::array<Change, 2> change = {Change(at, 0, m.node[0], position), Change(at, 1, m.node[1], position)};
    // Entries of the table: of x_i and t_i with x_j and t_j.
    const V x_x[2][2] = {{table.near, table.far}, {table.far, table.near}};
    const V x_t[2][2] = {{table.near_turn, hn::Neg(table.far_turn)}, {table.far_turn, hn::Neg(table.near_turn)}};
    const V t_t[2][2] = {{table.turn, table.turns}, {table.turns, table.turn}};
    for (std::size_t i = 0; i < 2; ++i) {
      const Tangent& here = m.node[i];
      const Mat& T = change[i].T;
      for (std::size_t j = 0; j < 2; ++j) {
        const V mass = hn::Mul(second, x_x[i][j]);
        out.set(6 * i, 6 * j, Mat{{mass, zero, zero}, {zero, mass, zero}, {zero, zero, mass}});
        out.set(6 * i, 6 * j + 3, times(x_t[i][j], change[j].t_tt));
        out.set(6 * i + 3, 6 * j, times(hn::Mul(second, x_t[j][i]), transposed(change[i].by_psi)));
        // What works on the spin, by psi of node j.
        const Vec of_rate = transposed_times(change[j].dw_t, m.node[j].t);
        const Vec of_spin = transposed_times(change[j].dw, m.node[j].t);
        const V c = hn::Mul(set(-sign_of(i) * sign_of(j)), m.c);
        Mat works = times(t_t[i][j], crossed(here.t, change[j].t_tt));
        works = plus_product(works, times(c, here.t), of_rate);
        works = plus_product(works, times(c, here.w_t_cross), of_spin);
        if (i != j) {
          out.set(6 * i + 3, 6 * j + 3, transposed_times(T, works));
          continue;
        }
        works = plus(works, hn::Mul(set(sign_of(i)), m.difference), crossed(here.t, change[i].dw));
        // The direction that the force on psi is taken along turns as well.
        const Mat turned = product(here.t, transposed_times(T, m.along[i])) - times(dot(m.along[i], here.t), T) -
                           crossed(m.twisting[i], T);
        works = plus(works, position, turned);
        const Mat slope = slope_of_spin_map_transposed(at, times(position, m.torque[i]), i);
        out.set(6 * i + 3, 6 * j + 3, transposed_times(T, works) + slope);
      }
    }
    out.add_to(K, first, std::min(hn::Lanes(tag), rows.elements - first));
  }
}

void find_kinetic_energy_here(const Rows& rows) {
  for (std::size_t first = 0; first < rows.elements; first += hn::Lanes(tag)) {
    const Register at{rows, first};
    std::array<Vec, 2> t_t;
    std::array<V, 2> twisting;
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec t = times(mat_of_node(at, turn, i), vec(at, triad));
      const Vec w = times(mat_of_node(at, spin_map, i), vec_of_node(at, rotation_rate, i));
      t_t[i] = cross(w, t);
      twisting[i] = dot(w, t);
    }
    const FourVectors X{vec(at, rate), t_t[0], vec_of_node(at, rate, 1), t_t[1]};
    const FourVectors P = times_table(table_of(at), X);
    const V difference = hn::Sub(twisting[1], twisting[0]);
    V twice = hn::Add(hn::Add(dot(X.x_1, P.x_1), dot(X.t_1, P.t_1)), hn::Add(dot(X.x_2, P.x_2), dot(X.t_2, P.t_2)));
    twice = hn::NegMulAdd(hn::Mul(at[twist_inertia], difference), difference, twice);
    at.set(energy, hn::Mul(set(0.5), twice));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::beam::spatial_lanes_kernel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace strandyn::beam::spatial_lanes_kernel {

HWY_EXPORT(find_inertia_force_here);
HWY_EXPORT(add_inertia_tangent_here);
HWY_EXPORT(find_kinetic_energy_here);

void find_inertia_force(const Rows& rows) {
  HWY_DYNAMIC_DISPATCH(find_inertia_force_here)(rows);
}
void add_inertia_tangent(const Rows& rows, const InertiaFactors& factors, const SpatialLanes::Blocks& K) {
  HWY_DYNAMIC_DISPATCH(add_inertia_tangent_here)(rows, factors, K);
}
void find_kinetic_energy(const Rows& rows) {
  HWY_DYNAMIC_DISPATCH(find_kinetic_energy_here)(rows);
}

}  // namespace strandyn::beam::spatial_lanes_kernel
#endif
