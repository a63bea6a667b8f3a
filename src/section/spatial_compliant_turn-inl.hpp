// The march of all layers around the full turn, for one register of section points, and the equations that close it.
// Two half turns go at once, theta from 0 to pi and from 0 to -pi: the two sides of a cell. Included once per
// instruction set.
//     edge(0) = start on both sides,   edge += step (q - mean),   step = +-dS
//     joint   = edge(pi) - edge(-pi)          = 0
//     neutral = F_b(phi) + F_b(phi + pi)      = 0
// for every layer, with its start and mean as unknowns. Both are sums along the march, of the gradients and of their
// derivatives alike.
#if defined(STRANDYN_SPATIAL_COMPLIANT_TURN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_SPATIAL_COMPLIANT_TURN_INL
#undef STRANDYN_SPATIAL_COMPLIANT_TURN_INL
#else
#define STRANDYN_SPATIAL_COMPLIANT_TURN_INL
#endif

#include <vector>

#include "compliant_march-inl.hpp"
#include "space-inl.hpp"
#include "spatial_compliant_kernel.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::spatial_compliant_kernel {
namespace HWY_NAMESPACE {
using namespace compliant_kernel::HWY_NAMESPACE;

/// Rows of lanes.
class LaneRows {
 public:
  explicit LaneRows(std::size_t rows) : rows_(rows * block_lanes) {}
  HWY_INLINE V operator[](std::size_t row) const { return hn::Load(tag, rows_.data() + row * block_lanes); }
  HWY_INLINE void set(std::size_t row, V value) { hn::Store(value, tag, rows_.data() + row * block_lanes); }
  HWY_INLINE void add(std::size_t row, V value) { set(row, hn::Add((*this)[row], value)); }

 private:
  AlignedVector rows_;
};

/// The two cells of a march: cosine and sine of the first, the share of each that lies before the neutral plane.
struct Place {
  double cosine, sine;
  Sides share;
};

/// What a march adds up: of the gradients, or of their derivatives by one thing.
struct Sums {
  explicit Sums(std::size_t layers) : mean(layers), neutral(layers), moment(2) {}
  LaneRows mean;     // of each layer; its derivative, one or zero
  LaneRows neutral;  // F_b(phi) + F_b(phi + pi)
  LaneRows moment;   // M2, M3

  HWY_INLINE void begin(std::size_t layer, V start, V mean_gradient, PerLayer& edge) {
    edge.set(layer, both(start));
    mean.set(layer, mean_gradient);
    neutral.set(layer, hn::Add(start, start));
  }
  HWY_INLINE void begin() {
    moment.set(0, hn::Zero(tag));
    moment.set(1, hn::Zero(tag));
  }
  /// One more cell on either side, with these gradients.
  HWY_INLINE void add(const SpatialCompliantCoefficients& c, const Place& at, const PerLayer& gradient,
                      PerLayer& edge) {
    V along = hn::Zero(tag);
    V across = hn::Zero(tag);
    for (std::size_t i = 0; i < c.angle.layers.size(); ++i) {
      const PlanarLayer& p = c.angle.planar.layers[i];
      const V weight = set(0.5 * p.weight);
      const Sides q = gradient[i];
      const Sides moved = mul(step_of(p), sub(q, both(mean[i])));
      edge.set(i, compliant_kernel::HWY_NAMESPACE::add(edge[i], moved));
      neutral.add(i, hn::MulAdd(at.share.t, moved.t, hn::Mul(at.share.c, moved.c)));
      along = hn::MulAdd(weight, hn::Add(q.t, q.c), along);
      across = hn::MulAdd(weight, hn::Sub(q.t, q.c), across);
    }
    moment.set(0, hn::MulAdd(set(at.cosine), along, moment[0]));
    moment.set(1, hn::MulAdd(set(at.sine), across, moment[1]));
  }
};

HWY_INLINE V joint_of(const PerLayer& edge, std::size_t layer) {
  const Sides end = edge[layer];
  return hn::Sub(end.t, end.c);
}

/// Derivatives by one thing: a strain, or an unknown.
struct Column {
  explicit Column(std::size_t layers) : sums(layers) {}
  Derivatives by;
  Sums sums;
  std::size_t start_of = Feed::no_layer;  // an unknown: the start or the mean of a layer
  std::size_t mean_of = Feed::no_layer;
  double eps = 0, twist = 0, chi2 = 0, chi3 = 0;  // a strain

  HWY_INLINE void begin(std::size_t layers) {
    const auto one_at = [](bool here) HWY_ATTR { return set(here ? 1 : 0); };
    sums.begin();
    for (std::size_t i = 0; i < layers; ++i) sums.begin(i, one_at(i == start_of), one_at(i == mean_of), by.edge);
  }
  HWY_INLINE void add(const SpatialCompliantCoefficients& c, const Place& at, const double* K_eps, const Wires& w) {
    const double along = at.cosine * chi2;
    const double across = at.sine * chi3;
    const Feed feed{.e = {set(along + across), set(along - across)}, .eps = eps, .twist = twist, .mean_of = mean_of};
    hold_slips(c.angle, feed, K_eps, w, by);
    let_slip(c.angle, w, by);
    sums.add(c, at, by.q, by.edge);
  }
};

/// The linear system of Newton's method: two equations a layer, neutral and joint, for its start and its mean.
class Closure {
 public:
  Closure(const SpatialCompliantCoefficients& c, const Column* unknowns)
      : size_(2 * c.angle.layers.size()), matrix_(size_ * size_), inverse_(size_) {
    for (std::size_t k = 0; k < size_; ++k) {
      for (std::size_t i = 0; i < size_ / 2; ++i) {
        matrix_.set(2 * i * size_ + k, unknowns[k].sums.neutral[i]);
        matrix_.set((2 * i + 1) * size_ + k, joint_of(unknowns[k].by.edge, i));
      }
    }
    for (std::size_t k = 0; k < size_; ++k) {
      // Without slip the pivots are these. Far below them the derivative is no guide.
      const double plain = k % 2 == 0 ? 2 : -c.points * 2 * c.angle.planar.layers[k / 2].half_step;
      const V pivot = matrix_[k * size_ + k];
      const Mask poor = hn::Lt(hn::Mul(pivot, set(1 / plain)), set(0.1));
      inverse_.set(k, hn::Div(set(1), hn::IfThenElse(poor, set(plain), pivot)));
      for (std::size_t row = k + 1; row < size_; ++row) {
        const V factor = hn::Mul(matrix_[row * size_ + k], inverse_[k]);
        matrix_.set(row * size_ + k, factor);
        for (std::size_t y = k + 1; y < size_; ++y) {
          matrix_.set(row * size_ + y, hn::NegMulAdd(factor, matrix_[k * size_ + y], matrix_[row * size_ + y]));
        }
      }
    }
  }
  /// `rhs` becomes the change of the unknowns that takes it away.
  HWY_INLINE void solve(LaneRows& rhs) const {
    for (std::size_t k = 0; k < size_; ++k) {
      for (std::size_t row = k + 1; row < size_; ++row) {
        rhs.set(row, hn::NegMulAdd(matrix_[row * size_ + k], rhs[k], rhs[row]));
      }
    }
    for (std::size_t k = size_; k-- > 0;) {
      V value = rhs[k];
      for (std::size_t y = k + 1; y < size_; ++y) value = hn::NegMulAdd(matrix_[k * size_ + y], rhs[y], value);
      rhs.set(k, hn::Mul(value, inverse_[k]));
    }
    for (std::size_t k = 0; k < size_; ++k) rhs.set(k, hn::Neg(rhs[k]));
  }

 private:
  std::size_t size_;
  LaneRows matrix_;  // its factors after elimination
  LaneRows inverse_;
};

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::spatial_compliant_kernel
HWY_AFTER_NAMESPACE();
#endif
