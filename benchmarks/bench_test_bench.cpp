// The test bench against the periodic response of the same span at three amplitudes, and its routes among each other:
// the tables of docs/test_bench.md.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "strandyn/build/span.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/results/json.hpp"
#include "strandyn/solver/periodic/periodic.hpp"
#include "strandyn/study/run_case.hpp"

using namespace strandyn;
using nlohmann::ordered_json;
using std::numbers::pi;

namespace {

constexpr int mode_number = 12;
constexpr double modal_ratio = 1e-3;

struct Case {
  const char* name;
  double amplitude_over_diameter;
  bool modal_damping;
};

casefile::Scene scene_of(const Case& c, const std::string& start) {
  std::string text =
      "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.5\n[section]\nlaw = \"return-map\"\n"
      "[span]\nlength_m = 30\ntension_rts = 0.2\nelements = 80\n"
      "[[load]]\ntype = \"harmonic-force\"\nat_m = 0.7\namplitude_N = 1\nfrequency = \"mode 12\"\n";
  if (c.modal_damping) text += fmt::format("[damping]\nmodal = [[{}, {}]]\n", mode_number, modal_ratio);
  text += fmt::format(
      "[analysis]\ntype = \"self-damping\"\nmethod = \"transient\"\nmodes = {}\namplitude_over_diameter = {}\n"
      "tensions_rts = 0.2\nbench = {{ start = \"{}\", max_cycles = 800 }}\n",
      mode_number, c.amplitude_over_diameter, start);
  return casefile::read_scene_text(text, "bench.toml");
}

/// [m] of the largest antinode of the fundamental, a loop and more from the ends.
double largest_antinode(const solver::PeriodicSolver& solver, const solver::PeriodicSolution& s, double length) {
  double largest = 0;
  const double loop = length / mode_number;
  for (const solver::LoopPoint& point : solver.loop_points(s.state)) {
    if (point.position >= loop && point.position <= length - loop) largest = std::max(largest, point.amplitude);
  }
  return largest;
}

struct Periodic {
  double frequency = 0;  // [Hz]
  double loss = 0;       // [J] per cycle
  double friction = 0;   // [J] per cycle, as the law books it
  std::size_t evaluations = 0;
};

/// The periodic state whose largest antinode swings by `amplitude` [m].
Periodic periodic(const Case& c, double amplitude) {
  const casefile::Scene scene = scene_of(c, "mode");
  const build::BuiltSpan built = build::build_span(scene);
  system::System system(built.model);
  const system::Vector rest = system.make_vector();
  system.begin(rest);
  const solver::Mode mode = solver::transverse_modes(system, rest, mode_number).back();
  if (c.modal_damping) {
    system::Vector momentum = system.make_vector();
    system::Matrix M = system.make_matrix();
    system.mass_matrix(rest.data(), M);
    M.multiply(mode.shape.data(), momentum.data());
    for (std::size_t i = 0; i < system.unknowns(); ++i) {
      if (!system.has_mass(i)) momentum(static_cast<Eigen::Index>(i)) = 0;
    }
    const double factor = 2 * modal_ratio * 2 * pi * mode.frequency / mode.shape.dot(momentum);
    system.set_damping({.rayleigh = {}, .modes = {{.momentum = momentum, .factor = factor}}});
  }
  std::size_t control = 0;  // the largest node of the loop next to the middle
  const auto y = [&](std::size_t node) { return std::abs(built.model.displacement(mode.shape.data(), node).y()); };
  for (std::size_t node = 0; node < built.model.nodes.size(); ++node) {
    const double x = built.model.nodes[node].x();
    if (x > 0.4 * built.length && x < 0.5 * built.length && y(node) > y(control)) control = node;
  }
  const solver::PeriodicSolver solver(system, rest,
                                      {.drive = {.node = built.model.loads.front().node}, .control = {.node = control}},
                                      {.harmonics = 5});
  solver::PeriodicSolution s = solver.resonance(amplitude * y(control), solver.from_mode(mode, amplitude * y(control)));
  std::size_t evaluations = s.effort.evaluations;
  if (!s.converged) {
    for (const solver::PeriodicSolution& each : solver.backbone({0.5 * amplitude, 0.8 * amplitude, amplitude}, mode)) {
      evaluations += each.effort.evaluations;
      s = each;
    }
  }
  for (int i = 0; i < 3 && s.converged; ++i) {
    const double found = largest_antinode(solver, s, built.length);
    if (std::abs(found / amplitude - 1) < 1e-6) break;
    s = solver.resonance(s.amplitude * amplitude / found, s.state);
  }
  if (!s.converged) fmt::print("periodic: {}\n", s.failure);
  return {.frequency = s.state.frequency,
          .loss = s.loop_work + s.viscous.total(),
          .friction = s.friction,
          .evaluations = evaluations};
}

ordered_json transient(const Case& c, const std::string& start) {
  const ordered_json point =
      ordered_json::parse(results::to_text(study::run_case(scene_of(c, start)).summary))["points"][0];
  if (point.contains("failed")) fmt::print("transient: {}\n", point["failed"].get<std::string>());
  return point.value("bench", ordered_json());
}

}  // namespace

int main() {
  const Case cases[] = {{"below first slip, modal damping 1e-3", 0.02, true},
                        {"first slip, at the clamps", 0.06, false},
                        {"partial slip", 0.1, false},
                        {"slip in the free span", 0.17, false},
                        {"gross slip near the clamps", 0.3, false}};
  for (const Case& c : cases) {
    std::fflush(stdout);
    const ordered_json mode = transient(c, "mode");
    const ordered_json rest = transient(c, "rest");
    if (mode.is_null()) continue;
    const Periodic p = periodic(c, mode["fundamental_amplitude_m"]);
    const ordered_json& ledger = mode["ledger"];
    const double friction = ledger["friction_dissipation_J"];
    const double loss =
        friction - ledger["quadrature_error_J"].get<double>() + ledger["viscous_dissipation_J"].get<double>();
    const double asked = mode["section_evaluations_until_steady"];
    fmt::print("{}, A/D = {}\n", c.name, c.amplitude_over_diameter);
    fmt::print(
        "  transient {:.6g} J per cycle (friction {:.6g}), {:.6f} Hz; periodic {:.6g} J ({:.6g}), {:.6f} Hz; "
        "transient over periodic {:.5f}\n",
        loss, friction, mode["frequency_Hz"].get<double>(), p.loss, p.friction, p.frequency, loss / p.loss);
    fmt::print("  section evaluations: periodic {}, transient {:.4g} from the mode in {} cycles (ratio {:.0f})",
               p.evaluations, asked, mode["cycles_until_steady"].get<int>(),
               asked / static_cast<double>(p.evaluations));
    if (!rest.is_null()) {
      const double from_rest = rest["section_evaluations_until_steady"];
      fmt::print(", {:.4g} from rest in {} (ratio {:.0f})", from_rest, rest["cycles_until_steady"].get<int>(),
                 from_rest / static_cast<double>(p.evaluations));
    }
    fmt::print("\n  routes: ledger {:.5g} W/m, numerical/friction {:.2g}, power {:.5f}, decay {:.5f} of it",
               ledger["self_damping_W_per_m"].get<double>(), ledger.value("numerical_over_friction", 0.0),
               mode["power"].value("over_ledger", 0.0), mode["decay"].value("over_ledger", 0.0));
    if (mode.contains("iswr")) {
      fmt::print("; between nodes ledger {:.5g}, ISWR {:.5g}", mode["iswr"]["ledger_W_per_m"].get<double>(),
                 mode["iswr"]["self_damping_W_per_m"].get<double>());
    }
    fmt::print("\n");
  }
}
