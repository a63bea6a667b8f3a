// A million cycles of a section, ten thousand of a span.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "point.hpp"
#include "scene.hpp"
#include "strands.hpp"
#include "strandyn/section/compliant.hpp"
#include "strandyn/section/linear_law.hpp"
#include "strandyn/section/masing.hpp"
#include "strandyn/section/multilinear.hpp"
#include "strandyn/section/return_map.hpp"
#include "strandyn/section/spatial_return_map.hpp"
#include "themes.hpp"

namespace strandyn::extremes {
namespace {

/// A closed loop of four steps, over and over: once settled it repeats, so neither its loss nor its state may drift.
Found repeats(const section::Law& law, int count, double curvature) {
  const double eps = strain_at(0.15);
  Point point(law, {.eps = eps});
  double least = 0;
  Answer a;
  const auto cycle = [&] {
    double lost = 0;
    for (double part : {1.0, 0.0, -1.0, 0.0}) {
      a = point.commit({.eps = eps, .chi2 = part * curvature, .chi3 = 0.5 * part * curvature});
      lost += a.dissipated;
      least = std::min(least, a.dissipated);
    }
    return lost;
  };
  for (int i = 0; i < 20; ++i) cycle();
  const double loss = cycle();
  const Answer before = a;
  for (int i = 0; i < count; ++i) cycle();
  const double last = cycle();
  Found found;
  if (loss > 0) found.close("loss of the last cycle (J/m)", last, loss, 1e-12);
  if (loss == 0) found.most("loss of the last cycle (J/m)", last, 0);
  return found
      .most("moment drifted by, over EI_max chi", std::abs(a.M2 - before.M2) / (curlew_constants().EI_max * curvature),
            1e-12)
      .most("stored energy drifted by", std::abs(a.stored / before.stored - 1), 1e-12)
      .least("least loss of a step (J/m)", least, 0)
      .costs({.extreme = 4.0 * (count + 22), .ordinary = 4 * 22, .unit = "section evaluations"});
}

const section::MultilinearSection springs{
    .EA = 1e7, .GJ = 10, .EI = 30, .springs = {{.stiffness = 500, .yield = 0.01}, {.stiffness = 300, .yield = 0.02}}};

/// An elastic span for ten thousand cycles: ten steps a cycle, eight elements.
Found span_keeps_energy(const std::string& section) {
  const auto text = [&](double seconds) {
    return section +
           fmt::format(
               "[span]\nlength_m = 10\ntension_rts = 0.15\nelements = 8\ngrading = \"uniform\"\nleft = \"pinned\"\n"
               "right = \"pinned\"\nmass = \"consistent\"\ncondense_axial = true\n[initial]\nvelocity_mode = 1\n"
               "antinode_velocity_m_per_s = 1e-3\n[integrator]\n{}step_s = 0.018\nmax_numerical_share = 1\n[analysis]\n"
               "type = \"transient\"\nduration_s = {}\nprobes_m = [5]\n",
               conserving, seconds);
  };
  const Run run(text(1900)), ordinary(text(1.9));
  return Found{}
      .least("cycles", 1900 * run.at("probes[0].frequency_Hz"), 1e4)
      .most("energy kept but for",
            std::abs(run.at("energy.numerical_dissipation_J")) / run.at("energy.initial_kinetic_J"), 1e-6)
      .most("energy above what came in", run.energy_above_input(), 1e-6)
      .most("friction over the energy at the start",
            run.at("energy.friction_dissipation_J") / run.at("energy.initial_kinetic_J"), 1e-12)
      .costs(evaluations(run, ordinary));
}

}  // namespace

std::vector<Extreme> cycle_rows() {
  using section::Dimension;
  const std::string bound =
      "the loop repeats: loss, moment and stored energy of the last cycle are those of the first ones";
  const auto curlew_text = [](const char* law) {
    return fmt::format("[conductor]\ncatalogue = \"curlew\"\n[section]\nlaw = \"{}\"\n", law);
  };
  return {
      {"cycles/return-map", "1e6 cycles of a section", bound,
       [] { return repeats(section::PlanarReturnMap(curlew(), 36), 1'000'000, 0.03); }, Pace::slow},
      {"cycles/masing", "1e6 cycles of a section", bound,
       [] { return repeats(section::MasingLaw(curlew()), 1'000'000, 0.03); }, Pace::slow},
      {"cycles/multilinear", "1e6 cycles of a section", bound,
       [] { return repeats(section::MultilinearLaw(springs, Dimension::planar), 1'000'000, 0.03); }, Pace::slow},
      {"cycles/stick", "1e6 cycles of a section", bound + "; none of either",
       [] {
         return repeats(section::LinearLaw("stick", Dimension::planar,
                                           {.EA = curlew_constants().EA, .EI = curlew_constants().EI_max}),
                        1'000'000, 0.03);
       },
       Pace::slow},
      {"cycles/compliant", "1e5 cycles of a section", bound,
       [] { return repeats(section::CompliantLaw(curlew()), 100'000, 0.03); }, Pace::slow},
      {"cycles/biaxial-return-map", "1e5 cycles of a section", bound,
       [] { return repeats(section::SpatialReturnMap(curlew(), {}), 100'000, 0.03); }, Pace::slow},
      {"cycles/stick-span", "1e4 cycles of a span, 10 steps each",
       "the trapezoidal rule keeps the energy of what is linear",
       [curlew_text] { return span_keeps_energy(curlew_text("stick")); }, Pace::slow},
      {"cycles/stranded-span", "1e4 cycles of a stranded span below first slip, 10 steps each",
       "what sticks loses nothing: energy is kept",
       [curlew_text] { return span_keeps_energy(curlew_text("return-map")); }, Pace::slow},
  };
}

}  // namespace strandyn::extremes
