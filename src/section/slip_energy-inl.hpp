// Energy of elastic elements that slide, and the books of a step. A force goes from q_0 to q_1 while the trial of an
// element of stiffness k is clipped, de_slip = (q_trial - q_1)/k:
//     D = max(q_1 de_slip, (q_0 + q_1)/2 de_slip),    E_quad = D - (q_0 + q_1)/2 de_slip >= 0,    U = q_1^2/(2k)
// The first is exact when a cell goes from stick to slip under a constant limit, the second when the limit shrinks.
#if defined(STRANDYN_SECTION_SLIP_ENERGY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_SECTION_SLIP_ENERGY_INL
#undef STRANDYN_SECTION_SLIP_ENERGY_INL
#else
#define STRANDYN_SECTION_SLIP_ENERGY_INL
#endif

#include "batch_view.hpp"
#include "lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::kernel {
namespace HWY_NAMESPACE {

/// Friction work of one element: what is booked, and the trapezoid of its force.
struct Slide {
  V loss, trapezoid;
};

HWY_INLINE Slide slide_of(V before, V trial, V now, V compliance) {
  const V slip = hn::Mul(hn::Sub(trial, now), compliance);
  const V at_mean = hn::Mul(hn::Mul(set(0.5), hn::Add(now, before)), slip);
  return {hn::Max(hn::Mul(now, slip), at_mean), at_mean};
}

/// Sums over the elements of a register of points.
struct SlipEnergy {
  V stored, dissipated, trapezoid;

  static HWY_INLINE SlipEnergy zero() {
    const V z = hn::Zero(tag);
    return {z, z, z};
  }
  HWY_INLINE void lose(V weight, const Slide& slide) {
    dissipated = hn::MulAdd(weight, slide.loss, dissipated);
    trapezoid = hn::MulAdd(weight, slide.trapezoid, trapezoid);
  }
  HWY_INLINE void store(V factor, V force) { stored = hn::MulAdd(factor, hn::Mul(force, force), stored); }
  /// A cell of a layer: weight C_j, stiffness k.
  template <class Layer>
  HWY_INLINE void add(const Layer& layer, V before, V trial, V now) {
    const V per_k = set(1 / layer.k);
    const V weight = set(layer.weight);
    lose(weight, slide_of(before, trial, now, per_k));
    store(hn::Mul(weight, hn::Mul(set(0.5), per_k)), now);
  }
  HWY_INLINE V quadrature_error() const { return hn::Sub(dissipated, trapezoid); }
};

/// `twice_linear` is twice the potential of what neither slips nor remembers.
HWY_INLINE void book(const Energies& out, Register at, V twice_linear, V stored, V dissipated, V quadrature_error) {
  at.store(hn::MulAdd(set(0.5), twice_linear, stored), out.stored);
  at.store(dissipated, out.dissipated);
  at.store(quadrature_error, out.quadrature_error);
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::kernel
HWY_AFTER_NAMESPACE();
#endif
