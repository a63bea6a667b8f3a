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

/// Stiffness of the interfaces of a register of points, before the step and under its strain.
struct ContactRows {
  explicit ContactRows(const CompliantCoefficients& c)
      : size(c.layers.size() * block_lanes), before(size), now(size), now_eps(size) {}

  std::size_t size;
  AlignedVector before, now, now_eps;

  void fill(const CompliantCoefficients& c, const double* peak, const double* eps) {
    for (std::size_t lane = 0; lane < hn::Lanes(tag); ++lane) {
      contact_stiffness(c, peak[lane], {.value = before.data() + lane});
      const bool wider = eps[lane] > peak[lane];
      contact_stiffness(c, wider ? eps[lane] : peak[lane],
                        {.value = now.data() + lane, .slope = now_eps.data() + lane});
      if (wider) continue;
      for (std::size_t row = lane; row < size; row += block_lanes) now_eps[row] = 0;
    }
  }

  Point seen_by(V eps, V chi_step, const double* block) const {
    return {.eps = eps,
            .chi_step = chi_step,
            .springs = block + scalar_rows * block_lanes,
            .K = now.data(),
            .K_eps = now_eps.data()};
  }
};

/// The march along one side of the neutral plane: bending force of every layer's wires at the cell's edge, what came of
/// the cell before, and the derivatives of both.
struct Side {
  explicit Side(std::size_t layers, double of_tension)
      : sign(of_tension),
        wires(layers),
        edge(layers),
        edge_chi(layers),
        edge_eps(layers),
        direct(layers),
        rhs(layers),
        slip(layers) {}

  double sign;
  Wires wires;
  PerLayer edge, edge_chi, edge_eps;
  PerLayer direct, rhs, slip;  // of the derivatives
};

/// kappa F_at + c_int R_res + kappa F_edge of every layer.
HWY_INLINE void load_of(const CompliantCoefficients& c, V eps, Side& side) {
  for (std::size_t i = 0; i < c.layers.size(); ++i) {
    const PlanarLayer& p = c.planar.layers[i];
    const V alone = hn::MulAdd(set(p.kappa * p.force_per_strain), eps, set(p.inner_residual));
    side.wires.load.set(i, hn::MulAdd(set(p.kappa), side.edge[i], alone));
  }
}

/// Derivatives of a solved cell's gradients by one strain, implicit in the slips; moves `edge` on and adds to the
/// moment. `e` is the derivative of what the angle sees of the curvature, `eps` that of the axial strain.
HWY_INLINE V differentiate(const CompliantCoefficients& c, double e, double eps, double cosine, const double* K_eps,
                           Side& side, PerLayer& edge) {
  const V zero = hn::Zero(tag);
  const Wires& w = side.wires;
  const std::size_t layers = c.layers.size();
  V handed = zero;
  V outside = zero;
  for (std::size_t i = 0; i < layers; ++i) {
    const PlanarLayer& p = c.planar.layers[i];
    const Layer& layer = c.layers[i];
    const V demand = set(p.k * e);
    V load = hn::MulAdd(set(p.kappa), edge[i], set(p.kappa * p.force_per_strain * eps));
    load = hn::MulAdd(set(side.sign * layer.own_load), demand, hn::Add(load, handed));
    V direct = hn::Mul(w.follow[i], load);
    if (eps != 0) {
      const V stiffer = hn::Mul(hn::Load(tag, K_eps + i * block_lanes), w.holding[i]);
      direct = hn::MulAdd(stiffer, w.across[i], direct);
    }
    side.direct.set(i, direct);
    side.rhs.set(i, hn::Sub(demand, hn::MulAdd(set(layer.traction_of_outer), outside, direct)));
    outside = direct;
    if (i + 1 < layers) handed = hn::Mul(w.handed[i], load);
  }
  eliminate(c, side.sign, side.wires, side.rhs, side.slip);
  // The gradients change as the tractions do: where nothing holds and limits are zero, that is exactly zero.
  V moment = zero;
  handed = zero;
  outside = zero;
  for (std::size_t i = 0; i < layers; ++i) {
    const PlanarLayer& p = c.planar.layers[i];
    const Layer& layer = c.layers[i];
    const V inside = i + 1 < layers ? side.slip[i + 1] : zero;
    const V across = hn::MulAdd(set(layer.slip_of_inner), inside, side.slip[i]);
    const V load = hn::NegMulAdd(set(side.sign * layer.own_load * layer.k_w), side.slip[i], handed);
    const V traction = hn::MulAdd(w.elastic[i], across, hn::MulAdd(w.follow[i], load, side.direct[i]));
    const V q = hn::MulAdd(set(layer.traction_of_outer), outside, traction);
    moment = hn::MulAdd(set(p.weight * cosine), q, moment);
    edge.set(i, hn::MulAdd(set(2 * side.sign * p.half_step), q, edge[i]));
    outside = traction;
    if (i + 1 < layers) handed = hn::Mul(w.handed[i], load);
  }
  return moment;
}

/// Solves one cell and goes on to the next.
template <bool kTangent, class OnCell>
HWY_INLINE void advance(const CompliantCoefficients& c, const Point& at, const Cell& cell, Side& side,
                        Dual<kTangent>& moment, const OnCell& on_cell) {
  const double cosine = c.planar.cosine[cell.angle];
  load_of(c, at.eps, side);
  solve(c, cell, side.wires);
  if constexpr (kTangent) {
    moment.chi = hn::Add(moment.chi, differentiate(c, cosine, 0, cosine, at.K_eps, side, side.edge_chi));
    moment.eps = hn::Add(moment.eps, differentiate(c, 0, 1, cosine, at.K_eps, side, side.edge_eps));
  }
  for (std::size_t i = 0; i < c.layers.size(); ++i) {
    const PlanarLayer& p = c.planar.layers[i];
    const V q = side.wires.q[i];
    moment.value = hn::MulAdd(set(p.weight * cosine), q, moment.value);
    side.edge.set(i, hn::MulAdd(set(2 * side.sign * p.half_step), q, side.edge[i]));
  }
  on_cell(cell, side.wires);
}

/// What a march needs to work in; made once per call.
struct Bench {
  explicit Bench(const CompliantCoefficients& c)
      : tension(c.layers.size(), 1), compression(c.layers.size(), -1), contacts(c) {}
  Side tension, compression;
  ContactRows contacts;
};

/// The whole march of one register of points. `on_cell(cell, wires)` sees every cell.
template <bool kTangent, class OnCell>
HWY_INLINE Dual<kTangent> march(const CompliantCoefficients& c, const Point& at, Bench& bench, const OnCell& on_cell) {
  auto moment = zero<kTangent>();
  if (c.layers.empty()) return moment;
  for (Side* side : {&bench.tension, &bench.compression}) {
    for (std::size_t i = 0; i < c.layers.size(); ++i) {
      for (PerLayer* edge : {&side->edge, &side->edge_chi, &side->edge_eps}) edge->set(i, hn::Zero(tag));
    }
  }
  const double* springs = at.springs;
  const std::size_t size = rows_of_cell(c) * block_lanes;
  for (std::size_t angle = 0; angle < c.planar.cosine.size(); ++angle) {
    for (Side* side : {&bench.tension, &bench.compression}) {
      const Cell cell{.angle = angle,
                      .side = side->sign,
                      .springs = springs,
                      .stiffness = at.K,
                      .e_step = hn::Mul(set(c.planar.cosine[angle]), at.chi_step)};
      advance<kTangent>(c, at, cell, *side, moment, on_cell);
      springs += size;
    }
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
    bench.contacts.fill(c, row.at + peak_strain * block_lanes, strains.eps + here.first);
    const Point at = bench.contacts.seen_by(eps, hn::Sub(chi, row[committed_chi]), row.at);
    answer(c.planar, out, here, eps, chi, march<kTangent>(c, at, bench, [](const Cell&, const Wires&) {}));
  }
}

/// Moves the springs of one interface to their new forces; adds their energies, in units of `weight`.
HWY_INLINE void settle(const SpringChain& chain, double* f, V K_before, V K, V across, V limit, V weight,
                       SlipEnergy& sums) {
  const V zero = hn::Zero(tag);
  const V half = set(0.5);
  const auto inverse = [zero](V x) HWY_ATTR {
    const Mask some = hn::Gt(x, zero);
    return hn::IfThenElseZero(some, hn::Div(set(1), hn::IfThenElse(some, x, set(1))));
  };
  const V per_K = inverse(K);
  const V widening = hn::Max(zero, hn::Sub(inverse(K_before), per_K));
  const V K_slip = hn::Mul(K, across);
  for (std::size_t i = 0; i < chain.limit.size(); ++i, f += block_lanes) {
    const V before = hn::Load(tag, f);
    const V trial = hn::MulAdd(set(chain.stiffness[i]), K_slip, before);
    const V most = hn::Mul(set(chain.limit[i]), limit);
    const V now = clip(trial, most);
    const V part = hn::Mul(weight, set(1 / chain.stiffness[i]));
    Slide slide = slide_of(before, trial, now, per_K);
    const V by_widening = hn::Mul(hn::Mul(half, widening), hn::Mul(before, before));
    slide.loss = hn::Add(slide.loss, by_widening);
    slide.trapezoid = hn::Add(slide.trapezoid, by_widening);
    sums.lose(part, slide);
    sums.stored = hn::MulAdd(part, hn::Mul(hn::Mul(half, per_K), hn::Mul(now, now)), sums.stored);
    hn::Store(now, tag, f);
  }
}

void commit_here(const CompliantCoefficients& c, double* history, const Strains& strains, const Energies& out) {
  Bench bench(c);
  for (const Register here : Registers{strains.points}) {
    double* row = here.rows(history, rows_of_block(c));
    double* peak = row + peak_strain * block_lanes;
    const V eps = here.load(strains.eps);
    const V chi = here.load(strains.chi);
    bench.contacts.fill(c, peak, strains.eps + here.first);
    const Point at = bench.contacts.seen_by(eps, hn::Sub(chi, Rows{row}[committed_chi]), row);

    SlipEnergy sums = SlipEnergy::zero();
    const auto settle_cell = [&](const Cell& cell, const Wires& w) HWY_ATTR {
      double* f = row + (cell.springs - row);
      for (std::size_t i = 0; i < c.layers.size(); ++i, f += (c.springs + 1) * block_lanes) {
        const PlanarLayer& p = c.planar.layers[i];
        const std::size_t K = i * block_lanes;
        hn::Store(w.traction[i], tag, f);
        settle(c.layers[i].chains[cell.angle], f + block_lanes, hn::Load(tag, bench.contacts.before.data() + K),
               hn::Load(tag, at.K + K), w.across[i], w.limit[i], set(p.weight * c.layers[i].k_w / p.k), sums);
        sums.store(set(p.weight / p.k / 2), w.q[i]);
      }
    };
    march<false>(c, at, bench, settle_cell);

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
