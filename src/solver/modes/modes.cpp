#include "strandyn/solver/modes/modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "mode_kind.hpp"
#include "nearest.hpp"
#include "rigid_modes.hpp"
#include "slices.hpp"
#include "strandyn/core/error.hpp"

namespace strandyn::solver {

using system::System;
using system::Vector;

namespace {

Mode as_rigid(Mode mode) {
  mode.kind = ModeKind::rigid;
  mode.frequency = 0;
  mode.number = 0;
  return mode;
}

/// What a mode is; an unstable state is refused.
class Judge {
 public:
  Judge(const System& system, const Pencil& pencil, bool free)
      : system_(system), pencil_(pencil), free_(free), noise_(free ? shift_of_free_chain(pencil.K, pencil.M) : 0) {}

  /// `before`: how many modes stand before it.
  Mode operator()(const RawMode& raw, std::size_t before) const {
    if (raw.eigenvalue < noise_) {
      throw ComputationError(
          fmt::format("mode {} has a negative stiffness (omega^2 = {:.3g} 1/s^2): the state about "
                      "which it vibrates is unstable; raise the tension",
                      before + 1, raw.eigenvalue));
    }
    Mode mode = describe(system_.model(), pencil_.M, raw);
    return free_ && raw.eigenvalue <= -noise_ ? as_rigid(std::move(mode)) : mode;
  }

 private:
  const System& system_;
  const Pencil& pencil_;
  bool free_;
  double noise_;  // [1/s^2] <= 0
};

/// Those of the lowest modes that are in the plane of the span, in slices, until there are `count`, or fewer where the
/// mesh carries no more.
std::vector<Mode> in_plane_by_slices(const System& system, const Vector& u, std::size_t count, const Stop& stop) {
  const Pencil pencil(system, u);
  const std::vector<RawMode> rigid = find_rigid(system, u, pencil.K, pencil.M);
  const Judge judge(system, pencil, !rigid.empty());
  std::vector<Mode> modes;
  std::size_t judged = 0;
  lowest_in_slices(system, pencil, rigid, stop, [&](const std::vector<RawMode>& found) {
    for (; judged < found.size(); ++judged) {
      Mode mode = judge(found[judged], judged);
      if (mode.kind == ModeKind::in_plane) modes.push_back(std::move(mode));
    }
    return modes.size() >= count;
  });
  return modes;
}

std::vector<Mode> numbered(std::vector<Mode> modes, std::size_t count) {
  modes.resize(count);
  for (std::size_t i = 0; i < count; ++i) modes[i].number = i + 1;
  return modes;
}

}  // namespace

std::vector<Mode> find_modes(const System& system, const Vector& u, const ModeOptions& options) {
  const Pencil pencil(system, u);
  const std::size_t with_mass = unknowns_with_mass(system);
  // The solver finds all modes but the highest.
  if (options.count >= with_mass || with_mass < 2) {
    throw ComputationError(
        fmt::format("{} modes were asked for, but the mesh has only {} unknowns with mass; "
                    "give more [span] elements",
                    options.count, with_mass));
  }
  const std::vector<RawMode> rigid = find_rigid(system, u, pencil.K, pencil.M);
  const Judge judge(system, pencil, !rigid.empty());
  const bool many = options.near == 0 && options.count > slice_size && 4 * options.count < with_mass;
  std::vector<RawMode> raw;
  if (many) {
    raw = lowest_in_slices(system, pencil, rigid, options.stop,
                           [&](const std::vector<RawMode>& found) { return found.size() >= options.count; });
    raw.resize(options.count);
  } else {
    raw = nearest_to(system, pencil, options, rigid);
  }
  std::vector<Mode> modes;
  for (const RawMode& mode : raw) modes.push_back(judge(mode, modes.size()));
  // What is nearest to a frequency leaves no mode out in between.
  std::size_t number = options.near > 0 ? modes_below(pencil, raw) : 0;
  number -= std::min(number, rigid.size());
  for (Mode& mode : modes) {
    if (mode.kind != ModeKind::rigid) mode.number = ++number;
  }
  return modes;
}

std::vector<Mode> rigid_modes(const System& system, const Vector& u) {
  const Pencil pencil(system, u);
  std::vector<Mode> modes;
  for (const RawMode& mode : find_rigid(system, u, pencil.K, pencil.M)) {
    modes.push_back(as_rigid(describe(system.model(), pencil.M, mode)));
  }
  return modes;
}

std::vector<Mode> transverse_modes(const System& system, const Vector& u, std::size_t count, const Stop& stop) {
  // Others lie in between: ask for a few more until enough transverse ones are found.
  const std::size_t with_mass = unknowns_with_mass(system);
  if (with_mass < 2) throw ComputationError("the mesh has no free nodes that vibrate; give more [span] elements");
  const std::size_t planes = model::is_spatial(system.model().freedom) ? 2 : 1;
  if (planes * count > slice_size) {
    std::vector<Mode> modes = in_plane_by_slices(system, u, count, stop);
    if (modes.size() >= count) return numbered(std::move(modes), count);
  }
  for (std::size_t asked = planes * count + 4;; asked *= 2) {
    asked = std::min(asked, with_mass - 1);
    std::vector<Mode> modes = find_modes(system, u, {.count = asked, .stop = stop});
    std::erase_if(modes, [](const Mode& mode) { return mode.kind != ModeKind::in_plane; });
    if (modes.size() >= count) return numbered(std::move(modes), count);
    if (asked + 1 >= with_mass) {
      throw ComputationError(
          fmt::format("the mesh carries only {} modes across the span, mode {} was asked for; "
                      "give more [span] elements",
                      modes.size(), count));
    }
  }
}

}  // namespace strandyn::solver
