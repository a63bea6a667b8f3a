// From 4 to 100 000 steps a cycle.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "point.hpp"
#include "scene.hpp"
#include "strands.hpp"
#include "strandyn/conductor/contact.hpp"
#include "strandyn/exact/friction_layer.hpp"
#include "strandyn/section/masing.hpp"
#include "strandyn/section/multilinear.hpp"
#include "themes.hpp"

namespace strandyn::extremes {
namespace {

using std::numbers::pi;

/// The elastic span's first mode at 1e-4 m: linear but for 6e-7 of its tension.
struct Linear {
  static constexpr double k = pi / 10;
  /// [rad/s]
  static double omega() { return k * std::sqrt((4000 + 10 * k * k) * (1 + 4000 / 1e7)); }
};

Run linear(const std::string& method, double steps_per_cycle, double periods) {
  const double period = 2 * pi / Linear::omega();
  return Run(
      elastic_span(fmt::format("[initial]\nvelocity_mode = 1\nantinode_velocity_m_per_s = {:.17g}\n[integrator]\n{}"
                               "step_s = {:.17g}\nmax_numerical_share = 1e9\n[analysis]\ntype = \"transient\"\n"
                               "duration_s = {:.17g}\nprobes_m = [5]\n",
                               Linear::omega() * 1e-4, method, period / steps_per_cycle, period * periods)));
}

/// The trapezoidal rule keeps the energy of what is linear, and tan(omega' h/2) = omega h/2.
Found trapezoidal(int steps, double periods) {
  const Run run = linear(conserving, steps, periods), ordinary = linear(conserving, 200, periods);
  const double h = 2 * pi / Linear::omega() / steps;
  const double exact = std::atan(Linear::omega() * h / 2) / (pi * h);
  // Zeros are read by straight lines between steps: each is off by some h (omega h)^2/20.
  const double read = std::pow(2 * pi / steps, 2) / (20 * steps * periods);
  return Found{}
      .close("frequency (Hz)", run.at("probes[0].frequency_Hz"), exact, 3e-6 + 2 * read)
      .most("energy kept but for",
            std::abs(run.at("energy.numerical_dissipation_J")) / run.at("energy.initial_kinetic_J"), 1e-6)
      .most("energy above what came in", run.energy_above_input(), 1e-6)
      .costs(evaluations(run, ordinary));
}

/// IDA at second order damps: energy only falls, whatever the step.
Found falls(int steps, double periods) {
  const Run run = linear("method = \"ida\"\n", steps, periods), ordinary = linear("method = \"ida\"\n", 200, periods);
  const auto& t = run.table("energies.csv");
  const auto &kinetic = t.column("kinetic_J"), &elastic = t.column("elastic_J");
  const std::size_t end = t.rows() - 1;
  // 8 J are stored at rest, known to some 32 units in their last place; 1e-5 J swing.
  return Found{}
      .most("energy above what came in", run.energy_above_input(), 1e-8)
      .within("energy left over that at the start", (kinetic[end] + elastic[end]) / kinetic[0], 0, 1)
      .costs(evaluations(run, ordinary));
}

/// [-] what the formula of second order takes in a radian, from cycle 10 to 30, over what theory says: (omega h)^3/2 of
/// the energy, two damping ratios of (omega h)^3/4.
double taken_over_theory(const Run& run, int steps) {
  const auto& t = run.table("energies.csv");
  const auto &time = t.column("t_s"), &kinetic = t.column("kinetic_J"), &elastic = t.column("elastic_J");
  const double period = 2 * pi / Linear::omega();
  std::size_t a = 0, b = 0;
  while (time[a] < 10 * period) ++a;
  for (b = a; b + 1 < t.rows() && time[b] < 30 * period;) ++b;
  const double taken = -std::log((kinetic[b] + elastic[b]) / (kinetic[a] + elastic[a]));
  const double angle = Linear::omega() * (time[b] - time[a]);
  return taken / angle / (std::pow(2 * pi / steps, 3) / 2);
}
Found third_power(int steps) {
  const Run coarse = linear("method = \"ida\"\n", steps, 31), fine = linear("method = \"ida\"\n", 2 * steps, 31);
  const double at_coarse = taken_over_theory(coarse, steps), at_fine = taken_over_theory(fine, 2 * steps);
  return Found{}
      .within("damping over (omega h)^3/4", at_fine, 0.97, 1.03)
      .within("error ratio when the step halves", 8 * at_coarse / at_fine, 7.5, 8.5)
      .costs(evaluations(fine, linear("method = \"ida\"\n", 200, 31)));
}

Found second_order(const std::string& method, double share) {
  const Run coarse = linear(method, 100, 40), fine = linear(method, 200, 40);
  const double exact = Linear::omega() / (2 * pi);
  const auto off = [&](const Run& run) { return run.at("probes[0].frequency_Hz") / exact - 1; };
  return Found{}
      .within("error ratio of the frequency when the step halves", off(coarse) / off(fine), 3.8, 4.2)
      .within("frequency too low by this over (omega h)^2", -off(fine) / std::pow(2 * pi / 200, 2), 0.95 * share,
              1.05 * share)
      .costs(evaluations(fine, coarse));
}

/// Stranded, with friction, at few steps.
Found stranded(const std::string& method, double steps_per_cycle) {
  const auto run_with = [&](double n) {
    return Run(
        curlew_span(fmt::format("[initial]\nvelocity_mode = 2\nantinode_velocity_m_per_s = 0.6\n[integrator]\n{}"
                                "step_s = {:.17g}\nmax_numerical_share = 1e9\n[analysis]\ntype = \"transient\"\n"
                                "duration_s = 0.9\n",
                                method, 1 / (11.6 * n))));
  };
  const Run run = run_with(steps_per_cycle), ordinary = run_with(200);
  return Found{}
      .most("energy above what came in", run.energy_above_input(), 1e-6)
      .least("friction (J)", run.at("energy.friction_dissipation_J"), 1e-4)
      .costs(evaluations(run, ordinary));
}

Found masing_steps(int steps) {
  const section::MasingLaw law(curlew());
  const double eps = strain_at(0.15), chi = 0.05;
  double exact = 0;
  for (const auto& layer : exact::friction_layers(curlew(), conductor::axial_wire_forces(curlew(), eps, 0))) {
    exact += exact::loss_per_cycle(layer, chi);
  }
  const double first = walk(law, cycles(eps, chi, steps, 1)).lost;
  const Walk two = walk(law, cycles(eps, chi, steps, 2));
  Found found;
  found.close("loss of the second cycle (J/m)", two.lost - first, exact, 1e-12 * std::sqrt(steps));
  add_account(two, found);
  return found.costs(
      {.extreme = static_cast<double>(steps), .ordinary = 200, .unit = "section evaluations of a cycle"});
}

Found multilinear_steps(int steps) {
  const section::MultilinearSection section{
      .EA = 1e7, .GJ = 10, .EI = 30, .springs = {{.stiffness = 500, .yield = 0.01}, {.stiffness = 300, .yield = 0.02}}};
  const section::MultilinearLaw law(section, section::Dimension::planar);
  const double chi = 0.05;
  double exact = 0;
  for (const section::Spring& s : section.springs) exact += 4 * s.stiffness * s.yield * (chi - s.yield);
  const Walk two = walk(law, cycles(1e-4, chi, steps, 2));
  Found found;
  found.close("loss of the second cycle (J/m)", two.lost - walk(law, cycles(1e-4, chi, steps, 1)).lost, exact,
              1e-12 * std::sqrt(steps));
  add_account(two, found);
  return found.costs(
      {.extreme = static_cast<double>(steps), .ordinary = 200, .unit = "section evaluations of a cycle"});
}

Found quadrature() {
  const section::MasingLaw law(curlew());
  const auto error = [&](int steps) {
    return walk(law, cycles(strain_at(0.15), 0.05, steps, 2)).quadrature_error -
           walk(law, cycles(strain_at(0.15), 0.05, steps, 1)).quadrature_error;
  };
  return Found{}
      .within("ratio when the steps double, 200 to 400", error(200) / error(400), 3.6, 4.4)
      .within("ratio when the steps double, 2000 to 4000", error(2000) / error(4000), 3.8, 4.2)
      .costs({.extreme = 4000, .ordinary = 200, .unit = "section evaluations of a cycle"});
}

}  // namespace

std::vector<Extreme> step_rows() {
  const std::string ida = "method = \"ida\"\n";
  std::vector<Extreme> rows;
  for (int n : {5, 20, 200, 5000}) {
    const double periods = n == 5000 ? 10 : 100;
    rows.push_back({fmt::format("steps/trapezoidal-{}", n),
                    fmt::format("{} steps a cycle, trapezoidal rule, an elastic span", n),
                    "energy is kept; the frequency is that of the rule, tan(omega' h/2) = omega h/2",
                    [n, periods] { return trapezoidal(n, periods); }});
    rows.push_back({fmt::format("steps/ida-{}", n), fmt::format("{} steps a cycle, IDA, an elastic span", n),
                    "energy falls and never grows", [n, periods] { return falls(n, periods); }});
  }
  rows.push_back({"steps/ida-third-power", "IDA at 100 and 200 steps a cycle", "it damps by (omega h)^3/4",
                  [] { return third_power(100); }});
  rows.push_back({"steps/ida-order", "IDA at 100 and 200 steps a cycle", "the frequency is too low by (omega h)^2/3",
                  [ida] { return second_order(ida, 1.0 / 3); }});
  rows.push_back({"steps/trapezoidal-order", "the trapezoidal rule at 100 and 200 steps a cycle",
                  "the frequency is too low by (omega h)^2/12", [] { return second_order(conserving, 1.0 / 12); }});
  for (double n : {5.0, 5000.0}) {
    const Pace pace = n > 100 ? Pace::slow : Pace::quick;
    rows.push_back({fmt::format("steps/stranded-trapezoidal-{:g}", n),
                    fmt::format("Curlew let go, {:g} steps a cycle, trapezoidal rule", n),
                    "friction takes energy, and no step has more than came in", [n] { return stranded(conserving, n); },
                    pace});
    rows.push_back({fmt::format("steps/stranded-ida-{:g}", n), fmt::format("Curlew let go, {:g} steps a cycle, IDA", n),
                    "friction takes energy, and no step has more than came in", [ida, n] { return stranded(ida, n); },
                    pace});
  }
  for (int n : {4, 100'000}) {
    rows.push_back({fmt::format("steps/masing-{}", n),
                    fmt::format("a section bent in {} steps a cycle, Masing's rule", n),
                    "loss of a cycle in closed form, at any step", [n] { return masing_steps(n); }});
    rows.push_back({fmt::format("steps/multilinear-{}", n),
                    fmt::format("a section bent in {} steps a cycle, springs", n),
                    "4 k y (chi - y) of every spring, at any step", [n] { return multilinear_steps(n); }});
  }
  rows.push_back({"steps/quadrature", "200 to 4000 steps a cycle",
                  "the quadrature error of friction is of second order", quadrature});
  return rows;
}

}  // namespace strandyn::extremes
