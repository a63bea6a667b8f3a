// Highway reads this file once per instruction set; the best that the machine has is chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "compliant_kernel.cpp"
#include "compliant_kernel.hpp"

#include <hwy/foreach_target.h>

#include "contact_cascade-inl.hpp"
#include "slip_energy-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::compliant_kernel {
namespace HWY_NAMESPACE {
using namespace kernel::HWY_NAMESPACE;

using PlanarLayer = PlanarCoefficients::Layer;
using Layer = CompliantCoefficients::Layer;
using conductor::SpringChain;

/// Newton's method ends after a handful of rounds; this many halvings would do without it.
constexpr int most_rounds = 200;
/// The residual of a cell is a sum of some tens of forces: what rounding leaves of it, over the sum of their sizes.
constexpr double rounding_of_a_cell = 2e-15;
/// A spring that stands at its limit counts as stuck, whatever the last digits say.
constexpr double still_stuck = 1 + 1e-13;

/// What the march knows of the whole point.
struct Point {
  V chi_step;       // since the last commit
  const double* K;  // [contact] rows of lanes; inner and outer of each layer in turn
  const double* K_eps;
};

/// What does not change from cell to cell of a layer.
template <bool kTangent>
struct Loads {
  Dual<kTangent> inner;    // kappa F_at + c_ext f_ext + c_int R_res
  Dual<kTangent> outside;  // limit of the outer contact
};

/// A cell under trial slip: the traction of its springs and how it changes.
struct Traction {
  V sum;             // of the springs' forces
  V elastic;         // [N/m^2] stiffness of the springs that hold
  V elastic_eps;     // its derivative by the strain, through the contacts' stiffness
  V sliding_inside;  // part of the inner limit that the sliding springs carry, signed
  V sliding_outside;
};

HWY_INLINE void add_springs(const SpringChain& chain, const double* f, V K, V K_eps, V slip, V limit, Traction& t,
                            V& sliding) {
  const V zero = hn::Zero(tag);
  const V reach = hn::Mul(limit, set(still_stuck));
  const V K_slip = hn::Mul(K, slip);
  V kappa_elastic = zero;
  for (std::size_t i = 0; i < chain.limit.size(); ++i, f += block_lanes) {
    const V kappa = set(chain.stiffness[i]);
    const V phi = set(chain.limit[i]);
    const V trial = hn::MulAdd(kappa, K_slip, hn::Load(tag, f));
    const V most = hn::Mul(phi, limit);
    t.sum = hn::Add(t.sum, clip(trial, most));
    // A limit of zero holds nothing, not even a trial of zero.
    const Mask holds = hn::Lt(hn::Abs(trial), hn::Mul(phi, reach));
    kappa_elastic = hn::Add(kappa_elastic, hn::IfThenElseZero(holds, kappa));
    sliding = hn::Add(sliding, hn::IfThenZeroElse(holds, hn::CopySign(phi, trial)));
  }
  t.elastic = hn::MulAdd(K, kappa_elastic, t.elastic);
  t.elastic_eps = hn::MulAdd(K_eps, kappa_elastic, t.elastic_eps);
}

/// One cell on one side of the neutral plane.
struct Cell {
  const PlanarLayer& planar;
  const Layer& layer;
  std::size_t angle;
  std::size_t contact;  // of the point's rows K: the inner one
  const double* f;      // committed forces of the springs, inner then outer

  double cosine_stick(const PlanarCoefficients& c) const { return planar.k * c.cosine[angle]; }
};

/// The solved cell.
struct Solution {
  V q, slip;       // [N/m], [m] since the last commit
  V limit_inside;  // [N/m]
  Mask closed;     // the inner contact presses
  Traction traction;
};

HWY_INLINE Traction traction_of(const Cell& cell, const Point& at, V slip, V limit_inside, V limit_outside,
                                std::size_t springs) {
  const V zero = hn::Zero(tag);
  Traction t{zero, zero, zero, zero, zero};
  const double* K = at.K + cell.contact * block_lanes;
  const double* K_eps = at.K_eps + cell.contact * block_lanes;
  add_springs(cell.layer.inner.chains[cell.angle], cell.f, hn::Load(tag, K), hn::Load(tag, K_eps), slip, limit_inside,
              t, t.sliding_inside);
  if (cell.layer.contacts > 1) {
    add_springs(cell.layer.outer.chains[cell.angle], cell.f + springs * block_lanes, hn::Load(tag, K + block_lanes),
                hn::Load(tag, K_eps + block_lanes), slip, limit_outside, t, t.sliding_outside);
  }
  return t;
}

/// k e = q + k_w u for the slip of the step. `mu_inner` is the inner limit without the cell's own part.
template <bool kTension>
HWY_INLINE Solution solve(const PlanarCoefficients& c, std::size_t springs, const Cell& cell, const Point& at,
                          V mu_inner, V limit_outside) {
  const V zero = hn::Zero(tag);
  const V k_w = set(cell.layer.k_w);
  const V feedback = set(kTension ? cell.layer.feedback : -cell.layer.feedback);
  V q_before = zero;
  for (std::size_t i = 0; i < springs * cell.layer.contacts; ++i) {
    q_before = hn::Add(q_before, hn::Load(tag, cell.f + i * block_lanes));
  }
  // Were all springs stuck, the slip would be this: never too far, and beyond the limits of those that slide on.
  const double* K = at.K + cell.contact * block_lanes;
  const V all_stuck = hn::Add(hn::Add(k_w, hn::Load(tag, K)), hn::Load(tag, K + block_lanes));
  const V stick_step = hn::Mul(set(cell.cosine_stick(c)), at.chi_step);
  const V driven = hn::Add(stick_step, q_before);

  Solution s;
  s.slip = hn::Div(stick_step, all_stuck);
  V low = set(-1e300);
  V high = set(1e300);
  for (int round = 0;; ++round) {
    const V q = hn::NegMulAdd(k_w, s.slip, driven);
    const V limit = hn::MulAdd(feedback, q, mu_inner);
    s.limit_inside = hn::Max(zero, limit);
    s.closed = hn::Gt(limit, zero);
    s.traction = traction_of(cell, at, s.slip, s.limit_inside, limit_outside, springs);
    s.q = s.traction.sum;
    const V residual = hn::Sub(s.q, q);
    const V size = hn::Add(hn::Add(s.limit_inside, limit_outside), hn::Add(hn::Abs(q), hn::Abs(driven)));
    const Mask done = hn::Le(hn::Abs(residual), hn::Mul(set(rounding_of_a_cell), size));
    if (round == most_rounds || hn::AllTrue(tag, done)) return s;

    const Mask short_of = hn::Lt(residual, zero);
    low = hn::IfThenElse(short_of, s.slip, low);
    high = hn::IfThenElse(short_of, high, s.slip);
    const V through_limit = hn::IfThenElseZero(s.closed, hn::Mul(s.traction.sliding_inside, feedback));
    const V slope = hn::MulAdd(k_w, hn::Sub(set(1), through_limit), s.traction.elastic);
    const V newton = hn::Sub(s.slip, hn::Div(residual, slope));
    const Mask inside = hn::And(hn::Gt(newton, low), hn::Lt(newton, high));
    const V next = hn::IfThenElse(inside, newton, hn::MulAdd(set(0.5), hn::Sub(high, low), low));
    // A solved lane waits unchanged for its neighbours.
    s.slip = hn::IfThenElse(done, s.slip, next);
  }
}

/// Derivatives of a solved cell's q: implicit in the slip.
template <bool kTension>
HWY_INLINE Dual<true> derivatives(const Solution& s, const Cell& cell, V stick, const Dual<true>& mu_inner,
                                  const Dual<true>& outside) {
  const V k_w = set(cell.layer.k_w);
  const V inside = hn::IfThenElseZero(s.closed, s.traction.sliding_inside);
  const V feedback = set(kTension ? cell.layer.feedback : -cell.layer.feedback);
  const V slope = hn::MulAdd(k_w, hn::NegMulAdd(inside, feedback, set(1)), s.traction.elastic);
  const V inverse = hn::Div(set(1), slope);
  const auto through_limits = [&](V d_inner, V d_outside) HWY_ATTR {
    return hn::Mul(k_w, hn::MulAdd(inside, d_inner, hn::Mul(s.traction.sliding_outside, d_outside)));
  };
  const V q_chi = hn::MulAdd(s.traction.elastic, stick, through_limits(mu_inner.chi, outside.chi));
  const V q_eps = hn::MulAdd(hn::Mul(k_w, s.slip), s.traction.elastic_eps, through_limits(mu_inner.eps, outside.eps));
  return {s.q, hn::Mul(q_chi, inverse), hn::Mul(q_eps, inverse)};
}

/// Solves one cell and goes on to the next.
template <bool kTension, bool kTangent>
HWY_INLINE Solution advance(const CompliantCoefficients& c, const Cell& cell, const Point& at,
                            const Loads<kTangent>& load, Quarter<kTangent>& quarter) {
  const auto mu_inner = sum(scaled(set(cell.planar.mu_int), load.inner), scaled(set(cell.planar.slope), quarter.edge));
  const Solution s = solve<kTension>(c.planar, c.springs, cell, at, mu_inner.value, load.outside.value);
  Dual<kTangent> q;
  if constexpr (kTangent) q = derivatives<kTension>(s, cell, set(cell.cosine_stick(c.planar)), mu_inner, load.outside);
  q.value = s.q;
  const V half = set(kTension ? cell.planar.half_step : -cell.planar.half_step);
  const Dual<kTangent> middle = sum(scaled(half, q), quarter.edge);
  quarter.edge = sum(scaled(half, q), middle);
  quarter.sum_of_force = sum(quarter.sum_of_force, middle);
  quarter.sum_of_moment = sum(quarter.sum_of_moment, scaled(set(c.planar.cosine[cell.angle]), q));
  return s;
}

/// The whole march of one register of points. `on_cell(cell, solution, at, limit_outside)` sees every cell.
template <bool kTangent, class OnCell>
HWY_INLINE Dual<kTangent> march(const CompliantCoefficients& c, const double* forces, V eps, const Point& at,
                                const OnCell& on_cell) {
  const std::size_t cells = c.planar.cosine.size();
  auto moment = zero<kTangent>();
  auto f_int = zero<kTangent>();
  for (std::size_t i = 0; i < c.layers.size(); ++i) {
    const Layer& layer = c.layers[i];
    const PlanarLayer& planar = c.planar.layers[i];
    const V own = set(planar.kappa * planar.force_per_strain);
    const auto outer = load_from_outside(planar, f_int);
    const auto alone = dual<kTangent>(hn::MulAdd(own, eps, set(planar.inner_residual)), hn::Zero(tag), own);
    const Loads<kTangent> load{.inner = sum(alone, outer), .outside = scaled(set(planar.mu_ext), outer)};
    auto tension = Quarter<kTangent>::at_rest();
    auto compression = Quarter<kTangent>::at_rest();
    const std::size_t size = layer.contacts * c.springs * block_lanes;
    for (std::size_t angle = 0; angle < cells; ++angle) {
      const Cell one{.planar = planar, .layer = layer, .angle = angle, .contact = 2 * i, .f = forces};
      on_cell(one, advance<true>(c, one, at, load, tension), load.outside.value);
      const Cell other{.planar = planar, .layer = layer, .angle = angle, .contact = 2 * i, .f = forces + size};
      on_cell(other, advance<false>(c, other, at, load, compression), load.outside.value);
      forces += 2 * size;
    }
    moment = sum(moment, scaled(set(planar.weight), sum(tension.sum_of_moment, compression.sum_of_moment)));
    const V mean = set(c.planar.mean_weight * planar.kappa);
    f_int = handed_inward(planar, sum(load.inner, scaled(mean, sum(tension.sum_of_force, compression.sum_of_force))));
  }
  return moment;
}

/// Stiffness of the contacts of a register of points, before the step and under its strain.
struct ContactRows {
  explicit ContactRows(const CompliantCoefficients& c)
      : size(2 * c.layers.size() * block_lanes), before(size), now(size), now_eps(size) {}

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

  Point seen_by(V chi_step) const { return {.chi_step = chi_step, .K = now.data(), .K_eps = now_eps.data()}; }
};

template <bool kTangent>
void respond_all(const CompliantCoefficients& c, const double* history, const Strains& strains, const Response& out) {
  ContactRows contacts(c);
  for (const Register at : Registers{strains.points}) {
    const Rows row{at.rows(history, rows_of_block(c))};
    const V eps = at.load(strains.eps);
    const V chi = at.load(strains.chi);
    contacts.fill(c, row.at + peak_strain * block_lanes, strains.eps + at.first);
    const V chi_step = hn::Sub(chi, row[committed_chi]);
    answer(c.planar, out, at, eps, chi,
           march<kTangent>(c, row.at + scalar_rows * block_lanes, eps, contacts.seen_by(chi_step),
                           [](const Cell&, const Solution&, V) {}));
  }
}

/// Moves the springs of one contact to their new forces; adds their energies, per k_w/k and in units of the weight.
HWY_INLINE void settle(const SpringChain& chain, double* f, V K_before, V K, const Solution& s, V limit, V weight,
                       SlipEnergy& sums) {
  const V zero = hn::Zero(tag);
  const V half = set(0.5);
  const auto inverse = [zero](V x) HWY_ATTR {
    const Mask some = hn::Gt(x, zero);
    return hn::IfThenElseZero(some, hn::Div(set(1), hn::IfThenElse(some, x, set(1))));
  };
  const V per_K = inverse(K);
  const V widening = hn::Max(zero, hn::Sub(inverse(K_before), per_K));
  for (std::size_t i = 0; i < chain.limit.size(); ++i, f += block_lanes) {
    const V before = hn::Load(tag, f);
    const V trial = hn::MulAdd(set(chain.stiffness[i]), hn::Mul(K, s.slip), before);
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
  ContactRows contacts(c);
  for (const Register here : Registers{strains.points}) {
    double* row = here.rows(history, rows_of_block(c));
    double* forces = row + scalar_rows * block_lanes;
    double* peak = row + peak_strain * block_lanes;
    const V eps = here.load(strains.eps);
    const V chi = here.load(strains.chi);
    contacts.fill(c, peak, strains.eps + here.first);
    const V chi_step = hn::Sub(chi, Rows{row}[committed_chi]);

    SlipEnergy sums = SlipEnergy::zero();
    const auto settle_cell = [&](const Cell& cell, const Solution& s, V limit_outside) HWY_ATTR {
      const double per_k = 1 / cell.planar.k;
      const V weight = set(cell.planar.weight * cell.layer.k_w * per_k);
      double* f = forces + (cell.f - forces);
      for (std::size_t side = 0; side < cell.layer.contacts; ++side, f += c.springs * block_lanes) {
        const std::size_t at = (cell.contact + side) * block_lanes;
        const SpringChain& chain = (side == 0 ? cell.layer.inner : cell.layer.outer).chains[cell.angle];
        settle(chain, f, hn::Load(tag, contacts.before.data() + at), hn::Load(tag, contacts.now.data() + at), s,
               side == 0 ? s.limit_inside : limit_outside, weight, sums);
      }
      sums.store(set(cell.planar.weight * per_k / 2), s.q);
    };
    march<false>(c, forces, eps, contacts.seen_by(chi_step), settle_cell);

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
