// The march of one layer around the full turn, for one register of section points. Included once per instruction set.
#if defined(STRANDYN_SPATIAL_MARCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_SPATIAL_MARCH_INL
#undef STRANDYN_SPATIAL_MARCH_INL
#else
#define STRANDYN_SPATIAL_MARCH_INL
#endif

#include <array>

#include "contact_cascade-inl.hpp"
#include "space-inl.hpp"
#include "spatial_return_map_kernel.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::spatial_kernel {
namespace HWY_NAMESPACE {
using namespace kernel::HWY_NAMESPACE;

using Layer = SpatialCoefficients::Layer;
using Load = LayerLoad<false>;
constexpr std::size_t quarters = 4;

/// Strain increments of bending since the reference, and where the neutral plane lies.
struct Bending {
  V d2, d3;
  V neutral;  // in cells, 0 to N/2
};

/// One cell: its gradient, with the limit's own force solved for. `base` is F_b at the cell's edge less mean(q) dS/2;
/// F_b at the midpoint is base + q dS/2.
struct Cell {
  V trial, q;
  Mask above, below;                // clipped
  Mask holds;                       // where both limits are zero nothing can stick, not even a trial of zero
  Mask upper_closed, lower_closed;  // the limit is above its floor: it follows F_b
};

/// The limits of a layer as lines in `base`, made once per march.
struct Limits {
  V floor, upper, lower;
  V upper_slope, lower_slope;
};

HWY_INLINE Limits limits_of(const Layer& layer, const Load& load) {
  return {.floor = load.floor.value,
          .upper = hn::MulAdd(load.numerator.value, set(layer.outward_gain), set(layer.outward_offset)),
          .lower = hn::Mul(load.numerator.value, set(layer.inward_gain)),
          .upper_slope = set(layer.slope * layer.outward_gain),
          .lower_slope = set(layer.slope * layer.inward_gain)};
}

HWY_INLINE Cell cell_of(const Limits& limits, V base, V trial) {
  const V raw_upper = hn::MulAdd(limits.upper_slope, base, limits.upper);
  const V raw_lower = hn::MulAdd(limits.lower_slope, base, limits.lower);
  const V upper = hn::Max(limits.floor, raw_upper);
  const V lower = hn::Neg(hn::Max(limits.floor, raw_lower));
  return {.trial = trial,
          .q = clip(trial, lower, upper),
          .above = hn::Gt(trial, upper),
          .below = hn::Lt(trial, lower),
          .holds = hn::Gt(hn::Sub(upper, lower), hn::Zero(tag)),
          .upper_closed = hn::Ge(raw_upper, limits.floor),
          .lower_closed = hn::Ge(raw_lower, limits.floor)};
}

/// dq/d(base).
HWY_INLINE V follow_of(const Limits& limits, const Cell& cell) {
  const V up = hn::IfThenElseZero(hn::And(cell.above, cell.upper_closed), limits.upper_slope);
  const V down = hn::IfThenElseZero(hn::And(cell.below, cell.lower_closed), limits.lower_slope);
  return hn::Sub(up, down);
}

/// Unknowns of a layer: F_b at the start of each quarter less mean(q) dS/2, and mean(q).
struct Unknowns {
  std::array<V, quarters> start;
  V mean;
};

/// What the four quarters, marched at once from their own starts, make of the unknowns, with the derivatives that
/// Newton's method needs. Four chains keep the arithmetic units busy while each waits for its own last cell.
struct Turn {
  std::array<V, quarters> end, end_by_start, end_by_mean;
  V before;  // sum over the turn of (share before the neutral plane) q
  std::array<V, quarters> before_by_start;
  V before_by_mean;
  V moment2, moment3;  // sums of cos q, sin q
  V force;             // sum of F_b at the midpoints
  V variation;         // sum of |q|
  V at_neutral;        // q of the two cells where the neutral plane lies; for the tangent only
};

/// What the tangent needs of every cell, written down by a march with kRecord. Rows of lanes, cell by cell.
struct Record {
  double* follow;   // dq/d(base)
  double* stick;    // dq/d(e)
  double* by_load;  // dq/d(load from outside)
};

/// dq/d(line load of the layer outside) of a clipped cell.
HWY_INLINE V by_load_of(const Layer& layer, const Cell& cell) {
  const double outer = layer.c_ext * layer.next_layer_ratio;
  const double closed = (layer.mu_int + layer.mu_ext) * outer;
  const V open = set(layer.mu_ext * outer);
  const V upper = hn::IfThenElse(cell.upper_closed, set(closed * layer.outward_gain), open);
  const V lower = hn::IfThenElse(cell.lower_closed, set(closed * layer.inward_gain), open);
  return hn::Sub(hn::IfThenElseZero(cell.above, upper), hn::IfThenElseZero(cell.below, lower));
}

struct Chain {
  V base, by_start, by_mean;
};

template <bool kRecord>
HWY_INLINE V advance(const Layer& layer, const Limits& limits, V trial, V share, V mean, Chain& chain, Turn& turn,
                     V& before_by_start, const Record& record, std::size_t at) {
  const Cell cell = cell_of(limits, chain.base, trial);
  const V step = set(2 * layer.half_step);
  const V follow = follow_of(limits, cell);
  if constexpr (kRecord) {
    hn::Store(follow, tag, record.follow + at * block_lanes);
    const Mask sticks = hn::AndNot(hn::Or(cell.above, cell.below), cell.holds);
    hn::Store(hn::IfThenElseZero(sticks, set(layer.k)), tag, record.stick + at * block_lanes);
    hn::Store(by_load_of(layer, cell), tag, record.by_load + at * block_lanes);
  }
  const V q_by_start = hn::Mul(follow, chain.by_start);
  const V q_by_mean = hn::Mul(follow, chain.by_mean);
  turn.force = hn::Add(turn.force, hn::MulAdd(set(layer.half_step), cell.q, chain.base));
  turn.variation = hn::Add(turn.variation, hn::Abs(cell.q));
  turn.before = hn::MulAdd(share, cell.q, turn.before);
  turn.before_by_mean = hn::MulAdd(share, q_by_mean, turn.before_by_mean);
  before_by_start = hn::MulAdd(share, q_by_start, before_by_start);
  chain.base = hn::MulAdd(step, hn::Sub(cell.q, mean), chain.base);
  chain.by_start = hn::MulAdd(step, q_by_start, chain.by_start);
  chain.by_mean = hn::MulAdd(step, hn::MulSub(follow, chain.by_mean, set(1)), chain.by_mean);
  return cell.q;
}

template <bool kRecord>
HWY_INLINE Turn turn_of(const SpatialCoefficients& c, const Layer& layer, const Limits& limits, const double* q,
                        const Bending& bending, const Unknowns& at, const Record& record) {
  const V zero = hn::Zero(tag);
  const V one = set(1);
  const V k = set(layer.k);
  const std::size_t cells = c.cosine.size();
  Chain chain0{at.start[0], one, zero};
  Chain chain1{at.start[1], one, zero};
  Chain chain2{at.start[2], one, zero};
  Chain chain3{at.start[3], one, zero};
  V before0 = zero, before1 = zero, before2 = zero, before3 = zero;
  Turn turn;
  turn.before = turn.before_by_mean = turn.moment2 = turn.moment3 = turn.force = turn.variation = turn.at_neutral =
      zero;
  const V second = hn::Sub(bending.neutral, set(static_cast<double>(cells)));
  for (std::size_t i = 0; i < cells; ++i) {
    const double* at_cell = q + i * block_lanes;
    const V cosine = set(c.cosine[i]);
    const V sine = set(c.sine[i]);
    const V along = hn::MulAdd(cosine, bending.d2, hn::Mul(sine, bending.d3));
    const V across = hn::NegMulAdd(sine, bending.d2, hn::Mul(cosine, bending.d3));
    const V trial0 = hn::MulAdd(k, along, hn::Load(tag, at_cell));
    const V trial1 = hn::MulAdd(k, across, hn::Load(tag, at_cell + cells * block_lanes));
    const V trial2 = hn::NegMulAdd(k, along, hn::Load(tag, at_cell + 2 * cells * block_lanes));
    const V trial3 = hn::NegMulAdd(k, across, hn::Load(tag, at_cell + 3 * cells * block_lanes));
    const V share02 = share_before(bending.neutral, static_cast<double>(i));
    const V share13 = share_before(second, static_cast<double>(i));
    const V q0 = advance<kRecord>(layer, limits, trial0, share02, at.mean, chain0, turn, before0, record, i);
    const V q1 = advance<kRecord>(layer, limits, trial1, share13, at.mean, chain1, turn, before1, record, cells + i);
    const V q2 =
        advance<kRecord>(layer, limits, trial2, share02, at.mean, chain2, turn, before2, record, 2 * cells + i);
    const V q3 =
        advance<kRecord>(layer, limits, trial3, share13, at.mean, chain3, turn, before3, record, 3 * cells + i);
    const V q02 = hn::Sub(q0, q2);
    const V q13 = hn::Sub(q1, q3);
    turn.moment2 = hn::MulAdd(cosine, q02, hn::NegMulAdd(sine, q13, turn.moment2));
    turn.moment3 = hn::MulAdd(sine, q02, hn::MulAdd(cosine, q13, turn.moment3));
    if constexpr (kRecord) {
      const auto lies_in = [](V place, std::size_t cell) HWY_ATTR {
        const double edge = static_cast<double>(cell);
        return hn::And(hn::Ge(place, set(edge)), hn::Lt(place, set(edge + 1)));
      };
      const V here = hn::IfThenElseZero(lies_in(bending.neutral, i), hn::Add(q0, q2));
      turn.at_neutral = hn::Add(turn.at_neutral, here);
      turn.at_neutral = hn::Add(turn.at_neutral, hn::IfThenElseZero(lies_in(second, i), hn::Add(q1, q3)));
    }
  }
  turn.end = {chain0.base, chain1.base, chain2.base, chain3.base};
  turn.end_by_start = {chain0.by_start, chain1.by_start, chain2.by_start, chain3.by_start};
  turn.end_by_mean = {chain0.by_mean, chain1.by_mean, chain2.by_mean, chain3.by_mean};
  turn.before_by_start = {before0, before1, before2, before3};
  return turn;
}

/// The linear system of Newton's method. Rows: each quarter ends where the next starts; F_b(phi) + F_b(phi + pi) = 0.
/// Columns: the four starts and the mean. Eliminated from start to start, so that two unknowns are left.
class Closure {
 public:
  Closure(const SpatialCoefficients& c, const Layer& layer, const V neutral, const Turn& turn)
      : end_by_start_(turn.end_by_start),
        end_by_mean_(turn.end_by_mean),
        before_by_start_(turn.before_by_start),
        step_(set(2 * layer.half_step)) {
    // start[j] = from_first[j] start[0] + from_mean[j] mean + (what the right-hand side adds)
    std::array<V, quarters + 1> from_first, from_mean;
    from_first[0] = set(1);
    from_mean[0] = hn::Zero(tag);
    V sum_first = hn::Zero(tag);
    V sum_mean = turn.before_by_mean;
    for (std::size_t j = 0; j < quarters; ++j) {
      sum_first = hn::MulAdd(before_by_start_[j], from_first[j], sum_first);
      sum_mean = hn::MulAdd(before_by_start_[j], from_mean[j], sum_mean);
      from_first[j + 1] = hn::Mul(end_by_start_[j], from_first[j]);
      from_mean[j + 1] = hn::MulAdd(end_by_start_[j], from_mean[j], end_by_mean_[j]);
    }
    const V own_mean = hn::Mul(step_, hn::NegMulAdd(set(2), neutral, set(1)));
    turn_by_first_ = hn::Sub(from_first[4], set(1));
    turn_by_mean_ = from_mean[4];
    neutral_by_first_ = hn::Add(from_first[2], hn::MulAdd(step_, sum_first, set(1)));
    neutral_by_mean_ = hn::Add(from_mean[2], hn::MulAdd(step_, sum_mean, own_mean));
    // Without slip the determinant is 2 N dS. Far below that the derivative is no guide: take the one without slip.
    const double plain = c.points * 2 * layer.half_step;
    V det = hn::NegMulAdd(turn_by_mean_, neutral_by_first_, hn::Mul(turn_by_first_, neutral_by_mean_));
    const Mask poor = hn::Lt(det, set(0.1 * 2 * plain));
    turn_by_first_ = hn::IfThenZeroElse(poor, turn_by_first_);
    turn_by_mean_ = hn::IfThenElse(poor, set(-plain), turn_by_mean_);
    neutral_by_first_ = hn::IfThenElse(poor, set(2), neutral_by_first_);
    neutral_by_mean_ = hn::IfThenElse(poor, hn::Add(set(-plain / 2), own_mean), neutral_by_mean_);
    inverse_det_ = hn::Div(set(1), hn::IfThenElse(poor, set(2 * plain), det));
  }

  /// The change of the unknowns that answers a change `end` of each quarter's end over the next start, and a change
  /// `neutral` of the sum of the two neutral forces.
  Unknowns solve(const std::array<V, quarters>& end, V neutral) const {
    std::array<V, quarters + 1> added;
    added[0] = hn::Zero(tag);
    V sum = hn::Zero(tag);
    for (std::size_t j = 0; j < quarters; ++j) {
      sum = hn::MulAdd(before_by_start_[j], added[j], sum);
      added[j + 1] = hn::MulAdd(end_by_start_[j], added[j], end[j]);
    }
    const V rhs_turn = hn::Neg(added[4]);
    const V rhs_neutral = hn::Neg(hn::Add(neutral, hn::MulAdd(step_, sum, added[2])));
    Unknowns change;
    change.start[0] =
        hn::Mul(inverse_det_, hn::NegMulAdd(turn_by_mean_, rhs_neutral, hn::Mul(neutral_by_mean_, rhs_turn)));
    change.mean =
        hn::Mul(inverse_det_, hn::NegMulAdd(neutral_by_first_, rhs_turn, hn::Mul(turn_by_first_, rhs_neutral)));
    for (std::size_t j = 0; j + 1 < quarters; ++j) {
      change.start[j + 1] =
          hn::MulAdd(end_by_start_[j], change.start[j], hn::MulAdd(end_by_mean_[j], change.mean, end[j]));
    }
    return change;
  }

 private:
  std::array<V, quarters> end_by_start_, end_by_mean_, before_by_start_;
  V step_;
  V turn_by_first_, turn_by_mean_, neutral_by_first_, neutral_by_mean_, inverse_det_;
};

/// Marches a layer until its unknowns fit. `at` enters as a guess and leaves as the solution.
///
/// The equations are piecewise linear: Newton ends after one correction unless points change between stick and slip.
/// Whatever `at` is, limits are >= 0 and the ledger closes; the cap only ends a march where mu |sin a| is so large
/// (above 2 or so) that the force feedback multiplies from cell to cell.
template <bool kRecord>
HWY_INLINE Turn solve_layer(const SpatialCoefficients& c, const Layer& layer, const Limits& limits, const double* q,
                            const Bending& bending, Unknowns& at, const Record& record) {
  constexpr int most_corrections = 12;
  constexpr double tolerance = 1e-13;  // of the way that the wire force travels in a turn
  const V step = set(2 * layer.half_step);
  for (int correction = 0;; ++correction) {
    const Turn turn = turn_of<kRecord>(c, layer, limits, q, bending, at, record);
    std::array<V, quarters> gap;
    V largest = hn::Zero(tag);
    for (std::size_t j = 0; j < quarters; ++j) {
      gap[j] = hn::Sub(turn.end[j], at.start[(j + 1) % quarters]);
      largest = hn::Max(largest, hn::Abs(gap[j]));
    }
    const V own = hn::Mul(hn::Mul(step, at.mean), hn::NegMulAdd(set(2), bending.neutral, set(1)));
    const V neutral = hn::Add(hn::Add(at.start[0], at.start[2]), hn::MulAdd(step, turn.before, own));
    largest = hn::Max(largest, hn::Abs(neutral));
    const V scale = hn::MulAdd(step, turn.variation, set(1e-9 * layer.force_per_strain));
    const Mask solved = hn::Le(largest, hn::Mul(set(tolerance), scale));
    if (correction == most_corrections || hn::AllTrue(tag, solved)) return turn;

    const Closure closure(c, layer, bending.neutral, turn);
    const Unknowns change = closure.solve(gap, neutral);
    // A solved point waits for its neighbours unchanged: its answer must not depend on them.
    for (std::size_t j = 0; j < quarters; ++j) {
      at.start[j] = hn::Add(at.start[j], hn::IfThenZeroElse(solved, change.start[j]));
    }
    at.mean = hn::Add(at.mean, hn::IfThenZeroElse(solved, change.mean));
  }
}

/// Goes once more through the cells of a solved layer: `visitor.on_cell(cell, base, q_reference, quarter, i)`.
template <class Visitor>
HWY_INLINE void replay(const SpatialCoefficients& c, const Layer& layer, const Limits& limits, const double* q,
                       const Bending& bending, const Unknowns& at, Visitor& visitor) {
  const std::size_t cells = c.cosine.size();
  V e2 = bending.d2;  // the increment as the quarter at hand sees it
  V e3 = bending.d3;
  for (std::size_t quarter = 0; quarter < quarters; ++quarter) {
    V base = at.start[quarter];
    for (std::size_t i = 0; i < cells; ++i) {
      const V e = hn::MulAdd(set(c.cosine[i]), e2, hn::Mul(set(c.sine[i]), e3));
      const V before = hn::Load(tag, q + (quarter * cells + i) * block_lanes);
      const Cell cell = cell_of(limits, base, hn::MulAdd(set(layer.k), e, before));
      visitor.on_cell(cell, base, before, quarter, i);
      base = hn::MulAdd(set(2 * layer.half_step), hn::Sub(cell.q, at.mean), base);
    }
    const V turned = e3;
    e3 = hn::Neg(e2);
    e2 = turned;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::spatial_kernel
HWY_AFTER_NAMESPACE();
#endif
