// Forward derivatives along a march in the plane: a value with its derivatives by curvature and axial strain,
//     f + f_chi dchi + f_eps deps
// A march in the plane goes over two quarter turns from the neutral plane and answers N = EA eps, M = EI_min chi + M_f.
// Without a tangent it carries values only. `mul_add` rounds once, `sum` of `scaled` twice: each law keeps to one.
#if defined(STRANDYN_SECTION_DUAL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_SECTION_DUAL_INL
#undef STRANDYN_SECTION_DUAL_INL
#else
#define STRANDYN_SECTION_DUAL_INL
#endif

#include "batch_view.hpp"
#include "lanes-inl.hpp"
#include "strandyn/section/return_map.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::kernel {
namespace HWY_NAMESPACE {

template <bool kTangent>
struct Dual {
  V value, chi, eps;
};
template <>
struct Dual<false> {
  V value;
};

/// The derivatives are left out where nobody wants them.
template <bool kTangent>
HWY_INLINE Dual<kTangent> dual(V value, V chi, V eps) {
  if constexpr (kTangent) return {value, chi, eps};
  if constexpr (!kTangent) return {value};
}

template <bool kTangent>
HWY_INLINE Dual<kTangent> zero() {
  const V z = hn::Zero(tag);
  return dual<kTangent>(z, z, z);
}

/// The same linear operation on the values and on the derivatives.
template <bool kTangent, class Operation, class... More>
HWY_INLINE Dual<kTangent> each(Operation op, const Dual<kTangent>& x, const More&... more) {
  if constexpr (kTangent) return {op(x.value, more.value...), op(x.chi, more.chi...), op(x.eps, more.eps...)};
  if constexpr (!kTangent) return {op(x.value, more.value...)};
}

template <bool kTangent>
HWY_INLINE Dual<kTangent> scaled(V factor, const Dual<kTangent>& x) {
  return each([factor](V a) HWY_ATTR { return hn::Mul(factor, a); }, x);
}

template <bool kTangent>
HWY_INLINE Dual<kTangent> sum(const Dual<kTangent>& x, const Dual<kTangent>& y) {
  return each([](V a, V b) HWY_ATTR { return hn::Add(a, b); }, x, y);
}

/// factor x + y
template <bool kTangent>
HWY_INLINE Dual<kTangent> mul_add(V factor, const Dual<kTangent>& x, const Dual<kTangent>& y) {
  return each([factor](V a, V b) HWY_ATTR { return hn::MulAdd(factor, a, b); }, x, y);
}

template <bool kTangent>
HWY_INLINE Dual<kTangent> choose(Mask first, const Dual<kTangent>& x, const Dual<kTangent>& y) {
  return each([first](V a, V b) HWY_ATTR { return hn::IfThenElse(first, a, b); }, x, y);
}

/// max(floor, x)
template <bool kTangent>
HWY_INLINE Dual<kTangent> at_least(const Dual<kTangent>& floor, const Dual<kTangent>& x) {
  Dual<kTangent> larger = choose(hn::Ge(x.value, floor.value), x, floor);
  larger.value = hn::Max(floor.value, x.value);
  return larger;
}

/// max(0, x)
template <bool kTangent>
HWY_INLINE Dual<kTangent> positive_part(const Dual<kTangent>& x) {
  const Mask positive = hn::Gt(x.value, hn::Zero(tag));
  Dual<kTangent> part = each([positive](V a) HWY_ATTR { return hn::IfThenElseZero(positive, a); }, x);
  part.value = hn::Max(hn::Zero(tag), x.value);
  return part;
}

/// One quarter turn on its way from the neutral plane: the bending force at the cell's edge and the sums so far.
template <bool kTangent>
struct Quarter {
  Dual<kTangent> edge, sum_of_force, sum_of_moment;

  static HWY_INLINE Quarter at_rest() { return {zero<kTangent>(), zero<kTangent>(), zero<kTangent>()}; }
};

template <bool kTangent>
HWY_INLINE void answer(const PlanarCoefficients& c, const Response& out, Register at, V eps, V chi,
                       const Dual<kTangent>& friction) {
  at.store(hn::Mul(set(c.EA), eps), out.N);
  at.store(hn::MulAdd(set(c.EI_min), chi, friction.value), out.M);
  if constexpr (kTangent) {
    at.store(hn::Add(set(c.EI_min), friction.chi), out.dM_dchi);
    at.store(friction.eps, out.dM_deps);
  }
}

/// EA eps^2 + EI_min chi^2
HWY_INLINE V twice_linear_energy(const PlanarCoefficients& c, V eps, V chi) {
  return hn::MulAdd(hn::Mul(set(c.EA), eps), eps, hn::Mul(hn::Mul(set(c.EI_min), chi), chi));
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::kernel
HWY_AFTER_NAMESPACE();
#endif
