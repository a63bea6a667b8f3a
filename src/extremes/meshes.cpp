// One element to twenty thousand, 1 mm beside 10 m.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "scene.hpp"
#include "themes.hpp"

namespace strandyn::extremes {
namespace {

using std::numbers::pi;

Cost seconds(const Run& extreme, const Run& ordinary) {
  return {.extreme = extreme.result().cost.cpu_s, .ordinary = ordinary.result().cost.cpu_s, .unit = "CPU seconds"};
}

/// The elastic span with EA = 1e10 N: hardly stretched, so that small strains are small. EI 1e4 N m^2 is a beam, whose
/// elements are shorter than what decays from a kink; 10 N m^2 is nearly a string.
constexpr double beam_like = 1e4, string_like = 10;
double frequency_of(int n, int elements, double EI, const std::string& mass = "consistent") {
  return Run(elastic_span(fmt::format("[analysis]\ntype = \"modes\"\ncount = {}\n", n)),
             {fmt::format("span.elements={}", elements), "span.mass=" + mass, "section.EA_N=1e10",
              fmt::format("section.EI_N_m2={}", EI)})
      .at(fmt::format("frequencies_Hz[{}]", n - 1));
}
/// [Hz] of its mode n; mass and curvature are counted per unstressed length.
double exact_frequency(int n, double EI) {
  const double k = n * pi / 10, stretch = 1 + 4000 / 1e10;
  return k * std::sqrt((4000 + EI * stretch * k * k) * stretch) / (2 * pi);
}

/// A cantilever of unit stiffness and length: a small force P bends it by P/3.
Found one_element() {
  const auto text = [](int elements) {
    return fmt::format(
        "[section]\nlaw = \"elastic\"\nEA_N = 1e8\nEI_N_m2 = 1\n[span]\nlength_m = 1\ntension_kN = 0\nelements = {}\n"
        "left = \"clamped\"\nright = \"free\"\n[[load]]\ntype = \"static-force\"\nat_m = 1\nforce_N = 1e-4\n"
        "[analysis]\ntype = \"static\"\nsteps = 1\n",
        elements);
  };
  const Run run(text(1)), ordinary(text(40));
  return Found{}
      .close("deflection (m)", run.at("steps[-1].displacement_m"), 1e-4 / 3, 1e-8)
      .costs(seconds(run, ordinary));
}

/// The beam's first mode under tension with so few elements: from above, near enough by Rayleigh's quotient.
Found few_elements() {
  const auto f = [](int elements, double EI) { return frequency_of(1, elements, EI) / exact_frequency(1, EI); };
  // One element swings as a parabola: 10 in the place of pi^2 for the tension, 12 in that of pi^4/8 for the bending.
  return Found{}
      .within("frequency with one element over the exact one", f(1, string_like), 1, 1.007)
      .within("error ratio, 4 to 8 elements", (f(4, beam_like) - 1) / (f(8, beam_like) - 1), 14, 18)
      .costs({.extreme = 1, .ordinary = 20, .unit = "section points of an evaluation"});
}

/// Three legs in line, 10 m, 1 mm and 10 m, one element each or a few: a cantilever under a force at its end.
Found millimetre_beside_ten_metres(int elements) {
  const auto text = [](const std::string& nodes, int n) {
    return fmt::format(
        "[section]\nlaw = \"elastic\"\nEA_N = 1e9\nEI_N_m2 = 1e4\n[span]\nnodes_m = {}\nelements = {}\ngrading = "
        "\"uniform\"\n"
        "left = \"clamped\"\nright = \"free\"\n[[load]]\ntype = \"static-force\"\nat_m = 20.001\nforce_N = 1e-3\n"
        "[analysis]\ntype = \"static\"\nsteps = 1\n",
        nodes, n);
  };
  const Run run(text("[[0, 0, 0], [10, 0, 0], [10.001, 0, 0], [20.001, 0, 0]]", elements));
  const Run ordinary(text("[[0, 0, 0], [20.001, 0, 0]]", elements));
  // Stiffnesses EI/l^3 differ by 1e12; what is left of 16 digits after that is four.
  return Found{}
      .close("deflection (m)", run.at("steps[-1].displacement_m"), 1e-3 * std::pow(20.001, 3) / (3e4), 1e-4)
      .costs(seconds(run, ordinary));
}

Found millimetre_modes() {
  const auto text = [](const std::string& nodes) {
    return "[section]\nlaw = \"elastic\"\nEA_N = 1e9\nEI_N_m2 = 1e4\nmass_kg_per_m = 1\n[span]\nnodes_m = " + nodes +
           "\nelements = 41\ngrading = \"uniform\"\nleft = \"pinned\"\nright = \"pinned\"\nmass = "
           "\"consistent\"\nrotary_inertia = false\n"
           "[analysis]\ntype = \"modes\"\ncount = 3\n";
  };
  const Run run(text("[[0, 0, 0], [10, 0, 0], [10.001, 0, 0], [20.001, 0, 0]]")),
      ordinary(text("[[0, 0, 0], [20.001, 0, 0]]"));
  Found found;
  for (int n : {1, 2, 3}) {
    found.close("frequency (Hz)", run.at(fmt::format("frequencies_Hz[{}]", n - 1)),
                std::pow(n * pi / 20.001, 2) * 100 / (2 * pi), 1e-4);
  }
  return found.costs(seconds(run, ordinary));
}

/// A force in the middle of a pinned beam under tension: w = F/(2 T) [L/2 - tanh(l L/2)/l], l = sqrt(T/EI).
Found twenty_thousand_static() {
  const auto text = [](int elements) {
    return fmt::format(
        "[section]\nlaw = \"elastic\"\nEA_N = 1e7\nEI_N_m2 = 10\nmass_kg_per_m = 1\n[span]\nlength_m = 100\ntension_kN "
        "= 4\n"
        "elements = {}\ngrading = \"uniform\"\nleft = \"pinned\"\nright = \"pinned\"\n[[load]]\ntype = "
        "\"static-force\"\nat_m = 50\n"
        "force_N = 0.01\n[analysis]\ntype = \"static\"\nsteps = 1\n",
        elements);
  };
  const Run run(text(20'000)), ordinary(text(200));
  // Stiffest over softest: EI (pi/h)^4 over T (pi/L)^2, 4e11, of which 16 digits leave 1e-4.
  const double l = std::sqrt(4000 / (10 * (1 + 4000 / 1e7)));
  return Found{}
      .close("deflection (m)", run.at("steps[-1].displacement_m"), 0.01 / 8000 * (50 - std::tanh(50 * l) / l), 1e-4)
      .costs(seconds(run, ordinary));
}

Found twenty_thousand_modes() {
  const auto text = [](int elements) {
    return fmt::format(
        "[section]\nlaw = \"elastic\"\nEA_N = 1e7\nEI_N_m2 = 10\nmass_kg_per_m = 1\n[span]\nlength_m = 100\ntension_kN "
        "= 4\n"
        "elements = {}\ngrading = \"uniform\"\nleft = \"pinned\"\nright = \"pinned\"\nmass = "
        "\"consistent\"\nrotary_inertia = false\n"
        "[analysis]\ntype = \"modes\"\ncount = 3\n",
        elements);
  };
  const Run run(text(20'000)), ordinary(text(200));
  // A condition of 4e11, as above; half of it in a frequency.
  Found found;
  for (int n : {1, 3}) {
    const double k = n * pi / 100;
    found.close("frequency (Hz)", run.at(fmt::format("frequencies_Hz[{}]", n - 1)),
                k * std::sqrt((4000 + 10 * k * k) * (1 + 4000 / 1e7)) / (2 * pi), 5e-5);
  }
  return found.costs(seconds(run, ordinary));
}

Found twenty_thousand_in_time() {
  const std::string text = curlew_span(
      fmt::format("[initial]\nvelocity_mode = 2\nantinode_velocity_m_per_s = 0.6\n[integrator]\n{}step_s = 2e-4\n"
                  "max_numerical_share = 1\n[analysis]\ntype = \"transient\"\nduration_s = 0.01\n",
                  conserving));
  const Run run(text, {"span.elements=20000", "span.grading=uniform", "span.length_m=200"}), ordinary(text);
  return Found{}
      .most("energy above what came in", run.energy_above_input(), 1e-6)
      .most("numerical part over the energy at the start",
            std::abs(run.at("energy.numerical_dissipation_J")) / run.at("energy.initial_kinetic_J"), 1e-3)
      .costs({.extreme = run.result().cost.cpu_s / 20'000,
              .ordinary = ordinary.result().cost.cpu_s / 40,
              .unit = "CPU seconds of an element"});
}

/// Beads on a string: 1 - (k h)^2/24, and no more than that for lumped masses on a smooth curve.
Found lumped() {
  const auto off = [](int elements) {
    return frequency_of(4, elements, string_like, "lumped") / exact_frequency(4, string_like) - 1;
  };
  const auto bead = [](int elements) { return std::pow(4 * pi / elements, 2) / 24; };
  return Found{}
      .most("error with 5 elements a loop over (k h)^2/24", std::abs(off(20)) / bead(20), 1)
      .most("error with 10 elements a loop over (k h)^2/24", std::abs(off(40)) / bead(40), 1)
      .costs({.extreme = 40, .ordinary = 20, .unit = "section points of an evaluation"});
}

Found consistent() {
  const auto f = [](int elements) { return frequency_of(4, elements, beam_like); };
  const double exact = exact_frequency(4, beam_like);
  return Found{}
      .within("error ratio of mode 4 when the elements halve, 20 to 40", (f(20) / exact - 1) / (f(40) / exact - 1), 14,
              18)
      .costs({.extreme = 40, .ordinary = 20, .unit = "section points of an evaluation"});
}

}  // namespace

std::vector<Extreme> mesh_rows() {
  return {
      {"meshes/one-element", "a cantilever of one element", "P L^3/3 EI, which a cubic holds exactly", one_element},
      {"meshes/few-elements", "a vibrating span of one element", "Rayleigh from above, error of fourth order",
       few_elements},
      {"meshes/1-mm-beside-10-m", "three elements of 10 m, 1 mm, 10 m", "P L^3/3 EI",
       [] { return millimetre_beside_ten_metres(3); }},
      {"meshes/1-mm-among-many", "1 mm between legs of 20 elements", "P L^3/3 EI",
       [] { return millimetre_beside_ten_metres(41); }},
      {"meshes/1-mm-modes", "1 mm between legs of 20 elements", "frequencies of the pinned beam", millimetre_modes},
      {"meshes/20000-static", "20 000 elements", "a beam under tension with a force in its middle",
       twenty_thousand_static, Pace::slow},
      {"meshes/20000-modes", "20 000 elements", "frequencies of the pinned beam under tension", twenty_thousand_modes,
       Pace::slow},
      {"meshes/20000-in-time", "20 000 elements of Curlew, 50 steps", "energy does not grow", twenty_thousand_in_time,
       Pace::slow},
      {"meshes/consistent-order", "5 and 10 elements a loop, consistent mass", "error of fourth order", consistent},
      {"meshes/lumped", "5 and 10 elements a loop, lumped mass", "no further off than beads on a string, (k h)^2/24",
       lumped},
  };
}

}  // namespace strandyn::extremes
