// Scenes that are in order key by key, and still cannot be, or can hardly be.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "resolve.hpp"

namespace strandyn::casefile {
namespace {

/// What a number usually is; beyond `impossible` no thing of this world has it.
struct Usual {
  double least = 0, most = 0;
  double impossible = std::numeric_limits<double>::infinity();
};

struct Judged {
  std::string path;  // of the key
  const char* what;  // "Young's modulus"
  const char* unit;  // " GPa", with what stands before it
  double value = 0;  // in that unit
  Usual usual;
};

void judge(const Judged& j, Scene& scene) {
  const std::string range = fmt::format("{} lies between {:g} and {:g}{}", j.what, j.usual.least, j.usual.most, j.unit);
  if (j.value > j.usual.impossible) {
    refuse(scene.source, j.path, fmt::format("no wire has {:g}{}", j.value, j.unit), range);
  }
  if (j.value >= j.usual.least && j.value <= j.usual.most) return;
  scene.warnings.push_back(fmt::format("{} = {:g}{} is unusual: {}", j.path, j.value, j.unit, range));
}

void judge_layers(Scene& scene) {
  constexpr double degree = std::numbers::pi / 180;
  for (std::size_t j = 0; j < scene.conductor->layers.size(); ++j) {
    const conductor::Layer& layer = scene.conductor->strand.layers[j];
    const std::string path = fmt::format("conductor.layer[{}]", j);
    judge({.path = path + ".young_GPa",
           .what = "Young's modulus of a wire",
           .unit = " GPa",
           .value = layer.young / 1e9,
           .usual = {.least = 10, .most = 250, .impossible = 1500}},
          scene);
    judge({.path = path + ".diameter_mm",
           .what = "the diameter of a wire",
           .unit = " mm",
           .value = layer.diameter * 1e3,
           .usual = {.least = 0.1, .most = 15}},
          scene);
    if (layer.density > 0) {
      judge({.path = path + ".density_kg_per_m3",
             .what = "the density of a wire",
             .unit = " kg/m^3",
             .value = layer.density,
             .usual = {.least = 1000, .most = 10000, .impossible = 23000}},
            scene);
    }
    if (j == 0) continue;
    judge({.path = path + ".friction_inner",
           .what = "the friction coefficient of wires",
           .unit = "",
           .value = layer.friction_inner,
           .usual = {.least = 0, .most = 1.5}},
          scene);
    judge({.path = path + ".lay_angle_deg",
           .what = "a lay angle, either way,",
           .unit = " degrees",
           .value = std::abs(layer.lay_angle) / degree,
           .usual = {.least = 0, .most = 30}},
          scene);
  }
}

/// A mass that its own wires contradict: the wires' with its grease is a tenth more at most.
void judge_mass(Scene& scene) {
  const std::optional<double> wires = scene.conductor->strand.geometric_mass();
  const std::optional<double> given = scene.conductor->mass_per_length;
  if (!wires || !given || !needs_strand(scene.section.law)) return;
  constexpr double impossible = 3, unusual = 1.1;
  const double ratio = *given / *wires;
  if (ratio > impossible || ratio < 1 / impossible) {
    refuse(scene.source, "conductor.mass_kg_per_m",
           fmt::format("is {:.4g} kg/m, and the wires alone have {:.4g} kg/m", *given, *wires),
           fmt::format("give about {:.4g}, or correct the wires' diameters and densities", *wires));
  }
  if (ratio <= unusual && ratio >= 1 / unusual) return;
  scene.warnings.push_back(fmt::format(
      "conductor.mass_kg_per_m = {:.4g} is {:.0f} % {} than the {:.4g} kg/m of the wires; grease adds up to "
      "ten per cent",
      *given, 100 * std::abs(ratio - 1), ratio > 1 ? "more" : "less", *wires));
}

/// No strand carries more than its rated strength, however the tension is written.
void refuse_beyond_strength(double tension, const std::string& path, const Scene& scene) {
  const double strength = scene.conductor ? scene.conductor->strand.rated_strength : 0;
  if (strength == 0 || tension <= strength * (1 + 1e-9)) return;
  refuse(
      scene.source, path,
      fmt::format("is {:.4g} kN, {:.3g} times the rated strength of the conductor", tension / 1e3, tension / strength),
      fmt::format("give at most {:.4g} kN; lines are strung at 10 to 30 % of it", strength / 1e3));
}

void warn_of_nothing(bool nothing, const std::string& path, Scene& scene) {
  if (nothing) scene.warnings.push_back(fmt::format("{} is 0: it does nothing", path));
}

/// A span that vibrates in loops between fixed ends is stretched by the square of their slope, (pi n A/L)^2/4.
void warn_of_wide_loops(const DecayAnalysis& decay, Scene& scene) {
  constexpr double bearable = 0.02;  // aluminium strands break at 1 to 2 %
  if (!decay.antinode_amplitude || !scene.span || !scene.span->length) return;
  const double slope = std::numbers::pi * decay.mode * *decay.antinode_amplitude / *scene.span->length;
  const double strain = slope * slope / 4;
  if (strain <= bearable) return;
  scene.warnings.push_back(
      fmt::format("analysis.antinode_amplitude_mm = {:g} stretches the span by {:.2g} %; strands break at 1 to 2 %",
                  1e3 * *decay.antinode_amplitude, 100 * strain));
}

}  // namespace

void check_plausible(Scene& scene) {
  if (scene.conductor) {
    judge_layers(scene);
    judge_mass(scene);
  }
  if (scene.span && scene.span->tension) refuse_beyond_strength(*scene.span->tension, "span.tension_kN", scene);
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    const bool nothing = scene.loads[i].type != LoadType::table && scene.loads[i].value() == 0;
    warn_of_nothing(nothing, fmt::format("the size of load[{}]", i), scene);
  }
  for (std::size_t i = 0; i < scene.motions.size(); ++i) {
    // A static motion of 0 holds its point, which is something.
    const bool nothing = scene.motions[i].is_harmonic() && scene.motions[i].value() == 0;
    warn_of_nothing(nothing, fmt::format("the amplitude of motion[{}]", i), scene);
  }
  if (const auto* decay = std::get_if<DecayAnalysis>(&scene.analysis)) {
    warn_of_wide_loops(*decay, scene);
  }
}

}  // namespace strandyn::casefile
