// The wires of all layers at one angle, and the interfaces between them: solved together, for one register of section
// points, on both sides of the neutral plane at once: while one side waits for a division the other goes on. Included
// once per instruction set. Rows run from the outermost layer inward, i = 0, 1, ...:
//     k_i e = q_i + k_w,i u_i             u_i slip of a wire of layer i along its own demand
//     q_i   = T_i + a_i T_(i-1)           T_i traction of the interface inside layer i, per length of wire of layer i
//     T_i   = traction of its springs at the slip  w_i = u_i + c_i u_(i+1)
//     limit of T_i = mu_i max(0, f_i),    f_i = own load + kappa_i F_b,i + h_i max(0, f_(i-1))
// a_i, c_i, h_i: `traction_of_outer`, `slip_of_inner`, `load_of_outer` (src/section/README.md). F_b at the midpoint of
// the cell is F_edge + side q dS/2 with its own q.
#if defined(STRANDYN_SECTION_COMPLIANT_CELL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_SECTION_COMPLIANT_CELL_INL
#undef STRANDYN_SECTION_COMPLIANT_CELL_INL
#else
#define STRANDYN_SECTION_COMPLIANT_CELL_INL
#endif

#include "compliant_springs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::compliant_kernel {
namespace HWY_NAMESPACE {
using namespace kernel::HWY_NAMESPACE;

using Layer = CompliantCoefficients::Layer;

/// Newton's method ends after a handful of rounds.
constexpr int most_rounds = 100;
/// The residual of a wire is a sum of some tens of forces: what rounding leaves of it, over the sum of their sizes.
constexpr double rounding_of_a_wire = 4e-15;

/// A register per layer and side. They lie in place: a pointer to them would be read again after every store.
class PerLayer {
 public:
  HWY_INLINE Sides operator[](std::size_t layer) const {
    const double* at = rows_ + 2 * layer * width;
    return {hn::Load(tag, at), hn::Load(tag, at + width)};
  }
  HWY_INLINE void set(std::size_t layer, const Sides& value) {
    double* at = rows_ + 2 * layer * width;
    hn::Store(value.t, tag, at);
    hn::Store(value.c, tag, at + width);
  }

 private:
  static constexpr std::size_t width = hn::MaxLanes(tag);
  alignas(64) double rows_[2 * most_compliant_layers * width] = {};
};

/// One angle: where its springs lie, and what it is given.
struct Cell {
  std::size_t angle;        // of a quarter turn
  const double* springs;    // committed: tension side before compression, per interface its traction and its springs
  const double* stiffness;  // [interface] K, rows of lanes
  bool windows;             // of springs that need no look, as registers of this width have left them
  Sides e_step;             // [1/m] what the angle sees of the curvature's step
  Sides onward;             // [-] the step over the last committed one: `onward`
};

/// The unknowns of a cell and what belongs to them. `load` is given: the load of the inner contact without the cell's
/// own gradients.
struct Wires {
  PerLayer load;                             // [N/m]
  PerLayer demand;                           // [N/m] gradient were no wire to slip in this step
  PerLayer slip;                             // [m] u of the step
  PerLayer across;                           // [m] w of the step
  PerLayer limit, traction, q;               // [N/m]
  PerLayer residual;                         // [N/m] q + k_w u - demand
  PerLayer first_residual;                   // of the first guess
  PerLayer elastic;                          // dT/dw
  PerLayer holding;                          // [-] elastic over K
  PerLayer follow;                           // dT/df
  PerLayer handed;                           // df of the next layer inward by that of this one
  PerLayer step, base;                       // Newton's, and the slips from which it goes
  PerLayer inverse, by_inner, load_by_slip;  // of the elimination
};

/// kappa dS/2 as either side has it.
HWY_INLINE Sides own_load(const Layer& layer) {
  return {set(layer.own_load), set(-layer.own_load)};
}

/// Tractions and residuals at `slip`; true where they balance, within `rounding` of the largest that they can be.
/// A look that is no judgement (`kJudge`) finds only what a correction needs.
template <bool kJudge>
HWY_INLINE SideMasks balance(const CompliantCoefficients& c, const Cell& cell, const Sides& rounding, Wires& w,
                             PerLayer& residuals) {
  const Sides zero = both(0);
  const std::size_t layers = c.layers.size();
  const std::size_t rows = rows_of_interface(c) * block_lanes;
  SideMasks open{hn::Lt(zero.t, zero.t), hn::Lt(zero.t, zero.t)};
  Sides outside = zero;  // T of the layer outside, its limit, its load
  Sides limit_outside = zero;
  Sides load_outside = zero;
  Sides slip = w.slip[0];
  for (std::size_t i = 0; i < layers; ++i) {
    const Layer& layer = c.layers[i];
    const Sides inside = i + 1 < layers ? w.slip[i + 1] : zero;
    const Sides across = mul_add(both(layer.slip_of_inner), inside, slip);
    const Sides demand = w.demand[i];
    const Sides wanted = neg_mul_add(both(layer.k_w), slip, demand);
    Sides load = mul_add(both(layer.load_of_outer), load_outside, w.load[i]);
    load = mul_add(own_load(layer), wanted, load);
    const SideMasks closed = above(load, zero);
    load = larger(zero, load);
    const Sides mu = both(c.planar.layers[i].mu_int);
    const Sides limit = mul(mu, load);
    const Sides K = both(hn::Load(tag, cell.stiffness + i * block_lanes));
    const Traction t = traction_of(layer.chains[cell.angle], {cell.springs + i * rows, layers * rows}, cell.windows,
                                   mul(K, across), limit);
    const Sides q = mul_add(both(layer.traction_of_outer), outside, t.sum);
    const Sides residual = sub(q, wanted);
    residuals.set(i, residual);
    if constexpr (kJudge) {
      Sides size = mul_add(both(layer.load_of_outer), limit_outside, limit);
      size = add(size, add(absolute(wanted), absolute(demand)));
      open = one_of(open, above(absolute(residual), mul(rounding, size)));
      w.across.set(i, across);
      w.limit.set(i, limit);
      w.traction.set(i, t.sum);
      w.q.set(i, q);
      w.holding.set(i, t.holding);
    }
    w.elastic.set(i, mul(K, t.holding));
    w.follow.set(i, if_else_zero(closed, mul(mu, t.sliding)));
    if (i + 1 < layers) w.handed.set(i, if_else_zero(closed, both(c.layers[i + 1].load_of_outer)));
    outside = t.sum;
    limit_outside = limit;
    load_outside = load;
    slip = inside;
  }
  return {hn::Not(open.t), hn::Not(open.c)};
}

/// The linear system of a cell: slips `out` whose residuals change by `rhs`. Eliminated from the outermost layer
/// inward; what the layer outside does is a line in the slip of the layer at hand.
HWY_INLINE void eliminate(const CompliantCoefficients& c, Wires& w) {
  const std::size_t layers = c.layers.size();
  const Sides zero = both(0);
  Sides traction_by_slip = zero;  // of the interface outside
  Sides load_by_slip = zero;      // handed by it
  for (std::size_t i = 0; i < layers; ++i) {
    const Layer& layer = c.layers[i];
    const Sides elastic = w.elastic[i];
    const Sides follow = w.follow[i];
    const Sides k_w = both(layer.k_w);
    const Sides to_inner = both(layer.slip_of_inner);
    const Sides by_slip = neg_mul_add(own_load(layer), k_w, load_by_slip);
    const Sides own = mul_add(follow, by_slip, add(elastic, k_w));
    const Sides inverse = div(both(1), mul_add(both(layer.traction_of_outer), traction_by_slip, own));
    const Sides by_inner = mul(mul(elastic, to_inner), inverse);  // less, per slip of the next layer
    const Sides own_load_by_slip = neg(mul(by_slip, by_inner));
    w.inverse.set(i, inverse);
    w.by_inner.set(i, by_inner);
    w.load_by_slip.set(i, by_slip);
    traction_by_slip = mul_add(elastic, sub(to_inner, by_inner), mul(follow, own_load_by_slip));
    if (i + 1 < layers) load_by_slip = mul(w.handed[i], own_load_by_slip);
  }
}

HWY_INLINE void substitute(const CompliantCoefficients& c, const Wires& w, const PerLayer& rhs, PerLayer& out) {
  const std::size_t layers = c.layers.size();
  Sides traction = both(0);
  Sides load = both(0);
  for (std::size_t i = 0; i < layers; ++i) {
    const Sides follow = w.follow[i];
    const Sides a = both(c.layers[i].traction_of_outer);
    const Sides known = neg_mul_add(follow, load, neg_mul_add(a, traction, rhs[i]));
    const Sides slip = mul(known, w.inverse[i]);
    out.set(i, slip);
    if (i + 1 == layers) break;
    const Sides load_here = mul_add(w.load_by_slip[i], slip, load);
    traction = mul_add(w.elastic[i], slip, mul(follow, load_here));
    load = mul(w.handed[i], load_here);
  }
  Sides inner = out[layers - 1];
  for (std::size_t i = layers - 1; i-- > 0;) {
    inner = neg_mul_add(w.by_inner[i], inner, out[i]);
    out.set(i, inner);
  }
}

/// What residuals do on Newton's step: the slope of the springs' potential along it.
HWY_INLINE Sides slope_along_step(const CompliantCoefficients& c, const Wires& w, const PerLayer& residual) {
  Sides sum = both(0);
  for (std::size_t i = 0; i < c.layers.size(); ++i) {
    sum = mul_add(both(c.layers[i].wires_per_length), mul(w.step[i], residual[i]), sum);
  }
  return sum;
}

/// The search for the lowest point along a Newton step that passed it. The potential is convex: the lowest point lies
/// between two lengths of which one has a falling slope, the other a rising one.
struct LineSearch {
  Sides slope_start;  // where the step starts
  Sides length;       // [-] of the way along it
  Sides low, high, slope_low, slope_high;

  static HWY_INLINE LineSearch begin(const Sides& slope) {
    const Sides zero = both(0);
    return {slope, both(1), zero, zero, slope, zero};
  }
  /// Where the step must be tried again, with another length. Half of the slope at the start is near enough.
  HWY_INLINE SideMasks retry(const Sides& slope, const SideMasks& done) {
    const Sides enough = mul(both(-0.5), slope_start);
    const SideMasks passed = above(slope, enough);
    const SideMasks short_of = both_of(above(neg(enough), slope), above(high, both(0)));
    const SideMasks again = without(done, one_of(passed, short_of));
    if (hn::AllFalse(tag, hn::Or(again.t, again.c))) return again;
    high = choose(passed, length, high);
    slope_high = choose(passed, slope, slope_high);
    low = choose(short_of, length, low);
    slope_low = choose(short_of, slope, slope_low);
    const Sides secant = div(slope_low, sub(slope_low, choose(again, slope_high, both(1))));
    const Sides part{clip(secant.t, set(0.1), set(0.9)), clip(secant.c, set(0.1), set(0.9))};
    length = choose(again, mul_add(part, sub(high, low), low), length);
    return again;
  }
  /// A new step, except where the old one is tried again.
  HWY_INLINE void restart(const SideMasks& again, const Sides& slope) {
    slope_start = choose(again, slope_start, slope);
    slope_low = choose(again, slope_low, slope);
    length = choose(again, length, both(1));
    low = if_else_zero(again, low);
    high = if_else_zero(again, high);
  }
};

/// What the cell is given: the gradients, were no wire to slip in this step.
HWY_INLINE void begin(const CompliantCoefficients& c, const Cell& cell, Wires& w) {
  const std::size_t layers = c.layers.size();
  const std::size_t rows = rows_of_interface(c) * block_lanes;
  Sides outside = both(0);
  for (std::size_t i = 0; i < layers; ++i) {
    const double* at = cell.springs + i * rows;
    const Sides traction{hn::Load(tag, at), hn::Load(tag, at + layers * rows)};
    const Sides before = mul_add(both(c.layers[i].traction_of_outer), outside, traction);
    const Sides step = mul(both(c.planar.layers[i].k), cell.e_step);
    w.demand.set(i, add(step, before));
    w.residual.set(i, step);
    outside = traction;
  }
}

/// A step over the one before where it goes on like that, else zero.
HWY_INLINE V onward(V step, V before) {
  const V least = hn::Mul(set(0.1), hn::Abs(step));
  const Mask like = hn::And(hn::Gt(hn::Mul(step, before), hn::Zero(tag)), hn::Gt(hn::Abs(before), least));
  return hn::IfThenElseZero(like, hn::Div(step, hn::IfThenElse(like, before, set(1))));
}

/// A first guess: where curvature goes on as in the last step, wires slip as in that; where it turns back, no spring
/// slides. True where it is as in the last step.
HWY_INLINE SideMasks guess(const CompliantCoefficients& c, const Cell& cell, Wires& w) {
  const std::size_t layers = c.layers.size();
  const std::size_t rows = rows_of_interface(c) * block_lanes;
  const SideMasks goes_on = above(cell.onward, both(0));
  if (!all_true(goes_on)) {
    for (std::size_t i = 0; i < layers; ++i) {
      w.elastic.set(i, both(hn::Load(tag, cell.stiffness + i * block_lanes)));
      w.follow.set(i, both(0));
      w.handed.set(i, both(0));
    }
    eliminate(c, w);
    substitute(c, w, w.residual, w.slip);
  }
  for (std::size_t i = 0; i < layers; ++i) {
    const Sides before = InterfaceAt{cell.springs + i * rows, layers * rows}[last_slip];
    w.slip.set(i, choose(goes_on, mul(cell.onward, before), w.slip[i]));
  }
  return goes_on;
}

/// What is left to do where the first correction was not the last. `done` is where it was.
inline HWY_NOINLINE void solve_on(const CompliantCoefficients& c, const Cell& cell, SideMasks done, Wires& w) {
  const std::size_t layers = c.layers.size();
  const Sides rounding = both(rounding_of_a_wire);
  LineSearch search = LineSearch::begin(slope_along_step(c, w, w.first_residual));
  for (int round = 1; round < most_rounds; ++round) {
    const SideMasks again = search.retry(slope_along_step(c, w, w.residual), done);
    if (!all_true(one_of(again, done))) {
      eliminate(c, w);
      substitute(c, w, w.residual, w.across);
      for (std::size_t i = 0; i < layers; ++i) {
        w.base.set(i, choose(again, w.base[i], w.slip[i]));
        w.step.set(i, choose(again, w.step[i], neg(w.across[i])));
      }
      search.restart(again, slope_along_step(c, w, w.residual));
    }
    // What is solved waits unchanged for its neighbours.
    for (std::size_t i = 0; i < layers; ++i) {
      w.slip.set(i, choose(done, w.slip[i], mul_add(search.length, w.step[i], w.base[i])));
    }
    done = balance<true>(c, cell, rounding, w, w.residual);
    if (all_true(done)) return;
  }
}

/// Solves a cell from the slips at hand. Where they are not a solution of its linear equations they are corrected at
/// least once, since limits far above all forces would let a `guessed` one pass for rounding. The potential of its
/// springs is convex with a piecewise linear slope: Newton's method. One correction does nearly always.
HWY_INLINE void solve(const CompliantCoefficients& c, const Cell& cell, const SideMasks& guessed, Wires& w) {
  const Sides zero = both(0);
  const Sides rounding = both(rounding_of_a_wire);
  SideMasks done{hn::Lt(zero.t, zero.t), hn::Lt(zero.t, zero.t)};
  if (all_true(guessed)) {
    balance<false>(c, cell, zero, w, w.first_residual);
  } else {
    done = balance<true>(c, cell, choose(guessed, zero, rounding), w, w.first_residual);
    if (all_true(done)) return;
  }
  eliminate(c, w);
  substitute(c, w, w.first_residual, w.step);
  for (std::size_t i = 0; i < c.layers.size(); ++i) {
    const Sides base = w.slip[i];
    const Sides step = neg(w.step[i]);
    w.base.set(i, base);
    w.step.set(i, step);
    w.slip.set(i, choose(done, base, add(base, step)));
  }
  done = balance<true>(c, cell, rounding, w, w.residual);
  if (!all_true(done)) solve_on(c, cell, done, w);
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::compliant_kernel
HWY_AFTER_NAMESPACE();
#endif
