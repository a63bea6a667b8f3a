// Highway reads this file once per instruction set; the best that the machine has is chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spatial_compliant_kernel.cpp"
#include "spatial_compliant_kernel.hpp"

#include <hwy/foreach_target.h>

#include "spatial_compliant_turn-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::spatial_compliant_kernel {
namespace HWY_NAMESPACE {

constexpr std::size_t strain_columns = component_count;

/// One register of points on its way from the committed state.
struct Trial {
  Point to;
  V step2, step3;  // of the curvature
  V last2, last3;  // and in the last committed step
  V neutral;       // in cells
  const double* cells;
  bool windows;  // see Cell
};

/// What a march works in; made once per call. Columns: by the four strains, then by start and mean of every layer.
struct Bench {
  explicit Bench(const SpatialCompliantCoefficients& c)
      : start(c.angle.layers.size()),
        sums(c.angle.layers.size()),
        variation(c.angle.layers.size()),
        at_neutral(c.angle.layers.size()),
        slips(2 * c.angle.layers.size() * c.cosine.size()),
        slips_by(2 * c.angle.layers.size() * 2 * c.angle.layers.size() * c.cosine.size()),
        contacts(c.angle),
        columns(strain_columns + 2 * c.angle.layers.size(), Column(c.angle.layers.size())) {
    columns[static_cast<std::size_t>(Component::axial)].eps = 1;
    columns[static_cast<std::size_t>(Component::torsion)].twist = 1;
    columns[static_cast<std::size_t>(Component::bending2)].chi2 = 1;
    columns[static_cast<std::size_t>(Component::bending3)].chi3 = 1;
    for (std::size_t i = 0; i < c.angle.layers.size(); ++i) {
      columns[strain_columns + 2 * i].start_of = i;
      columns[strain_columns + 2 * i + 1].mean_of = i;
    }
  }
  Wires wires;
  PerLayer edge;
  LaneRows start;       // [N] unknown, with sums.mean
  Sums sums;            // of the gradients
  LaneRows variation;   // sum of |q|
  LaneRows at_neutral;  // q of the two cells in which the neutral plane lies
  LaneRows slips;       // of all cells, as the last march left them
  LaneRows slips_by;    // [unknown][slip] their derivatives
  ContactRows contacts;
  std::vector<Column> columns;
};

/// What is known of the load of every inner contact before a cell is solved.
HWY_INLINE void load_of(const SpatialCompliantCoefficients& c, const Point& to, Bench& bench) {
  for (std::size_t i = 0; i < c.angle.layers.size(); ++i) {
    const PlanarLayer& p = c.angle.planar.layers[i];
    const Layer& layer = c.angle.layers[i];
    V alone = hn::MulAdd(set(p.kappa * p.force_per_strain), to[Component::axial], set(p.inner_residual));
    alone = hn::MulAdd(set(p.kappa * p.force_per_twist), to[Component::torsion], alone);
    const Sides edge = mul_add(both(p.kappa), bench.edge[i], both(alone));
    bench.wires.load.set(i, neg_mul_add(own_load(layer), both(bench.sums.mean[i]), edge));
  }
}

/// One march around the turn with the unknowns at hand. `again`: the slips of the march before are the first guess.
/// Columns from `first_column` on go along. `on_cell(cell, wires)` sees every cell.
template <class OnCell>
HWY_INLINE void march(const SpatialCompliantCoefficients& c, const Trial& trial, Bench& bench, bool again,
                      std::size_t first_column, const OnCell& on_cell) {
  const V zero = hn::Zero(tag);
  const std::size_t layers = c.angle.layers.size();
  const std::size_t quarter = c.cosine.size() / 2;
  Wires& w = bench.wires;
  bench.sums.begin();
  for (std::size_t i = 0; i < layers; ++i) {
    bench.sums.begin(i, bench.start[i], bench.sums.mean[i], bench.edge);
    bench.variation.set(i, zero);
    bench.at_neutral.set(i, zero);
  }
  for (std::size_t k = first_column; k < bench.columns.size(); ++k) bench.columns[k].begin(layers);
  if (layers == 0) return;
  const V opposite = hn::Sub(set(static_cast<double>(c.cosine.size())), trial.neutral);
  const double* springs = trial.cells;
  for (std::size_t n = 0; n < c.cosine.size(); ++n) {
    const double here = static_cast<double>(n);
    const Place place{.cosine = c.cosine[n],
                      .sine = c.sine[n],
                      .share = {share_before(trial.neutral, here), share_before(opposite, here)}};
    const V along = hn::Mul(set(place.cosine), trial.step2);
    const V across = hn::Mul(set(place.sine), trial.step3);
    const V along_last = hn::Mul(set(place.cosine), trial.last2);
    const V across_last = hn::Mul(set(place.sine), trial.last3);
    const Cell cell{.angle = n < quarter ? n : c.cosine.size() - 1 - n,
                    .springs = springs,
                    .stiffness = bench.contacts.now.data(),
                    .windows = trial.windows,
                    .e_step = {hn::Add(along, across), hn::Sub(along, across)},
                    .onward = {onward(hn::Add(along, across), hn::Add(along_last, across_last)),
                               onward(hn::Sub(along, across), hn::Sub(along_last, across_last))}};
    load_of(c, trial.to, bench);
    begin(c.angle, cell, w);
    const std::size_t first_slip = 2 * layers * n;
    SideMasks guessed = above(both(0), both(0));
    if (again) {
      for (std::size_t i = 0; i < layers; ++i) {
        w.slip.set(i, {bench.slips[first_slip + 2 * i], bench.slips[first_slip + 2 * i + 1]});
      }
    } else {
      guessed = guess(c.angle, cell, w);
    }
    solve(c.angle, cell, guessed, w);
    if (first_column < bench.columns.size()) eliminate(c.angle, w);
    for (std::size_t k = first_column; k < bench.columns.size(); ++k) {
      bench.columns[k].add(c, place, bench.contacts.now_eps.data(), w);
      if (k < strain_columns) continue;
      const std::size_t at = (k - strain_columns) * 2 * layers * c.cosine.size() + first_slip;
      for (std::size_t i = 0; i < layers; ++i) {
        const Sides slip = bench.columns[k].by.slip[i];
        bench.slips_by.set(at + 2 * i, slip.t);
        bench.slips_by.set(at + 2 * i + 1, slip.c);
      }
    }
    const Mask plane_t = hn::And(hn::Ge(trial.neutral, set(here)), hn::Lt(trial.neutral, set(here + 1)));
    const Mask plane_c = hn::And(hn::Gt(opposite, set(here)), hn::Le(opposite, set(here + 1)));
    for (std::size_t i = 0; i < layers; ++i) {
      const Sides q = w.q[i];
      const Sides slip = w.slip[i];
      bench.slips.set(first_slip + 2 * i, slip.t);
      bench.slips.set(first_slip + 2 * i + 1, slip.c);
      bench.variation.add(i, hn::Add(hn::Abs(q.t), hn::Abs(q.c)));
      bench.at_neutral.add(i, hn::Add(hn::IfThenElseZero(plane_t, q.t), hn::IfThenElseZero(plane_c, q.c)));
    }
    bench.sums.add(c, place, w.q, bench.edge);
    on_cell(cell, w);
    springs += 2 * compliant_kernel::rows_of_cell(c.angle) * block_lanes;
  }
}

/// Where the slips will be once the unknowns have changed, if no spring changes between stick and slip.
HWY_INLINE void foresee_slips(Bench& bench, const LaneRows& change, std::size_t unknowns, std::size_t slips) {
  for (std::size_t k = 0; k < unknowns; ++k) {
    const V by = change[k];
    for (std::size_t i = 0; i < slips; ++i) {
      bench.slips.set(i, hn::MulAdd(by, bench.slips_by[k * slips + i], bench.slips[i]));
    }
  }
}

/// Points whose force closes around the turn.
HWY_INLINE Mask closed(const SpatialCompliantCoefficients& c, const Bench& bench) {
  constexpr double tolerance = 1e-12;  // of the way that the wire force travels in a turn
  Mask all = hn::Eq(hn::Zero(tag), hn::Zero(tag));
  for (std::size_t i = 0; i < c.angle.layers.size(); ++i) {
    const PlanarLayer& p = c.angle.planar.layers[i];
    const V scale = hn::MulAdd(set(2 * p.half_step), bench.variation[i], set(1e-9 * p.force_per_strain));
    const V largest = hn::Max(hn::Abs(joint_of(bench.edge, i)), hn::Abs(bench.sums.neutral[i]));
    all = hn::And(all, hn::Le(largest, hn::Mul(set(tolerance), scale)));
  }
  return all;
}

/// Marches until the unknowns of all layers fit; columns from `first_column` belong to the last march.
///
/// A solved point waits unchanged for its neighbours. Whatever the unknowns are, limits are >= 0 and the ledger closes.
HWY_INLINE void solve_turn(const SpatialCompliantCoefficients& c, const Trial& trial, Bench& bench,
                           std::size_t first_column) {
  constexpr int most_corrections = 12;
  const auto look_on = [](const Cell&, const Wires&) {};
  const std::size_t layers = c.angle.layers.size();
  std::size_t from = first_column;
  bool again = false;
  for (int correction = 0;;) {
    march(c, trial, bench, again, from, look_on);
    again = true;
    const Mask solved = closed(c, bench);
    if (correction == most_corrections || hn::AllTrue(tag, solved)) return;
    if (from == bench.columns.size()) {
      from = strain_columns;  // the same again with its derivatives
      continue;
    }
    const Closure closure(c, bench.columns.data() + strain_columns);
    LaneRows change(2 * layers);
    for (std::size_t i = 0; i < layers; ++i) {
      change.set(2 * i, bench.sums.neutral[i]);
      change.set(2 * i + 1, joint_of(bench.edge, i));
    }
    closure.solve(change);
    for (std::size_t k = 0; k < 2 * layers; ++k) change.set(k, hn::IfThenZeroElse(solved, change[k]));
    for (std::size_t i = 0; i < layers; ++i) {
      bench.start.add(i, change[2 * i]);
      bench.sums.mean.add(i, change[2 * i + 1]);
    }
    foresee_slips(bench, change, 2 * layers, 2 * layers * c.cosine.size());
    ++correction;
  }
}

/// Derivatives of the moments by the four strains, from the columns of a solved turn.
HWY_INLINE void store_tangent(const SpatialCompliantCoefficients& c, const Trial& trial, const Bench& bench,
                              Register here, const SpatialResponse& out) {
  const std::size_t layers = c.angle.layers.size();
  const std::array<V, 2> neutral_by_chi =
      neutral_by_curvature(c.points, trial.to[Component::bending2], trial.to[Component::bending3]);
  const Closure closure(c, bench.columns.data() + strain_columns);
  const double linear[2][2] = {{c.EA, c.C_AT}, {c.C_AT, c.GJ}};
  constexpr std::size_t first_bending = static_cast<std::size_t>(Component::bending2);
  LaneRows change(2 * layers);
  for (std::size_t y = 0; y < component_count; ++y) {
    const Column& column = bench.columns[y];
    for (std::size_t i = 0; i < layers; ++i) {
      V moved = column.sums.neutral[i];
      if (y >= first_bending) {
        const V at_plane = hn::NegMulAdd(set(2), bench.sums.mean[i], bench.at_neutral[i]);
        const V turn = hn::Mul(set(2 * c.angle.planar.layers[i].half_step), neutral_by_chi[y - first_bending]);
        moved = hn::MulAdd(turn, at_plane, moved);
      }
      change.set(2 * i, moved);
      change.set(2 * i + 1, joint_of(column.by.edge, i));
    }
    closure.solve(change);
    for (std::size_t r = 0; r < 2; ++r) {
      V value = column.sums.moment[r];
      for (std::size_t k = 0; k < 2 * layers; ++k) {
        value = hn::MulAdd(change[k], bench.columns[strain_columns + k].sums.moment[r], value);
      }
      if (y == first_bending + r) value = hn::Add(value, set(c.EI_min));
      here.store(value, out.stiffness[first_bending + r][y]);
      here.store(set(y < 2 ? linear[r][y] : 0), out.stiffness[r][y]);
    }
  }
}

HWY_INLINE Trial trial_of(const SpatialCompliantCoefficients& c, const double* row, const SpatialStrains& strains,
                          Register here, Bench& bench) {
  const Rows at{row};
  const Point to = point_at(strains, here);
  const V chi2 = to[Component::bending2];
  const V chi3 = to[Component::bending3];
  bench.contacts.fill(c.angle, row + peak_strain * block_lanes, row + stiffness * block_lanes,
                      strains.at[static_cast<std::size_t>(Component::axial)] + here.first);
  for (std::size_t i = 0; i < c.angle.layers.size(); ++i) {
    bench.start.set(i, at[first_layer(c) + layer_rows * i + start_force]);
    bench.sums.mean.set(i, at[first_layer(c) + layer_rows * i + mean_gradient]);
  }
  return {.to = to,
          .step2 = hn::Sub(chi2, at[committed_chi2]),
          .step3 = hn::Sub(chi3, at[committed_chi3]),
          .last2 = at[last_step2],
          .last3 = at[last_step3],
          .neutral = neutral_cell(c.points, chi2, chi3, at[neutral]),
          .cells = row + first_cell(c) * block_lanes,
          .windows = compliant_kernel::HWY_NAMESPACE::same_registers(row + lanes * block_lanes)};
}

void respond_here(const SpatialCompliantCoefficients& c, const double* history, const SpatialStrains& strains,
                  const SpatialResponse& out) {
  Bench bench(c);
  for (const Register here : Registers{strains.points}) {
    const Trial trial = trial_of(c, here.rows(history, rows_of_block(c)), strains, here, bench);
    solve_turn(c, trial, bench, out.tangent ? 0 : bench.columns.size());
    const Point& p = trial.to;
    const V eps = p[Component::axial];
    const V twist = p[Component::torsion];
    here.store(hn::MulAdd(set(c.EA), eps, hn::Mul(set(c.C_AT), twist)), out.stress[0]);
    here.store(hn::MulAdd(set(c.C_AT), eps, hn::Mul(set(c.GJ), twist)), out.stress[1]);
    here.store(hn::MulAdd(set(c.EI_min), p[Component::bending2], bench.sums.moment[0]), out.stress[2]);
    here.store(hn::MulAdd(set(c.EI_min), p[Component::bending3], bench.sums.moment[1]), out.stress[3]);
    if (out.tangent) store_tangent(c, trial, bench, here, out);
  }
}

void commit_here(const SpatialCompliantCoefficients& c, double* history, const SpatialStrains& strains,
                 const Energies& out) {
  Bench bench(c);
  for (const Register here : Registers{strains.points}) {
    double* row = here.rows(history, rows_of_block(c));
    const Trial trial = trial_of(c, row, strains, here, bench);
    solve_turn(c, trial, bench, bench.columns.size());

    SlipEnergy sums = SlipEnergy::zero();
    double* K_before = row + stiffness * block_lanes;
    march(c, trial, bench, true, bench.columns.size(), [&](const Cell& cell, const Wires& w) HWY_ATTR {
      settle(c.angle, cell, w, row + (cell.springs - row), K_before, 0.5, sums);
    });
    bench.contacts.keep(c.angle, K_before);
    const auto keep = [row](std::size_t index, V value) HWY_ATTR { hn::Store(value, tag, row + index * block_lanes); };
    for (std::size_t i = 0; i < c.angle.layers.size(); ++i) {
      keep(first_layer(c) + layer_rows * i + start_force, bench.start[i]);
      keep(first_layer(c) + layer_rows * i + mean_gradient, bench.sums.mean[i]);
    }
    keep(last_step2, trial.step2);
    keep(last_step3, trial.step3);
    keep(committed_chi2, trial.to[Component::bending2]);
    keep(committed_chi3, trial.to[Component::bending3]);
    keep(neutral, trial.neutral);
    keep(lanes, register_width());
    keep(peak_strain, hn::Max(trial.to[Component::axial], Rows{row}[peak_strain]));
    book(out, here, twice_linear_energy(c, trial.to), sums.stored, sums.dissipated,
         hn::Max(hn::Zero(tag), sums.quadrature_error()));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::spatial_compliant_kernel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace strandyn::section::spatial_compliant_kernel {

HWY_EXPORT(respond_here);
HWY_EXPORT(commit_here);

void respond(const SpatialCompliantCoefficients& c, const double* history, const SpatialStrains& strains,
             const SpatialResponse& out) {
  HWY_DYNAMIC_DISPATCH(respond_here)(c, history, strains, out);
}

void commit(const SpatialCompliantCoefficients& c, double* history, const SpatialStrains& strains,
            const Energies& out) {
  HWY_DYNAMIC_DISPATCH(commit_here)(c, history, strains, out);
}

}  // namespace strandyn::section::spatial_compliant_kernel
#endif
