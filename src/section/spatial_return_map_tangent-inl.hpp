// Derivatives of one solved layer by the four strains, for one register of section points. Once per instruction set.
#if defined(STRANDYN_SPATIAL_TANGENT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_SPATIAL_TANGENT_INL
#undef STRANDYN_SPATIAL_TANGENT_INL
#else
#define STRANDYN_SPATIAL_TANGENT_INL
#endif

#include "spatial_return_map_march-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::spatial_kernel {
namespace HWY_NAMESPACE {

/// What the bending of wires adds to the resultants, in the order of the components.
using Resultants = std::array<V, component_count>;

/// Derivatives of the sums over a turn, or over one quarter of it, by one thing that a layer is given.
struct Sums {
  V before, moment2, moment3, force;

  static Sums none() {
    const V zero = hn::Zero(tag);
    return {zero, zero, zero, zero};
  }
  HWY_INLINE void add(V factor, const Sums& other) {
    before = hn::MulAdd(factor, other.before, before);
    moment2 = hn::MulAdd(factor, other.moment2, moment2);
    moment3 = hn::MulAdd(factor, other.moment3, moment3);
    force = hn::MulAdd(factor, other.force, force);
  }
};

/// The same with the end of each quarter.
struct Column {
  Sums sums;
  std::array<V, quarters> end;
};

/// Where the sums of a column take a cell: four quarters at once, cells i of each.
struct CellWeights {
  V cosine, sine, share02, share13;
};

/// dq of the four cells into the sums of a turn; the force takes F_b at the cells' edges here.
HWY_INLINE void collect(const CellWeights& w, const std::array<V, quarters>& q, const std::array<V, quarters>& base,
                        Sums& sums) {
  const V q02 = hn::Sub(q[0], q[2]);
  const V q13 = hn::Sub(q[1], q[3]);
  sums.before = hn::MulAdd(w.share02, hn::Add(q[0], q[2]), hn::MulAdd(w.share13, hn::Add(q[1], q[3]), sums.before));
  sums.moment2 = hn::MulAdd(w.cosine, q02, hn::NegMulAdd(w.sine, q13, sums.moment2));
  sums.moment3 = hn::MulAdd(w.sine, q02, hn::MulAdd(w.cosine, q13, sums.moment3));
  sums.force = hn::Add(sums.force, hn::Add(hn::Add(base[0], base[1]), hn::Add(base[2], base[3])));
}

/// What feeds a column beside the base: the increments of each cell's q while its base is held.
enum class Source { own_start, mean, load, chi2, chi3 };

template <Source kSource>
HWY_INLINE Column column_of(const SpatialCoefficients& c, const Layer& layer, const Record& record, V neutral,
                            std::array<Sums, quarters>* by_quarter) {
  const std::size_t cells = c.cosine.size();
  const V step = set(2 * layer.half_step);
  const V first = kSource == Source::own_start ? set(1) : hn::Zero(tag);
  std::array<V, quarters> base{first, first, first, first};
  Column column{Sums::none(), {}};
  Sums own0 = Sums::none(), own1 = own0, own2 = own0, own3 = own0;
  const V second = hn::Sub(neutral, set(static_cast<double>(cells)));
  for (std::size_t i = 0; i < cells; ++i) {
    const double place = static_cast<double>(i);
    const CellWeights w{set(c.cosine[i]), set(c.sine[i]), share_before(neutral, place), share_before(second, place)};
    std::array<V, quarters> q;
    for (std::size_t j = 0; j < quarters; ++j) {
      const std::size_t at = (j * cells + i) * block_lanes;
      const V follow = hn::Load(tag, record.follow + at);
      if constexpr (kSource == Source::load) {
        q[j] = hn::MulAdd(follow, base[j], hn::Load(tag, record.by_load + at));
      } else if constexpr (kSource == Source::chi2 || kSource == Source::chi3) {
        // (cos, sin) of the four quarters: (c, s), (-s, c), (-c, -s), (s, -c)
        const bool plain = (kSource == Source::chi2) == (j % 2 == 0);
        const bool negative = kSource == Source::chi2 ? j == 1 || j == 2 : j >= 2;
        const V e = plain ? w.cosine : w.sine;
        const V stick = hn::Load(tag, record.stick + at);
        const V direct = hn::Mul(follow, base[j]);
        q[j] = negative ? hn::NegMulAdd(stick, e, direct) : hn::MulAdd(stick, e, direct);
      } else {
        q[j] = hn::Mul(follow, base[j]);
      }
    }
    if constexpr (kSource == Source::own_start) {
      const V zero = hn::Zero(tag);
      collect(w, {q[0], zero, zero, zero}, {base[0], zero, zero, zero}, own0);
      collect(w, {zero, q[1], zero, zero}, {zero, base[1], zero, zero}, own1);
      collect(w, {zero, zero, q[2], zero}, {zero, zero, base[2], zero}, own2);
      collect(w, {zero, zero, zero, q[3]}, {zero, zero, zero, base[3]}, own3);
    } else {
      collect(w, q, base, column.sums);
    }
    for (std::size_t j = 0; j < quarters; ++j) {
      base[j] = hn::MulAdd(step, kSource == Source::mean ? hn::Sub(q[j], set(1)) : q[j], base[j]);
    }
  }
  // The midpoints' F_b is base + q dS/2: over a quarter that adds half of what q moved the base by.
  const V half = set(0.5);
  const V by_mean = set(kSource == Source::mean ? layer.half_step * static_cast<double>(cells) : 0);
  if constexpr (kSource == Source::own_start) {
    *by_quarter = {own0, own1, own2, own3};
    for (std::size_t j = 0; j < quarters; ++j) {
      (*by_quarter)[j].force = hn::MulAdd(half, hn::Sub(base[j], first), (*by_quarter)[j].force);
    }
  } else {
    for (std::size_t j = 0; j < quarters; ++j) {
      column.sums.force = hn::MulAdd(half, hn::Sub(base[j], first), hn::Add(column.sums.force, by_mean));
    }
  }
  column.end = base;
  return column;
}

/// Adds a layer to the tangent and hands the derivatives of its load inward. `inner` is the load before its clamp.
HWY_INLINE void add_tangent(const SpatialCoefficients& c, const Layer& layer, const Record& record, const Turn& turn,
                            const Unknowns& at, V neutral, V inner, const std::array<V, 2>& neutral_by_chi,
                            Resultants& f_int, std::array<Resultants, component_count>& tangent) {
  const V zero = hn::Zero(tag);
  const V one = set(1);
  std::array<Sums, quarters> by_start;
  column_of<Source::own_start>(c, layer, record, neutral, &by_start);
  const Column mean = column_of<Source::mean>(c, layer, record, neutral, nullptr);
  const Column load = column_of<Source::load>(c, layer, record, neutral, nullptr);
  const std::array<Column, 2> by_chi{column_of<Source::chi2>(c, layer, record, neutral, nullptr),
                                     column_of<Source::chi3>(c, layer, record, neutral, nullptr)};
  const Closure closure(c, layer, neutral, turn);
  const V step = set(2 * layer.half_step);
  const V neutral_turn = hn::Mul(step, hn::NegMulAdd(set(2), at.mean, turn.at_neutral));
  const Mask closed = hn::Gt(inner, zero);
  const double outer = layer.c_ext * layer.next_layer_ratio;
  const Resultants axial_force{set(layer.force_per_strain), set(layer.force_per_twist), zero, zero};
  constexpr std::size_t first_bending = static_cast<std::size_t>(Component::bending2);

  for (std::size_t y = 0; y < component_count; ++y) {
    // What strain y changes while starts and mean are held ...
    const V a = axial_force[y];
    Sums sums = Sums::none();
    std::array<V, quarters> end;
    sums.add(f_int[y], load.sums);
    for (std::size_t j = 0; j < quarters; ++j) end[j] = hn::Mul(f_int[y], load.end[j]);
    V neutral_moves = zero;
    if (y >= first_bending) {
      const Column& column = by_chi[y - first_bending];
      sums.add(one, column.sums);
      for (std::size_t j = 0; j < quarters; ++j) end[j] = hn::Add(end[j], column.end[j]);
      neutral_moves = hn::Mul(neutral_turn, neutral_by_chi[y - first_bending]);
    } else {
      // The axial force moves q as a start does, but is no part of F_b.
      for (std::size_t j = 0; j < quarters; ++j) {
        sums.add(a, by_start[j]);
        end[j] = hn::MulAdd(a, hn::Sub(turn.end_by_start[j], one), end[j]);
      }
      sums.force = hn::NegMulAdd(set(c.points), a, sums.force);
    }
    // ... and what these change in turn.
    const Unknowns change = closure.solve(end, hn::MulAdd(step, sums.before, neutral_moves));
    for (std::size_t j = 0; j < quarters; ++j) sums.add(change.start[j], by_start[j]);
    sums.add(change.mean, mean.sums);

    tangent[0][y] = hn::MulAdd(set(layer.axial_weight), sums.force, tangent[0][y]);
    tangent[1][y] = hn::MulAdd(set(layer.torsion_weight), sums.force, tangent[1][y]);
    tangent[2][y] = hn::MulAdd(set(layer.weight), sums.moment2, tangent[2][y]);
    tangent[3][y] = hn::MulAdd(set(layer.weight), sums.moment3, tangent[3][y]);
    V handed = hn::MulAdd(set(layer.kappa), a, hn::Mul(set(outer), f_int[y]));
    handed = hn::MulAdd(set(layer.kappa / c.points), sums.force, handed);
    f_int[y] = hn::IfThenElseZero(closed, hn::Mul(set(layer.inverse_c_int), handed));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::spatial_kernel
HWY_AFTER_NAMESPACE();
#endif
