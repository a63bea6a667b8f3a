// A register of numbers for either side of the neutral plane, worked on side by side: while one waits for a division
// the other goes on. Included once per instruction set.
#if defined(STRANDYN_SECTION_SIDES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_SECTION_SIDES_INL
#undef STRANDYN_SECTION_SIDES_INL
#else
#define STRANDYN_SECTION_SIDES_INL
#endif

#include "lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::kernel {
namespace HWY_NAMESPACE {

/// The same number on both sides of the neutral plane: tension grows with q on the first, falls on the second.
struct Sides {
  V t, c;
};
struct SideMasks {
  Mask t, c;
};

HWY_INLINE Sides both(V x) {
  return {x, x};
}
HWY_INLINE Sides both(double x) {
  return both(set(x));
}
HWY_INLINE Sides add(const Sides& x, const Sides& y) {
  return {hn::Add(x.t, y.t), hn::Add(x.c, y.c)};
}
HWY_INLINE Sides sub(const Sides& x, const Sides& y) {
  return {hn::Sub(x.t, y.t), hn::Sub(x.c, y.c)};
}
HWY_INLINE Sides mul(const Sides& x, const Sides& y) {
  return {hn::Mul(x.t, y.t), hn::Mul(x.c, y.c)};
}
HWY_INLINE Sides div(const Sides& x, const Sides& y) {
  return {hn::Div(x.t, y.t), hn::Div(x.c, y.c)};
}
/// x y + z, z - x y
HWY_INLINE Sides mul_add(const Sides& x, const Sides& y, const Sides& z) {
  return {hn::MulAdd(x.t, y.t, z.t), hn::MulAdd(x.c, y.c, z.c)};
}
HWY_INLINE Sides neg_mul_add(const Sides& x, const Sides& y, const Sides& z) {
  return {hn::NegMulAdd(x.t, y.t, z.t), hn::NegMulAdd(x.c, y.c, z.c)};
}
HWY_INLINE Sides neg(const Sides& x) {
  return {hn::Neg(x.t), hn::Neg(x.c)};
}
HWY_INLINE Sides absolute(const Sides& x) {
  return {hn::Abs(x.t), hn::Abs(x.c)};
}
HWY_INLINE Sides larger(const Sides& x, const Sides& y) {
  return {hn::Max(x.t, y.t), hn::Max(x.c, y.c)};
}
HWY_INLINE Sides smaller(const Sides& x, const Sides& y) {
  return {hn::Min(x.t, y.t), hn::Min(x.c, y.c)};
}
HWY_INLINE Sides with_sign_of(const Sides& size, const Sides& sign) {
  return {hn::CopySign(size.t, sign.t), hn::CopySign(size.c, sign.c)};
}
/// x, which is not negative, with the sign of the other.
HWY_INLINE Sides turned_as(const Sides& x, const Sides& sign) {
  const V only = hn::SignBit(tag);
  return {hn::OrAnd(x.t, sign.t, only), hn::OrAnd(x.c, sign.c, only)};
}
/// x, turned round where the other is negative.
HWY_INLINE Sides times_sign(const Sides& x, const Sides& sign) {
  const V only = hn::SignBit(tag);
  return {hn::Xor(x.t, hn::And(sign.t, only)), hn::Xor(x.c, hn::And(sign.c, only))};
}
HWY_INLINE SideMasks not_above(const Sides& x, const Sides& y) {
  return {hn::Le(x.t, y.t), hn::Le(x.c, y.c)};
}
HWY_INLINE SideMasks equal(const Sides& x, const Sides& y) {
  return {hn::Eq(x.t, y.t), hn::Eq(x.c, y.c)};
}
HWY_INLINE SideMasks above(const Sides& x, const Sides& y) {
  return {hn::Gt(x.t, y.t), hn::Gt(x.c, y.c)};
}
HWY_INLINE SideMasks both_of(const SideMasks& x, const SideMasks& y) {
  return {hn::And(x.t, y.t), hn::And(x.c, y.c)};
}
HWY_INLINE SideMasks one_of(const SideMasks& x, const SideMasks& y) {
  return {hn::Or(x.t, y.t), hn::Or(x.c, y.c)};
}
/// y and not x
HWY_INLINE SideMasks without(const SideMasks& x, const SideMasks& y) {
  return {hn::AndNot(x.t, y.t), hn::AndNot(x.c, y.c)};
}
HWY_INLINE bool all_true(const SideMasks& x) {
  return hn::AllTrue(tag, hn::And(x.t, x.c));
}
HWY_INLINE Sides choose(const SideMasks& first, const Sides& x, const Sides& y) {
  return {hn::IfThenElse(first.t, x.t, y.t), hn::IfThenElse(first.c, x.c, y.c)};
}
HWY_INLINE Sides zero_if(const SideMasks& mask, const Sides& x) {
  return {hn::IfThenZeroElse(mask.t, x.t), hn::IfThenZeroElse(mask.c, x.c)};
}
HWY_INLINE Sides if_else_zero(const SideMasks& mask, const Sides& x) {
  return {hn::IfThenElseZero(mask.t, x.t), hn::IfThenElseZero(mask.c, x.c)};
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::kernel
HWY_AFTER_NAMESPACE();
#endif
