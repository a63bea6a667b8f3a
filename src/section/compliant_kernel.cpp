// Highway reads this file once per instruction set; the best that the machine has is chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "compliant_kernel.cpp"
#include "compliant_kernel.hpp"

#include <hwy/foreach_target.h>

#include "compliant_march-inl.hpp"
#include "dual-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::compliant_kernel {
namespace HWY_NAMESPACE {
/// What the march knows of the whole point.
struct Point {
  V eps, chi_step;  // chi_step since the last commit
  V onward;
  bool windows;
};

/// What a march works in; made once per call.
struct Bench {
  explicit Bench(const CompliantCoefficients& c) : contacts(c) {}
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

/// kappa F_at + c_int R_res + kappa F_edge of every layer.
HWY_INLINE void load_of(const CompliantCoefficients& c, V eps, Bench& bench) {
  for (std::size_t i = 0; i < c.layers.size(); ++i) {
    const PlanarLayer& p = c.planar.layers[i];
    const V alone = hn::MulAdd(set(p.kappa * p.force_per_strain), eps, set(p.inner_residual));
    bench.wires.load.set(i, mul_add(both(p.kappa), bench.edge[i], both(alone)));
  }
}

/// One more cell along a quarter turn: the derivative of its moment, and of the force at the edge to come.
HWY_INLINE V advance(const CompliantCoefficients& c, double cosine, const Feed& feed, const double* K_eps,
                     const Wires& w, Derivatives& by) {
  hold_slips(c, feed, K_eps, w, by);
  let_slip(c, w, by);
  V moment = hn::Zero(tag);
  for (std::size_t i = 0; i < c.layers.size(); ++i) {
    const PlanarLayer& p = c.planar.layers[i];
    const Sides q = by.q[i];
    moment = hn::MulAdd(set(p.weight * cosine), hn::Add(q.t, q.c), moment);
    by.edge.set(i, mul_add(step_of(p), q, by.edge[i]));
  }
  return moment;
}

/// The whole march of one register of points. `on_cell(cell, wires)` sees every cell.
template <bool kTangent, class OnCell>
HWY_INLINE Dual<kTangent> march(const CompliantCoefficients& c, const Point& at, const double* springs, Bench& bench,
                                const OnCell& on_cell) {
  auto moment = zero<kTangent>();
  const std::size_t layers = c.layers.size();
  if (layers == 0) return moment;
  bench.at_neutral_plane(layers);
  Wires& w = bench.wires;
  for (std::size_t angle = 0; angle < c.planar.cosine.size(); ++angle) {
    const double cosine = c.planar.cosine[angle];
    const Cell cell{.angle = angle,
                    .springs = springs,
                    .stiffness = bench.contacts.now.data(),
                    .windows = at.windows,
                    .e_step = both(hn::Mul(set(cosine), at.chi_step)),
                    .onward = both(at.onward)};
    load_of(c, at.eps, bench);
    begin(c, cell, w);
    solve(c, cell, guess(c, cell, w), w);
    if constexpr (kTangent) {
      const double* K_eps = bench.contacts.now_eps.data();
      eliminate(c, w);
      moment.chi = hn::Add(moment.chi, advance(c, cosine, {.e = both(cosine)}, K_eps, w, bench.by_chi));
      moment.eps = hn::Add(moment.eps, advance(c, cosine, {.e = both(0), .eps = 1}, K_eps, w, bench.by_eps));
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

/// Points of one register, from their last commit to this state.
HWY_INLINE Point point_at(const double* row, V eps, V chi) {
  const V step = hn::Sub(chi, Rows{row}[committed_chi]);
  return {.eps = eps,
          .chi_step = step,
          .onward = onward(step, Rows{row}[last_step]),
          .windows = same_registers(row + lanes * block_lanes)};
}

template <bool kTangent>
void respond_all(const CompliantCoefficients& c, const double* history, const Strains& strains, const Response& out) {
  Bench bench(c);
  for (const Register here : Registers{strains.points}) {
    const double* row = here.rows(history, rows_of_block(c));
    const V eps = here.load(strains.eps);
    const V chi = here.load(strains.chi);
    bench.contacts.fill(c, row + peak_strain * block_lanes, row + stiffness * block_lanes, strains.eps + here.first);
    const double* cells = row + first_cell(c) * block_lanes;
    answer(c.planar, out, here, eps, chi,
           march<kTangent>(c, point_at(row, eps, chi), cells, bench, [](const Cell&, const Wires&) {}));
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
    bench.contacts.fill(c, peak, K_before, strains.eps + here.first);

    SlipEnergy sums = SlipEnergy::zero();
    const double* cells = row + first_cell(c) * block_lanes;
    march<false>(c, point_at(row, eps, chi), cells, bench, [&](const Cell& cell, const Wires& w) HWY_ATTR {
      settle(c, cell, w, row + (cell.springs - row), K_before, 1, sums);
    });
    bench.contacts.keep(c, K_before);
    hn::Store(hn::Sub(chi, Rows{row}[committed_chi]), tag, row + last_step * block_lanes);
    hn::Store(chi, tag, row + committed_chi * block_lanes);
    hn::Store(hn::Max(eps, hn::Load(tag, peak)), tag, peak);
    hn::Store(register_width(), tag, row + lanes * block_lanes);
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
