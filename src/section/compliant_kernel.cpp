// Highway reads this file once per instruction set; the best that the machine has is chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "compliant_kernel.cpp"
#include "compliant_kernel.hpp"

#include <hwy/foreach_target.h>

#include "compliant_cell-inl.hpp"
#include "dual-inl.hpp"
#include "slip_energy-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::compliant_kernel {
namespace HWY_NAMESPACE {
using PlanarLayer = PlanarCoefficients::Layer;

/// What the march knows of the whole point.
struct Point {
  V eps, chi_step;        // chi_step since the last commit
  const double* springs;  // committed
  const double* K;        // [interface] rows of lanes
  const double* K_eps;    // their derivatives by the strain
};

/// Stiffness of the interfaces of a register of points under its strain. It is remembered, and found anew only where
/// the strain is larger than ever.
struct ContactRows {
  explicit ContactRows(const CompliantCoefficients& c)
      : size(c.layers.size() * block_lanes), now(size), now_eps(size) {}

  std::size_t size;
  AlignedVector now, now_eps;

  void fill(const CompliantCoefficients& c, const double* block, const double* eps) {
    const double* peak = block + peak_strain * block_lanes;
    const double* committed = block + stiffness * block_lanes;
    for (std::size_t lane = 0; lane < hn::Lanes(tag); ++lane) {
      if (eps[lane] > peak[lane]) {
        contact_stiffness(c, eps[lane], {.value = now.data() + lane, .slope = now_eps.data() + lane});
        continue;
      }
      for (std::size_t row = lane; row < size; row += block_lanes) now[row] = committed[row], now_eps[row] = 0;
    }
  }

  Point seen_by(const CompliantCoefficients& c, V eps, V chi_step, const double* block) const {
    return {.eps = eps,
            .chi_step = chi_step,
            .springs = block + first_cell(c) * block_lanes,
            .K = now.data(),
            .K_eps = now_eps.data()};
  }
};

/// Derivatives by one strain along the march.
struct Derivatives {
  explicit Derivatives(std::size_t layers) : edge(layers), direct(layers), rhs(layers), slip(layers) {}
  PerLayer edge;    // of the bending force at the cell's edge
  PerLayer direct;  // of the tractions while no wire slips
  PerLayer rhs, slip;
};

/// What a march works in; made once per call.
struct Bench {
  explicit Bench(const CompliantCoefficients& c)
      : wires(c.layers.size()), edge(c.layers.size()), by_chi(c.layers.size()), by_eps(c.layers.size()), contacts(c) {}
  Wires wires;
  PerLayer edge;  // [N] bending force of every layer's wires at the cell's edge
  Derivatives by_chi, by_eps;
  ContactRows contacts;

  HWY_INLINE void at_neutral_plane(std::size_t layers) {
    for (std::size_t i = 0; i < layers; ++i) {
      for (PerLayer* row : {&edge, &by_chi.edge, &by_eps.edge}) row->set(i, both(0));
    }
  }
};

/// dS as either side has it.
HWY_INLINE Sides step_of(const PlanarLayer& p) {
  return {set(2 * p.half_step), set(-2 * p.half_step)};
}

/// kappa F_at + c_int R_res + kappa F_edge of every layer.
HWY_INLINE void load_of(const CompliantCoefficients& c, V eps, Bench& bench) {
  for (std::size_t i = 0; i < c.layers.size(); ++i) {
    const PlanarLayer& p = c.planar.layers[i];
    const V alone = hn::MulAdd(set(p.kappa * p.force_per_strain), eps, set(p.inner_residual));
    bench.wires.load.set(i, mul_add(both(p.kappa), bench.edge[i], both(alone)));
  }
}

/// What a strain changes in a solved cell while no wire slips; `e` is the derivative of what the angle sees of the
/// curvature, `eps` that of the axial strain.
HWY_INLINE void hold_slips(const CompliantCoefficients& c, double e, double eps, const double* K_eps, const Wires& w,
                           Derivatives& by) {
  Sides handed = both(0);
  Sides outside = both(0);
  for (std::size_t i = 0; i < c.layers.size(); ++i) {
    const PlanarLayer& p = c.planar.layers[i];
    const Layer& layer = c.layers[i];
    const Sides demand = both(p.k * e);
    Sides load = mul_add(both(p.kappa), by.edge[i], both(p.kappa * p.force_per_strain * eps));
    load = mul_add(own_load(layer), demand, add(load, handed));
    Sides direct = mul(w.follow[i], load);
    if (eps != 0) {
      const Sides stiffer = mul(both(hn::Load(tag, K_eps + i * block_lanes)), w.holding[i]);
      direct = mul_add(stiffer, w.across[i], direct);
    }
    by.direct.set(i, direct);
    by.rhs.set(i, sub(demand, mul_add(both(layer.traction_of_outer), outside, direct)));
    outside = direct;
    if (i + 1 < c.layers.size()) handed = mul(w.handed[i], load);
  }
}

/// And what the slips add. Moves the edge on; answers the derivative of the moment. The gradients change as the
/// tractions do: where nothing holds and limits are zero, that is exactly zero.
HWY_INLINE V let_slip(const CompliantCoefficients& c, double cosine, const Wires& w, Derivatives& by) {
  const std::size_t layers = c.layers.size();
  Sides moment = both(0);
  Sides handed = both(0);
  Sides outside = both(0);
  for (std::size_t i = 0; i < layers; ++i) {
    const PlanarLayer& p = c.planar.layers[i];
    const Layer& layer = c.layers[i];
    const Sides slip = by.slip[i];
    const Sides inside = i + 1 < layers ? by.slip[i + 1] : both(0);
    const Sides across = mul_add(both(layer.slip_of_inner), inside, slip);
    const Sides load = neg_mul_add(mul(own_load(layer), both(layer.k_w)), slip, handed);
    const Sides traction = mul_add(w.elastic[i], across, mul_add(w.follow[i], load, by.direct[i]));
    const Sides q = mul_add(both(layer.traction_of_outer), outside, traction);
    moment = mul_add(both(p.weight * cosine), q, moment);
    by.edge.set(i, mul_add(step_of(p), q, by.edge[i]));
    outside = traction;
    if (i + 1 < layers) handed = mul(w.handed[i], load);
  }
  return hn::Add(moment.t, moment.c);
}

/// The whole march of one register of points. `on_cell(cell, wires)` sees every cell.
template <bool kTangent, class OnCell>
HWY_INLINE Dual<kTangent> march(const CompliantCoefficients& c, const Point& at, Bench& bench, const OnCell& on_cell) {
  auto moment = zero<kTangent>();
  const std::size_t layers = c.layers.size();
  if (layers == 0) return moment;
  bench.at_neutral_plane(layers);
  Wires& w = bench.wires;
  const double* springs = at.springs;
  for (std::size_t angle = 0; angle < c.planar.cosine.size(); ++angle) {
    const double cosine = c.planar.cosine[angle];
    const Cell cell{.angle = angle, .springs = springs, .stiffness = at.K, .e_step = hn::Mul(set(cosine), at.chi_step)};
    load_of(c, at.eps, bench);
    solve(c, cell, w);
    if constexpr (kTangent) {
      hold_slips(c, cosine, 0, at.K_eps, w, bench.by_chi);
      hold_slips(c, 0, 1, at.K_eps, w, bench.by_eps);
      eliminate<2>(c, w, {&bench.by_chi.rhs, &bench.by_eps.rhs}, {&bench.by_chi.slip, &bench.by_eps.slip});
      moment.chi = hn::Add(moment.chi, let_slip(c, cosine, w, bench.by_chi));
      moment.eps = hn::Add(moment.eps, let_slip(c, cosine, w, bench.by_eps));
    }
    for (std::size_t i = 0; i < layers; ++i) {
      const PlanarLayer& p = c.planar.layers[i];
      const Sides q = w.q[i];
      moment.value = hn::MulAdd(set(p.weight * cosine), hn::Add(q.t, q.c), moment.value);
      bench.edge.set(i, mul_add(step_of(p), q, bench.edge[i]));
    }
    on_cell(cell, w);
    springs += 2 * rows_of_cell(c) * block_lanes;
  }
  return moment;
}

template <bool kTangent>
void respond_all(const CompliantCoefficients& c, const double* history, const Strains& strains, const Response& out) {
  Bench bench(c);
  for (const Register here : Registers{strains.points}) {
    const Rows row{here.rows(history, rows_of_block(c))};
    const V eps = here.load(strains.eps);
    const V chi = here.load(strains.chi);
    bench.contacts.fill(c, row.at, strains.eps + here.first);
    const Point at = bench.contacts.seen_by(c, eps, hn::Sub(chi, row[committed_chi]), row.at);
    answer(c.planar, out, here, eps, chi, march<kTangent>(c, at, bench, [](const Cell&, const Wires&) {}));
  }
}

/// Stiffness of an interface after the step, and its inverses.
struct Rigidity {
  HWY_INLINE Rigidity(V before, V after) : K(after), per_K(inverse(after)) {
    widening = hn::Mul(set(0.5), hn::Max(hn::Zero(tag), hn::Sub(inverse(before), per_K)));
  }
  static HWY_INLINE V inverse(V x) {
    const Mask some = hn::Gt(x, hn::Zero(tag));
    return hn::IfThenElseZero(some, hn::Div(set(1), hn::IfThenElse(some, x, set(1))));
  }
  V K, per_K;
  V widening;  // what a spring's square of force loses as K grows
};

/// Moves the springs of one interface to their new forces; adds their energies, in units of `weight`.
HWY_INLINE void settle(const SpringChain& chain, double* f, const Rigidity& K, V across, V limit, V weight,
                       SlipEnergy& sums) {
  const V K_slip = hn::Mul(K.K, across);
  const V half_per_K = hn::Mul(set(0.5), K.per_K);
  for (std::size_t i = 0; i < chain.limit.size(); ++i, f += block_lanes) {
    const V before = hn::Load(tag, f);
    const V trial = hn::MulAdd(set(chain.stiffness[i]), K_slip, before);
    const V most = hn::Mul(set(chain.limit[i]), limit);
    const V now = clip(trial, most);
    const V part = hn::Mul(weight, set(1 / chain.stiffness[i]));
    Slide slide = slide_of(before, trial, now, K.per_K);
    const V by_widening = hn::Mul(K.widening, hn::Mul(before, before));
    slide.loss = hn::Add(slide.loss, by_widening);
    slide.trapezoid = hn::Add(slide.trapezoid, by_widening);
    sums.lose(part, slide);
    sums.stored = hn::MulAdd(part, hn::Mul(half_per_K, hn::Mul(now, now)), sums.stored);
    hn::Store(now, tag, f);
  }
}

void commit_here(const CompliantCoefficients& c, double* history, const Strains& strains, const Energies& out) {
  Bench bench(c);
  for (const Register here : Registers{strains.points}) {
    double* row = here.rows(history, rows_of_block(c));
    double* peak = row + peak_strain * block_lanes;
    double* K_before = row + stiffness * block_lanes;
    const V eps = here.load(strains.eps);
    const V chi = here.load(strains.chi);
    bench.contacts.fill(c, row, strains.eps + here.first);
    const Point at = bench.contacts.seen_by(c, eps, hn::Sub(chi, Rows{row}[committed_chi]), row);

    SlipEnergy sums = SlipEnergy::zero();
    const auto settle_cell = [&](const Cell& cell, const Wires& w) HWY_ATTR {
      const std::size_t rows = (c.springs + 1) * block_lanes;
      double* f = row + (cell.springs - row);
      double* f_other = f + c.layers.size() * rows;
      for (std::size_t i = 0; i < c.layers.size(); ++i, f += rows, f_other += rows) {
        const PlanarLayer& p = c.planar.layers[i];
        const SpringChain& chain = c.layers[i].chains[cell.angle];
        const Rigidity K(hn::Load(tag, K_before + i * block_lanes), hn::Load(tag, at.K + i * block_lanes));
        const V weight = set(p.weight * c.layers[i].k_w / p.k);
        const Sides traction = w.traction[i];
        const Sides across = w.across[i];
        const Sides limit = w.limit[i];
        hn::Store(traction.t, tag, f);
        hn::Store(traction.c, tag, f_other);
        settle(chain, f + block_lanes, K, across.t, limit.t, weight, sums);
        settle(chain, f_other + block_lanes, K, across.c, limit.c, weight, sums);
        const Sides q = w.q[i];
        sums.store(set(p.weight / p.k / 2), q.t);
        sums.store(set(p.weight / p.k / 2), q.c);
      }
    };
    march<false>(c, at, bench, settle_cell);

    for (std::size_t i = 0; i < c.layers.size(); ++i) {
      hn::Store(hn::Load(tag, at.K + i * block_lanes), tag, K_before + i * block_lanes);
    }
    hn::Store(chi, tag, row + committed_chi * block_lanes);
    hn::Store(hn::Max(eps, hn::Load(tag, peak)), tag, peak);
    book(out, here, twice_linear_energy(c.planar, eps, chi), sums.stored, sums.dissipated,
         hn::Max(hn::Zero(tag), sums.quadrature_error()));
  }
}

void respond_here(const CompliantCoefficients& c, const double* history, const Strains& strains, const Response& out) {
  out.dM_dchi ? respond_all<true>(c, history, strains, out) : respond_all<false>(c, history, strains, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::compliant_kernel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace strandyn::section::compliant_kernel {

HWY_EXPORT(respond_here);
HWY_EXPORT(commit_here);

void respond(const CompliantCoefficients& c, const double* history, const Strains& strains, const Response& out) {
  HWY_DYNAMIC_DISPATCH(respond_here)(c, history, strains, out);
}

void commit(const CompliantCoefficients& c, double* history, const Strains& strains, const Energies& out) {
  HWY_DYNAMIC_DISPATCH(commit_here)(c, history, strains, out);
}

}  // namespace strandyn::section::compliant_kernel
#endif
