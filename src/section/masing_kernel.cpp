// Highway reads this file once per instruction set; the best that the machine has is chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "masing_kernel.cpp"
#include "masing_kernel.hpp"

#include <hwy/foreach_target.h>

#include <numbers>

#include "lanes-inl.hpp"
// After the lanes: Highway reads its functions once per instruction set, too.
#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::masing_kernel {
namespace HWY_NAMESPACE {
using namespace kernel::HWY_NAMESPACE;

constexpr double no_zero = 1e-300;  // keeps 0/0 at 0

/// phi = atan2(s, c) and beta = pi/2 - phi for s, c >= 0, both to rounding: the smaller one is the arctangent.
/// Without friction (c = 0) beta is zero, at h = 0 too.
struct Angles {
  V phi, beta;
};

HWY_INLINE Angles angles_of(V s, V c) {
  const V larger = hn::Max(hn::Max(s, c), set(no_zero));
  const V small = hn::Atan(tag, hn::Div(hn::Min(s, c), larger));
  const V rest = hn::Sub(set(std::numbers::pi / 2), small);
  const auto steep = hn::Ge(s, c);
  return {hn::IfThenElse(steep, rest, small), hn::IfThenElse(steep, small, rest)};
}

void virgin_curve_here(std::span<const double> EI_layer, const double* critical, const double* h, VirginCurve& out) {
  const V zero = hn::Zero(tag);
  const V half = set(0.5);
  for (std::size_t lane = 0; lane < block_lanes; lane += hn::Lanes(tag)) {
    const V signed_h = hn::Load(tag, h + lane);
    const V a = hn::Abs(signed_h);
    const V per_a = hn::Div(set(1), hn::Max(a, set(no_zero)));
    V moment = zero;
    V tangent = zero;
    V stored = zero;
    V dissipated = zero;
    const double* row = critical + lane;
    for (const double EI : EI_layer) {
      const V c = hn::Load(tag, row);
      row += block_lanes;
      const V s = hn::Sqrt(hn::Mul(hn::Max(zero, hn::Sub(a, c)), hn::Add(a, c)));
      const auto [phi, beta] = angles_of(s, c);
      const V cs = hn::Mul(c, s);
      const V c2_phi = hn::Mul(hn::Mul(c, c), phi);
      const V scale = set(2 / std::numbers::pi * EI);
      const V cs_per_a = hn::Mul(cs, per_a);
      // tangent = beta - (c/h)(s/h); stored = h^2 beta/2 - c s/2 + c^2 phi
      moment = hn::MulAdd(scale, hn::MulAdd(a, beta, cs_per_a), moment);
      tangent = hn::MulAdd(scale, hn::NegMulAdd(cs_per_a, per_a, beta), tangent);
      const V twice = hn::MulSub(hn::Mul(a, a), beta, cs);
      stored = hn::MulAdd(scale, hn::MulAdd(half, twice, c2_phi), stored);
      dissipated = hn::MulAdd(scale, hn::Add(hn::Sub(cs, c2_phi), hn::Sub(cs, c2_phi)), dissipated);
    }
    hn::Store(hn::CopySignToAbs(moment, signed_h), tag, out.moment + lane);
    hn::Store(tangent, tag, out.tangent + lane);
    hn::Store(stored, tag, out.stored + lane);
    hn::Store(dissipated, tag, out.dissipated + lane);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::masing_kernel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace strandyn::section::masing_kernel {

HWY_EXPORT(virgin_curve_here);

void virgin_curve(std::span<const double> EI_layer, const double* critical, const double* h, VirginCurve& out) {
  HWY_DYNAMIC_DISPATCH(virgin_curve_here)(EI_layer, critical, h, out);
}

}  // namespace strandyn::section::masing_kernel
#endif
