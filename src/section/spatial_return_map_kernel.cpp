// Highway reads this file once per instruction set; the best that the machine has is chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spatial_return_map_kernel.cpp"
#include "spatial_return_map_kernel.hpp"

#include <hwy/foreach_target.h>

#include <numbers>

#include "slip_energy-inl.hpp"
#include "spatial_return_map_kite-inl.hpp"
#include "spatial_return_map_tangent-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::spatial_kernel {
namespace HWY_NAMESPACE {
using namespace kernel::HWY_NAMESPACE;

HWY_INLINE Unknowns guess_of(const Rows& head) {
  Unknowns at;
  for (std::size_t j = 0; j < quarters; ++j) at.start[j] = head[start_of_quarter + j];
  at.mean = head[closure];
  return at;
}

/// A layer whose march is done.
struct Solved {
  std::size_t index;  // in the coefficients
  Load load;
  Limits limits;
  const double* q;  // of the reference
  Unknowns at;
  Turn turn;
  V inner;  // the load on its inner contact, not yet clamped
};

/// All layers of one register of points. `after_layer(solved)` sees each.
template <bool kRecord, class AfterLayer>
HWY_INLINE Resultants march(const SpatialCoefficients& c, const double* layers, const Point& p, const Bending& bending,
                            const Record& record, AfterLayer& after_layer) {
  const V zero = hn::Zero(tag);
  Resultants sum{zero, zero, zero, zero};
  Dual<false> f_int{zero};
  for (std::size_t j = 0; j < c.layers.size(); ++j) {
    const Layer& layer = c.layers[j];
    const double* head = layers + j * rows_of_layer(c) * block_lanes;
    const double* q = head + layer_scalar_rows * block_lanes;
    const V force = hn::MulAdd(set(layer.force_per_strain), p[Component::axial],
                               hn::Mul(set(layer.force_per_twist), p[Component::torsion]));
    const Load load = load_of(layer, set(layer.kappa), force, f_int);
    const Limits limits = limits_of(layer, load);
    Unknowns at = guess_of(Rows{head});
    const Turn turn = solve_layer<kRecord>(c, layer, limits, q, bending, at, record);
    sum[0] = hn::MulAdd(set(layer.axial_weight), turn.force, sum[0]);
    sum[1] = hn::MulAdd(set(layer.torsion_weight), turn.force, sum[1]);
    sum[2] = hn::MulAdd(set(layer.weight), turn.moment2, sum[2]);
    sum[3] = hn::MulAdd(set(layer.weight), turn.moment3, sum[3]);
    const V inner = hn::MulAdd(set(layer.kappa / c.points), turn.force, load.inner.value);
    f_int = handed_inward(layer, Dual<false>{inner});
    after_layer(Solved{j, load, limits, q, at, turn, inner});
  }
  return sum;
}

template <bool kTangent>
std::size_t respond_all(const SpatialCoefficients& c, const double* history, const Strains& strains,
                        const Response& out) {
  const V zero = hn::Zero(tag);
  const V EI_f = set(c.EI_friction);
  const double linear[2][2] = {{c.EA, c.C_AT}, {c.C_AT, c.GJ}};
  const std::size_t turn_size = static_cast<std::size_t>(c.points) * block_lanes;
  AlignedVector scratch(kTangent ? 3 * turn_size : 0);
  const Record record{scratch.data(), scratch.data() + (kTangent ? turn_size : 0),
                      scratch.data() + (kTangent ? 2 * turn_size : 0)};
  std::size_t marched = 0;
  for (const Register here : Registers{strains.points}) {
    const Rows row{here.rows(history, rows_of_block(c))};
    const Point p = point_at(strains, here);
    const V chi2 = p[Component::bending2];
    const V chi3 = p[Component::bending3];
    Bending bending{hn::Sub(chi2, row[reference_chi2]), hn::Sub(chi3, row[reference_chi3]), zero};
    const Mask idle = here.padding(strains.points);
    const Mask stuck = c.axial_resultants ? idle : hn::Or(sticks(c, row, p, bending), idle);

    Resultants friction{zero, zero, hn::MulAdd(EI_f, bending.d2, row[reference_M2]),
                        hn::MulAdd(EI_f, bending.d3, row[reference_M3])};
    std::array<Resultants, component_count> tangent;
    for (Resultants& r : tangent) r = {zero, zero, zero, zero};
    if (!hn::AllTrue(tag, stuck)) {
      bending.neutral = neutral_cell(c.points, chi2, chi3, row[neutral]);
      const std::array<V, 2> neutral_by_chi = neutral_by_curvature(c.points, chi2, chi3);
      Resultants f_int{zero, zero, zero, zero};
      const auto differentiate = [&](const Solved& l) HWY_ATTR {
        if constexpr (kTangent) {
          add_tangent(c, c.layers[l.index], record, l.turn, l.at, bending.neutral, l.inner, neutral_by_chi, f_int,
                      tangent);
        }
      };
      const Resultants swept =
          march<kTangent>(c, row.at + scalar_rows * block_lanes, p, bending, record, differentiate);
      for (std::size_t r = 2; r < component_count; ++r) friction[r] = hn::IfThenElse(stuck, friction[r], swept[r]);
      if (c.axial_resultants) friction[0] = swept[0], friction[1] = swept[1];
      marched += hn::CountTrue(tag, hn::Not(stuck));
    }
    here.store(hn::MulAdd(set(c.EA), p.strain[0], hn::MulAdd(set(c.C_AT), p.strain[1], friction[0])), out.stress[0]);
    here.store(hn::MulAdd(set(c.C_AT), p.strain[0], hn::MulAdd(set(c.GJ), p.strain[1], friction[1])), out.stress[1]);
    here.store(hn::MulAdd(set(c.EI_min), chi2, friction[2]), out.stress[2]);
    here.store(hn::MulAdd(set(c.EI_min), chi3, friction[3]), out.stress[3]);
    if constexpr (kTangent) {
      for (std::size_t r = 0; r < component_count; ++r) {
        for (std::size_t y = 0; y < component_count; ++y) {
          V value = tangent[r][y];
          if (r < 2 && !c.axial_resultants) value = zero;
          if (r >= 2) value = hn::IfThenElse(stuck, r == y ? EI_f : zero, value);
          const double constant = r < 2 && y < 2 ? linear[r][y] : r == y ? c.EI_min : 0;
          here.store(hn::Add(value, set(constant)), out.stiffness[r][y]);
        }
      }
    }
  }
  return marched;
}

/// Watches the replay of a committed layer: energies of the step, the new gradients, the kite's extent along its axis.
struct CommitVisitor {
  const SpatialCoefficients& c;
  Mask stuck;
  V before2, before3;  // committed minus reference curvature
  V axis2, axis3;
  SlipEnergy energy;
  Kite kite;
  const Layer* layer;
  V numerator;
  double* q_new;

  HWY_INLINE void on_cell(const Cell& cell, V base, V q_reference, std::size_t quarter, std::size_t i) {
    const double cosines[] = {c.cosine[i], -c.sine[i], -c.cosine[i], c.sine[i]};
    const double sines[] = {c.sine[i], c.cosine[i], -c.sine[i], -c.cosine[i]};
    const V e_before = hn::MulAdd(set(cosines[quarter]), before2, hn::Mul(set(sines[quarter]), before3));
    energy.add(*layer, hn::MulAdd(set(layer->k), e_before, q_reference), cell.trial, cell.q);
    hn::Store(hn::IfThenElse(stuck, q_reference, cell.q), tag, q_new + (quarter * c.cosine.size() + i) * block_lanes);

    const V limit = hn::MulAdd(set(layer->slope), hn::MulAdd(set(layer->half_step), cell.q, base), numerator);
    half_planes(c, *layer, quarter, i, axis2, axis3, limit, cell.q,
                [&](V along, V, V room) HWY_ATTR { kite.narrow_along(layer->k, along, room); });
  }
};

/// Second part of the kite, from the stored state; returns how much a turn of the neutral plane may cost.
HWY_INLINE V widen(const SpatialCoefficients& c, const double* layers, CommitVisitor& w) {
  const std::size_t cells = c.cosine.size();
  V offset = hn::Zero(tag);
  for (std::size_t j = 0; j < c.layers.size(); ++j) {
    const Layer& layer = c.layers[j];
    const Rows head{layers + j * rows_of_layer(c) * block_lanes};
    const Rows q{head.at + layer_scalar_rows * block_lanes};
    const Unknowns at = guess_of(head);
    const V numerator = head[reference_numerator];
    // F_0 moves by (q + q opposite - 2 mean)/2 R/sin a per angle; the angle modulo pi is at most pi/2 times its sine.
    const V per_turn = set(std::numbers::pi / 2 * layer.half_step / c.dtheta / layer.force_per_strain);
    for (std::size_t quarter = 0; quarter < quarters; ++quarter) {
      V base = at.start[quarter];
      for (std::size_t i = 0; i < cells; ++i) {
        const V here = q[quarter * cells + i];
        const V limit = hn::MulAdd(set(layer.slope), hn::MulAdd(set(layer.half_step), here, base), numerator);
        half_planes(c, layer, quarter, i, w.axis2, w.axis3, limit, here,
                    [&](V along, V across, V room) HWY_ATTR { w.kite.narrow_at_middle(layer, along, across, room); });
        base = hn::MulAdd(set(2 * layer.half_step), hn::Sub(here, at.mean), base);
        if (quarter >= quarters / 2) continue;
        const V both = hn::Add(here, q[(quarter + quarters / 2) * cells + i]);
        offset = hn::Max(offset, hn::Mul(per_turn, hn::Abs(hn::NegMulAdd(set(2), at.mean, both))));
      }
    }
  }
  return offset;
}

std::size_t commit_all(const SpatialCoefficients& c, double* history, const Strains& strains, const Energies& out) {
  const V zero = hn::Zero(tag);
  const V half = set(0.5);
  const V EI_f = set(c.EI_friction);
  std::size_t marched = 0;
  for (const Register here : Registers{strains.points}) {
    double* at = here.rows(history, rows_of_block(c));
    const Rows row{at};
    const auto writable = [at](std::size_t index) HWY_ATTR { return at + index * block_lanes; };
    const Point p = point_at(strains, here);
    const V chi2 = p[Component::bending2];
    const V chi3 = p[Component::bending3];
    Bending bending{hn::Sub(chi2, row[reference_chi2]), hn::Sub(chi3, row[reference_chi3]), zero};
    bending.neutral = neutral_cell(c.points, chi2, chi3, row[neutral]);
    const Mask stuck = hn::Or(sticks(c, row, p, bending), here.padding(strains.points));

    // Sticking from the reference on: the potential is a paraboloid, nothing is lost, the reference stays.
    V stored = hn::MulAdd(bending.d2, hn::MulAdd(hn::Mul(half, EI_f), bending.d2, row[reference_M2]), row[reference_U]);
    stored = hn::MulAdd(bending.d3, hn::MulAdd(hn::Mul(half, EI_f), bending.d3, row[reference_M3]), stored);
    V dissipated = zero;
    V quadrature_error = zero;
    if (!hn::AllTrue(tag, stuck)) {
      double* layers = writable(scalar_rows);
      V axis2 = hn::Sub(chi2, row[committed_chi2]);
      V axis3 = hn::Sub(chi3, row[committed_chi3]);
      const V length = hn::Sqrt(hn::MulAdd(axis2, axis2, hn::Mul(axis3, axis3)));
      const Mask moved = hn::Gt(length, set(1e-30));
      const V normalize = hn::Div(set(1), hn::IfThenElse(moved, length, set(1)));
      axis2 = hn::IfThenElse(moved, hn::Mul(axis2, normalize), set(1));
      axis3 = hn::IfThenElseZero(moved, hn::Mul(axis3, normalize));

      CommitVisitor w{.c = c,
                      .stuck = stuck,
                      .before2 = hn::Sub(row[committed_chi2], row[reference_chi2]),
                      .before3 = hn::Sub(row[committed_chi3], row[reference_chi3]),
                      .axis2 = axis2,
                      .axis3 = axis3,
                      .energy = SlipEnergy::zero(),
                      .kite = Kite::whole(),
                      .layer = nullptr,
                      .numerator = zero,
                      .q_new = nullptr};
      const auto keep = [&](const Solved& l) HWY_ATTR {
        const Layer& layer = c.layers[l.index];
        double* head = layers + l.index * rows_of_layer(c) * block_lanes;
        w.layer = &layer;
        w.numerator = l.load.numerator.value;
        w.q_new = head + layer_scalar_rows * block_lanes;
        replay(c, layer, l.limits, l.q, bending, l.at, w);
        for (std::size_t quarter = 0; quarter < quarters; ++quarter) {
          replace(head + (start_of_quarter + quarter) * block_lanes, stuck, l.at.start[quarter]);
        }
        replace(head + closure * block_lanes, stuck, l.at.mean);
        replace(head + reference_numerator * block_lanes, stuck, l.load.numerator.value);
      };
      const Resultants friction = march<false>(c, layers, p, bending, Record{}, keep);
      const V offset = widen(c, layers, w);
      stored = hn::IfThenElse(stuck, stored, w.energy.stored);
      dissipated = hn::IfThenElse(stuck, zero, w.energy.dissipated);
      quadrature_error = hn::IfThenElse(stuck, zero, w.energy.quadrature_error());

      const V length_of_kite = hn::Mul(half, hn::Sub(w.kite.high, w.kite.low));
      // A kite of no length holds nothing: where limits are zero even a curvature that has not moved yet slips.
      const V middle = hn::IfThenElse(hn::Gt(length_of_kite, zero), w.kite.middle(), set(no_kite));
      const auto inverse = [](V x) HWY_ATTR { return hn::Div(set(1), hn::Max(x, set(1 / without_bound))); };
      struct Renewed {
        Row at;
        V value;
      };
      const Renewed renewed[] = {{reference_eps, p[Component::axial]},
                                 {reference_twist, p[Component::torsion]},
                                 {reference_chi2, chi2},
                                 {reference_chi3, chi3},
                                 {reference_M2, friction[2]},
                                 {reference_M3, friction[3]},
                                 {reference_U, w.energy.stored},
                                 {Row::axis2, axis2},
                                 {Row::axis3, axis3},
                                 {stick_middle, middle},
                                 {inverse_length, inverse(length_of_kite)},
                                 {inverse_width, inverse(w.kite.width)},
                                 {inverse_drop, inverse(w.kite.drop)},
                                 {offset_drop, offset}};
      for (const Renewed& r : renewed) replace(writable(r.at), stuck, r.value);
      marched += hn::CountTrue(tag, hn::Not(stuck));
    }
    hn::Store(p[Component::axial], tag, writable(committed_eps));
    hn::Store(p[Component::torsion], tag, writable(committed_twist));
    hn::Store(chi2, tag, writable(committed_chi2));
    hn::Store(chi3, tag, writable(committed_chi3));
    hn::Store(bending.neutral, tag, writable(neutral));
    book(out, here, twice_linear_energy(c, p), stored, dissipated, quadrature_error);
  }
  return marched;
}

std::size_t respond_here(const SpatialCoefficients& c, const double* history, const Strains& strains,
                         const Response& out) {
  return out.tangent ? respond_all<true>(c, history, strains, out) : respond_all<false>(c, history, strains, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::spatial_kernel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace strandyn::section::spatial_kernel {

HWY_EXPORT(respond_here);
HWY_EXPORT(commit_all);

std::size_t respond(const SpatialCoefficients& c, const double* history, const Strains& strains, const Response& out) {
  return HWY_DYNAMIC_DISPATCH(respond_here)(c, history, strains, out);
}

std::size_t commit(const SpatialCoefficients& c, double* history, const Strains& strains, const Energies& out) {
  return HWY_DYNAMIC_DISPATCH(commit_all)(c, history, strains, out);
}

}  // namespace strandyn::section::spatial_kernel
#endif
