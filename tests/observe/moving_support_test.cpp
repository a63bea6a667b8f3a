// A string driven at its end, held against its exact motion, and what the ledger makes of it.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "strandyn/observe/ledger.hpp"
#include "strandyn/solver/time/integrator.hpp"
#include "support/check_close.hpp"
#include "system/freedoms.hpp"

using namespace strandyn;
using model::Freedom;
using model::Unknown;
using strandyn::observe::Account;
using strandyn::observe::Ledger;
using strandyn::system::System;
using strandyn::system::Vector;
using strandyn::test::check_close;
using strandyn::test::place;
using strandyn::test::zeros;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double length = 10;       // [m]
constexpr double tension = 1e4;     // [N]
constexpr double mass = 1;          // [kg/m]
constexpr double drag = 12;         // [N s/m^2]
constexpr double amplitude = 2e-4;  // [m]
constexpr double frequency = 7.3;   // [Hz], between the first mode, 5 Hz, and the second

/// Almost a string: sqrt(EI/T) = 1 cm.
model::Model driven_string(Freedom freedom) {
  model::Model model;
  model.freedom = freedom;
  std::vector<double> positions;
  for (int i = 0; i <= 40; ++i) positions.push_back(length * i / 40);
  model::lay_out(model, {.positions = positions, .strain = 1e-5});
  const std::array<bool, 6> pin = {true, true, true, true, false, false};
  model.supports = {{.node = 0, .fixed = pin}, {.node = 40, .fixed = pin}};
  const section::LinearStiffness stiffness{.EA = 1e9, .GJ = 1, .C_AT = 0, .EI = 1};
  model.law = std::make_shared<section::LinearLaw>(
      "elastic", model::is_spatial(freedom) ? section::Dimension::spatial : section::Dimension::planar, stiffness);
  model.inertia = {.mass = mass};
  model.mass_matrix = model::MassMatrix::consistent;
  model.drag = drag;
  model.motions = {
      {.node = 0, .unknown = Unknown::y, .amplitude = amplitude, .history = model::Harmonic{.frequency = frequency}}};
  return model;
}

/// Keeps the ledger at the last two cycle ends, and the sine and cosine part of the motion at a node in between.
class Watch final : public observe::Observer {
 public:
  Watch(Eigen::Index unknown, double from) : unknown_(unknown), from_(from) {}
  void begin(const System& system, const observe::StepRecord& initial) override { ledger_.begin(system, initial); }
  bool wants_forces() const override { return true; }
  void step(const System& system, const observe::StepRecord& record) override {
    ledger_.step(system, record);
    if (record.time < from_ + 1e-9) {
      before = ledger_.now();
      return;
    }
    after = ledger_.now();
    const double phase = 2 * pi * frequency * record.time;
    const double weight = 2 * record.step * frequency;
    sine += weight * record.u(unknown_) * std::sin(phase);
    cosine += weight * record.u(unknown_) * std::cos(phase);
  }

  Account before, after;
  double sine = 0, cosine = 0;

 private:
  Ledger ledger_;
  Eigen::Index unknown_;
  double from_;
};

}  // namespace

TEST_CASE("moving support: a string driven at its end swings as the exact one and takes its work from the support") {
  for (const Freedom freedom : {Freedom::planar, Freedom::transverse_planar, Freedom::spatial_untwisted}) {
    CAPTURE(static_cast<int>(freedom));
    const model::Model model = driven_string(freedom);
    System system(model);
    system.begin(zeros(model));
    // The start dies out as exp(-c t/(2 m)): 1e-7 of it is left after 19 cycles.
    constexpr double cycles = 20;
    Watch watch(place(model, 12, Unknown::y), (cycles - 1) / frequency);
    observe::Observer* const observers[] = {&watch};
    const auto summary = solver::integrate(system, {.u = zeros(model), .v = zeros(model)},
                                           {.step = 1 / (200 * frequency), .end_time = cycles / frequency, .stop = {}},
                                           solver::Ida{}, observers);
    REQUIRE(summary.ending == solver::Ending::finished);
    CHECK(summary.order_one_steps == 0);

    // y = Im[A sin k(L - x)/sin kL exp(i omega t)],  k^2 = (m omega^2 - i c omega)/T.
    const double omega = 2 * pi * frequency;
    const std::complex<double> k = std::sqrt(std::complex<double>(mass * omega * omega, -drag * omega) / tension);
    const std::complex<double> shape = amplitude * std::sin(k * 0.7 * length) / std::sin(k * length);
    // Steps of 1/200 cycle shift a frequency by (omega h)^2/3 = 3e-4: about 1e-3 of the amplitude between two modes.
    check_close(watch.sine, shape.real(), {.absolute = 3e-3 * std::abs(shape)});
    check_close(watch.cosine, shape.imag(), {.absolute = 3e-3 * std::abs(shape)});

    // Force of the support -T dy/dx(0) = T k cot(kL) A: its work of a cycle is pi A Im(force).
    const double work = pi * amplitude * amplitude * tension * (k * std::cos(k * length) / std::sin(k * length)).imag();
    const Account& a = watch.after;
    const Account& b = watch.before;
    check_close(a.external_work - b.external_work, work, {.relative = 5e-3});
    check_close(a.viscous.total() - b.viscous.total(), work, {.relative = 5e-3});
    CHECK(std::abs(a.numerical() - b.numerical()) <= 1e-3 * work);
    CHECK(std::abs(a.internal_work - a.elastic) <= 1e-3 * work);
  }
}
