// From 0.1 to 500 Hz.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scene.hpp"
#include "strands.hpp"
#include "strandyn/casefile/read.hpp"
#include "strandyn/exact/tensioned_beam.hpp"
#include "strandyn/section/material_damping.hpp"
#include "themes.hpp"

namespace strandyn::extremes {
namespace {

using std::numbers::pi;

/// Curlew between pins, all wires sticking: modes near a frequency against the closed form.
Found modes_near(double frequency, double length, int elements, double accuracy) {
  const auto text = [](double near, double l, int n) {
    return fmt::format(
        "[conductor]\ncatalogue = \"curlew\"\n[section]\nlaw = \"stick\"\n[span]\nlength_m = {}\ntension_rts = 0.15\n"
        "elements = {}\ngrading = \"uniform\"\nleft = \"pinned\"\nright = \"pinned\"\nmass = \"consistent\"\n"
        "rotary_inertia = false\n[analysis]\ntype = \"modes\"\ncount = 3\nnear_Hz = {}\n",
        l, n, near);
  };
  const Run run(text(frequency, length, elements)), ordinary(text(25, 10, 200));
  const double T = 0.15 * curlew().rated_strength;
  // Mass and curvature are counted per unstressed length; the span is stretched by this.
  const double stretch = 1 + T / curlew_constants().EA;
  const exact::TensionedBeam beam{.tension = T,
                                  .EI = curlew_constants().EI_max * stretch,
                                  .mass_per_length = curlew().mass_per_length / stretch,
                                  .length = length};
  std::vector<double> exact;
  for (int n = 1; n < 200; ++n) exact.push_back(exact::TensionedBeamMode(beam, exact::BeamEnds::pinned, n).frequency());
  // Among them those along the line, n/(2 L_0) sqrt(EA/m).
  const double along = std::sqrt(curlew_constants().EA / curlew().mass_per_length) * stretch / (2 * length);
  for (int n = 1; n < 10; ++n) exact.push_back(n * along);
  std::ranges::sort(exact, {}, [&](double f) { return std::abs(f - frequency); });
  exact.resize(3);
  std::ranges::sort(exact);
  Found found;
  for (std::size_t i = 0; i < 3; ++i) {
    found.close("frequency (Hz)", run.at(fmt::format("frequencies_Hz[{}]", i)), exact[i], accuracy);
  }
  return found.costs(
      {.extreme = run.result().cost.cpu_s, .ordinary = ordinary.result().cost.cpu_s, .unit = "CPU seconds"});
}

/// [kg/m] that gives the elastic span's first mode a frequency.
double mass_for(double frequency) {
  const double k = pi / 10;
  return (4000 + 10 * k * k) * (1 + 4000 / 1e7) * std::pow(k / (2 * pi * frequency), 2);
}

/// A uniform drag c: energy falls with exp(-c t/m).
Found drag(double frequency) {
  const auto run_at = [](double f) {
    const double m = mass_for(f), rate = 0.025 * f;  // exp(-0.5) in 20 cycles
    return Run(elastic_span(fmt::format("[initial]\nvelocity_mode = 1\nantinode_velocity_m_per_s = {:.17g}\n"
                                        "[damping]\ndrag_N_s_per_m2 = {:.17g}\n[integrator]\n{}step_s = {:.17g}\n"
                                        "[analysis]\ntype = \"transient\"\nduration_s = {:.17g}\n",
                                        2 * pi * f * 1e-4, rate * m, conserving, 1 / (400 * f), 20 / f)),
               {fmt::format("section.mass_kg_per_m={:.17g}", m)});
  };
  const Run run = run_at(frequency), ordinary = run_at(3.16);
  const double left = run.at("energy.kinetic_J") + run.at("energy.elastic_J");
  // Drag and mass both belong to the unstressed length. 400 steps a cycle: (omega h)^2 = 2.5e-4, a quarter of which the
  // rate of the trapezoidal rule is off.
  return Found{}
      .close("part of the energy left after 20 cycles", left / run.at("energy.initial_kinetic_J"), std::exp(-0.5), 1e-4)
      .close("drag over what is lost", run.at("energy.viscous_dissipation_J"),
             run.at("energy.initial_kinetic_J") - left, 1e-4)
      .most("energy above what came in", run.energy_above_input(), 1e-9)
      .costs(evaluations_per_step(run, ordinary));
}

/// Friction knows no time: the same swing of a heavier or lighter conductor loses the same in a cycle.
Found rate_independence(double factor) {
  const auto run_at = [](double part) {
    const double step = part / (5.7 * 200);
    casefile::Scene scene = casefile::read_scene_text(
        curlew_span(
            fmt::format("condense_axial = true\n[initial]\nvelocity_mode = 2\nantinode_velocity_m_per_s = {:.17g}\n"
                        "[integrator]\n{}step_s = {:.17g}\nmax_numerical_share = 1\n[analysis]\n"
                        "type = \"transient\"\nduration_s = {:.17g}\n",
                        0.9 / part, conserving, step, 1000 * step)),
        "extremes.toml");
    // Its wires have no such mass: a case would be refused.
    scene.section.mass_per_length = curlew().mass_per_length * part * part;
    return Run(scene);
  };
  const Run run = run_at(factor), ordinary = run_at(1);
  return Found{}
      .close("friction of the run (J)", run.at("energy.friction_dissipation_J"),
             ordinary.at("energy.friction_dissipation_J"), 1e-6)
      .least("friction over the energy at the start",
             run.at("energy.friction_dissipation_J") / run.at("energy.initial_kinetic_J"), 1e-3)
      .most("energy above what came in", run.energy_above_input(), 1e-6)
      .costs(evaluations_per_step(run, ordinary));
}

/// A mode of 500 Hz of the span itself, with friction.
Found vibrates_at_500() {
  const auto text = [](int mode, double amplitude) {
    return curlew_span(
        fmt::format("[integrator]\n{}steps_per_cycle = 200\nmax_numerical_share = 1\n[analysis]\n"
                    "type = \"decay\"\nmode = {}\nantinode_amplitude_mm = {}\ncycles = 4\n",
                    conserving, mode, amplitude));
  };
  const Run run(text(32, 0.2), {"span.elements=240", "span.grading=uniform"}), ordinary(text(4, 3));
  const double E = run.at("cycles[0].kinetic_J") + run.at("cycles[0].elastic_J");
  const double last = run.at("cycles[-1].kinetic_J") + run.at("cycles[-1].elastic_J");
  return Found{}
      .least("frequency (Hz)", run.at("steady.frequency_Hz"), 480)
      .least("friction of the last cycle (J)", run.at("cycles[-1].friction_dissipation_J"), 1e-6)
      .most("energy of the last cycle over that of the first", last / E, 1)
      .most("numerical share", run.at("steady.numerical_share"), 0.05)
      .costs(evaluations_per_step(run, ordinary));
}

/// Relaxing branches: loss of a sine in closed form, whatever the frequency.
Found metal(double frequency) {
  using section::Component;
  const section::ComponentStiffness stiffness{1, 0, 1, 0};
  const auto loss = section::material_loss(stiffness, 1e-3);
  const auto branches = section::branches_of(loss);
  const double omega = 2 * pi * frequency;
  const auto lost_with = [&](int steps) {
    section::MaterialMemory memory(branches, section::Dimension::planar, 1);
    section::Field before(section::Dimension::planar, 1), now = before;
    // The slowest branch needs long to settle: the mean over the last of many cycles, without what the start has left.
    double lost = 0;
    const int settling = 400;
    for (int i = 1; i <= steps * (settling + 1); ++i) {
      now[Component::bending2][0] = std::sin(2 * pi * i / steps);
      memory.commit(before, now, 1 / (frequency * steps));
      if (i > steps * settling) lost += memory.dissipated()[0];
      before = now;
    }
    return lost;
  };
  const double exact = pi * section::stiffness_at(branches, Component::bending2, omega).loss;
  const double coarse = lost_with(50), fine = lost_with(100);
  return Found{}
      .close("loss of a cycle", fine, exact, 2e-3)
      .within("error ratio when the step halves", (coarse - exact) / (fine - exact), 3.5, 4.5)
      .costs({.extreme = 100 * 401, .ordinary = 100 * 401, .unit = "steps"});
}

}  // namespace

std::vector<Extreme> frequency_rows() {
  std::vector<Extreme> rows = {
      {"frequency/modes-0.1", "modes near 0.1 Hz, a span of 555 m", "closed form of the pinned beam under tension",
       [] { return modes_near(0.1, 555, 400, 1e-5); }},
      {"frequency/modes-500", "modes near 500 Hz, a span of 10 m",
       "closed form of the pinned beam under tension, across its line and along it",
       [] { return modes_near(500, 10, 600, 1e-5); }},
      {"frequency/vibration-500", "Curlew vibrating in its mode 32, near 500 Hz",
       "friction takes energy, nobody gives it, the integrator takes less than 5 % of the losses", vibrates_at_500,
       Pace::slow},
  };
  for (double f : {0.1, 500.0}) {
    rows.push_back({fmt::format("frequency/drag-{:g}", f), fmt::format("a mode of {:g} Hz under drag", f),
                    "energy falls with exp(-c t/m)", [f] { return drag(f); }});
    rows.push_back({fmt::format("frequency/metal-{:g}", f), fmt::format("damping of the metal at {:g} Hz", f),
                    "loss of a sine in closed form, error of second order", [f] { return metal(f); }});
    rows.push_back({fmt::format("frequency/friction-{:g}", f),
                    fmt::format("Curlew made heavy or light until its mode 2 has {:g} Hz", f),
                    "friction knows no time: the same loss as at 11.4 Hz", [f] { return rate_independence(11.4 / f); },
                    Pace::slow});
  }
  return rows;
}

}  // namespace strandyn::extremes
