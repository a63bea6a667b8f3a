// One source, compiled by Highway for SSE4, AVX2 and AVX-512, and without vectors for all else; the best that the
// machine has is chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "return_map_kernel.cpp"
#ifndef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#endif
#include "return_map_kernel.hpp"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::kernel {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, block_lanes>;
using V = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;
using Layer = PlanarCoefficients::Layer;
constexpr Tag tag;
constexpr double without_bound = 1e300;

HWY_INLINE V set(double x) {
  return hn::Set(tag, x);
}

/// A value and, where the tangent is asked for, its derivatives with respect to curvature and axial strain.
template <bool kTangent>
struct Dual {
  V value, chi, eps;
};

/// What a layer's limit has beside the wire's own bending force: q_lim = max(floor, numerator + slope F_b).
template <bool kTangent>
struct LayerLoad {
  Dual<kTangent> floor;      // mu_ext c_ext f_ext: all that is left when the inner contact opens
  Dual<kTangent> numerator;  // floor + mu_int (kappa F_at + c_ext f_ext + c_int R_res)
  Dual<kTangent> inner;      // kappa F_at + c_ext f_ext + c_int R_res
};

template <bool kTangent>
HWY_INLINE LayerLoad<kTangent> load_of(const Layer& layer, V eps, const Dual<kTangent>& f_int_outside) {
  LayerLoad<kTangent> load;
  const V outer = set(layer.c_ext * layer.next_layer_ratio);
  const V own = set(layer.kappa * layer.force_per_strain);
  const V outer_load = hn::Mul(outer, f_int_outside.value);
  load.inner.value = hn::Add(hn::MulAdd(own, eps, outer_load), set(layer.inner_residual));
  load.floor.value = hn::Mul(set(layer.mu_ext), outer_load);
  load.numerator.value = hn::MulAdd(set(layer.mu_int), load.inner.value, load.floor.value);
  if constexpr (kTangent) {
    const V outer_chi = hn::Mul(outer, f_int_outside.chi);
    const V outer_eps = hn::Mul(outer, f_int_outside.eps);
    load.inner.chi = outer_chi;
    load.inner.eps = hn::Add(own, outer_eps);
    load.floor.chi = hn::Mul(set(layer.mu_ext), outer_chi);
    load.floor.eps = hn::Mul(set(layer.mu_ext), outer_eps);
    load.numerator.chi = hn::MulAdd(set(layer.mu_int), load.inner.chi, load.floor.chi);
    load.numerator.eps = hn::MulAdd(set(layer.mu_int), load.inner.eps, load.floor.eps);
  }
  return load;
}

/// One quarter turn on its way from the neutral plane: the bending force at the cell's edge and the sums so far.
template <bool kTangent>
struct Quarter {
  Dual<kTangent> edge, sum_of_force, sum_of_moment;

  static Quarter zero() {
    const V z = hn::Zero(tag);
    return {{z, z, z}, {z, z, z}, {z, z, z}};
  }
};

/// The limit of one direction at the midpoint of a cell, with its own force solved for.
template <bool kTangent>
HWY_INLINE Dual<kTangent> limit_of(const Dual<kTangent>& numerator, const Dual<kTangent>& floor, double gain,
                                   double offset) {
  Dual<kTangent> limit;
  const V g = set(gain);
  const V raw = hn::MulAdd(numerator.value, g, set(offset));
  limit.value = hn::Max(floor.value, raw);
  if constexpr (kTangent) {
    const Mask closed = hn::Ge(raw, floor.value);
    limit.chi = hn::IfThenElse(closed, hn::Mul(numerator.chi, g), floor.chi);
    limit.eps = hn::IfThenElse(closed, hn::Mul(numerator.eps, g), floor.eps);
  }
  return limit;
}

struct CellResult {
  V q, trial, mid_force;
};

/// Return map of one cell. `stick` = k cos(theta). On the tension side the force grows with q, on the other it falls.
template <bool kTension, bool kTangent>
HWY_INLINE CellResult advance(const Layer& layer, const LayerLoad<kTangent>& load, double cosine, V dchi, V q_reference,
                              Quarter<kTangent>& quarter) {
  const V slope = set(layer.slope);
  const V stick = set(layer.k * cosine);
  Dual<kTangent> numerator;
  numerator.value = hn::MulAdd(slope, quarter.edge.value, load.numerator.value);
  if constexpr (kTangent) {
    numerator.chi = hn::MulAdd(slope, quarter.edge.chi, load.numerator.chi);
    numerator.eps = hn::MulAdd(slope, quarter.edge.eps, load.numerator.eps);
  }
  const auto outward = limit_of<kTangent>(numerator, load.floor, layer.outward_gain, layer.outward_offset);
  const auto inward = limit_of<kTangent>(numerator, load.floor, layer.inward_gain, 0);
  const Dual<kTangent>& upper = kTension ? outward : inward;
  const Dual<kTangent>& lower = kTension ? inward : outward;

  CellResult cell;
  cell.trial = hn::MulAdd(stick, dchi, q_reference);
  cell.q = hn::Min(hn::Max(cell.trial, hn::Neg(lower.value)), upper.value);

  const V half = set(kTension ? layer.half_step : -layer.half_step);
  const V weight = set(cosine);
  cell.mid_force = hn::MulAdd(half, cell.q, quarter.edge.value);
  quarter.edge.value = hn::MulAdd(half, cell.q, cell.mid_force);
  quarter.sum_of_force.value = hn::Add(quarter.sum_of_force.value, cell.mid_force);
  quarter.sum_of_moment.value = hn::MulAdd(weight, cell.q, quarter.sum_of_moment.value);
  if constexpr (kTangent) {
    const Mask above = hn::Gt(cell.trial, upper.value);
    const Mask below = hn::Lt(cell.trial, hn::Neg(lower.value));
    // Where both limits are zero nothing can stick, not even a trial of zero.
    const Mask holds = hn::Gt(hn::Max(upper.value, lower.value), hn::Zero(tag));
    const V elastic = hn::IfThenElseZero(holds, stick);
    const V q_chi = hn::IfThenElse(above, upper.chi, hn::IfThenElse(below, hn::Neg(lower.chi), elastic));
    const V q_eps = hn::IfThenElse(above, upper.eps, hn::IfThenElse(below, hn::Neg(lower.eps), hn::Zero(tag)));
    const V mid_chi = hn::MulAdd(half, q_chi, quarter.edge.chi);
    const V mid_eps = hn::MulAdd(half, q_eps, quarter.edge.eps);
    quarter.edge.chi = hn::MulAdd(half, q_chi, mid_chi);
    quarter.edge.eps = hn::MulAdd(half, q_eps, mid_eps);
    quarter.sum_of_force.chi = hn::Add(quarter.sum_of_force.chi, mid_chi);
    quarter.sum_of_force.eps = hn::Add(quarter.sum_of_force.eps, mid_eps);
    quarter.sum_of_moment.chi = hn::MulAdd(weight, q_chi, quarter.sum_of_moment.chi);
    quarter.sum_of_moment.eps = hn::MulAdd(weight, q_eps, quarter.sum_of_moment.eps);
  }
  return cell;
}

/// The whole march of one register of points. `on_cell` sees every cell, `on_layer` the load of every layer.
template <bool kTangent, class Watcher>
HWY_INLINE Dual<kTangent> march(const PlanarCoefficients& c, const double* q, V eps, V dchi, Watcher& watcher) {
  const V zero = hn::Zero(tag);
  const std::size_t cells = c.cosine.size();
  Dual<kTangent> moment{zero, zero, zero};
  Dual<kTangent> f_int{zero, zero, zero};
  for (const Layer& layer : c.layers) {
    const auto load = load_of<kTangent>(layer, eps, f_int);
    auto tension = Quarter<kTangent>::zero();
    auto compression = Quarter<kTangent>::zero();
    watcher.template on_layer<kTangent>(layer, load);
    // Both sides in one loop: two independent chains keep the arithmetic units busy.
    for (std::size_t i = 0; i < cells; ++i) {
      const double* q_tension = q + i * block_lanes;
      const double* q_compression = q + (cells + i) * block_lanes;
      const V q0 = hn::Load(tag, q_tension);
      const V q1 = hn::Load(tag, q_compression);
      const CellResult t = advance<true, kTangent>(layer, load, c.cosine[i], dchi, q0, tension);
      const CellResult p = advance<false, kTangent>(layer, load, c.cosine[i], dchi, q1, compression);
      watcher.on_cell(layer, c.cosine[i], std::array<CellResult, 2>{t, p}, std::array<V, 2>{q0, q1},
                      static_cast<std::size_t>(q_tension - q), static_cast<std::size_t>(q_compression - q));
    }
    q += 2 * cells * block_lanes;
    watcher.end_layer(2 * cells * block_lanes);

    const V weight = set(layer.weight);
    const V mean = set(c.mean_weight * layer.kappa);
    const V inner =
        hn::MulAdd(mean, hn::Add(tension.sum_of_force.value, compression.sum_of_force.value), load.inner.value);
    const V inverse_c_int = set(layer.inverse_c_int);
    moment.value =
        hn::MulAdd(weight, hn::Add(tension.sum_of_moment.value, compression.sum_of_moment.value), moment.value);
    f_int.value = hn::Mul(inverse_c_int, hn::Max(zero, inner));
    if constexpr (kTangent) {
      const Mask closed = hn::Gt(inner, zero);
      const V inner_chi =
          hn::MulAdd(mean, hn::Add(tension.sum_of_force.chi, compression.sum_of_force.chi), load.inner.chi);
      const V inner_eps =
          hn::MulAdd(mean, hn::Add(tension.sum_of_force.eps, compression.sum_of_force.eps), load.inner.eps);
      f_int.chi = hn::IfThenElseZero(closed, hn::Mul(inverse_c_int, inner_chi));
      f_int.eps = hn::IfThenElseZero(closed, hn::Mul(inverse_c_int, inner_eps));
      moment.chi = hn::MulAdd(weight, hn::Add(tension.sum_of_moment.chi, compression.sum_of_moment.chi), moment.chi);
      moment.eps = hn::MulAdd(weight, hn::Add(tension.sum_of_moment.eps, compression.sum_of_moment.eps), moment.eps);
    }
  }
  return moment;
}

/// The rows of a block that one register of lanes sees.
struct Rows {
  const double* at;
  V operator[](std::size_t row) const { return hn::Load(tag, at + row * block_lanes); }
};

/// True where no angle of the point can slip between the reference state and (eps, reference_chi + dchi). A range of no
/// width, as friction limits of zero leave it, holds nothing.
HWY_INLINE Mask sticks(const Rows& row, V eps, V dchi) {
  const V zero = hn::Zero(tag);
  const V drop = hn::Mul(hn::Max(zero, hn::Sub(row[reference_eps], eps)), row[inverse_drop]);
  const V low = hn::MulAdd(drop, hn::Sub(row[stick_low_slack], row[stick_low]), row[stick_low]);
  const V high = hn::MulAdd(drop, hn::Sub(row[stick_high_slack], row[stick_high]), row[stick_high]);
  return hn::And(hn::Le(drop, set(1)), hn::And(hn::Gt(dchi, low), hn::Lt(dchi, high)));
}

/// Lanes of the register beginning at point `first` that are padding. They are at rest and count as stuck.
HWY_INLINE Mask padding(std::size_t first, std::size_t points) {
  return hn::Not(hn::FirstN(tag, points > first ? points - first : 0));
}

struct NoWatcher {
  template <bool kTangent>
  void on_layer(const Layer&, const LayerLoad<kTangent>&) {}
  void on_cell(const Layer&, double, const std::array<CellResult, 2>&, const std::array<V, 2>&, std::size_t,
               std::size_t) {}
  void end_layer(std::size_t) {}
};

template <bool kTangent>
std::size_t respond_all(const PlanarCoefficients& c, const double* history, const Strains& strains,
                        const Response& out) {
  const std::size_t block_size = rows_of_block(c) * block_lanes;
  std::size_t marched = 0;
  for (std::size_t first = 0; first < padded(strains.points); first += hn::Lanes(tag)) {
    const std::size_t lane = first % block_lanes;
    const Rows row{history + first / block_lanes * block_size + lane};
    const V eps = hn::Load(tag, strains.eps + first);
    const V chi = hn::Load(tag, strains.chi + first);
    const V dchi = hn::Sub(chi, row[reference_chi]);
    const Mask stuck = hn::Or(sticks(row, eps, dchi), padding(first, strains.points));

    Dual<kTangent> M{hn::MulAdd(set(c.EI_friction), dchi, row[reference_M]), set(c.EI_friction), hn::Zero(tag)};
    if (!hn::AllTrue(tag, stuck)) {
      NoWatcher nobody;
      const auto swept = march<kTangent>(c, row.at + scalar_rows * block_lanes, eps, dchi, nobody);
      M.value = hn::IfThenElse(stuck, M.value, swept.value);
      if constexpr (kTangent) {
        M.chi = hn::IfThenElse(stuck, M.chi, swept.chi);
        M.eps = hn::IfThenElse(stuck, M.eps, swept.eps);
      }
      marched += hn::CountTrue(tag, hn::Not(stuck));
    }
    hn::Store(hn::Mul(set(c.EA), eps), tag, out.N + first);
    hn::Store(hn::MulAdd(set(c.EI_min), chi, M.value), tag, out.M + first);
    if constexpr (kTangent) {
      hn::Store(hn::Add(set(c.EI_min), M.chi), tag, out.dM_dchi + first);
      hn::Store(M.eps, tag, out.dM_deps + first);
    }
  }
  return marched;
}

/// Watches a march to its end: energies of the step, the new gradients, and who slips.
struct EnergyWatcher {
  double* q_new;
  Mask stuck;
  V chi_before;  // committed minus reference
  V stored, dissipated, trapezoid;
  Mask slips;

  template <bool kTangent>
  void on_layer(const Layer&, const LayerLoad<kTangent>&) {}

  void on_cell(const Layer& layer, double cosine, const std::array<CellResult, 2>& cells, const std::array<V, 2>& q0,
               std::size_t tension_offset, std::size_t compression_offset) {
    const V stick = set(layer.k * cosine);
    const V per_k = set(1 / layer.k);
    const V half = set(0.5);
    for (std::size_t side = 0; side < 2; ++side) {
      const V q = cells[side].q;
      const V before = hn::MulAdd(stick, chi_before, q0[side]);
      const V weight = set(layer.weight);
      const V slip = hn::Mul(hn::Sub(cells[side].trial, q), per_k);
      const V rounding = hn::Mul(set(1e-12), hn::Abs(q));
      slips = hn::Or(slips, hn::Gt(hn::Abs(hn::Sub(cells[side].trial, q)), rounding));
      const V at_end = hn::Mul(q, slip);
      const V at_mean = hn::Mul(hn::Mul(half, hn::Add(q, before)), slip);
      dissipated = hn::MulAdd(weight, hn::Max(at_end, at_mean), dissipated);
      trapezoid = hn::MulAdd(weight, at_mean, trapezoid);
      stored = hn::MulAdd(hn::Mul(weight, hn::Mul(half, per_k)), hn::Mul(q, q), stored);
      hn::Store(hn::IfThenElse(stuck, q0[side], q), tag, q_new + (side == 0 ? tension_offset : compression_offset));
    }
  }

  void end_layer(std::size_t size) { q_new += size; }
};

/// Watches a march that goes nowhere: the box of curvature in which the committed gradients stay within their limits.
struct BoxWatcher {
  V low, high, low_slack, high_slack;
  V drop;                 // strain drop of the slack box
  V numerator;            // of the layer under way
  double growth = 0;      // [N m] bending force at the cell's edge per curvature while all stick
  bool outermost = true;  // the next layer is the first

  template <bool kTangent>
  void on_layer(const Layer& layer, const LayerLoad<kTangent>& load) {
    numerator = load.numerator.value;
    growth = 0;
    if (outermost && layer.limit_per_strain > 0) {
      // A quarter of the strain that would unload the outermost layer: far enough to serve a vibration, near enough
      // to leave room for curvature in the slack box.
      drop = hn::Mul(set(0.25 / layer.limit_per_strain), hn::Max(hn::Zero(tag), numerator));
    }
    outermost = false;
  }

  void on_cell(const Layer& layer, double cosine, const std::array<CellResult, 2>& cells, const std::array<V, 2>&,
               std::size_t, std::size_t) {
    const double mid_growth = growth + layer.half_step * layer.k * cosine;
    growth = mid_growth + layer.half_step * layer.k * cosine;
    for (std::size_t side = 0; side < 2; ++side) {
      // |q + stick d| <= limit + follow d with d the curvature yet to come: two half-planes.
      const V q = cells[side].q;
      const double follow = (side == 0 ? 1 : -1) * layer.slope * mid_growth;
      const V limit = hn::MulAdd(set(layer.slope), cells[side].mid_force, numerator);
      const V lost = hn::Mul(set(layer.limit_per_strain), drop);
      narrow(layer.k * cosine - follow, hn::Sub(limit, q), lost);
      narrow(-layer.k * cosine - follow, hn::Add(limit, q), lost);
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

  void end_layer(std::size_t) {}
};

HWY_INLINE void replace(double* row_of_lanes, Mask keep, V value) {
  hn::Store(hn::IfThenElse(keep, hn::Load(tag, row_of_lanes), value), tag, row_of_lanes);
}

std::size_t commit_all(const PlanarCoefficients& c, double* history, const Strains& strains, const Energies& out) {
  const std::size_t block_size = rows_of_block(c) * block_lanes;
  const V zero = hn::Zero(tag);
  const V half = set(0.5);
  std::size_t marched = 0;
  for (std::size_t first = 0; first < padded(strains.points); first += hn::Lanes(tag)) {
    const std::size_t lane = first % block_lanes;
    double* at = history + first / block_lanes * block_size + lane;
    const Rows row{at};
    const auto writable = [at](std::size_t index) HWY_ATTR { return at + index * block_lanes; };
    const V eps = hn::Load(tag, strains.eps + first);
    const V chi = hn::Load(tag, strains.chi + first);
    const V dchi = hn::Sub(chi, row[reference_chi]);
    const Mask stuck = hn::Or(sticks(row, eps, dchi), padding(first, strains.points));

    // Sticking from the reference on: the potential is a parabola, nothing is lost, the reference stays.
    const V EI_f = set(c.EI_friction);
    V stored = hn::MulAdd(dchi, hn::MulAdd(hn::Mul(half, EI_f), dchi, row[reference_M]), row[reference_U]);
    V dissipated = zero;
    V quadrature_error = zero;
    if (!hn::AllTrue(tag, stuck)) {
      double* q = at + scalar_rows * block_lanes;
      EnergyWatcher w{.q_new = q,
                      .stuck = stuck,
                      .chi_before = hn::Sub(row[committed_chi], row[reference_chi]),
                      .stored = zero,
                      .dissipated = zero,
                      .trapezoid = zero,
                      .slips = hn::Not(hn::Eq(zero, zero))};
      const V M = march<false>(c, q, eps, dchi, w).value;
      stored = hn::IfThenElse(stuck, stored, w.stored);
      dissipated = hn::IfThenElse(stuck, zero, w.dissipated);
      quadrature_error = hn::IfThenElse(stuck, zero, hn::Sub(w.dissipated, w.trapezoid));
      replace(writable(reference_chi), stuck, chi);
      replace(writable(reference_eps), stuck, eps);
      replace(writable(reference_M), stuck, M);
      replace(writable(reference_U), stuck, w.stored);

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
    const V linear = hn::MulAdd(hn::Mul(set(c.EA), eps), eps, hn::Mul(hn::Mul(set(c.EI_min), chi), chi));
    hn::Store(hn::MulAdd(half, linear, stored), tag, out.stored + first);
    hn::Store(dissipated, tag, out.dissipated + first);
    hn::Store(quadrature_error, tag, out.quadrature_error + first);
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
}  // namespace strandyn::section::kernel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace strandyn::section {
namespace kernel {

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

}  // namespace kernel

VectorTarget vector_target() {
  return kernel::target_in_use();
}

}  // namespace strandyn::section
#endif
