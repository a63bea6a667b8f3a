#pragma once
/// \file Natural frequencies and mode shapes about the committed state, all friction sticking at first.
///
///     K phi = omega^2 M phi,   phi^T M phi = 1
/// K is the tangent at the committed state, its symmetric part, loads that follow rotations included. Unknowns without
/// mass follow the others. A round section vibrates alike in all planes: of such equal frequencies every mode is found,
/// and the shapes are turned so that each moves in one plane.

#include <vector>

#include "strandyn/core/stop.hpp"
#include "strandyn/system/system.hpp"

namespace strandyn::solver {

/// Where most of the kinetic energy of a mode is: along the chain, across it in the x-y plane or out of it, in twist;
/// or the chain moves in one piece that no support holds, at frequency 0.
enum class ModeKind { axial, in_plane, out_of_plane, torsional, rigid };
const char* name_of(ModeKind kind);  ///< "in-plane"

struct Mode {
  double frequency = 0;    ///< [Hz]
  std::size_t number = 0;  ///< from 1, among all modes that are not rigid, which have 0; of `transverse_modes`
                           ///< among those
  ModeKind kind = ModeKind::in_plane;
  system::Vector shape;   ///< all unknowns; scaled to 1 m (or 1 rad, a torsional one) where it is largest
  double modal_mass = 0;  ///< [kg] ([kg m^2]) of that scaling
};

struct ModeOptions {
  std::size_t count = 1;
  double near = 0;  ///< [Hz] the modes whose frequencies are nearest to this one; 0: the lowest
  Stop stop = {};   ///< asked now and then
};

/// Modes in ascending order, rigid ones first. Throws ComputationError where the state is unstable or the solver
/// stalls, Interrupted where it is stopped.
std::vector<Mode> find_modes(const system::System& system, const system::Vector& u, const ModeOptions& options);

/// The lowest modes whose motion is mainly across the span and in its plane: what "mode 12" counts. Rigid motions do
/// not.
std::vector<Mode> transverse_modes(const system::System& system, const system::Vector& u, std::size_t count,
                                   const Stop& stop = {});
/// The motions of the chain in one piece that nothing holds: none of a span between supports.
std::vector<Mode> rigid_modes(const system::System& system, const system::Vector& u);

}  // namespace strandyn::solver
