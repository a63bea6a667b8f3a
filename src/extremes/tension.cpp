// From slack to the rated strength, and through all of it in one cycle.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "point.hpp"
#include "scene.hpp"
#include "strands.hpp"
#include "strandyn/exact/elastic_catenary.hpp"
#include "strandyn/exact/full_slip.hpp"
#include "strandyn/exact/tensioned_beam.hpp"
#include "strandyn/section/compliant.hpp"
#include "strandyn/section/return_map.hpp"
#include "strandyn/section/spatial_compliant.hpp"
#include "strandyn/section/spatial_return_map.hpp"
#include "themes.hpp"

namespace strandyn::extremes {
namespace {

using section::CompliantLaw;
using section::PlanarReturnMap;

Found slack() {
  const conductor::Strand bare = curlew_with(0.7, 0);
  const PlanarReturnMap law(bare, 36);
  const double EI_min = section_constants(bare).EI_min;
  const Walk w = walk(law, cycles(0, 0.1, 100));
  Point point(law, {});
  Found found;
  found.close("EI", point.respond({.chi2 = 0.1}).EI, EI_min, 1e-14).most("loss (J/m)", w.lost, 0);
  add_account(w, found);
  return found.costs(cost_of(law, cycles(0, 0.1, 100), PlanarReturnMap(curlew(), 36)));
}

Found slack_but_pressed() {
  const PlanarReturnMap law(curlew(), 36);
  Point point(law, {});
  const Walk w = walk(law, cycles(0, 0.1, 100, 2));
  Found found;
  found.close("EI", point.respond({.chi2 = 1e-6}).EI, curlew_constants().EI_max, 1e-13)
      .least("loss over EI_max chi^2", w.lost / (curlew_constants().EI_max * 0.01), 1e-3);
  add_account(w, found);
  return found.costs(cost_of(law, cycles(0, 0.1, 100, 2), law));
}

/// Without residual forces all that presses is the tension: the loss of a cycle goes with its square at equal
/// chi/chi_0.
Found nearly_slack() {
  const conductor::Strand bare = curlew_with(0.7, 0);
  const PlanarReturnMap law(bare, 36);
  const double factor = 1e-9, chi = 0.05;
  const Walk ordinary = walk(law, cycles(strain_at(0.15), chi, 200, 2));
  const Walk faint = walk(law, cycles(factor * strain_at(0.15), factor * chi, 200, 2));
  // Where tension is left it alone decides: all forces scale, so do the curvatures at which they are reached.
  return Found{}
      .close("loss over that at 1e9 times the tension and curvature", faint.lost / ordinary.lost, factor * factor, 1e-9)
      .costs(cost_of(law, cycles(factor * strain_at(0.15), factor * chi, 200, 2), law));
}

Found rated_strength() {
  const PlanarReturnMap law(curlew(), 36);
  const double T = curlew().rated_strength, eps = strain_at(1), chi = 1000;
  Point point(law, {.eps = eps});
  const double moment = point.respond({.eps = eps, .chi2 = chi}).M2 - curlew_constants().EI_min * chi;
  return Found{}
      .close("full-slip moment", moment, exact::full_slip_at_points(curlew(), T, 36).M_inf, 1e-9)
      .close("full-slip moment (closed form)", moment, exact::full_slip(curlew(), T).M_inf, 2.5e-3)
      .close("EI at rest", point.respond({.eps = eps}).EI, curlew_constants().EI_max, 1e-13)
      .costs(cost_of(law, cycles(eps, 0.1, 100), law));
}

Found opened_by_compression() {
  const PlanarReturnMap law(curlew(), 36);
  const double eps = strain_at(0.15), chi = 0.03;
  Point point(law, {.eps = eps});
  const double stored = point.commit({.eps = eps, .chi2 = chi}).stored;
  const double linear = (curlew_constants().EA * eps * eps + curlew_constants().EI_min * chi * chi) / 2;
  const Answer open = point.commit({.eps = -5e-3, .chi2 = chi});
  return Found{}
      .close("moment", open.M2, curlew_constants().EI_min * chi, 1e-14)
      .close("loss less its quadrature error (J/m)", open.dissipated - open.quadrature_error, stored - linear, 1e-12)
      .costs(cost_of(law, {{.eps = eps}, {.eps = eps, .chi2 = chi}, {.eps = -5e-3, .chi2 = chi}}, law));
}

/// 0 to 60 % of the rated strength and back while the section bends to and fro once; space: about both axes, and
/// twists.
Path tension_cycles(int count, int steps) {
  Path path = {{.eps = 0}};
  for (int i = 1; i <= count * steps; ++i) {
    const double phase = 2 * std::numbers::pi * i / steps;
    path.push_back({.eps = strain_at(0.3) * (1 - std::cos(phase)),
                    .chi2 = 0.05 * std::sin(phase),
                    .chi3 = 0.03 * std::sin(2 * phase),
                    .chi1 = 0.02 * std::sin(phase)});
  }
  return path;
}

Found cycled(const section::Law& law, const section::Law& ordinary) {
  const Walk w = walk(law, tension_cycles(12, 60));
  // A path of the same states: after some turns the state repeats, so the work of a turn is what it loses.
  Point point(law, {});
  const Path one = tension_cycles(1, 60);
  Answer a, before;
  double lost = 0, work = 0, error = 0, stored = 0;
  for (int turn = 0; turn < 12; ++turn) {
    lost = work = error = 0;
    stored = a.stored;
    for (std::size_t i = 1; i < one.size(); ++i) {
      before = a;
      a = point.commit(one[i]);
      lost += a.dissipated;
      error += a.quadrature_error;
      work += (before.N + a.N) / 2 * (one[i].eps - one[i - 1].eps) +
              (before.M1 + a.M1) / 2 * (one[i].chi1 - one[i - 1].chi1) +
              (before.M2 + a.M2) / 2 * (one[i].chi2 - one[i - 1].chi2) +
              (before.M3 + a.M3) / 2 * (one[i].chi3 - one[i - 1].chi3);
    }
  }
  Found found;
  add_account(w, found);
  // The axial energy that comes and goes is ten thousand times as large as the loss, and known to its last places.
  return found
      .close("work of the twelfth turn, with its quadrature error, against its loss (J/m)", work + error, lost, 1e-9)
      .most("stored in the twelfth turn over its loss", std::abs(a.stored - stored) / lost, 1e-9)
      .least("loss of the twelfth turn (J/m)", lost, 1e-3)
      .costs(cost_of(law, tension_cycles(12, 60), ordinary));
}

Found sagging() {
  // The unstressed cable is longer than the chord by a half: no tension but what its weight gives.
  const Run slack(
      "[section]\nlaw = \"elastic\"\nEA_N = 1e7\nEI_N_m2 = 1e-3\nmass_kg_per_m = 1\n[span]\nlength_m = 20\n"
      "unstressed_length_m = 30\nelements = 80\ngrading = \"uniform\"\nleft = \"pinned\"\nright = \"pinned\"\n"
      "gravity = true\n[analysis]\ntype = \"modes\"\ncount = 1\n");
  const Run taut(
      "[section]\nlaw = \"elastic\"\nEA_N = 1e7\nEI_N_m2 = 1e-3\nmass_kg_per_m = 1\n[span]\nlength_m = 20\n"
      "unstressed_length_m = 20\nelements = 80\ngrading = \"uniform\"\nleft = \"pinned\"\nright = \"pinned\"\n"
      "gravity = true\n[analysis]\ntype = \"modes\"\ncount = 1\n");
  const auto cable = exact::ElasticCatenary::from_unstressed_length(
      {.span = 20, .height_difference = 0, .weight_per_length = 9.80665}, 1e7, 30);
  // Straight elements of s = 0.375 m below a curvature of w/H: the sag misses (s^2/8) w/H at most.
  const double missed = 0.375 * 0.375 / 8 * 9.80665 / cable.horizontal_tension();
  return Found{}
      .close("sag (m)", slack.at("rest.sag_m"), cable.sag(), 2 * missed / cable.sag())
      .close("horizontal tension (N)", slack.at("rest.horizontal_tension_N"), cable.horizontal_tension(), 5e-3)
      .costs(evaluations(slack, taut));
}

Found frequency_at(double tension_rts) {
  const auto text = [](double part) {
    return "[conductor]\ncatalogue = \"curlew\"\n[section]\nlaw = \"stick\"\n[span]\nlength_m = 10\ntension_rts = " +
           std::to_string(part) +
           "\nelements = 80\ngrading = \"uniform\"\nmass = \"consistent\"\nrotary_inertia = false\n[analysis]\n"
           "type = \"modes\"\ncount = 5\n";
  };
  const Run run(text(tension_rts)), ordinary(text(0.15));
  // Mass and curvature are counted per unstressed length; the span is stretched by this.
  const double T = tension_rts * curlew().rated_strength, stretch = 1 + T / curlew_constants().EA;
  const exact::TensionedBeam beam{.tension = T,
                                  .EI = curlew_constants().EI_max * stretch,
                                  .mass_per_length = curlew().mass_per_length / stretch,
                                  .length = 10};
  Found found;
  for (int n : {1, 5}) {
    const exact::TensionedBeamMode mode(beam, exact::BeamEnds::clamped, n);
    const double exact = mode.frequency();
    // Hermite's cubic misses exp(i k x) by (k h)^4/720 of its energy, and what decays from a clamp by (l h)^4/720; the
    // clamps have 2/xi of the frequency.
    const double h = 10.0 / 80, decay = std::sqrt(T / beam.EI), xi = std::max(10 * decay, 2.0);
    const double accuracy = (std::pow(mode.wavenumber() * h, 4) + 2 / xi * std::pow(decay * h, 4)) / 720;
    found.close("frequency (Hz)", run.at("frequencies_Hz[" + std::to_string(n - 1) + "]"), exact, accuracy);
  }
  return found.costs(evaluations(run, ordinary));
}

}  // namespace

std::vector<Extreme> tension_rows() {
  const std::string one_cycle = "0 to 60 % of the rated strength and back within one cycle of bending, twelve cycles";
  const std::string account =
      "stored plus lost is the work of every step; no step gives energy; a turn that repeats does as much work as it "
      "loses";
  return {
      {"tension/slack", "no tension and no residual forces, 0.1 1/m", "nothing presses: EI_min, no loss", slack},
      {"tension/slack-pressed", "no tension, the residual forces of stranding",
       "it sticks with EI_max, and loses energy", slack_but_pressed},
      {"tension/nearly-slack", "a tension of 1.5e-10 of the rated strength, no residual forces",
       "all scales with the tension: the loss with its square", nearly_slack},
      {"tension/rated-strength", "the rated strength itself", "full-slip moment of the closed form; sticking, EI_max",
       rated_strength},
      {"tension/opened", "a bent strand pushed together until every contact opens",
       "EI_min is left; all that friction had stored is lost", opened_by_compression},
      {"tension/cycled-return-map", one_cycle, account,
       [] { return cycled(PlanarReturnMap(curlew(), 36), PlanarReturnMap(curlew(), 36)); }},
      {"tension/cycled-compliant", one_cycle, account,
       [] { return cycled(CompliantLaw(curlew()), CompliantLaw(curlew())); }},
      {"tension/cycled-biaxial-return-map", one_cycle + ", about both axes and with twist", account,
       [] {
         const section::SpatialReturnMap law(curlew(), {});
         return cycled(law, law);
       }},
      {"tension/cycled-spatial-compliant", one_cycle + ", about both axes and with twist", account,
       [] {
         const section::SpatialCompliantLaw law(curlew(), {.springs = section::springs_in_space});
         return cycled(law, law);
       }},
      {"tension/sagging-span", "a cable half as long again as its chord, EI 1e-3 N m^2", "the elastic catenary",
       sagging},
      {"tension/zero-span", "a clamped span without tension", "frequencies of the clamped beam",
       [] { return frequency_at(0); }},
      {"tension/rated-span", "a clamped span at its rated strength", "frequencies of the clamped beam under tension",
       [] { return frequency_at(1); }},
  };
}

}  // namespace strandyn::extremes
