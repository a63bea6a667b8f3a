#pragma once
/// \file The energy ledger: every term computed on its own, the remainder shown as the integrator's error.
///
///     external work  = sum (f_n + f_n+1)/2 . (u_n+1 - u_n)                  loads, and reactions of moving supports
///     kinetic        = v . M v/2,   elastic = stored in the sections        from the state
///     friction       = sum D,       quadrature error = sum E_quad           from `commit`
///     material       = sum D of the metal of the wires                      from `commit`
///     viscous        = sum h (v_n . c v_n + v_n+1 . c v_n+1)/2
///     air            = sum h (v_n . F_air,n + v_n+1 . F_air,n+1)/2          of still air, which is no self-damping
///     attached       = sum of what hung dampers lose, their kinetic and elastic energy beside that of the chain
///     wind           = sum h (v_n . F_wind,n + v_n+1 . F_wind,n+1)/2        work of the wind
///     numerical      = external + wind - change of (kinetic + elastic) - friction - material - viscous - air
///                      - attached
///     internal work  = sum (f_int,n + f_int,n+1)/2 . (u_n+1 - u_n)          second way to elastic + friction
/// The ledger closes by definition; E_quad is contained in the numerical part, with a minus. The internal work shares
/// no code with stored and dissipated energies: internal - (change of elastic + friction + material - E_quad) is the
/// error of the trapezoidal rule over the curved motion of the chain, and falls with the square of the step.

#include "strandyn/observe/step_record.hpp"

namespace strandyn::observe {

/// Cumulative terms since the start. [J]
struct Account {
  double external_work = 0;
  double wind = 0;     ///< its work
  double kinetic = 0;  ///< of the state
  double elastic = 0;  ///< of the state, above that of the initial state
  double friction = 0;
  double material = 0;
  system::ViscousLoss viscous = {};
  double air = 0;
  double attached = 0;  ///< by Stockbridge dampers
  double quadrature_error = 0;
  double internal_work = 0;
  double initial_kinetic = 0;  ///< constant

  /// All that physics takes: the numerical part is measured against it.
  double work_in() const { return external_work + wind; }
  double dissipated() const { return friction + material + viscous.total() + air + attached; }
  void archive(Archive& a) {
    a(external_work, wind, kinetic, elastic, friction, material);
    for (const system::ViscousTerm& term : system::viscous_terms) a(viscous.*term.value);
    a(air, attached, quadrature_error, internal_work, initial_kinetic);
  }
  double numerical() const { return external_work + wind - (kinetic - initial_kinetic) - elastic - dissipated(); }
};

/// Between two accounts, each term linear in `part` from 0 to 1: the remainder stays what the terms leave over.
Account interpolate(const Account& from, const Account& to, double part);

class Ledger final : public Observer {
 public:
  void begin(const system::System& system, const StepRecord& initial) override;
  void step(const system::System& system, const StepRecord& record) override;
  void exchanged(const StepRecord& record) override;
  bool wants_forces() const override { return true; }
  void archive(Archive& a) override {
    a(now_, initial_elastic_, power_, air_power_, wind_power_, u_, external_, internal_);
  }

  const Account& now() const { return now_; }
  /// [N], [N m] loads at the last step; at supports that move, what the support has to do.
  const system::Vector& external_force() const { return external_; }

 private:
  Account now_;
  double initial_elastic_ = 0;  // [J]
  system::ViscousLoss power_;   // [W] at the last step
  double air_power_ = 0;        // [W] likewise
  double wind_power_ = 0;       // [W] likewise
  system::Vector u_, external_, internal_;
};

}  // namespace strandyn::observe
