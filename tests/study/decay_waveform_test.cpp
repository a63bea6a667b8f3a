// Why decaying cycles lose more than steady ones at the same coordinate of the mode: the section's own closed loops at
// the waveforms of both states say it.
//
// From a run of the bench, the harmonics of curvature and tension of every section point, against the phase of the
// mode:
//     c_k = sum w x exp(-i k omega t)/sum w,     w = 1 + cos(pi t/T), |t| < T
// Each waveform is run round and round in the section law until its loss repeats. No dynamics, and no history but the
// largest strain that the points have seen.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "strandyn/build/point.hpp"
#include "strandyn/build/span.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/laboratory/readings.hpp"
#include "strandyn/self_damping/method.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using observe::StepRecord;
using section::Component;
using section::Field;
using std::numbers::pi;
using test::check_close;
using Complex = std::complex<double>;

namespace {

constexpr int harmonics = 25;  // nine lose a per cent
constexpr int samples = 200;   // of a loop
constexpr int mode = 12;

/// All steps from the first measured cycle on.
class Recorder final : public observe::Observer {
 public:
  explicit Recorder(const laboratory::BenchSpan& bench) : bench_(bench) {}
  void begin(const system::System& system, const StepRecord& initial) override {
    if (strains.empty()) keep(system, initial);
    decay_begins = strains.size() - 1;
  }
  void step(const system::System& system, const StepRecord& record) override { keep(system, record); }

  std::vector<Field> strains;
  std::vector<double> coordinate;  // [m] of the mode
  std::size_t decay_begins = 0;

 private:
  void keep(const system::System& system, const StepRecord& record) {
    strains.push_back(system.committed_strains());
    coordinate.push_back(bench_.modal_coordinate(record.u));
  }
  const laboratory::BenchSpan& bench_;
};

/// Of two cycles: coefficients of each section point, 0 to `harmonics`.
struct Waveform {
  double amplitude = 0;  // [m] of the mode
  Eigen::ArrayXXcd curvature, strain;
};

class Sections {
 public:
  Sections(const laboratory::BenchSpan& bench, const Recorder& record, double step)
      : system_(bench.at_rest().system), law_(*bench.at_rest().built.model.law), record_(record), step_(step) {
    steady_ = law_.start(record.strains.front());
    section::StepEnergy energy(points());
    after_ = steady_;
    for (const Field& each : record.strains) {
      law_.commit(after_, each, energy);
      if (&each == &record.strains[record.strains.size() / 8]) steady_ = after_;
    }
  }

  /// About a step of the record, at 2 pi/omega = T.
  Waveform waveform(std::size_t centre, double omega) const {
    Waveform w;
    w.curvature = w.strain = Eigen::ArrayXXcd::Zero(harmonics + 1, static_cast<Eigen::Index>(points()));
    const Complex mode_phasor = mean(centre, centre, omega, [&](std::size_t i, double weight, const Complex& turn) {
      Complex power = 1;
      for (int k = 0; k <= harmonics; ++k) {
        const Complex factor = (k ? 2.0 : 1.0) * weight * power;
        w.curvature.row(k) += factor * row(record_.strains[i][Component::bending2]);
        w.strain.row(k) += factor * row(record_.strains[i][Component::axial]);
        power *= turn;
      }
    });
    w.amplitude = std::abs(mode_phasor);
    for (int k = 0; k <= harmonics; ++k) {
      const Complex turn = std::polar(1.0, -k * std::arg(mode_phasor));
      w.curvature.row(k) *= turn;
      w.strain.row(k) *= turn;
    }
    return w;
  }

  /// [rad/s] from the phase of the mode half a cycle apart.
  double omega(std::size_t centre, double guess) const {
    const auto quarter = static_cast<std::size_t>(std::lround(pi / 2 / guess / step_));
    for (int pass = 0; pass < 3; ++pass) {
      const Complex before = mean(centre - quarter, centre, guess), after = mean(centre + quarter, centre, guess);
      guess += std::arg(after / before) / (2 * static_cast<double>(quarter) * step_);
    }
    return guess;
  }

  /// [J] per cycle of all sections.
  double loss(const Waveform& w, bool steady) const {
    section::History history = steady ? steady_ : after_;
    std::vector<Field> loop;
    for (int i = 0; i < samples; ++i) {
      Eigen::ArrayXcd turns(harmonics + 1);
      for (int k = 0; k <= harmonics; ++k) turns(k) = std::polar(1.0, 2 * pi * k * i / samples);
      Field& at = loop.emplace_back(section::Dimension::planar, points());
      for (std::size_t p = 0; p < points(); ++p) {
        const auto column = static_cast<Eigen::Index>(p);
        at[Component::bending2][p] = (w.curvature.col(column) * turns).real().sum();
        at[Component::axial][p] = (w.strain.col(column) * turns).real().sum();
      }
    }
    section::StepEnergy energy(points());
    double lost = 0, before = -1;
    for (int cycle = 0; cycle < 8 && std::abs(lost - before) > 1e-6 * lost; ++cycle) {
      before = cycle ? lost : -1;
      lost = 0;
      for (int i = 1; i <= samples; ++i) {
        law_.commit(history, loop[static_cast<std::size_t>(i % samples)], energy);
        for (std::size_t p = 0; p < points(); ++p) {
          lost += (energy.dissipated[p] - energy.quadrature_error[p]) * system_.point_length(p);
        }
      }
    }
    return lost;
  }

 private:
  std::size_t points() const { return record_.strains.front().points(); }
  Eigen::Map<const Eigen::Array<double, 1, Eigen::Dynamic>> row(const AlignedVector& values) const {
    return {values.data(), static_cast<Eigen::Index>(points())};
  }
  using Each = std::function<void(std::size_t, double, const Complex&)>;
  /// [m] phasor of the mode over two cycles about a step, its phase counted from another; `each` hears of every step.
  Complex mean(std::size_t centre, std::size_t origin, double omega, const Each& each = {}) const {
    const auto half = static_cast<int>(2 * pi / omega / step_);
    double weights = 0;
    const auto weight_at = [&](int i) { return 1 + std::cos(omega * i * step_ / 2); };
    for (int i = -half; i <= half; ++i) weights += weight_at(i);
    Complex sum = 0;
    for (int i = -half; i <= half; ++i) {
      const auto at = static_cast<std::size_t>(static_cast<int>(centre) + i);
      const double time = (static_cast<double>(at) - static_cast<double>(origin)) * step_;
      const Complex turn = std::polar(1.0, -omega * time);
      const double weight = weight_at(i) / weights;
      sum += 2 * weight * turn * record_.coordinate[at];
      if (each) each(at, weight, turn);
    }
    return sum;
  }

  const system::System& system_;
  const section::Law& law_;
  const Recorder& record_;
  double step_;  // [s]
  section::History steady_, after_;
};

/// What the decaying cycles lose at the measured amplitude, over the steady loss.
struct Excess {
  double measured = 0, predicted = 0, third_alone = 0, fundamental_alone = 0;
};

/// By a parabola of logarithms, as the bench reads.
double at_steady_amplitude(const std::vector<double>& amplitudes, const std::vector<double>& losses) {
  Eigen::MatrixXd powers(static_cast<Eigen::Index>(losses.size()), 3);
  Eigen::VectorXd values(powers.rows());
  for (Eigen::Index i = 0; i < powers.rows(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    for (int term = 0; term < 3; ++term) powers(i, term) = std::pow(std::log(amplitudes[at]), term);
    values(i) = std::log(losses[at]);
  }
  return std::exp(powers.colPivHouseholderQr().solve(values)(0));
}

Excess excess_at(double amplitude_over_diameter) {
  const auto scene =
      casefile::read_scene(STRANDYN_SOURCE_DIR "/cases/self_damping/curlew_bench.toml",
                           {"section.law=compliant", "section.points=20", "integrator.method=generalized-alpha",
                            "integrator.steps_per_cycle=100",
                            "analysis.amplitude_over_diameter=" + std::to_string(amplitude_over_diameter)});
  const self_damping::Point point = self_damping::points_of(scene).front();
  const casefile::Scene own = build::scene_of_point(scene, point.ask());
  build::BuiltSpan built = build::build_span(own);
  const build::Shaker shaker = build::find_shaker(own, built);
  laboratory::BenchSpan bench(std::move(built), shaker, mode);
  Recorder record(bench);
  const auto run =
      laboratory::run_bench(bench, point.antinode_amplitude, build::Integration(scene), {}, {.watch = &record});
  const auto readings = laboratory::read_all(bench, run);
  REQUIRE(readings.decay);

  const auto cycle = static_cast<std::size_t>(run.cost.steps_per_cycle);
  const double omega = 2 * pi * run.steady.drive.frequency;
  const Sections sections(bench, record, 2 * pi / omega / static_cast<double>(cycle));
  const Waveform steady = sections.waveform(10 * cycle, omega);
  const double steady_loss = sections.loss(steady, true);

  std::vector<double> amplitudes, all, third, first;
  for (std::size_t at = record.decay_begins + 3 * cycle / 2; at + 2 * cycle < record.strains.size(); at += cycle) {
    const Waveform decaying = sections.waveform(at, sections.omega(at, omega));
    const double ratio = decaying.amplitude / steady.amplitude;
    if (std::abs(std::log(ratio)) > 0.12) continue;
    const auto loss_with = [&](int k) {  // one harmonic of the decaying curvature in the steady waveform
      Waveform mixed = steady;
      mixed.curvature *= ratio;
      mixed.curvature.row(k) = decaying.curvature.row(k);
      return sections.loss(mixed, true) / steady_loss;
    };
    amplitudes.push_back(ratio);
    all.push_back(sections.loss(decaying, false) / steady_loss);
    third.push_back(loss_with(3));
    first.push_back(loss_with(1));
  }
  REQUIRE(amplitudes.size() > 4);
  return {.measured = readings.decay->ledger / readings.ledger.power,
          .predicted = at_steady_amplitude(amplitudes, all),
          .third_alone = at_steady_amplitude(amplitudes, third),
          .fundamental_alone = at_steady_amplitude(amplitudes, first)};
}

}  // namespace

TEST_CASE("decay method: closed loops at the waveforms of decaying and steady cycles say what decaying ones lose more" *
          doctest::test_suite("slow")) {
  for (const double amplitude : {0.17, 0.25}) {
    const Excess excess = excess_at(amplitude);
    CAPTURE(amplitude);
    MESSAGE(amplitude << ": measured " << excess.measured << ", closed loops " << excess.predicted
                      << ", third harmonic alone " << excess.third_alone << ", fundamental alone "
                      << excess.fundamental_alone);
    CHECK(excess.measured > 1.02);
    check_close(excess.predicted - 1, excess.measured - 1, {.relative = 0.2});
    CHECK(excess.third_alone > 1.03);
  }
}
