// A register of element matrices, added to the blocks of a chain. Included once per instruction set.
#if defined(STRANDYN_BEAM_ELEMENT_BLOCKS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_BEAM_ELEMENT_BLOCKS_INL
#undef STRANDYN_BEAM_ELEMENT_BLOCKS_INL
#else
#define STRANDYN_BEAM_ELEMENT_BLOCKS_INL
#endif

#include <algorithm>
#include <array>

#include "element_lanes-inl.hpp"
#include "space_lanes-inl.hpp"
#include "strandyn/beam/spatial_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::beam::lanes {
namespace HWY_NAMESPACE {

/// Matrices of a register of elements with six unknowns a node: entry by entry, column by column.
class ElementMatrices {
 public:
  static constexpr std::size_t size = 12;

  HWY_INLINE void set(std::size_t row, std::size_t column, V value) {
    hn::Store(value, tag, entries_ + (size * column + row) * most_lanes);
  }
  /// A 3 x 3 block that begins there.
  HWY_INLINE void set(std::size_t row, std::size_t column, const Mat& m) {
    set_column(row, column, m.x);
    set_column(row, column + 1, m.y);
    set_column(row, column + 2, m.z);
  }
  HWY_INLINE void set_column(std::size_t row, std::size_t column, const Vec& v) {
    set(row, column, v.x);
    set(row + 1, column, v.y);
    set(row + 2, column, v.z);
  }

  /// Adds the matrices of `count` elements from `first` on.
  void add_to(const SpatialLanes::Blocks& K, std::size_t first, std::size_t count) const {
    K.nodal_unknowns == 6 ? add<6>(K, first, count) : add<5>(K, first, count);
  }

 private:
  /// The six unknowns of a node that the chain has.
  template <std::size_t B>
  static constexpr std::size_t kept(std::size_t i) {
    return B == 5 && i > 2 ? i + 1 : i;
  }
  /// Where the entries of a B x B block lie, as its columns follow each other.
  template <std::size_t B>
  static constexpr std::array<std::size_t, B * B> places(std::size_t row, std::size_t column) {
    std::array<std::size_t, B * B> all{};
    for (std::size_t c = 0; c < B; ++c) {
      for (std::size_t r = 0; r < B; ++r) {
        all[B * c + r] = (size * (column + kept<B>(c)) + row + kept<B>(r)) * most_lanes;
      }
    }
    return all;
  }

  template <std::size_t B>
  void add(const SpatialLanes::Blocks& K, std::size_t first, std::size_t count) const {
    static constexpr auto first_by_first = places<B>(0, 0), first_by_second = places<B>(0, 6);
    static constexpr auto second_by_first = places<B>(6, 0), second_by_second = places<B>(6, 6);
    const std::size_t block = B * B;
    add_block(first_by_first, K.diagonal + block * first, count);
    add_block(second_by_second, K.diagonal + block * (first + 1), count);
    add_block(first_by_second, K.upper + block * first, count);
    add_block(second_by_first, K.lower + block * first, count);
  }

  /// To blocks that follow each other, one of each element.
  template <std::size_t n>
  void add_block(const std::array<std::size_t, n>& place, double* to, std::size_t count) const {
    std::size_t i = 0;
#if HWY_MAX_BYTES >= 32
    if constexpr (most_lanes == 4) {
      // Four entries of four elements are turned about into four entries of each element.
      for (; count == most_lanes && i + 4 <= n; i += 4) {
        const V a = hn::Load(tag, entries_ + place[i]), b = hn::Load(tag, entries_ + place[i + 1]);
        const V c = hn::Load(tag, entries_ + place[i + 2]), d = hn::Load(tag, entries_ + place[i + 3]);
        const V ab_even = hn::InterleaveLower(tag, a, b), ab_odd = hn::InterleaveUpper(tag, a, b);
        const V cd_even = hn::InterleaveLower(tag, c, d), cd_odd = hn::InterleaveUpper(tag, c, d);
        const auto add_to = [to, i](std::size_t element, V four) HWY_ATTR {
          double* at = to + n * element + i;
          hn::StoreU(hn::Add(hn::LoadU(tag, at), four), tag, at);
        };
        add_to(0, hn::ConcatLowerLower(tag, cd_even, ab_even));
        add_to(1, hn::ConcatLowerLower(tag, cd_odd, ab_odd));
        add_to(2, hn::ConcatUpperUpper(tag, cd_even, ab_even));
        add_to(3, hn::ConcatUpperUpper(tag, cd_odd, ab_odd));
      }
    }
#endif
    for (; i < n; ++i) {
      for (std::size_t element = 0; element < count; ++element) to[n * element + i] += entries_[place[i] + element];
    }
  }

  HWY_ALIGN double entries_[size * size * most_lanes];
};

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::beam::lanes
HWY_AFTER_NAMESPACE();
#endif
