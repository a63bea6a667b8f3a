// Dampers of a span in an energy balance.
#include "strandyn/self_damping/protection.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "strandyn/casefile/read.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using test::check_close;

namespace {

const std::string sdm =
    "arm_m = [0.150, 0.197], weight_kg = [2.65, 3.115], inertia_kg_m2 = [8.41e-3, 1.65e-2], offset_m = [0.0163, "
    "0.0222]";
const std::string exchanged =
    "arm_m = [0.197, 0.150], weight_kg = [3.115, 2.65], inertia_kg_m2 = [1.65e-2, 8.41e-3], offset_m = [0.0222, "
    "0.0163]";

/// [W] of one damper on 300 m of Drake at an antinode amplitude of one millimetre.
double power(double frequency, double at, const std::string& arms) {
  const casefile::Scene scene = casefile::read_scene_text(
      fmt::format("[conductor]\ncatalogue = \"drake\"\n[section]\nlaw = \"return-map\"\n"
                  "[analysis]\ntype = \"self-damping\"\nmethod = \"foti-2018\"\nfrequencies_Hz = [20]\n"
                  "amplitude_over_diameter = [0.1]\ntensions_kN = 28\n"
                  "[[analysis.energy_balance]]\nwind = \"cigre\"\nself_damping = \"foti-2018\"\nspan_m = 300\n"
                  "damper = [ {{ at_m = {}, clamp_mass_kg = 0.835, {}, "
                  "messenger = {{ EI_N_m2 = 7.7945, mass_kg_per_m = 1.035, loss_factor = 0.0769 }} }} ]\n",
                  at, arms),
      "balance.toml");
  const self_damping::Protection one(scene, scene.as<casefile::SelfDampingAnalysis>().energy_balances.front());
  return one.at({.antinode_amplitude = 1e-3, .frequency = frequency}, 28e3).power;
}

}  // namespace

TEST_CASE("protection: a damper at the right end takes what its mirror image takes at the left one") {
  for (const double f : {10.0, 20.0, 35.0}) {
    check_close(power(f, 299, exchanged), power(f, 1, sdm), {.relative = 1e-12});
    check_close(power(f, 299, sdm), power(f, 1, exchanged), {.relative = 1e-12});
  }
  // Its clamp turns with the conductor, so that the order of its unequal arms counts.
  CHECK(power(10, 1, exchanged) > 1.2 * power(10, 1, sdm));
}
