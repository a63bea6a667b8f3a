// The integrators' own damping, what they say about friction, and what the mass matrix changes, as tables.
//   bench_integration [linear] [friction] [mass] [adaptive] [long]      all of them unless named
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "reference_beam.hpp"
#include "strandyn/observe/cycles.hpp"
#include "strandyn/observe/histories.hpp"
#include "strandyn/results/json.hpp"
#include "strandyn/solver/modes/modes.hpp"
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
  const solver::TimeMethod chosen =
      method.rho < 0 ? solver::TimeMethod(solver::Ida{}) : solver::GeneralizedAlpha{.rho_inf = method.rho};
  return {.damping = solver::damping_ratio(chosen, angle), .frequency_error = solver::frequency_error(chosen, angle)};
}

/// Mode 12 of the taut beam at 0.05 mm, where tension and sections hardly notice. 40 cycles, the first half left out.
void print_linear_row(const Choice& method, int steps_per_cycle) {
  bench::Span span("beam/elastic_benchmark_planar.toml", joined(method.keys, {"span.elements=60"}));
  const solver::Mode mode = solver::transverse_modes(span.system, span.u, 12).back();
  const double omega = 2 * pi * mode.frequency;
  const system::Vector velocity = 5e-5 * omega * mode.shape / mode.shape.cwiseAbs().maxCoeff();
  observe::CycleObserver cycles({.period = 1 / mode.frequency, .loop_length = span.built.length / 12});
  observe::ProbeHistories probes({model::nearest_node(span.built.model, 13.8)});
  observe::Observer* const observers[] = {&cycles, &probes};
  const auto steps = static_cast<std::size_t>(40 * steps_per_cycle + 2);
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
  return ordered_json::parse(results::to_text(result.summary));
}

std::vector<std::string> decay(const char* law, double amplitude_mm, int cycles) {
  return {fmt::format("section.law=\"{}\"", law),
          fmt::format("analysis={{type=\"decay\",mode=12,cycles={},antinode_amplitude_mm={}}}", cycles, amplitude_mm),
          "load[0].amplitude_N=0", "integrator.max_numerical_share=1e9"};
}

std::vector<double> column(const ordered_json& summary, const char* key) {
  std::vector<double> values;
  for (const auto& cycle : summary["cycles"]) values.push_back(cycle[key].get<double>());
  return values;
}

double total(const ordered_json& summary, const char* key) {
  double sum = 0;
  for (double value : column(summary, key)) sum += value;
  return sum;
}

/// The parts of the remainder of a run, of its friction. Own: what the integrator takes; the remainder is own -
/// quadrature.
struct Remainder {
  double steps = 0;  // per cycle
  double own = 0;
  double quadrature = 0;
};

/// A row beside the run with the finest steps. Orders from the row before, where it has half of the steps.
Remainder print_friction_row(const char* law, double amplitude_mm, const Choice& method, const ordered_json& s,
                             const ordered_json& finest, const Remainder& coarser, bool chosen) {
  const double friction = total(s, "friction_dissipation_J");
  const double numerical = total(s, "numerical_dissipation_J");
  const double quadrature = total(s, "quadrature_error_J");
  const std::vector<double> of_cycle = column(s, "friction_dissipation_J");
  const std::vector<double> best = column(finest, "friction_dissipation_J");
  double largest = 0;
  for (std::size_t i = 0; i < best.size(); ++i) largest = std::max(largest, std::abs(of_cycle[i] / best[i] - 1));
  const Remainder r{.steps = s["steady"]["steps_per_cycle"],
                    .own = (numerical + quadrature) / friction,
                    .quadrature = quadrature / friction};
  const auto order = [&](double before, double now) {
    if (std::abs(r.steps / coarser.steps - 2) > 1e-6) return std::string();
    return fmt::format(" ({:.1f})", std::log2(std::abs(before / now)));
  };
  fmt::print(
      "| {} | {} | {} | {:.0f}{} | {:.2e} | {:.6e} | {:+.2f} % | {:.2f} % | {:+.1e} | {:+.1e}{} | {:.1e}{} | {:.2f} "
      "|\n",
      law, amplitude_mm, method.name, r.steps, chosen ? " auto" : "", s["steady"]["damping_ratio"].get<double>(),
      friction, 100 * (friction / total(finest, "friction_dissipation_J") - 1), 100 * largest, numerical / friction,
      r.own, order(coarser.own, r.own), r.quadrature, order(coarser.quadrature, r.quadrature),
      s["cost"]["newton_iterations"].get<double>() / s["cost"]["steps"].get<double>());
  std::fflush(stdout);
  return r;
}

/// Free decays of the laboratory span, at the steps that `auto` chooses, at half and at double; beside
/// generalized-alpha at the finest step.
void print_friction() {
  constexpr int finest_steps = 1600;
  fmt::print(
      "\n| law | antinode mm | method | steps per cycle | damping ratio | friction J | off finest | at most in a cycle "
      "| remainder | own (order) | quadrature (order) | corrections |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  struct Swing {
    const char* law;
    double amplitude_mm;
    int cycles;
  };
  for (const auto& [law, amplitude, cycles] : {Swing{.law = "return-map", .amplitude_mm = 1.8, .cycles = 10},
                                               Swing{.law = "return-map", .amplitude_mm = 4.3, .cycles = 10},
                                               Swing{.law = "return-map", .amplitude_mm = 12, .cycles = 10},
                                               Swing{.law = "compliant", .amplitude_mm = 0.1, .cycles = 3}}) {
    const auto fixed = [&](const Choice& method, int steps) {
      return run(joined(joined(decay(law, amplitude, cycles), method.keys),
                        {fmt::format("integrator.steps_per_cycle={}", steps)}));
    };
    const ordered_json finest = fixed(methods()[2], finest_steps);
    for (std::size_t m : {std::size_t{0}, std::size_t{2}}) {
      const Choice& method = methods()[m];
      const ordered_json chosen =
          run(joined(joined(decay(law, amplitude, cycles), method.keys), {"integrator.step=auto"}));
      const int n = static_cast<int>(std::lround(chosen["steady"]["steps_per_cycle"].get<double>()));
      Remainder r = print_friction_row(law, amplitude, method, fixed(method, n / 2), finest, {}, false);
      r = print_friction_row(law, amplitude, method, chosen, finest, r, true);
      r = print_friction_row(law, amplitude, method, fixed(method, 2 * n), finest, r, false);
      if (4 * n <= finest_steps) print_friction_row(law, amplitude, method, fixed(method, 4 * n), finest, r, false);
    }
    print_friction_row(law, amplitude, methods()[2], finest, finest, {}, false);
  }
}

// ---- mass

double twelfth_frequency(const std::vector<std::string>& overrides) {
  const casefile::Scene scene = casefile::read_scene(STRANDYN_SOURCE_DIR "/cases/curlew_lab_span.toml", overrides);
  const build::BuiltSpan built = build::build_span(scene);
  system::System system(built.model);
  const system::Vector u = system.make_vector();
  system.begin(u);
  return solver::transverse_modes(system, u, 12).back().frequency;
}

/// The largest moment on a node whose rotations have no mass, of the largest force on a node [m]: at the start, and
/// after a step.
class Balance final : public observe::Observer {
 public:
  void begin(const system::System& system, const observe::StepRecord& initial) override {
    start = look(system, initial);
  }
  void step(const system::System& system, const observe::StepRecord& record) override {
    later = std::max(later, look(system, record));
  }
  double start = 0, later = 0;

 private:
  static double look(const system::System& system, const observe::StepRecord& record) {
    system::Vector force = system.make_vector();
    system.internal_force(record.u.data(), force.data());
    double largest = 0;
    for (std::size_t i = 0; i < system.unknowns(); ++i) {
      if (!system.has_mass(i) && !system.is_held(i))
        largest = std::max(largest, std::abs(force(static_cast<Eigen::Index>(i))));
    }
    return largest / force.cwiseAbs().maxCoeff();
  }
};

/// Rotations without mass are algebraic: are they in balance when the run begins, and at the end of every step?
void print_balance() {
  fmt::print(
      "\n| method | moment on a massless rotation, of the largest force | after a step, at most |\n| --- | --- | --- "
      "|\n");
  for (std::size_t m : {std::size_t{0}, std::size_t{2}}) {
    bench::Span span("curlew_lab_span.toml", joined(methods()[m].keys, {"span.mass=lumped", "load[0].amplitude_N=0"}));
    Balance balance;
    observe::Observer* const observers[] = {&balance};
    bench::integrate(span, bench::sine_velocity(span, 12, 0.8), 2e-4, 400, observers);
    fmt::print("| {} | {:.1e} m | {:.1e} m |\n", methods()[m].name, balance.start, balance.later);
  }
}

void print_mass() {
  const auto keys = [](int elements, const char* grading, const char* mass, bool rotary) {
    return std::vector<std::string>{fmt::format("span.elements={}", elements), fmt::format("span.grading={}", grading),
                                    fmt::format("span.mass={}", mass), fmt::format("span.rotary_inertia={}", rotary)};
  };
  constexpr int cycles = 5;
  const std::vector<std::string> motion = joined(decay("return-map", 5, cycles), {"integrator.steps_per_cycle=200"});
  fmt::print(
      "\n| mesh | mass | rotary inertia | method | f_12 error | friction error | steps | corrections | residuals | "
      "tangents |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  // Rotary inertia lowers the frequency by 4e-5: each is held against its own.
  double frequency[2];
  double friction[2][2];
  for (bool rotary : {false, true}) {
    const auto fine = joined(motion, keys(320, "clamps", "consistent", rotary));
    frequency[rotary] = twelfth_frequency(fine);
    for (std::size_t m : {std::size_t{0}, std::size_t{2}}) {
      friction[rotary][m / 2] = total(run(joined(fine, methods()[m].keys)), "friction_dissipation_J");
    }
  }
  for (const char* grading : {"clamps", "uniform"}) {
    for (int elements : {40, 80, 160}) {
      for (const char* mass : {"lumped", "consistent"}) {
        for (bool rotary : {false, true}) {
          const auto mesh = joined(motion, keys(elements, grading, mass, rotary));
          const double f = twelfth_frequency(mesh);
          for (std::size_t m : {std::size_t{0}, std::size_t{2}}) {
            const ordered_json s = run(joined(mesh, methods()[m].keys));
            const double lost = total(s, "friction_dissipation_J");
            const ordered_json& cost = s["cost"];
            fmt::print("| {} {} | {} | {} | {} | {:+.1e} | {:+.2f} % | {} | {} | {} | {} |\n", elements,
                       grading == std::string("clamps") ? "graded" : "uniform", mass, rotary ? "yes" : "no",
                       methods()[m].name, f / frequency[rotary] - 1, 100 * (lost / friction[rotary][m / 2] - 1),
                       cost["steps"].dump(), cost["newton_iterations"].dump(), cost["residual_evaluations"].dump(),
                       cost["jacobian_evaluations"].dump());
          }
        }
      }
    }
  }
  print_balance();
}

// ---- steps by IDA's own control of the error

void print_adaptive() {
  fmt::print(
      "\n| antinode mm | rtol | steps per cycle | of order 1 | cut | friction J | remainder, of friction |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n");
  constexpr int cycles = 10;
  for (double amplitude : {1.8, 4.3, 12.0}) {
    const auto row = [&](const std::string& name, const std::vector<std::string>& keys) {
      const ordered_json s = run(joined(decay("return-map", amplitude, cycles), keys));
      const double friction = total(s, "friction_dissipation_J");
      const ordered_json& cost = s["cost"];
      fmt::print("| {} | {} | {:.0f} | {} | {} | {:.5e} | {:+.1e} |\n", amplitude, name,
                 cost["steps"].get<double>() / cycles, cost["order_one_steps"].dump(), cost["rejected_steps"].dump(),
                 friction, total(s, "numerical_dissipation_J") / friction);
      std::fflush(stdout);
    };
    for (const char* rtol : {"1e-3", "1e-4", "1e-5"}) {
      row(rtol, {"integrator.step=adaptive", std::string("integrator.rtol=") + rtol});
    }
    row("fixed", {"integrator.step=auto"});
  }
}

// ---- ten thousand cycles

/// Mode 1 of the taut beam at 0.8 mm, eight elements: how much of the energy is left. Across the line only, the beam is
/// linear but for the tension of its swing, 2e-6.
void print_long() {
  constexpr std::size_t cycles_run = 10000;
  fmt::print(
      "\n| unknowns | method | steps per cycle | cycles | energy left | predicted | lost part off |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n");
  const auto row = [&](const Choice& method, int n, bool condensed) {
    bench::Span span("beam/elastic_benchmark_planar.toml",
                     joined(method.keys, {"span.elements=8", fmt::format("span.condense_axial={}", condensed)}));
    const solver::Mode mode = solver::transverse_modes(span.system, span.u, 1).back();
    const system::Vector velocity = 8e-4 * 2 * pi * mode.frequency * mode.shape / mode.shape.cwiseAbs().maxCoeff();
    observe::Ledger ledger;
    observe::Observer* const observers[] = {&ledger};
    bench::integrate(span, velocity, 1 / (mode.frequency * n), cycles_run * static_cast<std::size_t>(n), observers);
    const observe::Account& a = ledger.now();
    const double left = (a.kinetic + a.elastic) / a.initial_kinetic;
    const double predicted = std::exp(-4 * pi * predict(method, 2 * pi / n).damping * static_cast<double>(cycles_run));
    fmt::print("| {} | {} | {} | {} | {:.9f} | {:.9f} | {} |\n", condensed ? "across" : "all", method.name, n,
               cycles_run, left, predicted,
               predicted < 1 ? fmt::format("{:+.2f} %", 100 * ((1 - left) / (1 - predicted) - 1)) : "-");
    std::fflush(stdout);
  };
  for (bool condensed : {true, false}) {
    row(methods()[1], 20, condensed);
    row(methods()[2], 50, condensed);
    row(methods()[0], 200, condensed);
  }
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> wanted(arguments + 1, arguments + count);
  const auto wants = [&](const char* name) { return wanted.empty() || std::ranges::count(wanted, name) > 0; };
  if (wants("linear")) print_linear();
  if (wants("friction")) print_friction();
  if (wants("mass")) print_mass();
  if (wants("adaptive")) print_adaptive();
  if (wants("long")) print_long();
}
