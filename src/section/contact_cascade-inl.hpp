// How the contacts of a strand load each other, from the outermost layer inward. Per length of contact helix,
//     inner     = kappa F_at + c_ext f_ext + c_int R_res,       f_ext = next_layer_ratio f_int of the layer outside
//     numerator = mu_int inner + floor,                         floor = mu_ext c_ext f_ext
//     q_lim     = max(floor, numerator + mu_int kappa F_b)      F_b the wire's own bending force
//     f_int     = max(0, inner + kappa mean(F_b))/c_int
// The floor is what is left of the limit when the inner contact opens.
#if defined(STRANDYN_SECTION_CONTACT_CASCADE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_SECTION_CONTACT_CASCADE_INL
#undef STRANDYN_SECTION_CONTACT_CASCADE_INL
#else
#define STRANDYN_SECTION_CONTACT_CASCADE_INL
#endif

#include "dual-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::kernel {
namespace HWY_NAMESPACE {

template <bool kTangent>
struct LayerLoad {
  Dual<kTangent> floor, numerator, inner;
};

/// c_ext f_ext
template <bool kTangent>
HWY_INLINE Dual<kTangent> load_from_outside(const PlanarCoefficients::Layer& layer, const Dual<kTangent>& f_int) {
  return scaled(set(layer.c_ext * layer.next_layer_ratio), f_int);
}

/// `weight` times `strain` is kappa F_at; derivatives are those by `strain`.
template <bool kTangent>
HWY_INLINE LayerLoad<kTangent> load_of(const PlanarCoefficients::Layer& layer, V weight, V strain,
                                       const Dual<kTangent>& f_int) {
  LayerLoad<kTangent> load;
  const Dual<kTangent> outer = load_from_outside(layer, f_int);
  load.inner = outer;
  load.inner.value = hn::Add(hn::MulAdd(weight, strain, outer.value), set(layer.inner_residual));
  if constexpr (kTangent) load.inner.eps = hn::Add(weight, outer.eps);
  load.floor = scaled(set(layer.mu_ext), outer);
  load.numerator = mul_add(set(layer.mu_int), load.inner, load.floor);
  return load;
}

/// f_int of a layer; `inner` includes the mean of its bending force.
template <bool kTangent>
HWY_INLINE Dual<kTangent> handed_inward(const PlanarCoefficients::Layer& layer, const Dual<kTangent>& inner) {
  return scaled(set(layer.inverse_c_int), positive_part(inner));
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::kernel
HWY_AFTER_NAMESPACE();
#endif
