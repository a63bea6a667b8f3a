// An element in its position, and what its resultants do in its frame. Included once per instruction set.
#if defined(STRANDYN_BEAM_SPATIAL_FORCES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_BEAM_SPATIAL_FORCES_INL
#undef STRANDYN_BEAM_SPATIAL_FORCES_INL
#else
#define STRANDYN_BEAM_SPATIAL_FORCES_INL
#endif

#include "spatial_registers-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::beam::spatial_lanes_kernel {
namespace HWY_NAMESPACE {

struct ElementKinematics {
  explicit HWY_INLINE ElementKinematics(const Register& at)
      : l0(at[length]),
        per_l(hn::Div(set(1), at[chord])),
        lean(at[Row::lean]),
        per_upright(hn::Div(set(1), at[upright])),
        angle{vec(at, angle_1), vec(at, angle_2)},
        inverse{at[inverse_1], at[inverse_2]},
        direction{vec(at, direction_1), vec(at, direction_2)} {}

  /// d eps/d(theta_1, theta_2) about axis y: the slope of the mean of (v'^2 + w'^2)/2. About z likewise.
  HWY_INLINE V strain_slope_y(std::size_t node) const { return slope(angle[node].y, angle[1 - node].y); }
  HWY_INLINE V strain_slope_z(std::size_t node) const { return slope(angle[node].z, angle[1 - node].z); }

  V l0, per_l, lean, per_upright;
  std::array<Vec, 2> angle;
  std::array<V, 2> inverse;
  std::array<Vec, 2> direction;

 private:
  static HWY_INLINE V slope(V here, V there) { return hn::Mul(hn::MulSub(set(4), here, there), set(1.0 / 30)); }
};

/// What works on the chord's stretch and, node by node, on theta_i or on the spin against the frame.
struct LocalForce {
  V stretch;
  std::array<Vec, 2> theta, spin;
};

HWY_INLINE LocalForce local_force(const ElementKinematics& k, const SpatialLanes::Points& r, std::size_t first) {
  LocalForce f;
  f.stretch = mean_of(r.axial, first, 1, 1);
  const V torque = mean_of(r.torsion, first, 1, 1);
  const V inside = hn::Mul(f.stretch, k.l0);
  for (std::size_t i = 0; i < 2; ++i) {
    f.theta[i] = {i == 0 ? hn::Neg(torque) : torque,
                  hn::MulAdd(inside, k.strain_slope_y(i), moment_of(r.bending2, first, i)),
                  hn::MulAdd(inside, k.strain_slope_z(i), moment_of(r.bending3, first, i))};
    // T^-T of theta_i: 1 + S/2 + e S^2
    const Vec once = cross(k.angle[i], f.theta[i]);
    f.spin[i] = plus(plus(f.theta[i], set(0.5), once), k.inverse[i], cross(k.angle[i], once));
  }
  return f;
}

/// What works on the motion: on the chord's change and on the spins of the nodes, in the frame's axes.
struct MotionForce {
  HWY_INLINE MotionForce(const ElementKinematics& k, const LocalForce& f) {
    const Vec sum = f.spin[0] + f.spin[1];
    const V roll = hn::Mul(hn::Mul(set(0.5), sum.x), k.per_upright);
    chord = {f.stretch, hn::Neg(hn::Mul(sum.z, k.per_l)), hn::Mul(hn::MulAdd(k.lean, sum.x, sum.y), k.per_l)};
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec& n = k.direction[i];
      node[i] = {hn::NegMulAdd(roll, n.y, f.spin[i].x), hn::MulAdd(roll, n.x, f.spin[i].y), f.spin[i].z};
    }
  }
  Vec chord;
  std::array<Vec, 2> node;
};

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::beam::spatial_lanes_kernel
HWY_AFTER_NAMESPACE();
#endif
