// Loads that reverse each step, snaps, sudden release, blows; stiff axial modes, heavy bodies, stiff springs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene.hpp"
#include "themes.hpp"

namespace strandyn::extremes {
namespace {

using std::numbers::pi;

/// +F and -F in turns, a step each.
std::string reversing(double at, double force, double step, int steps) {
  std::string rows;
  for (int i = 1; i <= steps; ++i) rows += fmt::format(", [{:.17g}, {}]", i * step, i % 2 ? force : -force);
  return fmt::format("[[load]]\ntype = \"table\"\nat_m = {}\nhistory = [[0, 0]{}]\n", at, rows);
}
std::string smooth(double at, double force, double step, int steps) {
  std::string rows;
  for (int i = 1; i <= steps; ++i)
    rows += fmt::format(", [{:.17g}, {:.17g}]", i * step, force * std::sin(2 * pi * i / 50.0));
  return fmt::format("[[load]]\ntype = \"table\"\nat_m = {}\nhistory = [[0, 0]{}]\n", at, rows);
}

Found reverses(const std::string& method, bool stranded) {
  constexpr double step = 1e-3;
  constexpr int steps = 400;
  const std::string rest = fmt::format(
      "[integrator]\n{}step_s = {}\nmax_numerical_share = 1e9\n[analysis]\ntype = \"transient\"\nduration_s = {}\n",
      method, step, step * steps);
  const auto run_with = [&](const std::string& load) {
    return stranded ? Run(curlew_span(load + rest)) : Run(elastic_span(load + rest));
  };
  const double force = stranded ? 3000 : 100;
  const Run run = run_with(reversing(stranded ? 0.3 : 5, force, step, steps)),
            ordinary = run_with(smooth(stranded ? 0.3 : 5, force, step, steps));
  Found found;
  found.most("energy above what came in", run.energy_above_input(), 1e-6);
  if (stranded) found.least("friction (J)", run.at("energy.friction_dissipation_J"), 1e-9);
  return found.costs(evaluations_per_step(run, ordinary));
}

/// A bar whose end slides across its line: P = EA (strain) (lean), while it shortens, snaps through and is pulled on
/// the other side.
Found snap_through() {
  const auto text = [](double millimetres) {
    return fmt::format(
        "[section]\nlaw = \"elastic\"\nEA_N = 1e6\nEI_N_m2 = 1\n[span]\nnodes_m = [[0, 0, 0], [1, 0.1, 0]]\nelements = "
        "1\n"
        "left = \"pinned\"\nright = \"free\"\n[[motion]]\ntype = \"static-motion\"\nat = \"right\"\ndisplacement_mm = "
        "0\n"
        "direction = [1, 0, 0]\n[[load]]\ntype = \"static-force\"\nat_m = 1.004987562\nforce_N = 1\ndirection = [0, "
        "-1, 0]\n"
        "[static]\ncontrol = \"displacement\"\ndisplacement_mm = {}\n[analysis]\ntype = \"static\"\nsteps = 50\n",
        millimetres);
  };
  const Run run(text(250)), ordinary(text(0.01));
  const double l0 = std::sqrt(1.01);
  const auto exact = [&](double w) {
    const double h = 0.1 - w, l = std::sqrt(1 + h * h);
    return 1e6 * (l0 - l) / l0 * h / l;
  };
  double worst = 0, largest = 0;
  for (int i = 0; i < 50; ++i) {
    const double w = run.at(fmt::format("steps[{}].displacement_m", i));
    largest = std::max(largest, std::abs(exact(w)));
    worst = std::max(worst, std::abs(run.at(fmt::format("steps[{}].load_N", i)) - exact(w)));
  }
  return Found{}.most("load off by, over the largest", worst / largest, 1e-9).costs(evaluations(run, ordinary));
}

/// Two bars that lean against each other, pushed over their top: they jump, and nobody has given them energy.
Found snaps_in_time(const std::string& method, double tolerance) {
  const auto text = [&](double force) {
    return fmt::format(
        "[section]\nlaw = \"elastic\"\nEA_N = 1e6\nEI_N_m2 = 1\nmass_kg_per_m = 1\n[span]\nnodes_m = [[0, 0, 0], [1, "
        "0.1, 0], [2, 0, 0]]\n"
        "elements = 8\ngrading = \"uniform\"\nleft = \"pinned\"\nright = \"pinned\"\nmass = "
        "\"consistent\"\n[[load]]\ntype = \"table\"\n"
        "at_m = 1.00498756211\nhistory = [[0, 0], [0.05, {}]]\ndirection = [0, -1, 0]\n[integrator]\n{}step_s = 2e-5\n"
        "max_numerical_share = 1e9\n[analysis]\ntype = \"transient\"\nduration_s = 0.1\n",
        force, method);
  };
  const Run run(text(800)), ordinary(text(1));
  return Found{}
      .least("jump of the joint (m)", -run.at("probes[0].displacement_m.min[1]"), 0.15)
      .most("energy above what came in", run.energy_above_input(), tolerance)
      .costs(evaluations_per_step(run, ordinary));
}

/// Pulled aside and let go within a step: it swings with the energy that was put in, F w/2.
Found sudden_release() {
  const auto text = [](double fall) {
    return elastic_span(fmt::format(
        "[[load]]\ntype = \"table\"\nat_m = 5\nhistory = [[0, 10], [{:.17g}, 0]]\n[integrator]\n{}step_s = 1e-4\n"
        "[analysis]\ntype = \"transient\"\nduration_s = 1\nprobes_m = [5]\n",
        fall, conserving));
  };
  const Run run(text(1e-9)), ordinary(text(0.3));
  const auto& t = run.table("energies.csv");
  const auto &kinetic = t.column("kinetic_J"), &elastic = t.column("elastic_J");
  double largest = 0, least = 1e9;
  for (std::size_t i = 5; i < t.rows(); ++i) {
    largest = std::max(largest, kinetic[i] + elastic[i]);
    least = std::min(least, kinetic[i] + elastic[i]);
  }
  // Pulled in its middle: all modes begin at their crests there, with one sign, and never sum up to more again. Pinned
  // under tension: w = F/(2 T) [L/2 - tanh(l L/2)/l], l^2 = T/EI.
  const double l = std::sqrt(400.0), w = 10.0 / 8000 * (5 - std::tanh(5 * l) / l);
  return Found{}
      .within("swing to the other side over that", -run.at("probes[0].displacement_m.min[1]") / (2 * w), 0.9, 1.001)
      .most("energy kept but for, of F w/2", (largest - least) / (10 * w / 2), 1e-4)
      .most("energy above what came in, of F w/2", run.energy_above_input(10 * w / 2), 1e-4)
      .costs(evaluations_per_step(run, ordinary));
}

/// A blow of a microsecond on a free bar leaves its impulse, whatever the step.
Found blow() {
  const auto text = [](double length) {
    return fmt::format(
        "[section]\nlaw = \"elastic\"\nEA_N = 1e6\nEI_N_m2 = 100\nmass_kg_per_m = 2\n[span]\nlength_m = 4\ntension_kN "
        "= 0\nelements = 8\n"
        "left = \"free\"\nright = \"free\"\nmass = \"consistent\"\n[[load]]\ntype = \"table\"\nat_m = 2\nhistory = "
        "[[0, 0], [{0:.17g}, {1:.17g}], [{2:.17g}, 0]]\n"
        "[integrator]\n{3}step_s = {0:.17g}\n[analysis]\ntype = \"transient\"\nduration_s = {4:.17g}\n",
        length / 2, 2 / length, length, conserving, 400 * length);
  };
  const Run run(text(1e-6)), ordinary(text(1e-2));
  return Found{}
      .close("momentum (N s)", run.at("momentum.linear_kg_m_per_s[1]"), 1, 1e-9)
      .most("energy above what came in", run.energy_above_input(), 1e-6)
      .costs(evaluations_per_step(run, ordinary));
}

/// Axial modes 1e5 times as fast as the step: Kirchhoff's string (its frequency: amplitude.cpp), and energy is kept.
Found stiff_axially(const std::string& method) {
  constexpr double EA = 1e12, A = 1.5e-4;
  const auto text = [&](double stiffness) {
    return fmt::format(
        "[section]\nlaw = \"elastic\"\nEA_N = {}\nEI_N_m2 = 10\nmass_kg_per_m = 1\n[span]\nlength_m = 10\ntension_kN = "
        "4\nelements = 20\n"
        "grading = \"uniform\"\nleft = \"pinned\"\nright = \"pinned\"\nmass = \"consistent\"\nrotary_inertia = "
        "false\n[initial]\nvelocity_mode = 1\n"
        "antinode_velocity_m_per_s = 3e-3\n[integrator]\n{}step_s = 1e-3\nmax_numerical_share = 1e9\n[analysis]\ntype "
        "= \"transient\"\n"
        "duration_s = 6.4\nprobes_m = [5]\n",
        stiffness, method);
  };
  const Run run(text(EA)), ordinary(text(1e7));
  const double k = pi / 10, w2 = k * k * (4000 + 10 * k * k), b = EA * std::pow(k, 4) / 4;
  // The amplitude that a start with 3 mm/s reaches: v^2 = A^2 (w2 + b A^2/2).
  double swing = A;
  for (int i = 0; i < 50; ++i) swing = 3e-3 / std::sqrt(w2 + b * swing * swing / 2);
  const double s = w2 + b * swing * swing;
  const double exact = std::sqrt(s) / (4 * std::comp_ellint_1(std::sqrt(b * swing * swing / (2 * s))));
  // At some 300 steps a cycle a method is off by (omega h)^2/3 = 1.5e-4 at most. The trapezoidal rule misses the work
  // of a cubic force by b h^2 A^2/4 of the energy on the way from the middle to the crest, and gives it back.
  const double missed = 1.1 * b * 1e-6 * swing * swing / 4;
  return Found{}
      .close("frequency (Hz)", run.at("probes[0].frequency_Hz"), exact, 2e-4)
      .most("energy above what came in", run.energy_above_input(), missed)
      .costs(evaluations_per_step(run, ordinary));
}

constexpr double stretch = 1 + 4000 / 1e7;

/// A span of 10 kg with a body in its middle, EI = 10 N m^2, 400 elements.
std::string with_body(const std::string& body) {
  return "[section]\nlaw = \"elastic\"\nEA_N = 1e7\nEI_N_m2 = 10\nmass_kg_per_m = 1\n[span]\nlength_m = 10\ntension_kN "
         "= 4\nelements = 400\n"
         "grading = \"uniform\"\nleft = \"pinned\"\nright = \"pinned\"\nmass = \"consistent\"\nrotary_inertia = "
         "false\n[[body]]\nat_m = 5\n" +
         body + "\n[analysis]\ntype = \"modes\"\ncount = 2\n";
}
Cost seconds(const Run& extreme, const Run& ordinary) {
  return {.extreme = extreme.result().cost.cpu_s, .ordinary = ordinary.result().cost.cpu_s, .unit = "CPU seconds"};
}
/// [Hz] of half the span, pinned here and there; its bending stiffness counts per unstressed length.
double half_span() {
  const double k = pi / 5;
  return k * std::sqrt((4000 + 10 * stretch * k * k) * stretch) / (2 * pi);
}

/// 1e6 kg on 10 kg: the static stiffness in the middle, 2 T/[L/2 - tanh(l L/2)/l] with l^2 = T/EI, and a third of the
/// span swings with the body.
Found heavy_body() {
  const Run run(with_body("mass_kg = 1e6")), ordinary(with_body("mass_kg = 1"));
  const double l = std::sqrt(400 / stretch), K = 8000 / (5 - std::tanh(5 * l) / l);
  return Found{}
      .close("frequency (Hz)", run.at("frequencies_Hz[0]"), std::sqrt(K / (1e6 + 10 / 3.0)) / (2 * pi), 1e-5)
      .close("frequency of the half span (Hz)", run.at("frequencies_Hz[1]"), half_span(), 1e-5)
      .costs(seconds(run, ordinary));
}

/// A spring of 1e15 N/m in the middle is a support: half spans, pinned or, moving alike, clamped there:
/// tan(r)/r = tanh(p)/p, p^2 - r^2 = xi^2, pi < r < 3 pi/2.
Found stiff_spring() {
  const Run run(with_body("stiffness_N_per_m = 1e15")), ordinary(with_body("stiffness_N_per_m = 1e3"));
  const double EI = 10 * stretch, xi2 = 25 * 4000 / EI;
  double low = pi, high = 1.5 * pi - 1e-9;
  for (int i = 0; i < 80; ++i) {
    const double r = (low + high) / 2, p = std::sqrt(xi2 + r * r);
    (std::tan(r) / r < std::tanh(p) / p ? low : high) = r;
  }
  const double symmetric = low * std::sqrt(xi2 + low * low) * std::sqrt(EI * stretch) / 25 / (2 * pi);
  return Found{}
      .close("antisymmetric mode (Hz)", run.at("frequencies_Hz[0]"), half_span(), 1e-5)
      .close("symmetric mode (Hz)", run.at("frequencies_Hz[1]"), symmetric, 1e-5)
      .costs(seconds(run, ordinary));
}

/// A support that pulls the vibrating span from slack to 60 % of its strength and back.
Found pulled_in_time() {
  const auto text = [](double pull) {
    return fmt::format(
        "[conductor]\ncatalogue = \"curlew\"\nfriction = 0.7\n[section]\nlaw = \"return-map\"\n[span]\nlength_m = "
        "10\ntension_rts = 0.01\nelements = 40\n"
        "[[motion]]\ntype = \"table\"\nat = \"right\"\ndirection = [1, 0, 0]\nhistory = [[0, 0], [0.2, {0:.17g}], "
        "[0.4, 0], [0.5, 0]]\n"
        "[initial]\nvelocity_mode = 1\nantinode_velocity_m_per_s = 0.5\n[integrator]\n{1}step_s = "
        "5e-4\nmax_numerical_share = 1e9\n"
        "[analysis]\ntype = \"transient\"\nduration_s = 0.5\n",
        pull, conserving);
  };
  const Run run(text(0.0325)), ordinary(text(1e-4));
  return Found{}
      .most("energy above what came in", run.energy_above_input(), 1e-6)
      .least("friction (J)", run.at("energy.friction_dissipation_J"), 1e-3)
      .most("numerical share", run.at("energy.numerical_share"), 0.05)
      .costs(evaluations_per_step(run, ordinary));
}

}  // namespace

std::vector<Extreme> load_rows() {
  const std::string ida = "method = \"ida\"\n", input = "no step has more energy than came in";
  return {
      {"loads/reversing-elastic", "100 N that turn round in every step, trapezoidal rule", input,
       [] { return reverses(conserving, false); }},
      {"loads/reversing-stranded", "3 kN on Curlew that turn round in every step, trapezoidal rule",
       input + "; friction takes some", [] { return reverses(conserving, true); }},
      {"loads/reversing-ida", "3 kN on Curlew that turn round in every step, IDA", input + "; friction takes some",
       [ida] { return reverses(ida, true); }},
      {"loads/snap-through", "a bar pushed through its line, displacement controlled",
       "the closed form of the truss, maximum and minimum included", snap_through},
      {"loads/snap-conserving", "two bars that snap through in time, trapezoidal rule", input,
       [] { return snaps_in_time(conserving, 1e-3); }, Pace::slow},
      {"loads/snap-ida", "two bars that snap through in time, IDA", input, [ida] { return snaps_in_time(ida, 1e-3); },
       Pace::slow},
      {"loads/sudden-release", "10 N let go in 1 ns", "swings to the other side and no further; F w/2 is kept",
       sudden_release, Pace::slow},
      {"loads/blow", "a blow of 1 N s in 1 microsecond on a free bar",
       "momentum is the impulse; no step has more energy than came in", blow},
      {"loads/stiff-axial-1e12", "EA of 1e12 N, trapezoidal rule",
       "frequency of Kirchhoff's string; no step has more energy than came in",
       [] { return stiff_axially(conserving); }},
      {"loads/stiff-axial-1e12-ida", "EA of 1e12 N, IDA",
       "frequency of Kirchhoff's string; no step has more energy than came in", [ida] { return stiff_axially(ida); }},
      {"loads/heavy-body", "1e6 kg on a span of 10 kg",
       "stiffness of the beam under a force over the mass; the half span", heavy_body},
      {"loads/stiff-spring", "a spring of 1e15 N/m in the middle",
       "it is a support: half spans, pinned and clamped there", stiff_spring},
      {"loads/pulled", "a vibrating span pulled from 1 to 60 % of its strength and back in 0.4 s",
       "no step has more energy than came in; the numerical part below 5 %", pulled_in_time, Pace::slow},
  };
}

}  // namespace strandyn::extremes
