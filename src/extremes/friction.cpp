// Friction from 0 to 100, residual forces from 0 to 1e6 N/m, EI_max/EI_min of 300.
#include <fmt/format.h>

#include <cmath>

#include "point.hpp"
#include "scene.hpp"
#include "strands.hpp"
#include "strandyn/exact/full_slip.hpp"
#include "strandyn/section/compliant.hpp"
#include "strandyn/section/return_map.hpp"
#include "strandyn/section/spatial_return_map.hpp"
#include "themes.hpp"

namespace strandyn::extremes {
namespace {

using conductor::Strand;
using section::CompliantLaw;
using section::PlanarReturnMap;

Strand pressed_by(double residual) {
  Strand strand = curlew();
  for (std::size_t j = 1; j < strand.layers.size(); ++j) strand.layers[j].residual_force = residual;
  return strand;
}

Found without_friction(const section::Law& law) {
  const Path path = cycles(strain_at(0.15), 0.1, 100);
  const Walk w = walk(law, path);
  Point point(law, path.front());
  Found found;
  found.close("EI", point.respond({.eps = strain_at(0.15), .chi2 = 0.1}).EI, curlew_constants().EI_min, 1e-15)
      .most("loss (J/m)", w.lost, 0);
  add_account(w, found);
  return found.costs(cost_of(law, path, law));
}

/// What is left when all slips, and that small curvatures stick.
Found full_slip(const Strand& strand, double tension_rts) {
  const double T = tension_rts * curlew().rated_strength;
  const auto c = section_constants(strand);
  const double eps = T / c.EA;
  const exact::FullSlip exact = exact::full_slip_at_points(strand, T, 36);
  const PlanarReturnMap law(strand, 36);
  // The cell next to 90 degrees has cos(theta) = 0.044 and slips last; wires that press harder where they are pulled
  // slip later still.
  const double chi = 1000 * exact.chi_0;
  Point point(law, {.eps = eps});
  const double moment = point.respond({.eps = eps, .chi2 = chi}).M2 - c.EI_min * chi;
  const Walk w = walk(law, cycles(eps, 3 * exact.chi_0, 200, 2));
  Found found;
  found.close("full-slip moment (N m)", moment, exact.M_inf, 1e-9)
      .close("EI at rest", point.respond({.eps = eps, .chi2 = 1e-6 * exact.chi_0}).EI, c.EI_max, 1e-12)
      .least("loss (J/m)", w.lost, 0);
  add_account(w, found);
  return found.costs(cost_of(law, cycles(eps, 3 * exact.chi_0, 200, 2), PlanarReturnMap(curlew(), 36)));
}

/// Friction that no limit can be reached with: EI_max, no loss, while all contacts press.
Found without_bound(const Strand& strand, double chi) {
  const PlanarReturnMap law(strand, 36);
  const Path path = cycles(strain_at(0.15), chi, 100);
  const Walk w = walk(law, path);
  Point point(law, path.front());
  Found found;
  found
      .close("moment (N m)", point.respond({.eps = strain_at(0.15), .chi2 = chi}).M2, curlew_constants().EI_max * chi,
             1e-12)
      .most("loss over EI_max chi^2", w.lost / (curlew_constants().EI_max * chi * chi), 1e-12);
  add_account(w, found);
  return found.costs(cost_of(law, path, PlanarReturnMap(curlew(), 36)));
}

/// Limits and the slips that reach them go with friction, the stiffness of a contact does not: mu^-2 D(mu chi) is the
/// same for all mu, while bending does not yet change what presses. At 1e-3 1/m it does by 4 % on either side of the
/// neutral plane, up here and down there: 0.2 % of the loss.
Found micro_slip(double mu) {
  const double eps = strain_at(0.15), chi = 1e-5;
  const CompliantLaw one(curlew_with(1)), other(curlew_with(mu));
  const auto loss = [&](const section::Law& law, double amplitude) {
    return walk(law, cycles(eps, amplitude, 100, 2)).lost - walk(law, cycles(eps, amplitude, 100, 1)).lost;
  };
  return Found{}
      .close("loss over mu^2, at mu times the curvature", loss(other, mu * chi) / (mu * mu), loss(one, chi), 1e-2)
      .costs(cost_of(other, cycles(eps, mu * chi, 100), CompliantLaw(curlew())));
}

Found compliant_account(const Strand& strand, double chi) {
  const CompliantLaw law(strand);
  const Path path = cycles(strain_at(0.15), chi, 200, 2);
  Found found;
  add_account(walk(law, path), found);
  Point point(law, path.front());
  return found
      .within("EI at rest over EI_max", point.respond({.eps = strain_at(0.15)}).EI / section_constants(strand).EI_max,
              0.5, 1)
      .costs(cost_of(law, path, CompliantLaw(curlew())));
}

Found thin_wires() {
  const Strand strand = many_thin_wires();
  const auto c = section_constants(strand);
  Found found = full_slip(strand, 0.15);
  return found.least("EI_max over EI_min", c.EI_max / c.EI_min, 300);
}

/// A span whose bending stiffness falls to a three hundredth where it slips.
Found thin_wires_vibrate() {
  const auto text = [](double EI, double velocity) {
    return fmt::format(
        "[section]\nlaw = \"multilinear\"\nEA_N = 1e7\nEI_N_m2 = {}\nmass_kg_per_m = 1\n[[section.spring]]\n"
        "stiffness_N_m2 = {}\nyield_per_m = 0.002\n[span]\nlength_m = 10\ntension_kN = 4\nelements = 60\nmass = "
        "\"consistent\"\n"
        "condense_axial = true\n[initial]\nvelocity_mode = 3\nantinode_velocity_m_per_s = {}\n[integrator]\n{}step_s = "
        "2e-4\n"
        "max_numerical_share = 1\n[analysis]\ntype = \"transient\"\nduration_s = 0.6\n",
        EI, 300 - EI, velocity, conserving);
  };
  const Run run(text(1, 1)), ordinary(text(100, 1));
  return Found{}
      .most("energy above what came in", run.energy_above_input(), 1e-6)
      .least("friction over the energy at the start",
             run.at("energy.friction_dissipation_J") / run.at("energy.initial_kinetic_J"), 1e-3)
      .most("numerical share", run.at("energy.numerical_share"), 0.05)
      .costs(evaluations_per_step(run, ordinary));
}

}  // namespace

std::vector<Extreme> friction_rows() {
  const std::string account = "; stored plus lost is the work of every step, no step gives energy";
  std::vector<Extreme> rows = {
      {"friction/0-return-map", "mu = 0", "EI_min and no loss",
       [] { return without_friction(PlanarReturnMap(curlew_with(0), 36)); }},
      {"friction/0-compliant", "mu = 0, contacts that give", "EI_min and no loss",
       [] { return without_friction(CompliantLaw(curlew_with(0))); }},
      {"friction/0-biaxial", "mu = 0, about both axes", "EI_min and no loss",
       [] { return without_friction(section::SpatialReturnMap(curlew_with(0), {})); }},
      {"friction/100-return-map", "mu = 100, 0.02 1/m", "no limit is reached while all contacts press: EI_max, no loss",
       [] { return without_bound(curlew_with(100), 0.02); }},
      {"friction/100-micro-slip", "mu = 100, contacts that give", "loss mu^2 f(chi/mu), as at mu = 1",
       [] { return micro_slip(100); }},
      {"friction/0.001-micro-slip", "mu = 0.001, contacts that give", "loss mu^2 f(chi/mu), as at mu = 1",
       [] { return micro_slip(1e-3); }},
      {"friction/100-compliant", "mu = 100, contacts that give, 0.3 1/m", "elastic, below EI_max" + account,
       [] { return compliant_account(curlew_with(100), 0.3); }},
      {"residual/1e6-stick", "residual forces of 1e6 N/m, 1 1/m", "sticks: EI_max, no loss",
       [] { return without_bound(pressed_by(1e6), 1); }},
      {"residual/1e6-compliant", "residual forces of 1e6 N/m, contacts that give, 10 1/m",
       "elastic, below EI_max" + account, [] { return compliant_account(pressed_by(1e6), 10); }},
      {"stiffness/300", "EI_max/EI_min of 300: thin wires around a soft core",
       "closed form of full slip; sticking, EI_max" + account, thin_wires},
      {"stiffness/300-span", "a span with EI_max/EI_min of 300", "friction takes energy, no step has more than came in",
       thin_wires_vibrate, Pace::slow},
  };
  for (double mu : {1e-6, 0.01, 3.0, 10.0}) {
    rows.push_back({fmt::format("friction/{:g}-full-slip", mu), fmt::format("mu = {:g}, all slips", mu),
                    "closed form of full slip; sticking, EI_max" + account,
                    [mu] { return full_slip(curlew_with(mu), 0.15); }});
  }
  for (double R : {0.0, 1.0, 1e3, 1e6}) {
    rows.push_back({fmt::format("residual/{:g}-full-slip", R), fmt::format("residual forces of {:g} N/m", R),
                    "closed form of full slip; sticking, EI_max" + account,
                    [R] { return full_slip(pressed_by(R), 0.15); }});
  }
  return rows;
}

}  // namespace strandyn::extremes
