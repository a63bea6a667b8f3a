// What the marches of the compliant laws share, in the plane and in space: stiffness of the interfaces, derivatives of
// a solved cell, and how a cell is committed. Included once per instruction set.
#if defined(STRANDYN_SECTION_COMPLIANT_MARCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_SECTION_COMPLIANT_MARCH_INL
#undef STRANDYN_SECTION_COMPLIANT_MARCH_INL
#else
#define STRANDYN_SECTION_COMPLIANT_MARCH_INL
#endif

#include "compliant_cell-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::compliant_kernel {
namespace HWY_NAMESPACE {
using PlanarLayer = PlanarCoefficients::Layer;

/// Stiffness of the interfaces of a register of points under its strain. It is remembered, and found anew only where
/// the strain is larger than ever.
struct ContactRows {
  explicit ContactRows(const CompliantCoefficients& c)
      : size(c.layers.size() * block_lanes), now(size), now_eps(size) {}

  std::size_t size;
  AlignedVector now, now_eps;  // rows of lanes; the second is the derivative by the strain

  /// `peak` and `committed` are rows of the history, `eps` the strains to come.
  void fill(const CompliantCoefficients& c, const double* peak, const double* committed, const double* eps) {
    for (std::size_t lane = 0; lane < hn::Lanes(tag); ++lane) {
      if (eps[lane] > peak[lane]) {
        contact_stiffness(c, eps[lane], {.value = now.data() + lane, .slope = now_eps.data() + lane});
        continue;
      }
      for (std::size_t row = lane; row < size; row += block_lanes) now[row] = committed[row], now_eps[row] = 0;
    }
  }
  HWY_INLINE void keep(const CompliantCoefficients& c, double* committed) const {
    for (std::size_t at = 0; at < c.layers.size() * block_lanes; at += block_lanes) {
      hn::Store(hn::Load(tag, now.data() + at), tag, committed + at);
    }
  }
};

/// dS as either side has it.
HWY_INLINE Sides step_of(const PlanarLayer& p) {
  return {set(2 * p.half_step), set(-2 * p.half_step)};
}

/// What moves a solved cell, per unit of something: the curvature that the angle sees, strains, the mean gradient of a
/// layer (in space), and through `Derivatives::edge` the forces at the cell's edge.
struct Feed {
  static constexpr std::size_t no_layer = ~std::size_t{0};
  Sides e;
  double eps = 0;
  double twist = 0;
  std::size_t mean_of = no_layer;
};

/// Derivatives by one thing along the march.
struct Derivatives {
  PerLayer edge;    // of the bending force at the cell's edge
  PerLayer direct;  // of the tractions while no wire slips
  PerLayer rhs, slip;
  PerLayer q;  // of the gradients
};

/// What the feed changes in a solved cell while no wire slips.
HWY_INLINE void hold_slips(const CompliantCoefficients& c, const Feed& feed, const double* K_eps, const Wires& w,
                           Derivatives& by) {
  Sides handed = both(0);
  Sides outside = both(0);
  for (std::size_t i = 0; i < c.layers.size(); ++i) {
    const PlanarLayer& p = c.planar.layers[i];
    const Layer& layer = c.layers[i];
    const Sides demand = mul(both(p.k), feed.e);
    const double straight = p.force_per_strain * feed.eps + p.force_per_twist * feed.twist;
    Sides load = mul_add(both(p.kappa), by.edge[i], both(p.kappa * straight));
    load = mul_add(own_load(layer), demand, add(load, handed));
    if (i == feed.mean_of) load = sub(load, own_load(layer));
    Sides direct = mul(w.follow[i], load);
    if (feed.eps != 0) {
      const Sides stiffer = mul(both(hn::Load(tag, K_eps + i * block_lanes)), w.holding[i]);
      direct = mul_add(stiffer, w.across[i], direct);
    }
    by.direct.set(i, direct);
    by.rhs.set(i, sub(demand, mul_add(both(layer.traction_of_outer), outside, direct)));
    outside = direct;
    if (i + 1 < c.layers.size()) handed = mul(w.handed[i], load);
  }
}

/// And what the slips add: `by.q`. The gradients change as the tractions do: where nothing holds and limits are zero,
/// that is exactly zero.
HWY_INLINE void let_slip(const CompliantCoefficients& c, const Wires& w, Derivatives& by) {
  const std::size_t layers = c.layers.size();
  substitute(c, w, by.rhs, by.slip);
  Sides handed = both(0);
  Sides outside = both(0);
  for (std::size_t i = 0; i < layers; ++i) {
    const Layer& layer = c.layers[i];
    const Sides slip = by.slip[i];
    const Sides inside = i + 1 < layers ? by.slip[i + 1] : both(0);
    const Sides across = mul_add(both(layer.slip_of_inner), inside, slip);
    const Sides load = neg_mul_add(mul(own_load(layer), both(layer.k_w)), slip, handed);
    const Sides traction = mul_add(w.elastic[i], across, mul_add(w.follow[i], load, by.direct[i]));
    by.q.set(i, mul_add(both(layer.traction_of_outer), outside, traction));
    outside = traction;
    if (i + 1 < layers) handed = mul(w.handed[i], load);
  }
}

/// Commits a solved cell: its springs, of which `springs` is where they are written; stiffness of the interfaces before
/// and after. A point of the cell counts `share` of the layers' weights.
HWY_INLINE void settle(const CompliantCoefficients& c, const Cell& cell, const Wires& w, double* springs,
                       const double* K_before, double share, SlipEnergy& sums) {
  const std::size_t rows = rows_of_interface(c) * block_lanes;
  double* f = springs;
  double* f_other = f + c.layers.size() * rows;
  for (std::size_t i = 0; i < c.layers.size(); ++i, f += rows, f_other += rows) {
    const PlanarLayer& p = c.planar.layers[i];
    const Rigidity K(hn::Load(tag, K_before + i * block_lanes), hn::Load(tag, cell.stiffness + i * block_lanes));
    const V weight = set(share * p.weight * c.layers[i].k_w / p.k);
    const Sides total = w.traction[i];
    const Sides slip = w.slip[i];
    hn::Store(total.t, tag, f + traction * block_lanes);
    hn::Store(total.c, tag, f_other + traction * block_lanes);
    hn::Store(slip.t, tag, f + last_slip * block_lanes);
    hn::Store(slip.c, tag, f_other + last_slip * block_lanes);
    settle_springs(c.layers[i].chains[cell.angle], f, c.layers.size() * rows, cell.windows, K, w.across[i], w.limit[i],
                   weight, sums);
    const Sides q = w.q[i];
    sums.store(set(share * p.weight / p.k / 2), q.t);
    sums.store(set(share * p.weight / p.k / 2), q.c);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::compliant_kernel
HWY_AFTER_NAMESPACE();
#endif
