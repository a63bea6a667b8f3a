#pragma once
/// \file What stands on the test bench: a span at rest under its tension, the mode that is to vibrate, and a shaker.
///
/// The shaker is a force F sin(w t + phase) at a point, or the prescribed motion b sin(w t + phase) of a support or a
/// point. What it does is constant during an integration: it changes from one run to the next, at the end of a cycle,
/// where the drive passes zero, so that it never jumps.

#include <complex>

#include "strandyn/build/shaker.hpp"
#include "strandyn/solver/time/integrator.hpp"
#include "strandyn/span/rest.hpp"

namespace strandyn::laboratory {

/// Of one integration.
struct Drive {
  double frequency = 0;  ///< [Hz]
  double amplitude = 0;  ///< [N] or [m]; below zero it brakes
  double phase = 0;      ///< [rad]
};

class BenchSpan {
 public:
  /// `mode` [-] counts the modes across the span, in its plane.
  BenchSpan(build::BuiltSpan built, const build::Shaker& shaker, int mode);

  span::SpanAtRest& at_rest() { return span_; }
  const span::SpanAtRest& at_rest() const { return span_; }

  int mode_number() const { return mode_number_; }
  double frequency() const { return frequency_; }    ///< [Hz] of the mode at rest
  double modal_mass() const { return modal_mass_; }  ///< [kg] at an antinode of 1
  /// [-] cycles that a wave takes there and back along the span: in them the mode below falls behind by one. n in mode
  /// n of a string; fewer in a stiff span, whose modes lie further apart.
  double round_trip() const { return round_trip_; }
  double loop_length() const { return loop_length_; }     ///< [m] by tension and mass
  const system::Vector& shape() const { return shape_; }  ///< at an antinode of 1; driven in its own direction

  bool moves() const { return shaker_.moves; }
  double shaker_position() const;  ///< [m] from the left support
  /// Force on the modal coordinate per drive: [-] share of the shape at a force, [N/m] of a motion.
  double coupling() const { return coupling_; }
  /// Of an integration under `drive`: the span's own shaker has an amplitude of 1.
  std::vector<model::Drive> drives(const Drive& drive) const {
    return {{.frequency = drive.frequency, .amplitude = drive.amplitude, .phase = drive.phase}};
  }

  /// [m] the mode's share in a state, projected with the mass matrix: no other mode of the span at rest shows in it.
  double modal_coordinate(const system::Vector& u) const { return sensor_.dot(u - span_.u); }
  double driven_displacement(const system::Vector& u) const;        ///< [m] ([rad]) of the shaker's point
  double shaker_force(const system::Vector& external_force) const;  ///< [N] ([N m]) on the shaker's point
  /// The mode passing its rest position towards an antinode amplitude [m], while everything else follows the drive,
  /// which is at its crest: no other mode is struck.
  solver::InitialMotion start(double antinode_amplitude, double drive_amplitude) const;

 private:
  void find_mode();
  system::Vector unit_drive_force(system::Matrix& dynamic) const;
  void find_response();

  int mode_number_ = 1;
  span::SpanAtRest span_;
  double frequency_ = 0, modal_mass_ = 0, loop_length_ = 0, round_trip_ = 1;
  system::Vector shape_, momentum_, sensor_;
  build::Shaker shaker_;
  double coupling_ = 0;
  system::Vector response_;  // of all but the mode, per drive, in phase with it
};

}  // namespace strandyn::laboratory
