// What the spatial laws share: the strains of a register of points, and where the neutral plane of bending lies. Angles
// are counted in cells of the grid around the turn. Included once per instruction set.
#if defined(STRANDYN_SECTION_SPACE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_SECTION_SPACE_INL
#undef STRANDYN_SECTION_SPACE_INL
#else
#define STRANDYN_SECTION_SPACE_INL
#endif

#include <hwy/contrib/math/math-inl.h>

#include <array>
#include <numbers>

#include "batch_view.hpp"
#include "lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::kernel {
namespace HWY_NAMESPACE {

/// The strains of one register of points.
struct Point {
  std::array<V, component_count> strain;
  V operator[](Component c) const { return strain[static_cast<std::size_t>(c)]; }
};

HWY_INLINE Point point_at(const SpatialStrains& strains, Register at) {
  Point p;
  for (std::size_t c = 0; c < component_count; ++c) p.strain[c] = at.load(strains.at[c]);
  return p;
}

/// EA eps^2 + 2 C_AT eps chi1 + GJ chi1^2 + EI_min (chi2^2 + chi3^2)
template <class Stiffness>
HWY_INLINE V twice_linear_energy(const Stiffness& c, const Point& p) {
  const V eps = p[Component::axial];
  const V twist = p[Component::torsion];
  const V chi2 = p[Component::bending2];
  const V chi3 = p[Component::bending3];
  V linear = hn::Mul(set(c.EI_min), hn::MulAdd(chi2, chi2, hn::Mul(chi3, chi3)));
  linear = hn::MulAdd(hn::Mul(set(c.EA), eps), eps, linear);
  return hn::MulAdd(hn::MulAdd(set(2 * c.C_AT), eps, hn::Mul(set(c.GJ), twist)), twist, linear);
}

HWY_INLINE double cells_per_radian(int points) {
  return 1 / (2 * std::numbers::pi / points);
}

/// Neutral angle phi = atan(chi3/chi2), modulo half a turn, in cells; `kept` where the curvature is too small to tell.
HWY_INLINE V neutral_cell(int points, V chi2, V chi3, V kept) {
  constexpr double undefined_below = 1e-12;  // [1/m]
  const V a2 = hn::Abs(chi2);
  const V a3 = hn::Abs(chi3);
  const Mask steep = hn::Gt(a3, a2);
  const Mask defined = hn::Ge(hn::Max(a2, a3), set(undefined_below));
  const V below = hn::IfThenElse(defined, hn::IfThenElse(steep, chi3, chi2), set(1));
  const V angle = hn::Atan(tag, hn::Div(hn::IfThenElse(steep, hn::Neg(chi2), chi3), below));
  const V half_turn = set(points / 2);
  V cell = hn::MulAdd(angle, set(cells_per_radian(points)), hn::IfThenElseZero(steep, set(points / 4)));
  cell = hn::Add(cell, hn::IfThenElseZero(hn::Lt(cell, hn::Zero(tag)), half_turn));
  cell = hn::Sub(cell, hn::IfThenElseZero(hn::Ge(cell, half_turn), half_turn));
  return hn::IfThenElse(defined, cell, kept);
}

/// Derivatives of the neutral angle, in cells, by chi2 and chi3.
HWY_INLINE std::array<V, 2> neutral_by_curvature(int points, V chi2, V chi3) {
  const V square = hn::MulAdd(chi2, chi2, hn::Mul(chi3, chi3));
  const Mask defined = hn::Ge(square, set(1e-24));
  const V factor =
      hn::IfThenElseZero(defined, hn::Div(set(cells_per_radian(points)), hn::IfThenElse(defined, square, set(1))));
  return {hn::Neg(hn::Mul(chi3, factor)), hn::Mul(chi2, factor)};
}

/// The share of cell `i` of a part of the turn that lies before the neutral plane, `cells` = neutral minus the part's
/// start.
HWY_INLINE V share_before(V cells, double i) {
  return hn::Min(hn::Max(hn::Sub(cells, set(i)), hn::Zero(tag)), set(1));
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::kernel
HWY_AFTER_NAMESPACE();
#endif
