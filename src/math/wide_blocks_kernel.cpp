// Highway reads this file once per instruction set; the best that the machine has is chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "wide_blocks_kernel.cpp"
#include "wide_blocks_kernel.hpp"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>
#include <cmath>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace strandyn::math::wide_blocks {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, 4>;
using V = hn::Vec<Tag>;
constexpr Tag tag;
constexpr std::size_t lanes = hn::MaxLanes(tag);

HWY_INLINE V set(double x) {
  return hn::Set(tag, x);
}

/// A column of B numbers; what only fills its last register is zero.
template <std::size_t B>
struct Column {
  static constexpr std::size_t parts = (B + lanes - 1) / lanes;
  static constexpr std::size_t rest = B % lanes;  // numbers in the last register, 0: all

  static HWY_INLINE Column load(const double* from) {
    Column c;
    for (std::size_t p = 0; p < B / lanes; ++p) c.part[p] = hn::LoadU(tag, from + lanes * p);
    if constexpr (rest == 1 && lanes > 1) {
      c.part[parts - 1] = hn::IfThenElseZero(hn::FirstN(tag, 1), set(from[B - 1]));
    }
#if HWY_MAX_BYTES >= 32
    if constexpr (rest > 1) {
      static_assert(2 * rest == lanes);
      c.part[parts - 1] = hn::ZeroExtendVector(tag, hn::LoadU(hn::Half<Tag>(), from + lanes * (parts - 1)));
    }
#endif
    return c;
  }
  HWY_INLINE void store(double* to) const {
    for (std::size_t p = 0; p < B / lanes; ++p) hn::StoreU(part[p], tag, to + lanes * p);
    if constexpr (rest == 1 && lanes > 1) {
      to[B - 1] = hn::GetLane(part[parts - 1]);
    }
#if HWY_MAX_BYTES >= 32
    if constexpr (rest > 1) {
      constexpr hn::Half<Tag> half;
      hn::StoreU(hn::LowerHalf(half, part[parts - 1]), half, to + lanes * (parts - 1));
    }
#endif
  }
  HWY_INLINE void add(V factor, const Column& other) {
    for (std::size_t p = 0; p < parts; ++p) part[p] = hn::MulAdd(factor, other.part[p], part[p]);
  }
  HWY_INLINE void subtract(V factor, const Column& other) {
    for (std::size_t p = 0; p < parts; ++p) part[p] = hn::NegMulAdd(factor, other.part[p], part[p]);
  }

  V part[parts];
};

/// Number `k` of a column, in all lanes.
template <std::size_t B>
HWY_INLINE V broadcast(const Column<B>& c, std::size_t k) {
  const V part = c.part[k / lanes];
#if HWY_MAX_BYTES >= 32
  const std::size_t lane = k % lanes;
  const V both = lane < 2 ? hn::ConcatLowerLower(tag, part, part) : hn::ConcatUpperUpper(tag, part, part);
  return lane % 2 == 0 ? hn::InterleaveLower(tag, both, both) : hn::InterleaveUpper(tag, both, both);
#elif HWY_TARGET == HWY_SCALAR
  return part;
#else
  return k % lanes == 0 ? hn::InterleaveLower(tag, part, part) : hn::InterleaveUpper(tag, part, part);
#endif
}

template <std::size_t B>
struct Block {
  static HWY_INLINE Block load(const double* from) {
    Block b;
    for (std::size_t c = 0; c < B; ++c) b.column[c] = Column<B>::load(from + B * c);
    return b;
  }
  HWY_INLINE void store(double* to) const {
    for (std::size_t c = 0; c < B; ++c) column[c].store(to + B * c);
  }
  Column<B> column[B];
};

/// a b, the second read from memory number by number.
template <std::size_t B>
HWY_INLINE Column<B> times(const Block<B>& a, const double* b) {
  Column<B> sum;
  for (std::size_t p = 0; p < Column<B>::parts; ++p) sum.part[p] = hn::Mul(set(b[0]), a.column[0].part[p]);
#pragma GCC unroll 6
  for (std::size_t k = 1; k < B; ++k) sum.add(set(b[k]), a.column[k]);
  return sum;
}

/// Marks of row k, and of those below it.
template <std::size_t B, std::size_t k>
struct Row {
  static constexpr std::size_t size = Column<B>::parts * lanes;
  static constexpr std::array<double, size> marked(bool below) {
    std::array<double, size> all{};
    for (std::size_t r = 0; r < size; ++r) all[r] = r == k || (below && r > k) ? 1 : 0;
    return all;
  }
  alignas(64) static constexpr std::array<double, size> itself = marked(false), and_below = marked(true);

  static HWY_INLINE hn::Mask<Tag> is(const std::array<double, size>& marks, std::size_t part) {
    return hn::Ne(hn::Load(tag, marks.data() + lanes * part), hn::Zero(tag));
  }
};

/// One step of Gauss and Jordan, without exchange of rows. False where the pivot is below a tenth of what stands below
/// it, both brought to like size: a block mixes forces and moments. Of a definite block none is.
template <std::size_t k, std::size_t B>
HWY_INLINE bool eliminate_column(Block<B>& a, const double* size) {
  using R = Row<B, k>;
  constexpr std::size_t parts = Column<B>::parts;
  Column<B>& pivots = a.column[k];
  const V pivot = broadcast(pivots, k);
  const V bound = hn::Mul(hn::Abs(pivot), set(10 * size[k]));
  for (std::size_t p = k / lanes; p < parts; ++p) {
    const V below = hn::Mul(hn::Abs(pivots.part[p]), hn::Load(tag, size + lanes * p));
    if (!hn::AllTrue(tag, hn::Le(hn::IfThenElseZero(R::is(R::and_below, p), below), bound))) return false;
  }
  const V inverse = hn::Div(set(1), pivot);
  Column<B> column;
  for (std::size_t p = 0; p < parts; ++p) column.part[p] = hn::Neg(hn::Mul(inverse, pivots.part[p]));
  column.part[k / lanes] = hn::IfThenElse(R::is(R::itself, k / lanes), inverse, column.part[k / lanes]);
#pragma GCC unroll 6
  for (std::size_t c = 0; c < B; ++c) {
    if (c == k) continue;
    Column<B>& other = a.column[c];
    const V factor = broadcast(other, k);
    other.part[k / lanes] = hn::IfThenZeroElse(R::is(R::itself, k / lanes), other.part[k / lanes]);
    other.add(factor, column);
  }
  pivots = column;
  return true;
}

/// In place.
template <std::size_t B, std::size_t... k>
HWY_INLINE bool invert(Block<B>& a, const double* size, std::index_sequence<k...>) {
  return (eliminate_column<k>(a, size) && ...);
}

template <std::size_t B>
bool eliminate_all(const Chain& a, double* inverse, double* lower) {
  constexpr std::size_t block = B * B;
  V sum = hn::Zero(tag);  // what is not finite stays so in every sum: one look at the end is enough

  for (std::size_t i = 0; i < a.nodes; ++i) {
    Block<B> pivot = Block<B>::load(a.diagonal + block * i);
    double* L = lower + block * i;
    if (i > 0) {
      const Block<B> below = Block<B>::load(a.lower + block * (i - 1));
      const double* before = inverse + block * (i - 1);
      Block<B> factor;
      for (std::size_t c = 0; c < B; ++c) factor.column[c] = times(below, before + B * c);
      factor.store(L);
      const double* above = a.upper + block * (i - 1);
      for (std::size_t c = 0; c < B; ++c) {
#pragma GCC unroll 6
        for (std::size_t k = 0; k < B; ++k) pivot.column[c].subtract(set(above[B * c + k]), factor.column[k]);
      }
    }
    HWY_ALIGN double whole[block];
    pivot.store(whole);
    HWY_ALIGN double size[Column<B>::parts * lanes] = {};
    for (std::size_t r = 0; r < B; ++r) {
      const double diagonal = std::abs(whole[(B + 1) * r]);
      size[r] = diagonal > 0 ? 1 / std::sqrt(diagonal) : 1;
    }
    if (!invert(pivot, size, std::make_index_sequence<B>())) {
      invert_with_exchanges(static_cast<int>(B), whole, inverse + block * i);
      pivot = Block<B>::load(inverse + block * i);
    } else {
      pivot.store(inverse + block * i);
    }
    for (std::size_t c = 0; c < B; ++c) {
      for (const V part : pivot.column[c].part) sum = hn::Add(sum, part);
    }
  }
  return std::isfinite(hn::GetLane(hn::SumOfLanes(tag, sum)));
}

template <std::size_t B>
void substitute_all(std::size_t nodes, const double* inverse, const double* lower, const double* upper, double* x) {
  constexpr std::size_t block = B * B;
  const auto reduced = [](const double* from, const double* factor, const double* known) HWY_ATTR {
    Column<B> y = Column<B>::load(from);
    for (std::size_t k = 0; k < B; ++k) y.subtract(set(known[k]), Column<B>::load(factor + B * k));
    return y;
  };
  for (std::size_t i = 1; i < nodes; ++i) reduced(x + B * i, lower + block * i, x + B * (i - 1)).store(x + B * i);
  for (std::size_t i = nodes; i-- > 0;) {
    if (i + 1 < nodes) reduced(x + B * i, upper + block * i, x + B * (i + 1)).store(x + B * i);
    times(Block<B>::load(inverse + block * i), x + B * i).store(x + B * i);
  }
}

bool eliminate_5(const Chain& a, double* inverse, double* lower) {
  return eliminate_all<5>(a, inverse, lower);
}
bool eliminate_6(const Chain& a, double* inverse, double* lower) {
  return eliminate_all<6>(a, inverse, lower);
}
void substitute_5(std::size_t nodes, const double* inverse, const double* lower, const double* upper, double* x) {
  substitute_all<5>(nodes, inverse, lower, upper, x);
}
void substitute_6(std::size_t nodes, const double* inverse, const double* lower, const double* upper, double* x) {
  substitute_all<6>(nodes, inverse, lower, upper, x);
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::math::wide_blocks
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace strandyn::math::wide_blocks {

HWY_EXPORT(eliminate_5);
HWY_EXPORT(eliminate_6);
HWY_EXPORT(substitute_5);
HWY_EXPORT(substitute_6);

template <>
bool eliminate<5>(const Chain& a, double* inverse, double* lower) {
  return HWY_DYNAMIC_DISPATCH(eliminate_5)(a, inverse, lower);
}
template <>
bool eliminate<6>(const Chain& a, double* inverse, double* lower) {
  return HWY_DYNAMIC_DISPATCH(eliminate_6)(a, inverse, lower);
}
template <>
void substitute<5>(std::size_t nodes, const double* inverse, const double* lower, const double* upper, double* x) {
  HWY_DYNAMIC_DISPATCH(substitute_5)(nodes, inverse, lower, upper, x);
}
template <>
void substitute<6>(std::size_t nodes, const double* inverse, const double* lower, const double* upper, double* x) {
  HWY_DYNAMIC_DISPATCH(substitute_6)(nodes, inverse, lower, upper, x);
}

}  // namespace strandyn::math::wide_blocks
#endif
