#pragma once
/// \file A turbulent record of the wind: a sum of sines with the spectrum of von Karman for the component along the
/// wind.                                                                                          [ESDU 85020]
///
///     S(f) = 4 sigma^2 (L/U)/(1 + 70.8 (f L/U)^2)^(5/6),   sigma = I U
///     u(t)/U = 1 + sum a_i sin(2 pi f_i t + phi_i),   a_i^2/2 = S(f_i) df_i/U^2, scaled so that their sum is I^2
/// 200 frequencies in even steps of the logarithm from 0.003 U/L to `highest`, each moved by chance within its step;
/// the phases are drawn, too. A seed gives one record on every machine. One record stands for the whole span: gusts are
/// taken to be longer than it.

#include <cstdint>
#include <vector>

namespace strandyn::air {

struct Turbulence {
  double intensity = 0;  ///< [-] I, deviation over mean
  double length = 100;   ///< [m] L
  double speed = 0;      ///< [m/s] U
  double highest = 0;    ///< [Hz] no gusts beyond: those that shed vortices are not gusts
  std::uint32_t seed = 1;
};

class Gusts {
 public:
  Gusts() = default;  ///< none
  explicit Gusts(const Turbulence& turbulence);

  double at(double time) const;  ///< [-] u/U at a time [s]; 1 without gusts
  double variance() const;       ///< [-] of u/U over a long time

 private:
  struct Sine {
    double amplitude = 0, omega = 0, phase = 0;
  };
  std::vector<Sine> sines_;
};

}  // namespace strandyn::air
