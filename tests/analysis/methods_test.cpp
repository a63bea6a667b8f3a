#include "strandyn/analysis/methods.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "support/check_close.hpp"

using namespace strandyn::analysis;
using strandyn::test::check_close;
using Complex = std::complex<double>;

namespace {

constexpr double pi = std::numbers::pi;

/// A beam in tension with viscous damping c along it, pinned at x = 0, shaken at x = L: the exact steady state is
/// y = Y sin(kappa x), EI kappa^4 + T kappa^2 = m omega^2 - i omega c, with no near field at a pinned end.
/// EI = 0 is the string.
struct DampedSpan {
  WaveGuide guide{.tension = 32.6e3, .mass_per_length = 1.98, .EI = 0};
  double frequency = 20;
  double damping_ratio = 1e-3;  // c/(2 m omega)
  double amplitude = 5e-3;      // Y

  double omega() const { return 2 * pi * frequency; }
  double c() const { return 2 * guide.mass_per_length * omega() * damping_ratio; }
  Complex kappa() const {
    const Complex inertia(guide.mass_per_length * omega() * omega(), -omega() * c());
    const double T = guide.tension;
    return std::sqrt(2.0 * inertia / (T + std::sqrt(T * T + 4 * guide.EI * inertia)));
  }
  double alpha() const { return -kappa().imag(); }
  double beta() const { return kappa().real(); }

  Complex y(double x) const { return amplitude * std::sin(kappa() * x); }
  Complex velocity(double x) const { return Complex(0, omega()) * y(x); }
  Complex force(double x) const {  // across the span, T y' - EI y'''
    const Complex k = kappa();
    return amplitude * k * std::cos(k * x) * (guide.tension + guide.EI * k * k);
  }
  /// Exact power that runs through x toward the end [W]: force on velocity and moment on angular velocity.
  double power_through(double x) const {
    const Complex k = kappa();
    const Complex moment = -guide.EI * k * k * y(x);
    const Complex turning = Complex(0, omega()) * amplitude * k * std::cos(k * x);
    return drive_power(force(x), velocity(x)) + drive_power(moment, turning);
  }
  /// Mean of c |v|^2/2 from 0 to x times x [W], the ledger by position.
  double lost_until(double x) const {
    const double V = omega() * amplitude;
    const double a = 2 * alpha(), b = 2 * beta();
    return c() * V * V / 4 * (std::sinh(a * x) / a - std::sin(b * x) / b);
  }

  /// Where |y|^2 = Y^2 (sin^2(beta x) + sinh^2(alpha x)) has its n-th half-loop extreme: node for even n.
  double extreme(int half_loops) const {
    const double a = 2 * alpha(), b = 2 * beta();
    double x = half_loops * pi / b;
    for (int i = 0; i < 20; ++i) {
      x -= (b * std::sin(b * x) + a * std::sinh(a * x)) / (b * b * std::cos(b * x) + a * a * std::cosh(a * x));
    }
    return x;
  }
  NodeReading reading(int node) const {
    return {.node_amplitude = std::abs(y(extreme(2 * node))), .antinode_amplitude = std::abs(y(extreme(2 * node + 1)))};
  }
  NodePair nodes(int near, int far) const {
    return {.near = reading(near), .far = reading(far), .distance = extreme(2 * near) - extreme(2 * far)};
  }
  Antinode antinode() const {
    return {.mass_per_length = guide.mass_per_length, .frequency = frequency, .velocity = omega() * amplitude};
  }
};

}  // namespace

TEST_CASE("methods: power and ledger agree to rounding on a damped string, the others to the order of the damping") {
  for (const double zeta : {1e-3, 1e-4}) {
    const DampedSpan span{.damping_ratio = zeta};
    const double L = span.extreme(21);  // shaken at the antinode of the eleventh loop
    const double ledger = span.lost_until(L) / L;
    const double power = power_method({.force = std::abs(span.force(L)),
                                       .velocity = std::abs(span.velocity(L)),
                                       .phase = std::arg(span.force(L)) - std::arg(span.velocity(L))},
                                      L);
    check_close(power, ledger, {.relative = 1e-11}, "power method");  // the phase is 90 degrees but for some 0.03
    // Loops grow toward the shaker as cosh(alpha x): the mean of V^2 exceeds that of the end by (2 alpha L)^2/6.
    const double growth = std::pow(2 * span.alpha() * L, 2) / 6;
    const double simple = power_per_length(zeta, span.antinode());
    check_close(simple, span.c() * std::pow(span.antinode().velocity, 2) / 4, {.relative = 1e-14});
    check_close(simple, ledger, {.relative = 1.1 * growth}, "zeta");
    const double delta = 2 * pi * zeta / std::sqrt(1 - zeta * zeta);  // free decay of a mode of the same span
    check_close(decay_method(delta, span.antinode()), ledger, {.relative = 1.1 * growth}, "decay");
    check_close(
        iswr_method(span.nodes(9, 1), span.guide, span.frequency),
        (span.lost_until(span.extreme(18)) - span.lost_until(span.extreme(2))) / (span.extreme(18) - span.extreme(2)),
        {.relative = 0.1 * growth}, "ISWR");  // each node has its own antinode: measured 0.07
  }
}

TEST_CASE("methods: a freely decaying damped string gives the same power per length as the shaken one") {
  const DampedSpan span{.damping_ratio = 2e-3};
  // A mode decays as exp(-c t/2m) at a slightly lowered frequency; amplitudes one cycle apart.
  const double rate = span.c() / (2 * span.guide.mass_per_length);
  const double omega_d = std::sqrt(span.omega() * span.omega() - rate * rate);
  std::vector<double> amplitudes;
  for (int i = 0; i <= 40; ++i) amplitudes.push_back(span.amplitude * std::exp(-rate * 2 * pi * i / omega_d));
  const double by_two =
      logarithmic_decrement({.first_amplitude = amplitudes.front(), .last_amplitude = amplitudes.back(), .cycles = 40});
  const DecrementFit fit = fit_decrement(amplitudes).value();
  check_close(fit.decrement, by_two, {.relative = 1e-12});
  check_close(fit.first_amplitude, span.amplitude, {.relative = 1e-12});
  check_close(damping_ratio_of_decrement(by_two), 2e-3, {.relative = 1e-12});
  Antinode antinode = span.antinode();
  antinode.frequency = omega_d / (2 * pi);
  check_close(decay_method(by_two, antinode), span.c() * antinode.velocity * antinode.velocity / 4,
              {.relative = 1e-12});
}

TEST_CASE("methods: a phase and complex amplitudes say the same and so does the work of a cycle") {
  const Complex F = std::polar(60.0, 0.4), v = std::polar(0.3, -0.9);
  check_close(drive_power(F, v), 60 * 0.3 / 2 * std::cos(1.3), {.relative = 1e-14});
  check_close(drive_power({.force = 60, .velocity = 0.3, .phase = 1.3}), drive_power(F, v), {.relative = 1e-14});
  // The work of one cycle by quadrature; 64 points are exact for a product of two sines.
  const double f = 25, omega = 2 * pi * f;
  double work = 0;
  for (int i = 0; i < 64; ++i) {
    const double t = i / (64 * f);
    work += std::real(F * std::polar(1.0, omega * t)) * std::real(v * std::polar(1.0, omega * t)) / (64 * f);
  }
  check_close(power_method({.work = work, .frequency = f}, 30), drive_power(F, v) / 30, {.relative = 1e-13});
  check_close(drive_power({.force = 60, .velocity = 0.3, .phase = pi / 2}), 0, {.absolute = 1e-15});
}

TEST_CASE("methods: the decay formula is the energy lost per cycle to the order of the decrement") {
  const Antinode antinode{.mass_per_length = 2, .frequency = 25, .velocity = 0.7};
  for (const double delta : {1e-2, 1e-4}) {
    const double energy = 2 * 0.7 * 0.7 / 4;  // per length
    const double lost = energy * -std::expm1(-2 * delta);
    check_close(decay_method(delta, antinode), 25 * lost, {.relative = 1.01 * delta});  // 1 - delta + ...
    check_close(damping_ratio(decay_method(delta, antinode), antinode), delta / (2 * pi), {.relative = 1e-14});
  }
}

TEST_CASE("methods: ratio, loss factor and power turn into each other") {
  const Antinode antinode{.mass_per_length = 1.5, .frequency = 20, .velocity = 0.5};
  // 2 P/(m omega V^2) by hand: 2 . 0.03/(1.5 . 40 pi . 0.25).
  check_close(damping_ratio(0.03, antinode), 0.06 / (15 * pi), {.relative = 1e-14});
  check_close(power_per_length(damping_ratio(0.03, antinode), antinode), 0.03, {.relative = 1e-14});
  check_close(loss_factor(1.2e-3), 2.4e-3, {.relative = 1e-15});
  check_close(damping_ratio_of_decrement(1e-4), 1e-4 / (2 * pi), {.relative = 1e-9});
}

TEST_CASE("methods: the fitted decrement finds noise between cycles in its standard error") {
  // ln Y = -0.01 i with +0.02 and -0.02 in turn, twelve cycles: slope and error by hand from the sums.
  std::vector<double> amplitudes;
  for (int i = 0; i < 12; ++i) amplitudes.push_back(std::exp(-0.01 * i + (i % 2 == 0 ? 0.02 : -0.02)));
  const DecrementFit fit = fit_decrement(amplitudes).value();
  // sum (i - 5.5) e_i = 0.02 . (-6), sum (i - 5.5)^2 = 143; residual square 12 . 0.0004 - 0.12^2/143 on 10 degrees.
  check_close(fit.decrement, 0.01 + 0.12 / 143, {.relative = 1e-12});
  check_close(fit.standard_error.value(), std::sqrt((12 * 0.0004 - 0.0144 / 143) / 10 / 143), {.relative = 1e-12});
}

TEST_CASE("methods: no decrement from fewer than two amplitudes or from a vanished one") {
  CHECK_FALSE(fit_decrement(std::vector<double>{1.0}).has_value());
  CHECK_FALSE(fit_decrement(std::vector<double>{1.0, 0.5, 0.0}).has_value());
  CHECK_FALSE(fit_decrement(std::vector<double>{1.0, std::nan(""), 0.5}).has_value());
  const DecrementFit two = fit_decrement(std::vector<double>{1.0, 0.5}).value();
  check_close(two.decrement, std::log(2.0), {.relative = 1e-15});
  CHECK_FALSE(two.standard_error.has_value());
}

TEST_CASE("methods: without bending the impedance is the root of tension times mass and a loop is half a wave") {
  const WaveGuide string{.tension = 25e3, .mass_per_length = 1.6};
  check_close(wave_impedance(string, 17), std::sqrt(25e3 * 1.6), {.relative = 1e-14});
  check_close(loop_length(string, 17), std::sqrt(25e3 / 1.6) / 34, {.relative = 1e-14});
  // To first order of EI k^2/T the impedance grows by 3/2 of it and k shrinks by half of it.
  WaveGuide stiff = string;
  stiff.EI = 0.1;
  const double k = wavenumber(string, 17);
  const double share = 0.1 * k * k / 25e3;
  check_close(wave_impedance(stiff, 17) / wave_impedance(string, 17) - 1, 1.5 * share, {.relative = 1e-5});
  check_close(1 - wavenumber(stiff, 17) / k, 0.5 * share, {.relative = 1e-5});
  // Impedance is mass times group velocity, d omega/dk.
  stiff.EI = 3000;
  const double h = 1e-4;
  const double group = 4 * pi * h / (wavenumber(stiff, 17 + h) - wavenumber(stiff, 17 - h));
  check_close(wave_impedance(stiff, 17), 1.6 * group, {.relative = 1e-8});
}

TEST_CASE("methods: in a beam the standing wave ratio needs the impedance of the beam") {
  DampedSpan span{.damping_ratio = 1e-4};
  span.guide.EI = 2400;
  const double far = span.extreme(2), near = span.extreme(18);
  const double ledger = (span.lost_until(near) - span.lost_until(far)) / (near - far);
  check_close((span.power_through(near) - span.power_through(far)) / (near - far), ledger, {.relative = 1e-9});
  // Measured 4.4e-7, of the order of (alpha x)^2; ten times less damping makes it a hundred times smaller.
  check_close(iswr_method(span.nodes(9, 1), span.guide, span.frequency), ledger, {.relative = 1e-6});
  WaveGuide string = span.guide;
  string.EI = 0;
  const double share = 2400 * span.beta() * span.beta() / string.tension;
  const double short_of = iswr_method(span.nodes(9, 1), string, span.frequency) / ledger;
  check_close(short_of, std::sqrt(1 + share) / (1 + 2 * share), {.relative = 1e-6});  // 0.91: 9 % of the power unseen
  CHECK(short_of < 0.92);
}

TEST_CASE("methods: with one antinode amplitude the two-node formula is that of the standards") {
  const WaveGuide string{.tension = 25e3, .mass_per_length = 1.6};
  const double f = 20, Y = 4e-3, V = 2 * pi * f * Y;
  const NodePair nodes{.near = {.node_amplitude = 5e-5, .antinode_amplitude = Y},
                       .far = {.node_amplitude = 1e-5, .antinode_amplitude = Y},
                       .distance = 6 * loop_length(string, f)};
  const double S_n = 5e-5 / Y, S_k = 1e-5 / Y;
  check_close(iswr_method(nodes, string, f),
              0.5 * std::sqrt(25e3 * 1.6) * V * V * (S_n - S_k) / (6 * loop_length(string, f)), {.relative = 1e-13});
  // A running wave has no node: the ratio is one and all of its power goes through.
  const NodeReading running{.node_amplitude = Y, .antinode_amplitude = Y};
  check_close(power_at_node(running, string, f), 200 * V * V / 2, {.relative = 1e-14});
}
