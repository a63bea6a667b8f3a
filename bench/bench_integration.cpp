// The integrators' own damping, what they say about friction, and what the mass matrix changes, as tables.
//   bench_integration [linear] [friction] [mass] [long]      all of them unless named
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference_beam.hpp"
#include "strandyn/observe/cycles.hpp"
#include "strandyn/observe/histories.hpp"
#include "strandyn/solver/modes.hpp"
#include "strandyn/study/run_case.hpp"

using namespace strandyn;
using nlohmann::ordered_json;
using std::numbers::pi;

namespace {

struct Choice {
  const char* name;
  std::vector<std::string> keys;
  double rho = -1;  // below 0: IDA
};

const std::vector<Choice>& methods() {
  static const std::vector<Choice> list = {
      {"IDA", {"integrator.method=ida"}},
      {"generalized-alpha, rho 1", {"integrator.method=generalized-alpha", "integrator.rho_inf=1"}, 1},
      {"generalized-alpha, rho 0.9", {"integrator.method=generalized-alpha", "integrator.rho_inf=0.9"}, 0.9},
      {"generalized-alpha, rho 0.8", {"integrator.method=generalized-alpha", "integrator.rho_inf=0.8"}, 0.8}};
  return list;
}

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// ---- a linear mode

struct Prediction {
  double damping = 0;
  double frequency_error = 0;
};

Prediction predict(const Choice& method, double angle) {
  if (method.rho < 0) return {.damping = std::pow(angle, 3) / 4, .frequency_error = -angle * angle / 3};
  const solver::GeneralizedAlpha alpha{.rho_inf = method.rho};
  return {.damping = alpha.damping_ratio(angle), .frequency_error = alpha.frequency_error(angle)};
}

/// Mode 12 of the taut beam at 0.02 mm, where tension and sections do not notice. 25 cycles, the first five left out.
void print_linear_row(const Choice& method, int steps_per_cycle) {
  bench::Span span("beam/elastic_benchmark_planar.toml",
                   joined(method.keys, {"span.elements=60", "integrator.newton_tolerance=1e-14"}));
  const solver::Mode mode = solver::transverse_modes(span.system, span.u, 12).back();
  const double omega = 2 * pi * mode.frequency;
  const system::Vector velocity = 2e-5 * omega * mode.shape / mode.shape.cwiseAbs().maxCoeff();
  observe::CycleObserver cycles({.period = 1 / mode.frequency, .loop_length = span.built.length / 12});
  observe::ProbeHistories probes({model::nearest_node(span.built.model, 13.8)});
  solver::Observer* const observers[] = {&cycles, &probes};
  const auto steps = static_cast<std::size_t>(25 * steps_per_cycle + 2);
  bench::integrate(span, velocity, 1 / (mode.frequency * steps_per_cycle), steps, observers);
  double numerical = 0;
  double energy = 0;
  for (std::size_t i = cycles.cycles().size() - 20; i < cycles.cycles().size(); ++i) {
    numerical += cycles.cycles()[i].numerical;
    energy += cycles.cycles()[i].kinetic + cycles.cycles()[i].elastic;
  }
  const double measured = numerical / (4 * pi * energy);
  const double error = probes.frequency(0).value_or(0) / mode.frequency - 1;
  const Prediction p = predict(method, 2 * pi / steps_per_cycle);
  fmt::print("| {} | {} | {:.3e} | {:.3e} | {} | {:+.3e} | {:+.3e} | {:.3f} |\n", method.name, steps_per_cycle,
             p.damping, measured, p.damping > 0 ? fmt::format("{:.3f}", measured / p.damping) : "-", p.frequency_error,
             error, error / p.frequency_error);
}

void print_linear() {
  fmt::print(
      "\n| method | steps per cycle | damping predicted | measured | ratio | frequency error predicted | measured | "
      "ratio |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Choice& method : methods()) {
    for (int n : {50, 100, 200, 400, 800}) print_linear_row(method, n);
  }
}

// ---- friction

ordered_json run(const std::vector<std::string>& overrides) {
  const auto file = STRANDYN_SOURCE_DIR "/cases/curlew_lab_span.toml";
  study::CaseResult result = study::run_case(casefile::read_scene(file, overrides));
  if (!result.message.empty()) fmt::print(stderr, "{}\n", result.message);
  return std::move(result.summary);
}

std::vector<std::string> decay(double amplitude_mm, int cycles) {
  return {"analysis={type=\"decay\",mode=12,cycles=" + fmt::format("{}", cycles) +
              ",antinode_amplitude_mm=" + fmt::format("{}", amplitude_mm) + "}",
          "load[0].amplitude_N=0", "integrator.max_numerical_share=0.05"};
}

double total(const ordered_json& summary, const char* key) {
  double sum = 0;
  for (const auto& cycle : summary["cycles"]) sum += cycle[key].get<double>();
  return sum;
}

void print_friction_row(double amplitude_mm, const Choice& method, const ordered_json& s) {
  const double friction = total(s, "friction_dissipation_J");
  const double numerical = total(s, "numerical_dissipation_J");
  const ordered_json& steady = s["steady"];
  fmt::print("| {} | {} | {:.0f} | {:.2e} | {:.6e} | {:+.2e} | {:+.2e} | {} |\n", amplitude_mm, method.name,
             steady["steps_per_cycle"].get<double>(), steady["damping_ratio"].get<double>(), friction,
             numerical / friction, total(s, "quadrature_error_J") / friction,
             s["cost"]["newton_iterations"].get<double>() / s["cost"]["steps"].get<double>());
}

/// Free decays of the laboratory span at three amplitudes, at the steps that `auto` chooses, and at half and double.
void print_friction() {
  constexpr int cycles = 10;
  fmt::print(
      "\n| antinode mm | method | steps per cycle | damping ratio | friction J | numerical/friction | "
      "quadrature/friction | corrections a step |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (double amplitude : {0.8, 4.0, 12.0}) {
    for (std::size_t m : {std::size_t{0}, std::size_t{2}}) {
      const Choice& method = methods()[m];
      const ordered_json chosen = run(joined(joined(decay(amplitude, cycles), method.keys), {"integrator.step=auto"}));
      const int n = static_cast<int>(std::lround(chosen["steady"]["steps_per_cycle"].get<double>()));
      const auto fixed = [&](int steps) {
        return run(joined(joined(decay(amplitude, cycles), method.keys),
                          {"integrator.step=fixed", fmt::format("integrator.steps_per_cycle={}", steps)}));
      };
      print_friction_row(amplitude, method, fixed(n / 2));
      print_friction_row(amplitude, method, chosen);
      print_friction_row(amplitude, method, fixed(2 * n));
      print_friction_row(amplitude, method, fixed(4 * n));
    }
  }
}

// ---- mass

double twelfth_frequency(const std::vector<std::string>& overrides) {
  const casefile::Scene scene = casefile::read_scene(STRANDYN_SOURCE_DIR "/cases/curlew_lab_span.toml", overrides);
  const casefile::BuiltSpan built = casefile::build_span(scene);
  system::System system(built.model);
  const system::Vector u = system.make_vector();
  system.begin(u);
  return solver::transverse_modes(system, u, 12).back().frequency;
}

void print_mass() {
  const auto keys = [](int elements, const char* grading, const char* mass, bool rotary) {
    return std::vector<std::string>{fmt::format("span.elements={}", elements), fmt::format("span.grading={}", grading),
                                    fmt::format("span.mass={}", mass), fmt::format("span.rotary_inertia={}", rotary)};
  };
  constexpr int cycles = 5;
  fmt::print(
      "\n| mesh | mass | rotary inertia | method | f_12 error | friction error | steps | corrections | residuals | "
      "tangents |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  const auto fine = keys(320, "clamps", "consistent", false);
  const double reference = twelfth_frequency(joined(decay(5, cycles), fine));
  const std::vector<std::string> steps = {"integrator.steps_per_cycle=200"};
  std::vector<double> friction;
  for (std::size_t m : {std::size_t{0}, std::size_t{2}}) {
    friction.push_back(
        total(run(joined(joined(joined(decay(5, cycles), fine), methods()[m].keys), steps)), "friction_dissipation_J"));
  }
  for (const char* grading : {"clamps", "uniform"}) {
    for (int elements : {80, 160}) {
      for (const char* mass : {"lumped", "consistent"}) {
        for (bool rotary : {false, true}) {
          const auto mesh = joined(decay(5, cycles), keys(elements, grading, mass, rotary));
          const double frequency = twelfth_frequency(mesh);
          for (std::size_t m : {std::size_t{0}, std::size_t{2}}) {
            const ordered_json s = run(joined(joined(mesh, methods()[m].keys), steps));
            const double lost = total(s, "friction_dissipation_J");
            const ordered_json& cost = s["cost"];
            fmt::print("| {} {} | {} | {} | {} | {:+.1e} | {:+.2f} % | {} | {} | {} | {} |\n", elements,
                       grading == std::string("clamps") ? "graded" : "uniform", mass, rotary ? "yes" : "no",
                       methods()[m].name, frequency / reference - 1, 100 * (lost / friction[m == 0 ? 0 : 1] - 1),
                       cost["steps"].dump(), cost["newton_iterations"].dump(), cost["residual_evaluations"].dump(),
                       cost["jacobian_evaluations"].dump());
          }
        }
      }
    }
  }
}

// ---- ten thousand cycles

/// Mode 1 of the taut beam, eight elements: how much of the energy is left.
void print_long() {
  constexpr std::size_t cycles_run = 10000;
  fmt::print("\n| method | steps per cycle | cycles | energy left | predicted |\n| --- | --- | --- | --- | --- |\n");
  const auto row = [&](const Choice& method, int n) {
    bench::Span span("beam/elastic_benchmark_planar.toml",
                     joined(method.keys, {"span.elements=8", "integrator.newton_tolerance=1e-13"}));
    const solver::Mode mode = solver::transverse_modes(span.system, span.u, 1).back();
    const system::Vector velocity = 1e-4 * 2 * pi * mode.frequency * mode.shape / mode.shape.cwiseAbs().maxCoeff();
    observe::Ledger ledger;
    solver::Observer* const observers[] = {&ledger};
    bench::integrate(span, velocity, 1 / (mode.frequency * n), cycles_run * static_cast<std::size_t>(n), observers);
    const observe::Account& a = ledger.now();
    const double left = (a.kinetic + a.elastic) / a.initial_kinetic;
    const double predicted = std::exp(-4 * pi * predict(method, 2 * pi / n).damping * static_cast<double>(cycles_run));
    fmt::print("| {} | {} | {} | {:.9f} | {:.9f} |\n", method.name, n, cycles_run, left, predicted);
  };
  row(methods()[1], 20);
  row(methods()[2], 20);
  row(methods()[0], 200);
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> wanted(arguments + 1, arguments + count);
  const auto wants = [&](const char* name) { return wanted.empty() || std::ranges::count(wanted, name) > 0; };
  if (wants("linear")) print_linear();
  if (wants("friction")) print_friction();
  if (wants("mass")) print_mass();
  if (wants("long")) print_long();
}
