// The wires of all layers at one angle, and the interfaces between them: solved together, for one register of section
// points. Included once per instruction set. Rows run from the outermost layer inward, i = 0, 1, ...:
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

#include "lanes-inl.hpp"
#include "strandyn/section/compliant.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::compliant_kernel {
namespace HWY_NAMESPACE {
using namespace kernel::HWY_NAMESPACE;

using Layer = CompliantCoefficients::Layer;
using conductor::SpringChain;

/// Newton's method ends after a handful of rounds.
constexpr int most_rounds = 100;
/// The residual of a wire is a sum of some tens of forces: what rounding leaves of it, over the sum of their sizes.
constexpr double rounding_of_a_wire = 4e-15;
/// A spring that stands at its limit counts as stuck, whatever the last digits say.
constexpr double still_stuck = 1 + 1e-13;

/// A row of lanes per layer.
class PerLayer {
 public:
  explicit PerLayer(std::size_t layers) : rows_(layers * block_lanes) {}
  HWY_INLINE V operator[](std::size_t layer) const { return hn::Load(tag, rows_.data() + layer * block_lanes); }
  HWY_INLINE void set(std::size_t layer, V value) { hn::Store(value, tag, rows_.data() + layer * block_lanes); }

 private:
  AlignedVector rows_;
};

/// The springs of an interface under a trial slip.
struct Traction {
  V sum;      // of the springs' forces
  V holding;  // [-] the part of the stiffness that holds
  V sliding;  // [-] the part of the limit that sliding springs carry, signed
};

HWY_INLINE Traction traction_of(const SpringChain& chain, const double* f, V K_slip, V limit) {
  const V zero = hn::Zero(tag);
  const V reach = hn::Mul(limit, set(still_stuck));
  Traction t{zero, zero, zero};
  for (std::size_t i = 0; i < chain.limit.size(); ++i, f += block_lanes) {
    const V kappa = set(chain.stiffness[i]);
    const V phi = set(chain.limit[i]);
    const V trial = hn::MulAdd(kappa, K_slip, hn::Load(tag, f));
    t.sum = hn::Add(t.sum, clip(trial, hn::Mul(phi, limit)));
    // A limit of zero holds nothing, not even a trial of zero.
    const Mask holds = hn::Lt(hn::Abs(trial), hn::Mul(phi, reach));
    t.holding = hn::Add(t.holding, hn::IfThenElseZero(holds, kappa));
    t.sliding = hn::Add(t.sliding, hn::IfThenZeroElse(holds, hn::CopySign(phi, trial)));
  }
  return t;
}

/// One cell: where its springs lie, and what it is given.
struct Cell {
  std::size_t angle;        // of a quarter turn
  double side;              // 1 where F_b grows with q along the march, -1 where it falls
  const double* springs;    // committed: per interface its traction, then the forces of its springs
  const double* stiffness;  // [interface] K, rows of lanes
  V e_step;                 // [1/m] what the angle sees of the curvature's step
};

/// The unknowns of a cell and what belongs to them. `load` is given: the load of the inner contact without the cell's
/// own gradients.
struct Wires {
  explicit Wires(std::size_t layers)
      : load(layers),
        demand(layers),
        slip(layers),
        across(layers),
        limit(layers),
        traction(layers),
        q(layers),
        residual(layers),
        elastic(layers),
        holding(layers),
        follow(layers),
        handed(layers),
        step(layers),
        base(layers),
        work(layers) {}

  PerLayer load;                // [N/m]
  PerLayer demand;              // [N/m] gradient were no wire to slip in this step
  PerLayer slip;                // [m] u of the step
  PerLayer across;              // [m] w of the step
  PerLayer limit, traction, q;  // [N/m]
  PerLayer residual;            // [N/m] q + k_w u - demand
  PerLayer elastic;             // dT/dw
  PerLayer holding;             // [-] elastic over K
  PerLayer follow;              // dT/df
  PerLayer handed;              // df of the next layer inward by that of this one
  PerLayer step, base;          // Newton's, and the slips from which it goes
  PerLayer work;
};

/// Tractions and residuals at `slip`; true where they balance.
HWY_INLINE Mask balance(const CompliantCoefficients& c, const Cell& cell, Wires& w) {
  const V zero = hn::Zero(tag);
  const std::size_t layers = c.layers.size();
  const std::size_t rows = (c.springs + 1) * block_lanes;
  Mask done = hn::Eq(zero, zero);
  V outside = zero;  // T of the layer outside, its limit, its load
  V limit_outside = zero;
  V load_outside = zero;
  V slip = w.slip[0];
  for (std::size_t i = 0; i < layers; ++i) {
    const Layer& layer = c.layers[i];
    const V inside = i + 1 < layers ? w.slip[i + 1] : zero;
    const V across = hn::MulAdd(set(layer.slip_of_inner), inside, slip);
    const V wanted = hn::NegMulAdd(set(layer.k_w), slip, w.demand[i]);
    V load = hn::MulAdd(set(layer.load_of_outer), load_outside, w.load[i]);
    load = hn::MulAdd(set(cell.side * layer.own_load), wanted, load);
    const Mask closed = hn::Gt(load, zero);
    load = hn::Max(zero, load);
    const V mu = set(c.planar.layers[i].mu_int);
    const V limit = hn::Mul(mu, load);
    const V K = hn::Load(tag, cell.stiffness + i * block_lanes);
    const Traction t =
        traction_of(layer.chains[cell.angle], cell.springs + i * rows + block_lanes, hn::Mul(K, across), limit);
    const V q = hn::MulAdd(set(layer.traction_of_outer), outside, t.sum);
    const V residual = hn::Sub(q, wanted);
    V size = hn::MulAdd(set(std::abs(layer.traction_of_outer)), limit_outside, limit);
    size = hn::Add(size, hn::Add(hn::Abs(wanted), hn::Abs(w.demand[i])));
    done = hn::And(done, hn::Le(hn::Abs(residual), hn::Mul(set(rounding_of_a_wire), size)));
    w.across.set(i, across);
    w.limit.set(i, limit);
    w.traction.set(i, t.sum);
    w.q.set(i, q);
    w.residual.set(i, residual);
    w.holding.set(i, t.holding);
    w.elastic.set(i, hn::Mul(K, t.holding));
    w.follow.set(i, hn::IfThenElseZero(closed, hn::Mul(mu, t.sliding)));
    if (i + 1 < layers) w.handed.set(i, hn::IfThenElseZero(closed, set(c.layers[i + 1].load_of_outer)));
    outside = t.sum;
    limit_outside = limit;
    load_outside = load;
    slip = inside;
  }
  return done;
}

/// The linear system of a cell: slips `out` whose residuals change by `rhs`. Eliminated from the outermost layer
/// inward; what the layer outside does is a line in the slip of the layer at hand.
HWY_INLINE void eliminate(const CompliantCoefficients& c, double side, Wires& w, const PerLayer& rhs, PerLayer& out) {
  const std::size_t layers = c.layers.size();
  const V zero = hn::Zero(tag);
  V traction = zero, traction_by_slip = zero;  // of the interface outside
  V load = zero, load_by_slip = zero;          // handed by it
  for (std::size_t i = 0; i < layers; ++i) {
    const Layer& layer = c.layers[i];
    const V elastic = w.elastic[i];
    const V follow = w.follow[i];
    const V a = set(layer.traction_of_outer);
    const V k_w = set(layer.k_w);
    const V by_slip = hn::NegMulAdd(set(side * layer.own_load), k_w, load_by_slip);
    const V own = hn::MulAdd(follow, by_slip, hn::Add(elastic, k_w));
    const V inverse = hn::Div(set(1), hn::MulAdd(a, traction_by_slip, own));
    const V known = hn::NegMulAdd(follow, load, hn::NegMulAdd(a, traction, rhs[i]));
    const V slip = hn::Mul(known, inverse);
    const V by_inner = hn::Mul(hn::Mul(elastic, set(layer.slip_of_inner)), inverse);  // less, per slip of the next
    out.set(i, slip);
    w.work.set(i, by_inner);
    const V own_load = hn::MulAdd(by_slip, slip, load);
    const V own_load_by_slip = hn::Neg(hn::Mul(by_slip, by_inner));
    traction = hn::MulAdd(elastic, slip, hn::Mul(follow, own_load));
    traction_by_slip =
        hn::MulAdd(elastic, hn::Sub(set(layer.slip_of_inner), by_inner), hn::Mul(follow, own_load_by_slip));
    if (i + 1 == layers) break;
    load = hn::Mul(w.handed[i], own_load);
    load_by_slip = hn::Mul(w.handed[i], own_load_by_slip);
  }
  V inner = out[layers - 1];
  for (std::size_t i = layers - 1; i-- > 0;) {
    inner = hn::NegMulAdd(w.work[i], inner, out[i]);
    out.set(i, inner);
  }
}

/// What the residuals do on Newton's step: the slope of the springs' potential along it.
HWY_INLINE V slope_along_step(const CompliantCoefficients& c, const Wires& w) {
  V sum = hn::Zero(tag);
  for (std::size_t i = 0; i < c.layers.size(); ++i) {
    sum = hn::MulAdd(set(c.layers[i].wires_per_length), hn::Mul(w.step[i], w.residual[i]), sum);
  }
  return sum;
}

/// Solves a cell. The potential of its springs is convex with a piecewise linear slope: Newton's method. Where a step
/// passes the lowest point on its way, that point is searched for, until the slope is half of what it was.
HWY_INLINE void solve(const CompliantCoefficients& c, const Cell& cell, Wires& w) {
  const V zero = hn::Zero(tag);
  const std::size_t layers = c.layers.size();
  const std::size_t rows = (c.springs + 1) * block_lanes;
  // Were all springs stuck, the slips would be these.
  V outside = zero;
  for (std::size_t i = 0; i < layers; ++i) {
    const V traction = hn::Load(tag, cell.springs + i * rows);
    const V before = hn::MulAdd(set(c.layers[i].traction_of_outer), outside, traction);
    const V step = hn::Mul(set(c.planar.layers[i].k), cell.e_step);
    w.demand.set(i, hn::Add(step, before));
    w.residual.set(i, step);
    w.elastic.set(i, hn::Load(tag, cell.stiffness + i * block_lanes));
    w.follow.set(i, zero);
    w.handed.set(i, zero);
    outside = traction;
  }
  eliminate(c, cell.side, w, w.residual, w.slip);

  V slope_before = zero;      // along Newton's step, where it starts
  V length = set(1);          // of the way along it
  V low = zero, high = zero;  // lengths between which the lowest point lies, once it was passed
  V slope_low = zero, slope_high = zero;
  for (int round = 0;; ++round) {
    const Mask done = balance(c, cell, w);
    if (round == most_rounds || hn::AllTrue(tag, done)) return;
    const V slope = slope_along_step(c, w);
    const V enough = hn::Mul(set(-0.5), slope_before);
    const Mask passed = hn::Gt(slope, enough);
    const Mask short_of = hn::And(hn::Lt(slope, hn::Neg(enough)), hn::Gt(high, zero));
    Mask again = hn::AndNot(done, hn::Or(passed, short_of));
    if (round == 0) again = hn::Lt(set(1), zero);
    if (!hn::AllFalse(tag, again)) {
      high = hn::IfThenElse(passed, length, high);
      slope_high = hn::IfThenElse(passed, slope, slope_high);
      low = hn::IfThenElse(short_of, length, low);
      slope_low = hn::IfThenElse(short_of, slope, slope_low);
      const V secant = hn::Div(slope_low, hn::Sub(slope_low, hn::IfThenElse(again, slope_high, set(1))));
      const V between = hn::MulAdd(clip(secant, set(0.1), set(0.9)), hn::Sub(high, low), low);
      length = hn::IfThenElse(again, between, length);
    }
    if (!hn::AllTrue(tag, hn::Or(again, done))) {
      for (std::size_t i = 0; i < layers; ++i) w.base.set(i, hn::IfThenElse(again, w.base[i], w.slip[i]));
      eliminate(c, cell.side, w, w.residual, w.across);
      for (std::size_t i = 0; i < layers; ++i) {
        w.step.set(i, hn::IfThenElse(again, w.step[i], hn::Neg(w.across[i])));
      }
      slope_before = hn::IfThenElse(again, slope_before, slope_along_step(c, w));
      slope_low = hn::IfThenElse(again, slope_low, slope_before);
      length = hn::IfThenElse(again, length, set(1));
      low = hn::IfThenElseZero(again, low);
      high = hn::IfThenElseZero(again, high);
    }
    // A solved lane waits unchanged for its neighbours.
    for (std::size_t i = 0; i < layers; ++i) {
      w.slip.set(i, hn::IfThenElse(done, w.slip[i], hn::MulAdd(length, w.step[i], w.base[i])));
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::compliant_kernel
HWY_AFTER_NAMESPACE();
#endif
