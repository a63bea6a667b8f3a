// From 1e-15 to ten diameters: curvatures of a section, amplitudes of a span.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "point.hpp"
#include "scene.hpp"
#include "strands.hpp"
#include "strandyn/conductor/contact.hpp"
#include "strandyn/exact/friction_layer.hpp"
#include "strandyn/section/compliant.hpp"
#include "strandyn/section/masing.hpp"
#include "strandyn/section/return_map.hpp"
#include "themes.hpp"

namespace strandyn::extremes {
namespace {

using std::numbers::pi;

/// A cycle of curvature `chi` sticks: EI_max to the last digits, and no loss.
Found sticks(double chi) {
  const section::PlanarReturnMap law(curlew(), 36);
  const double eps = strain_at(0.15);
  const Walk w = walk(law, cycles(eps, chi, 100));
  Point point(law, {.eps = eps});
  return Found{}
      .close("moment (N m)", point.commit({.eps = eps, .chi2 = chi}).M2, curlew_constants().EI_max * chi, 1e-13)
      .most("loss (J/m)", w.lost, 0)
      .costs(cost_of(law, cycles(eps, chi, 100), law));
}

/// Contacts that give: the loss of a small cycle goes with the cube of its amplitude.
Found cubic(double chi) {
  const section::CompliantLaw law(curlew());
  const double eps = strain_at(0.15), decade = 10;
  const auto loss = [&](double amplitude) {
    return walk(law, cycles(eps, amplitude, 100, 2)).lost - walk(law, cycles(eps, amplitude, 100, 1)).lost;
  };
  return Found{}
      .within("exponent of the amplitude over a decade", std::log10(loss(decade * chi) / loss(chi)), 2.95, 3.05)
      .costs(cost_of(law, cycles(eps, chi, 100), law));
}

Found beyond_smallest_spring() {
  const section::CompliantLaw law(curlew());
  const double eps = strain_at(0.15), chi = 1e-15;
  const Walk w = walk(law, cycles(eps, chi, 100));
  Point point(law, {.eps = eps});
  const double EI = point.respond({.eps = eps}).EI;
  return Found{}
      .close("moment (N m)", point.commit({.eps = eps, .chi2 = chi}).M2, EI * chi, 1e-12)
      .most("loss over EI_max chi^2", w.lost / (curlew_constants().EI_max * chi * chi), 1e-6)
      .least("EI_max over EI", curlew_constants().EI_max / EI, 1)
      .least("EI over EI_min", EI / curlew_constants().EI_min, 1)
      .costs(cost_of(law, cycles(eps, chi, 100), law));
}

/// Frozen limits: the loss of a cycle in closed form, `part` of a layer's first slip to far beyond.
Found masing(double part) {
  const section::MasingLaw law(curlew());
  const double eps = strain_at(0.15);
  const auto layers = exact::friction_layers(curlew(), conductor::axial_wire_forces(curlew(), eps, 0));
  double first = 1e9;
  for (const exact::FrictionLayer& layer : layers) first = std::min(first, layer.chi_cr);
  const double chi = part * first;
  double exact = 0;
  for (const exact::FrictionLayer& layer : layers) exact += exact::loss_per_cycle(layer, chi);
  Point point(law, {.eps = eps});
  point.commit({.eps = eps, .chi2 = chi});
  double lost = point.commit({.eps = eps, .chi2 = -chi}).dissipated;
  lost += point.commit({.eps = eps, .chi2 = chi}).dissipated;
  // Just beyond first slip the closed form is a small difference of its terms: x^2 - 1 has lost these digits.
  const double known = 1e-12 + 1e-15 / std::pow(std::max(part - 1, 1e-9), 1.5);
  return Found{}.close("loss (J/m)", lost, exact, known).costs(cost_of(law, cycles(eps, chi, 100), law));
}

Found all_slips(double chi) {
  const section::PlanarReturnMap law(curlew(), 36);
  const double eps = strain_at(0.15);
  Point point(law, {.eps = eps});
  const Answer a = point.respond({.eps = eps, .chi2 = chi});
  const Walk w =
      walk(law, {{.eps = eps}, {.eps = eps, .chi2 = chi}, {.eps = eps, .chi2 = -chi}, {.eps = eps, .chi2 = chi}});
  Found found;
  found.close("EI", a.EI, curlew_constants().EI_min, 1e-15);
  add_account(w, found);
  return found.costs(cost_of(law, cycles(eps, chi, 100), law));
}

/// The pinned span of one tension for all elements swings as Kirchhoff's string: its mode's coordinate obeys
/// x'' + w0^2 x + b x^3 = 0, b/w0^2 = (EA/T)(n pi/2 L)^2 (T the stiffness that resists, EI (n pi/L)^2 included), with
/// the period 4 K(k)/sqrt(w0^2 + b A^2), k^2 = b A^2/(2 (w0^2 + b A^2)).
struct Kirchhoff {
  double w0 = 0, b = 0;  ///< [rad/s], [1/(m s)^2]
  double frequency(double A) const {
    const double s = w0 * w0 + b * A * A;
    return std::sqrt(s) / (4 * std::comp_ellint_1(std::sqrt(b * A * A / (2 * s))));
  }
  /// [m/s] with which the swing of amplitude A passes the middle.
  double velocity(double A) const { return A * std::sqrt(w0 * w0 + b * A * A / 2); }
};

double late_kinetic(const Run& run) {
  const auto& kinetic = run.table("energies.csv").column("kinetic_J");
  return *std::max_element(kinetic.end() - 800, kinetic.end()) / kinetic.front();
}

/// With the axial unknowns, or with one tension for all elements.
Found swing(double amplitude, bool condensed) {
  // elastic_span: T = 4000 N, EI = 10 N m^2, EA = 1e7 N, L = 10 m; masses per length between the supports, stretched.
  const double k = pi / 10, stretched = 1 + 4000 / 1e7;
  const Kirchhoff string{.w0 = k * std::sqrt((4000 + 10 * k * k) * stretched),
                         .b = stretched * stretched * 1e7 * std::pow(k, 4) / 4};
  const auto text = [&](double A) {
    const double f = string.frequency(A);
    return elastic_span(
        fmt::format("[initial]\nvelocity_mode = 1\nantinode_velocity_m_per_s = {:.17g}\n[integrator]\n{}"
                    "step_s = {:.17g}\n[analysis]\ntype = \"transient\"\nduration_s = {:.17g}\n"
                    "probes_m = [5]\n",
                    string.velocity(A), conserving, 1 / (400 * f), 20.5 / f));
  };
  const std::vector<std::string> how = {condensed ? "span.condense_axial=true" : "span.condense_axial=false"};
  const Run run(text(amplitude), how), ordinary(text(0.01), how);
  // 400 steps a cycle lower the frequency by (omega h)^2/12 = 2.1e-5 of itself, and the period is read between steps.
  // The string counts its length to the square of the slope; the next term is the slope's square over four of that.
  const double accuracy = 5e-5 + std::pow(k * amplitude, 2) / 4;
  return Found{}
      .close("frequency (Hz)", run.at("probes[0].frequency_Hz"), string.frequency(amplitude), accuracy)
      .close("amplitude (m)", run.at("probes[0].displacement_m.max[1]"), amplitude, 2e-3)
      .close("greatest kinetic energy of the last two cycles over that at the start", late_kinetic(run), 1, 2e-4)
      .costs(evaluations_per_step(run, ordinary));
}

/// What the trapezoidal rule keeps must stand in the ledger at every step, kinetic and elastic energy together.
Found ledger(double amplitude) {
  const double k = pi / 10, omega = k * std::sqrt((4000 + 10 * k * k) * (1 + 4000 / 1e7));
  const auto text = [&](double A) {
    return elastic_span(
        fmt::format("[initial]\nvelocity_mode = 1\nantinode_velocity_m_per_s = {:.17g}\n[integrator]\n{}"
                    "step_s = 1e-3\nmax_numerical_share = 1e9\n[analysis]\ntype = \"transient\"\nduration_s = 3\n",
                    omega * A, conserving));
  };
  const std::vector<std::string> how = {"span.condense_axial=false"};
  const Run run(text(amplitude), how), ordinary(text(1e-3), how);
  // What the tension has stored, T^2 L/(2 EA), has 16 digits; the swing, m L omega^2 A^2/4, has what is left of them.
  const double stored = 4000.0 * 4000 * 10 / 2e7, swinging = 10.0 / 4 * std::pow(omega * amplitude, 2);
  const double digits = std::numeric_limits<double>::epsilon() * stored / swinging;
  return Found{}
      .most("kinetic and elastic energy, kept but for", run.energy_drift(), 1e-3 + digits)
      .costs(evaluations_per_step(run, ordinary));
}

/// A stranded span that starts with ten diameters: nobody gives energy to it.
Found ten_diameters() {
  const auto text = [](double amplitude) {
    return curlew_span(
        fmt::format("condense_axial = true\n[integrator]\n{}steps_per_cycle = 400\nmax_numerical_share = 1\n"
                    "[analysis]\ntype = \"decay\"\nmode = 2\nantinode_amplitude_mm = {}\ncycles = 10\n",
                    conserving, amplitude));
  };
  const double diameter = 1e3 * curlew().outer_diameter();
  const Run run(text(10 * diameter)), ordinary(text(0.1 * diameter));
  const double start = run.at("cycles[0].kinetic_J") + run.at("cycles[0].elastic_J") +
                       run.at("cycles[0].friction_dissipation_J") + run.at("cycles[0].numerical_dissipation_J");
  double worst = 0, before = start;
  for (int i = 0; i < 10; ++i) {
    const std::string cycle = fmt::format("cycles[{}].", i);
    const double energy = run.at(cycle + "kinetic_J") + run.at(cycle + "elastic_J");
    worst = std::max(worst, (energy - before) / start);
    before = energy;
  }
  return Found{}
      .most("largest growth of energy in a cycle, of that at the start", worst, 0)
      .least("friction of the first cycle (J)", run.at("cycles[0].friction_dissipation_J"), 1e-3)
      .most("numerical share", run.at("steady.numerical_share"), 0.05)
      .costs(evaluations_per_step(run, ordinary));
}

}  // namespace

std::vector<Extreme> amplitude_rows() {
  const std::string stuck = "nothing slips: M = EI_max chi to 13 digits, no loss";
  const std::string kirchhoff =
      "frequency of Kirchhoff's string (elliptic integral); it passes the middle as fast as at the start";
  std::vector<Extreme> rows;
  for (double chi : {1e-15, 1e-12, 1e-6}) {
    rows.push_back({fmt::format("amplitude/curvature-{:g}", chi), fmt::format("a curvature of {:g} 1/m", chi), stuck,
                    [chi] { return sticks(chi); }});
  }
  rows.push_back({"amplitude/compliant-1e-15", "a curvature of 1e-15 1/m, contacts that give",
                  "elastic between EI_min and EI_max, no loss that counts", beyond_smallest_spring});
  for (double chi : {1e-5, 1e-4}) {
    rows.push_back({fmt::format("amplitude/cubic-{:g}", chi),
                    fmt::format("curvatures of {:g} and {:g} 1/m", chi, 10 * chi),
                    "contacts that give lose with the cube of a small amplitude", [chi] { return cubic(chi); }});
  }
  for (double part : {1.000001, 1.5, 1e3, 1e6}) {
    rows.push_back({fmt::format("amplitude/masing-{:.7g}", part),
                    fmt::format("{:.7g} times the curvature of first slip", part),
                    "loss of a cycle in closed form, every layer", [part] { return masing(part); }});
  }
  rows.push_back({"amplitude/bent-double", "a curvature of 1000 1/m, a circle thinner than a wire",
                  "all slips: EI_min; stored plus lost is the work", [] { return all_slips(1000); }});
  for (double amplitude : {1e-15, 1e-12, 1e-9, 1e-3, 0.3}) {
    rows.push_back({fmt::format("amplitude/span-{:g}", amplitude),
                    fmt::format("a span that swings by {:g} m", amplitude), kirchhoff,
                    [amplitude] { return swing(amplitude, true); }});
  }
  for (double amplitude : {1e-15, 1e-12, 1e-9}) {
    rows.push_back({fmt::format("amplitude/stretching-span-{:g}", amplitude),
                    fmt::format("the same by {:g} m, free to move along its line", amplitude), kirchhoff,
                    [amplitude] { return swing(amplitude, false); }});
  }
  rows.push_back({"amplitude/ten-diameters", "Curlew let go at ten diameters in its mode 2",
                  "no cycle ends with more energy than it began; the integrator takes less than 5 % of the losses",
                  ten_diameters, Pace::slow});
  for (double amplitude : {1e-4, 1e-6, 1e-8}) {
    rows.push_back({fmt::format("amplitude/ledger-{:g}", amplitude),
                    fmt::format("the energies that are told of a span that swings by {:g} m", amplitude),
                    "the trapezoidal rule keeps the energy of what is linear: kinetic and elastic sum up at every step",
                    [amplitude] { return ledger(amplitude); }});
  }
  return rows;
}

}  // namespace strandyn::extremes
