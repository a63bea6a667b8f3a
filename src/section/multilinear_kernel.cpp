// Highway reads this file once per instruction set; the best that the machine has is chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "multilinear_kernel.cpp"
#include "multilinear_kernel.hpp"

#include <hwy/foreach_target.h>

#include "batch_view.hpp"
#include "lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::multilinear_kernel {
namespace HWY_NAMESPACE {
using namespace kernel::HWY_NAMESPACE;

/// Adds what springs did to the energies of a step.
HWY_INLINE void add_to(StepEnergy& energy, Register at, V twice_stored, V dissipated, V twice_error) {
  const kernel::Energies sums = kernel::view(energy);
  at.store(hn::Add(at.load(sums.stored), hn::Mul(set(0.5), twice_stored)), sums.stored);
  at.store(hn::Add(at.load(sums.dissipated), dissipated), sums.dissipated);
  at.store(hn::Add(at.load(sums.quadrature_error), hn::Mul(set(0.5), twice_error)), sums.quadrature_error);
}

template <bool kTangent>
void respond_axis_all(const MultilinearSection& section, const double* history, std::size_t points, const double* chi,
                      const AxisResponse& out) {
  const V EI = set(section.EI);
  for (const Register at : Registers{points}) {
    const double* row = at.rows(history, axis_rows(section));
    const V chi_now = at.load(chi);
    const V dchi = hn::Sub(chi_now, hn::Load(tag, row));
    V M = hn::Mul(EI, chi_now);
    V dM = EI;
    for (const Spring& spring : section.springs) {
      row += block_lanes;
      const V k = set(spring.stiffness);
      const V y = set(spring.yield);
      const V trial = hn::Add(hn::Load(tag, row), dchi);
      const V e = clip(trial, y);
      M = hn::MulAdd(k, e, M);
      if constexpr (kTangent) dM = hn::Add(dM, hn::IfThenElseZero(hn::Eq(e, trial), k));
    }
    at.store(M, out.M);
    if constexpr (kTangent) at.store(dM, out.dM_dchi);
  }
}

void respond_axis_here(const MultilinearSection& section, const double* history, std::size_t points, const double* chi,
                       const AxisResponse& out) {
  out.dM_dchi ? respond_axis_all<true>(section, history, points, chi, out)
              : respond_axis_all<false>(section, history, points, chi, out);
}

void commit_axis_here(const MultilinearSection& section, double* history, std::size_t points, const double* chi,
                      StepEnergy& energy) {
  const V zero = hn::Zero(tag);
  for (const Register at : Registers{points}) {
    double* row = at.rows(history, axis_rows(section));
    const V chi_now = at.load(chi);
    const V dchi = hn::Sub(chi_now, hn::Load(tag, row));
    hn::Store(chi_now, tag, row);
    V twice_stored = zero;
    V dissipated = zero;
    V twice_error = zero;
    for (const Spring& spring : section.springs) {
      row += block_lanes;
      const V y = set(spring.yield);
      const V before = hn::Load(tag, row);
      const V trial = hn::Add(before, dchi);
      const V e = clip(trial, y);
      const V k_slip = hn::Mul(set(spring.stiffness), hn::Sub(trial, e));
      twice_stored = hn::MulAdd(hn::Mul(set(spring.stiffness), e), e, twice_stored);
      dissipated = hn::MulAdd(e, k_slip, dissipated);
      twice_error = hn::MulAdd(hn::Sub(e, before), k_slip, twice_error);
      hn::Store(e, tag, row);
    }
    add_to(energy, at, twice_stored, dissipated, twice_error);
  }
}

struct Pair {
  V axis2, axis3;
};

HWY_INLINE Pair load_pair(const double* row) {
  return {hn::Load(tag, row), hn::Load(tag, row + block_lanes)};
}

HWY_INLINE void store_pair(const Pair& p, double* row) {
  hn::Store(p.axis2, tag, row);
  hn::Store(p.axis3, tag, row + block_lanes);
}

HWY_INLINE V dot(const Pair& a, const Pair& b) {
  return hn::MulAdd(a.axis2, b.axis2, hn::Mul(a.axis3, b.axis3));
}

HWY_INLINE Pair difference(const Pair& a, const Pair& b) {
  return {hn::Sub(a.axis2, b.axis2), hn::Sub(a.axis3, b.axis3)};
}

struct RadialReturn {
  Pair trial, e;
  V length;  // of the trial stretch
  V scale;   // e = scale * trial
  Mask slips;
};

HWY_INLINE RadialReturn return_radially(const Spring& spring, const Pair& before, const Pair& dchi) {
  const V one = set(1);
  RadialReturn r;
  r.trial = {hn::Add(before.axis2, dchi.axis2), hn::Add(before.axis3, dchi.axis3)};
  r.length = hn::Sqrt(dot(r.trial, r.trial));
  r.slips = hn::Gt(r.length, set(spring.yield));
  r.scale = hn::IfThenElse(r.slips, hn::Div(set(spring.yield), hn::IfThenElse(r.slips, r.length, one)), one);
  r.e = {hn::Mul(r.scale, r.trial.axis2), hn::Mul(r.scale, r.trial.axis3)};
  return r;
}

template <bool kTangent>
void respond_pair_all(const MultilinearSection& section, const double* history, const Curvatures& chi,
                      const PairResponse& out) {
  const V EI = set(section.EI);
  for (const Register at : Registers{chi.points}) {
    const double* row = at.rows(history, 2 * axis_rows(section));
    const Pair chi_now{at.load(chi.chi2), at.load(chi.chi3)};
    const Pair dchi = difference(chi_now, load_pair(row));
    Pair M{hn::Mul(EI, chi_now.axis2), hn::Mul(EI, chi_now.axis3)};
    V d22 = EI;
    V d23 = hn::Zero(tag);
    V d33 = EI;
    for (const Spring& spring : section.springs) {
      row += 2 * block_lanes;
      const V k = set(spring.stiffness);
      const RadialReturn r = return_radially(spring, load_pair(row), dchi);
      M.axis2 = hn::MulAdd(k, r.e.axis2, M.axis2);
      M.axis3 = hn::MulAdd(k, r.e.axis3, M.axis3);
      if constexpr (kTangent) {
        // k (y/|t|) (I - t t^T/|t|^2) where it slips, k I where it sticks.
        const V k_scale = hn::Mul(k, r.scale);
        const V inverse = hn::Div(set(1), hn::IfThenElse(r.slips, r.length, set(1)));
        const V n2 = hn::IfThenElseZero(r.slips, hn::Mul(r.trial.axis2, inverse));
        const V n3 = hn::IfThenElseZero(r.slips, hn::Mul(r.trial.axis3, inverse));
        d22 = hn::MulAdd(k_scale, hn::NegMulAdd(n2, n2, set(1)), d22);
        d23 = hn::NegMulAdd(k_scale, hn::Mul(n2, n3), d23);
        d33 = hn::MulAdd(k_scale, hn::NegMulAdd(n3, n3, set(1)), d33);
      }
    }
    at.store(M.axis2, out.M2);
    at.store(M.axis3, out.M3);
    if constexpr (kTangent) {
      at.store(d22, out.dM2_dchi2);
      at.store(d23, out.dM2_dchi3);
      at.store(d33, out.dM3_dchi3);
    }
  }
}

void respond_pair_here(const MultilinearSection& section, const double* history, const Curvatures& chi,
                       const PairResponse& out) {
  out.dM2_dchi2 ? respond_pair_all<true>(section, history, chi, out)
                : respond_pair_all<false>(section, history, chi, out);
}

void commit_pair_here(const MultilinearSection& section, double* history, const Curvatures& chi, StepEnergy& energy) {
  const V zero = hn::Zero(tag);
  for (const Register at : Registers{chi.points}) {
    double* row = at.rows(history, 2 * axis_rows(section));
    const Pair chi_now{at.load(chi.chi2), at.load(chi.chi3)};
    const Pair dchi = difference(chi_now, load_pair(row));
    store_pair(chi_now, row);
    V twice_stored = zero;
    V dissipated = zero;
    V twice_error = zero;
    for (const Spring& spring : section.springs) {
      row += 2 * block_lanes;
      const V k = set(spring.stiffness);
      const Pair before = load_pair(row);
      const RadialReturn r = return_radially(spring, before, dchi);
      const Pair slip = difference(r.trial, r.e);
      twice_stored = hn::MulAdd(k, dot(r.e, r.e), twice_stored);
      dissipated = hn::MulAdd(k, dot(r.e, slip), dissipated);
      // Never negative but for the rounding of |before| <= y.
      twice_error = hn::MulAdd(k, hn::Max(zero, dot(difference(r.e, before), slip)), twice_error);
      store_pair(r.e, row);
    }
    add_to(energy, at, twice_stored, dissipated, twice_error);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::multilinear_kernel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace strandyn::section::multilinear_kernel {

HWY_EXPORT(respond_axis_here);
HWY_EXPORT(commit_axis_here);
HWY_EXPORT(respond_pair_here);
HWY_EXPORT(commit_pair_here);

void respond_axis(const MultilinearSection& section, const double* history, std::size_t points, const double* chi,
                  const AxisResponse& out) {
  HWY_DYNAMIC_DISPATCH(respond_axis_here)(section, history, points, chi, out);
}

void commit_axis(const MultilinearSection& section, double* history, std::size_t points, const double* chi,
                 StepEnergy& energy) {
  HWY_DYNAMIC_DISPATCH(commit_axis_here)(section, history, points, chi, energy);
}

void respond_pair(const MultilinearSection& section, const double* history, const Curvatures& chi,
                  const PairResponse& out) {
  HWY_DYNAMIC_DISPATCH(respond_pair_here)(section, history, chi, out);
}

void commit_pair(const MultilinearSection& section, double* history, const Curvatures& chi, StepEnergy& energy) {
  HWY_DYNAMIC_DISPATCH(commit_pair_here)(section, history, chi, energy);
}

}  // namespace strandyn::section::multilinear_kernel
#endif
