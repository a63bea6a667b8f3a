// The springs of one interface, on both sides of the neutral plane: their traction under a trial slip, and what a
// commit does to them. Included once per instruction set.
//
// Most springs need no look: the smallest slide on, the largest stay stuck. So a commit leaves for each interface a
// window of springs, one for all points of a register and both sides: those below `slid_to` stood at their limit,
// pushed on by the step, those from `stuck_from` on had room. With d = K w, limits L_n then and L now, y_i = f_i/phi_i
// and p_i = kappa_i/phi_i, spring i
//     stays stuck if  |y_i + p_i d| < L,      slides if  y_i + p_i d > L  or  < -L
// For all stuck ones max(|y_i| + p_i d_max) is kept, for a d_max larger than the last step. For all sliding ones
// |y_i| = L_n, and the extremes of p_i tell. If either does not do, its springs are looked at one by one. Either way
// sums come out the same to the bit, so that a point does not feel which of the two its neighbours asked for: forces
// and stiffness are summed from the largest spring down, and parts of the limit have so few digits that no order
// matters.
#if defined(STRANDYN_SECTION_COMPLIANT_SPRINGS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRANDYN_SECTION_COMPLIANT_SPRINGS_INL
#undef STRANDYN_SECTION_COMPLIANT_SPRINGS_INL
#else
#define STRANDYN_SECTION_COMPLIANT_SPRINGS_INL
#endif

#include "compliant_kernel.hpp"
#include "sides-inl.hpp"
#include "slip_energy-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace strandyn::section::compliant_kernel {
namespace HWY_NAMESPACE {
using namespace kernel::HWY_NAMESPACE;

/// What a row of a table holds for either side.
HWY_INLINE Sides at_column(const double* row, SpringTable::Column column) {
  return {set(row[2 * column]), set(row[2 * column + 1])};
}

/// A spring that stands at its limit counts as stuck, whatever the last digits say.
constexpr double still_stuck = 1 + 1e-13;
/// Beyond that it surely slides.
constexpr double surely_slides = 1 + 1e-12;
/// Covers what rounding takes off a bound.
constexpr double rounded_up = 1 + 1e-15;
/// Room of the springs that need no look, in last steps of slip and of limit: the next one may be a larger one.
constexpr double steps_of_room = 2.5;

/// The springs of an interface under a trial slip.
struct Traction {
  Sides sum;      // of the springs' forces
  Sides holding;  // [-] the part of the stiffness that holds
  Sides sliding;  // [-] the part of the limit that sliding springs carry, signed
};

/// The rows of an interface at a midpoint on the tension side, and how far on those of the compression side are.
struct InterfaceAt {
  const double* at;
  std::size_t other_side;
  HWY_INLINE Sides operator[](std::size_t row) const {
    const double* here = at + row * block_lanes;
    return {hn::Load(tag, here), hn::Load(tag, here + other_side)};
  }
  /// One for all lanes.
  HWY_INLINE Window window_of(std::size_t springs) const { return Window::unpack(at[window * block_lanes], springs); }
};

/// What a commit notes of its registers, and whether it was made with ones like these: a history may come from another
/// machine.
HWY_INLINE V register_width() {
  return set(static_cast<double>(hn::Lanes(tag)));
}
HWY_INLINE bool same_registers(const double* lanes_row) {
  return *lanes_row == static_cast<double>(hn::Lanes(tag));
}

/// Sums over springs.
struct Springs {
  Sides held, holding, sliding;

  HWY_INLINE void add(const double* row, const Sides& K_slip, const Sides& reach, const Sides& f) {
    const Sides kappa = at_column(row, SpringTable::kappa);
    const Sides phi = at_column(row, SpringTable::phi);
    const Sides trial = mul_add(kappa, K_slip, f);
    // A limit of zero holds nothing, not even a trial of zero.
    const SideMasks holds = above(mul(phi, reach), absolute(trial));
    held = kernel::HWY_NAMESPACE::add(held, if_else_zero(holds, f));
    holding = kernel::HWY_NAMESPACE::add(holding, if_else_zero(holds, kappa));
    sliding = kernel::HWY_NAMESPACE::add(sliding, zero_if(holds, turned_as(phi, trial)));
  }
};

/// Whether all springs that had room stay stuck.
HWY_INLINE bool have_room(const InterfaceAt& face, const Sides& K_slip, const Sides& limit) {
  return all_true(both_of(not_above(absolute(K_slip), absolute(face[next_step])), above(limit, face[needed])));
}

/// Whether all springs below a row slide, and to which side.
struct Slides {
  bool all = false;
  bool onward = false;  // all of them on, as the last step pushed them
  Sides direction;      // its signs count
};
HWY_INLINE Slides slide_below(const SpringTable& table, const double* row, const InterfaceAt& face, const Sides& K_slip,
                              const Sides& limit) {
  const Sides pushed = face[next_step];
  const Sides along = times_sign(K_slip, pushed);
  const Sides least = at_column(row, SpringTable::pull_below);
  const Sides then = face[limit_then];
  const Sides needed = mul(limit, both(surely_slides));
  const SideMasks forward = above(along, both(0));
  const SideMasks pulled = above(mul_add(least, along, then), needed);
  if (all_true(both_of(forward, pulled))) return {.all = true, .onward = true, .direction = pushed};
  const Sides most = at_column(table.row(0), SpringTable::pull_from);
  const SideMasks held_back = above(mul_add(most, along, then), needed);
  const SideMasks goes_on = one_of(both_of(forward, pulled), without(forward, held_back));
  const SideMasks turns = above(neg(needed), mul_add(least, along, then));
  return {.all = all_true(one_of(goes_on, turns)), .direction = choose(goes_on, pushed, neg(pushed))};
}

/// `windows`: whether a commit has left the sums for registers of this width.
HWY_INLINE Traction traction_of(const SpringTable& table, const InterfaceAt& face, bool windows, const Sides& K_slip,
                                const Sides& limit) {
  const std::size_t springs = table.springs();
  Springs sum{both(0), both(0), both(0)};
  Window look{0, springs};
  if (windows) {
    look = face.window_of(springs);
    const double* row = table.row(look.stuck_from);
    if (have_room(face, K_slip, limit)) {
      sum.held = face[held_there];
      sum.holding = at_column(row, SpringTable::kappa_from);
    } else {
      look.stuck_from = springs;
    }
    if (look.slid_to > 0) {
      row = table.row(look.slid_to);
      const Slides slides = slide_below(table, row, face, K_slip, limit);
      if (slides.all) {
        sum.sliding = turned_as(at_column(row, SpringTable::phi_below), slides.direction);
      } else {
        look.slid_to = 0;
      }
    }
  }
  const Sides reach = mul(limit, both(still_stuck));
  const double* row = table.row(look.stuck_from);
  for (std::size_t i = look.stuck_from; i-- > look.slid_to;) {
    row -= SpringTable::row_length;
    sum.add(row, K_slip, reach, face[first_spring + i]);
  }
  return {mul_add(limit, sum.sliding, mul_add(sum.holding, K_slip, sum.held)), sum.holding, sum.sliding};
}

/// Stiffness of an interface after the step, and its inverses.
struct Rigidity {
  HWY_INLINE Rigidity(V before, V after) : K(after), per_K(inverse(after)) {
    widening = hn::Mul(set(0.5), hn::Max(hn::Zero(tag), hn::Sub(inverse(before), per_K)));
  }
  static HWY_INLINE V inverse(V x) {
    const Mask some = hn::Gt(x, hn::Zero(tag));
    return hn::IfThenElseZero(some, hn::Div(set(1), hn::IfThenElse(some, x, set(1))));
  }
  V K, per_K;
  V widening;  // what a spring's square of force loses as K grows
};

/// Energies of the springs of an interface, over what `add_to` multiplies them by.
struct SpringEnergy {
  V stored, lost, trapezoid, widened;

  HWY_INLINE void store(const Sides& per_kappa, const Sides& now) {
    const Sides twice = mul(mul(now, now), per_kappa);
    stored = hn::Add(stored, hn::Add(twice.t, twice.c));
  }
  HWY_INLINE void lose(const Sides& per_kappa, const Sides& before, const Sides& trial, const Sides& now) {
    const Slide t = slide_of(before.t, trial.t, now.t, per_kappa.t);
    const Slide c = slide_of(before.c, trial.c, now.c, per_kappa.c);
    lost = hn::Add(lost, hn::Add(t.loss, c.loss));
    trapezoid = hn::Add(trapezoid, hn::Add(t.trapezoid, c.trapezoid));
  }
  HWY_INLINE void widen(const Sides& per_kappa, const Sides& before) {
    const Sides part = mul(mul(before, before), per_kappa);
    widened = hn::Add(widened, hn::Add(part.t, part.c));
  }
  HWY_INLINE void add_to(SlipEnergy& sums, const Rigidity& K, V weight) const {
    const V by_widening = hn::Mul(K.widening, widened);
    sums.dissipated = hn::MulAdd(weight, hn::MulAdd(K.per_K, lost, by_widening), sums.dissipated);
    sums.trapezoid = hn::MulAdd(weight, hn::MulAdd(K.per_K, trapezoid, by_widening), sums.trapezoid);
    sums.stored = hn::MulAdd(hn::Mul(weight, hn::Mul(set(0.5), K.per_K)), stored, sums.stored);
  }
};

/// The window that a commit leaves: from the largest spring down as far as all have room.
struct NextWindow {
  Sides lowest;           // the least limit that the next step may have
  Sides step, step_size;  // K w that it may have
  Sides held, most;       // of those that have room: the sum of their forces, the limit that they need at most
  std::size_t stuck_from;
  bool open = true;

  HWY_INLINE NextWindow(std::size_t springs, const Sides& grown, const Sides& limit, const Sides& K_slip)
      : stuck_from(springs) {
    lowest = sub(limit, absolute(grown));
    step = mul(both(steps_of_room), K_slip);
    step_size = absolute(step);
    held = both(0);
    most = both(-1e300);
  }
  /// Those of the window before that have kept their room, by a bound that spares a look at each: none needs more than
  /// what all needed, and what the slip and a longer step to come add to the one that is pulled most.
  HWY_INLINE bool keeps_room(const double* row, const InterfaceAt& face, const Sides& K_slip) {
    const Sides more = sub(add(absolute(K_slip), step_size), absolute(face[next_step]));
    const Sides pulled = mul(at_column(row, SpringTable::pull_from), larger(both(0), more));
    const Sides bound = mul_add(both(rounded_up), face[needed], pulled);
    if (!all_true(above(lowest, bound))) return false;
    most = bound;
    return true;
  }
  /// One more spring, which has that force now.
  HWY_INLINE void take(std::size_t spring, const double* row, const Sides& now) {
    const Sides y = mul(at_column(row, SpringTable::per_phi), absolute(now));
    const Sides next = larger(most, mul_add(at_column(row, SpringTable::pull_from), step_size, y));
    open = all_true(above(lowest, next));
    if (!open) return;
    most = next;
    held = add(held, now);
    stuck_from = spring;
  }
  /// Springs below the others that stand at their limit, pushed on, and outrun it; those below `first` do.
  HWY_INLINE std::size_t slid_to(const SpringTable& table, const InterfaceAt& face, const Sides& limit,
                                 const Sides& grown, std::size_t first) const {
    const Sides signed_limit = with_sign_of(limit, step);
    const double* row = table.row(first);
    for (std::size_t i = first; i < stuck_from; ++i) {
      const Sides at_limit = mul(signed_limit, at_column(row, SpringTable::phi));
      row += SpringTable::row_length;
      const SideMasks outrun = above(mul(at_column(row, SpringTable::pull_below), step_size), grown);
      if (!all_true(both_of(outrun, equal(at_limit, face[first_spring + i])))) return i;
    }
    return stuck_from;
  }
};

/// The springs of an interface on their way through a commit.
struct Settling {
  const SpringTable& table;
  double* at;
  std::size_t other_side;
  Sides K_slip, limit;

  HWY_INLINE void keep(std::size_t row, const Sides& value) const {
    hn::Store(value.t, tag, at + row * block_lanes);
    hn::Store(value.c, tag, at + row * block_lanes + other_side);
  }
  HWY_INLINE Sides force(std::size_t spring) const { return InterfaceAt{at, other_side}[first_spring + spring]; }
  HWY_INLINE Sides trial(const double* row, const Sides& f) const {
    return mul_add(at_column(row, SpringTable::kappa), K_slip, f);
  }
  /// Springs from `from` on, which stay stuck.
  template <bool kTake>
  HWY_INLINE void stick(std::size_t from, NextWindow& next, SpringEnergy& energy) const {
    const double* row = table.row(table.springs());
    for (std::size_t i = table.springs(); i-- > from;) {
      row -= SpringTable::row_length;
      const Sides now = trial(row, force(i));
      energy.store(at_column(row, SpringTable::per_kappa), now);
      keep(first_spring + i, now);
      if constexpr (!kTake) next.held = add(next.held, now);
      if constexpr (kTake) {
        if (next.open) next.take(i, row, now);
      }
    }
  }
  /// Springs from `to` down to `from`, which may slide.
  HWY_INLINE void clip_each(std::size_t to, std::size_t from, NextWindow& next, SpringEnergy& energy) const {
    const double* row = table.row(to);
    for (std::size_t i = to; i-- > from;) {
      row -= SpringTable::row_length;
      const Sides per_kappa = at_column(row, SpringTable::per_kappa);
      const Sides f = force(i);
      const Sides most = mul(limit, at_column(row, SpringTable::phi));
      const Sides clipped = trial(row, f);
      const Sides now{clip(clipped.t, most.t), clip(clipped.c, most.c)};
      energy.lose(per_kappa, f, clipped, now);
      energy.store(per_kappa, now);
      keep(first_spring + i, now);
      if (next.open) next.take(i, row, now);
    }
  }
  /// Springs below `to`, which slide on.
  HWY_INLINE void slide(std::size_t to, const Sides& direction, SpringEnergy& energy) const {
    const Sides signed_limit = with_sign_of(limit, direction);
    const double* row = table.row(to);
    for (std::size_t i = to; i-- > 0;) {
      row -= SpringTable::row_length;
      const Sides per_kappa = at_column(row, SpringTable::per_kappa);
      const Sides f = force(i);
      const Sides now = mul(signed_limit, at_column(row, SpringTable::phi));
      energy.lose(per_kappa, f, trial(row, f), now);
      energy.store(per_kappa, now);
      keep(first_spring + i, now);
    }
  }
};

/// Moves the springs of one interface and leaves their window. `at` is the row of the interface on the tension side.
HWY_INLINE void settle_springs(const SpringTable& table, double* at, std::size_t other_side, bool windows,
                               const Rigidity& K, const Sides& across, const Sides& limit, V weight, SlipEnergy& sums) {
  const std::size_t springs = table.springs();
  const InterfaceAt face{at, other_side};
  const Sides K_slip = mul(both(K.K), across);
  const Settling settling{table, at, other_side, K_slip, limit};
  const Sides grown = mul(both(steps_of_room), sub(limit, face[limit_then]));
  NextWindow next(springs, grown, limit, K_slip);
  const V zero = hn::Zero(tag);
  SpringEnergy energy{zero, zero, zero, zero};
  if (!hn::AllTrue(tag, hn::Eq(K.widening, zero))) {
    for (std::size_t i = springs; i-- > 0;) {
      energy.widen(at_column(table.row(i), SpringTable::per_kappa), settling.force(i));
    }
  }
  const Window before = windows ? face.window_of(springs) : Window{0, springs};
  std::size_t free_from = springs;
  if (windows && have_room(face, K_slip, limit)) {
    free_from = before.stuck_from;
    if (next.keeps_room(table.row(free_from), face, K_slip)) {
      next.stuck_from = free_from;
      settling.stick<false>(free_from, next, energy);
    } else {
      settling.stick<true>(free_from, next, energy);
    }
  }
  Slides slides;
  if (before.slid_to > 0) slides = slide_below(table, table.row(before.slid_to), face, K_slip, limit);
  const std::size_t slid_to = slides.onward ? before.slid_to : 0;
  settling.clip_each(free_from, slid_to, next, energy);
  std::size_t outrun_to = 0;
  if (slid_to > 0) {
    settling.slide(slid_to, slides.direction, energy);
    const Sides least = at_column(table.row(slid_to), SpringTable::pull_below);
    if (all_true(above(mul(least, next.step_size), grown))) outrun_to = slid_to;
  }
  energy.add_to(sums, K, weight);
  const Window left{next.slid_to(table, face, limit, grown, outrun_to), next.stuck_from};
  settling.keep(limit_then, limit);
  settling.keep(window, both(left.packed()));
  settling.keep(held_there, next.held);
  settling.keep(next_step, next.step);
  settling.keep(needed, next.most);
}

}  // namespace HWY_NAMESPACE
}  // namespace strandyn::section::compliant_kernel
HWY_AFTER_NAMESPACE();
#endif
