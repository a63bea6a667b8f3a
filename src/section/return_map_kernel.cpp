// Highway reads this file once per instruction set; the best that the machine has is chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "return_map_kernel.cpp"
#include "return_map_kernel.hpp"

#include <hwy/foreach_target.h>

#include <array>

#include "contact_cascade-inl.hpp"
#include "slip_energy-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::return_map_kernel {
namespace HWY_NAMESPACE {
using namespace kernel::HWY_NAMESPACE;

using Layer = PlanarCoefficients::Layer;
constexpr double without_bound = 1e300;

/// The limit of one direction at the midpoint of a cell, with its own force solved for.
template <bool kTangent>
HWY_INLINE Dual<kTangent> limit_of(const Dual<kTangent>& numerator, const Dual<kTangent>& floor, double gain,
                                   double offset) {
  Dual<kTangent> raw = scaled(set(gain), numerator);
  raw.value = hn::MulAdd(numerator.value, set(gain), set(offset));
  return at_least(floor, raw);
}

struct CellResult {
  V q, trial, mid_force;
};

/// Return map of one cell. `stick` = k cos(theta). On the tension side the force grows with q, on the other it falls.
template <bool kTension, bool kTangent>
HWY_INLINE CellResult advance(const Layer& layer, const LayerLoad<kTangent>& load, double cosine, V dchi, V q_reference,
                              Quarter<kTangent>& quarter) {
  const V stick = set(layer.k * cosine);
  const Dual<kTangent> numerator = mul_add(set(layer.slope), quarter.edge, load.numerator);
  const auto outward = limit_of(numerator, load.floor, layer.outward_gain, layer.outward_offset);
  const auto inward = limit_of(numerator, load.floor, layer.inward_gain, 0);
  const Dual<kTangent>& upper = kTension ? outward : inward;
  const Dual<kTangent>& lower = kTension ? inward : outward;

  const V trial = hn::MulAdd(stick, dchi, q_reference);
  const V lowest = hn::Neg(lower.value);
  Dual<kTangent> q;
  q.value = clip(trial, lowest, upper.value);
  if constexpr (kTangent) {
    const Mask above = hn::Gt(trial, upper.value);
    const Mask below = hn::Lt(trial, lowest);
    // Where both limits are zero nothing can stick, not even a trial of zero.
    const Mask holds = hn::Gt(hn::Max(upper.value, lower.value), hn::Zero(tag));
    const V elastic = hn::IfThenElseZero(holds, stick);
    q.chi = hn::IfThenElse(above, upper.chi, hn::IfThenElse(below, hn::Neg(lower.chi), elastic));
    q.eps = hn::IfThenElse(above, upper.eps, hn::IfThenElse(below, hn::Neg(lower.eps), hn::Zero(tag)));
  }
  const V half = set(kTension ? layer.half_step : -layer.half_step);
  const Dual<kTangent> middle = mul_add(half, q, quarter.edge);
  quarter.edge = mul_add(half, q, middle);
  quarter.sum_of_force = sum(quarter.sum_of_force, middle);
  quarter.sum_of_moment = mul_add(set(cosine), q, quarter.sum_of_moment);
  return {.q = q.value, .trial = trial, .mid_force = middle.value};
}

/// The two cells of one angle, tension side first: what came out, the reference gradients, their rows in `q`.
struct Cells {
  double cosine;
  std::array<CellResult, 2> now;
  std::array<V, 2> reference;
  std::array<std::size_t, 2> offset;
};

/// The whole march of one register of points. `on_cells` sees every angle, `on_layer` the load of every layer.
template <bool kTangent, class Watcher>
HWY_INLINE Dual<kTangent> march(const PlanarCoefficients& c, const double* q, V eps, V dchi, Watcher& watcher) {
  const std::size_t cells = c.cosine.size();
  const std::size_t side = cells * block_lanes;
  std::size_t at = 0;
  auto moment = zero<kTangent>();
  auto f_int = zero<kTangent>();
  for (const Layer& layer : c.layers) {
    const auto load = load_of(layer, set(layer.kappa * layer.force_per_strain), eps, f_int);
    auto tension = Quarter<kTangent>::at_rest();
    auto compression = Quarter<kTangent>::at_rest();
    watcher.on_layer(layer, load.numerator.value);
    // Both sides in one loop: two independent chains keep the arithmetic units busy.
    for (std::size_t i = 0; i < cells; ++i, at += block_lanes) {
      const V q0 = hn::Load(tag, q + at);
      const V q1 = hn::Load(tag, q + at + side);
      const CellResult t = advance<true>(layer, load, c.cosine[i], dchi, q0, tension);
      const CellResult p = advance<false>(layer, load, c.cosine[i], dchi, q1, compression);
      watcher.on_cells(layer, Cells{c.cosine[i], {t, p}, {q0, q1}, {at, at + side}});
    }
    at += side;

    const V mean = set(c.mean_weight * layer.kappa);
    moment = mul_add(set(layer.weight), sum(tension.sum_of_moment, compression.sum_of_moment), moment);
    f_int = handed_inward(layer, mul_add(mean, sum(tension.sum_of_force, compression.sum_of_force), load.inner));
  }
  return moment;
}

/// True where no angle of the point can slip between the reference state and (eps, reference_chi + dchi). A range of no
/// width, as friction limits of zero leave it, holds nothing.
HWY_INLINE Mask sticks(const Rows& row, V eps, V dchi) {
  const V zero = hn::Zero(tag);
  const V drop = hn::Mul(hn::Max(zero, hn::Sub(row[reference_eps], eps)), row[inverse_drop]);
  const V low = hn::MulAdd(drop, hn::Sub(row[stick_low_slack], row[stick_low]), row[stick_low]);
  const V high = hn::MulAdd(drop, hn::Sub(row[stick_high_slack], row[stick_high]), row[stick_high]);
  return hn::And(hn::Le(drop, set(1)), hn::And(hn::Gt(dchi, low), hn::Lt(dchi, high)));
}

struct NoWatcher {
  void on_layer(const Layer&, V) {}
  void on_cells(const Layer&, const Cells&) {}
};

template <bool kTangent>
std::size_t respond_all(const PlanarCoefficients& c, const double* history, const Strains& strains,
                        const Response& out) {
  std::size_t marched = 0;
  for (const Register at : Registers{strains.points}) {
    const Rows row{at.rows(history, rows_of_block(c))};
    const V eps = at.load(strains.eps);
    const V chi = at.load(strains.chi);
    const V dchi = hn::Sub(chi, row[reference_chi]);
    const Mask stuck = hn::Or(sticks(row, eps, dchi), at.padding(strains.points));

    const V EI_f = set(c.EI_friction);
    auto M = dual<kTangent>(hn::MulAdd(EI_f, dchi, row[reference_M]), EI_f, hn::Zero(tag));
    if (!hn::AllTrue(tag, stuck)) {
      NoWatcher nobody;
      M = choose(stuck, M, march<kTangent>(c, row.at + scalar_rows * block_lanes, eps, dchi, nobody));
      marched += hn::CountTrue(tag, hn::Not(stuck));
    }
    answer(c, out, at, eps, chi, M);
  }
  return marched;
}

/// Watches a march to its end: energies of the step, the new gradients, and who slips.
struct EnergyWatcher {
  double* gradients;
  Mask stuck;
  V chi_before;  // committed minus reference
  SlipEnergy energy;
  Mask slips;

  void on_layer(const Layer&, V) {}

  void on_cells(const Layer& layer, const Cells& cells) {
    const V stick = set(layer.k * cells.cosine);
    for (std::size_t side = 0; side < 2; ++side) {
      const V q = cells.now[side].q;
      const V trial = cells.now[side].trial;
      const V rounding = hn::Mul(set(1e-12), hn::Abs(q));
      slips = hn::Or(slips, hn::Gt(hn::Abs(hn::Sub(trial, q)), rounding));
      energy.add(layer, hn::MulAdd(stick, chi_before, cells.reference[side]), trial, q);
      hn::Store(hn::IfThenElse(stuck, cells.reference[side], q), tag, gradients + cells.offset[side]);
    }
  }
};

/// Watches a march that goes nowhere: the box of curvature in which the committed gradients stay within their limits.
struct BoxWatcher {
  V low, high, low_slack, high_slack;
  V drop;                 // strain drop of the slack box
  V numerator;            // of the layer under way
  double growth = 0;      // [N m] bending force at the cell's edge per curvature while all stick
  bool outermost = true;  // the next layer is the first

  void on_layer(const Layer& layer, V numerator_of_layer) {
    numerator = numerator_of_layer;
    growth = 0;
    if (outermost && layer.limit_per_strain > 0) {
      // A quarter of the strain that would unload the outermost layer: far enough to serve a vibration, near enough
      // to leave room for curvature in the slack box.
      drop = hn::Mul(set(0.25 / layer.limit_per_strain), hn::Max(hn::Zero(tag), numerator));
    }
    outermost = false;
  }

  void on_cells(const Layer& layer, const Cells& cells) {
    const double mid_growth = growth + layer.half_step * layer.k * cells.cosine;
    growth = mid_growth + layer.half_step * layer.k * cells.cosine;
    for (std::size_t side = 0; side < 2; ++side) {
      // |q + stick d| <= limit + follow d with d the curvature yet to come: two half-planes.
      const V q = cells.now[side].q;
      const double follow = (side == 0 ? 1 : -1) * layer.slope * mid_growth;
      const V limit = hn::MulAdd(set(layer.slope), cells.now[side].mid_force, numerator);
      const V lost = hn::Mul(set(layer.limit_per_strain), drop);
      narrow(layer.k * cells.cosine - follow, hn::Sub(limit, q), lost);
      narrow(-layer.k * cells.cosine - follow, hn::Add(limit, q), lost);
    }
  }

  /// slope d <= room, and slope d <= room - lost in the slack box.
  void narrow(double slope, V room, V lost) {
    if (slope == 0) {
      const V nothing = set(-without_bound);
      high = hn::IfThenElse(hn::Lt(room, hn::Zero(tag)), nothing, high);
      high_slack = hn::IfThenElse(hn::Lt(room, lost), nothing, high_slack);
      return;
    }
    const V inverse = set(1 / slope);
    const V bound = hn::Mul(room, inverse);
    const V bound_slack = hn::Mul(hn::Sub(room, lost), inverse);
    if (slope > 0) {
      high = hn::Min(high, bound);
      high_slack = hn::Min(high_slack, bound_slack);
    } else {
      low = hn::Max(low, bound);
      low_slack = hn::Max(low_slack, bound_slack);
    }
  }
};

std::size_t commit_all(const PlanarCoefficients& c, double* history, const Strains& strains, const Energies& out) {
  const V zero = hn::Zero(tag);
  const V half = set(0.5);
  std::size_t marched = 0;
  for (const Register here : Registers{strains.points}) {
    double* at = here.rows(history, rows_of_block(c));
    const Rows row{at};
    const auto writable = [at](std::size_t index) HWY_ATTR { return at + index * block_lanes; };
    const V eps = here.load(strains.eps);
    const V chi = here.load(strains.chi);
    const V dchi = hn::Sub(chi, row[reference_chi]);
    const Mask stuck = hn::Or(sticks(row, eps, dchi), here.padding(strains.points));

    // Sticking from the reference on: the potential is a parabola, nothing is lost, the reference stays.
    const V EI_f = set(c.EI_friction);
    V stored = hn::MulAdd(dchi, hn::MulAdd(hn::Mul(half, EI_f), dchi, row[reference_M]), row[reference_U]);
    V dissipated = zero;
    V quadrature_error = zero;
    if (!hn::AllTrue(tag, stuck)) {
      double* q = at + scalar_rows * block_lanes;
      EnergyWatcher w{.gradients = q,
                      .stuck = stuck,
                      .chi_before = hn::Sub(row[committed_chi], row[reference_chi]),
                      .energy = SlipEnergy::zero(),
                      .slips = hn::Not(hn::Eq(zero, zero))};
      const V M = march<false>(c, q, eps, dchi, w).value;
      stored = hn::IfThenElse(stuck, stored, w.energy.stored);
      dissipated = hn::IfThenElse(stuck, zero, w.energy.dissipated);
      quadrature_error = hn::IfThenElse(stuck, zero, w.energy.quadrature_error());
      replace(writable(reference_chi), stuck, chi);
      replace(writable(reference_eps), stuck, eps);
      replace(writable(reference_M), stuck, M);
      replace(writable(reference_U), stuck, w.energy.stored);

      // Who slips will march again, without a box. Who has come to rest gets one, by a march from here to here.
      const Mask rests = hn::AndNot(hn::Or(stuck, w.slips), hn::Eq(zero, zero));
      BoxWatcher box{.low = set(-without_bound),
                     .high = set(without_bound),
                     .low_slack = set(-without_bound),
                     .high_slack = set(without_bound),
                     .drop = c.layers.empty() ? set(without_bound) : zero,  // a single wire cannot slip
                     .numerator = zero};
      if (!hn::AllFalse(tag, rests)) march<false>(c, q, eps, zero, box);
      const Mask two_boxes = hn::And(hn::Gt(box.drop, zero), hn::Le(box.low_slack, box.high_slack));
      // The state just committed is admissible whatever rounding says of a point that stands on its limit.
      const V low = hn::Min(box.low, zero);
      const V high = hn::Max(box.high, zero);
      const auto boxed = [&](V value, double none) HWY_ATTR { return hn::IfThenElse(rests, value, set(none)); };
      replace(writable(stick_low), stuck, boxed(low, 1));
      replace(writable(stick_high), stuck, boxed(high, -1));
      replace(writable(stick_low_slack), stuck, boxed(hn::IfThenElse(two_boxes, box.low_slack, low), 1));
      replace(writable(stick_high_slack), stuck, boxed(hn::IfThenElse(two_boxes, box.high_slack, high), -1));
      const V inverse = hn::Div(set(1), hn::IfThenElse(two_boxes, box.drop, set(1 / without_bound)));
      replace(writable(inverse_drop), stuck, boxed(inverse, 0));
      marched += hn::CountTrue(tag, hn::Not(stuck));
    }
    hn::Store(chi, tag, writable(committed_chi));
    book(out, here, twice_linear_energy(c, eps, chi), stored, dissipated, quadrature_error);
  }
  return marched;
}

std::size_t respond_here(const PlanarCoefficients& c, const double* history, const Strains& strains,
                         const Response& out) {
  return out.dM_dchi ? respond_all<true>(c, history, strains, out) : respond_all<false>(c, history, strains, out);
}

std::size_t lanes_here() {
  return hn::Lanes(tag);
}
int64_t target_here() {
  return HWY_TARGET;
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::return_map_kernel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace strandyn::section {
namespace return_map_kernel {

HWY_EXPORT(respond_here);
HWY_EXPORT(commit_all);
HWY_EXPORT(lanes_here);
HWY_EXPORT(target_here);

std::size_t respond(const PlanarCoefficients& c, const double* history, const Strains& strains, const Response& out) {
  return HWY_DYNAMIC_DISPATCH(respond_here)(c, history, strains, out);
}

std::size_t commit(const PlanarCoefficients& c, double* history, const Strains& strains, const Energies& out) {
  return HWY_DYNAMIC_DISPATCH(commit_all)(c, history, strains, out);
}

VectorTarget target_in_use() {
  return {.name = hwy::TargetName(HWY_DYNAMIC_DISPATCH(target_here)()), .lanes = HWY_DYNAMIC_DISPATCH(lanes_here)()};
}

}  // namespace return_map_kernel

VectorTarget vector_target() {
  return return_map_kernel::target_in_use();
}

}  // namespace strandyn::section
#endif
