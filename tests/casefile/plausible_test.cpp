// What can hardly be is warned of once, with the number and its usual range; what is usual is not.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>

#include "strandyn/casefile/read.hpp"
#include "strandyn/conductor/catalogue.hpp"

using namespace strandyn;

namespace {

std::vector<std::string> warnings_of(const std::string& conductor, const std::string& more = "",
                                     const std::string& amplitude = "4") {
  return casefile::read_scene_text(
             "[conductor]\n" + conductor + "[span]\nlength_m = 10\ntension_rts = 0.2\nelements = 30\n" + more +
                 "[analysis]\ntype = \"decay\"\nmode = 4\nantinode_amplitude_mm = " + amplitude + "\ncycles = 3\n",
             "test.toml")
      .warnings;
}

void check_only(const std::vector<std::string>& warnings, const char* words) {
  CAPTURE(words);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings.front().find(words) != std::string::npos);
}

std::string two_layers(const std::string& outer, int wires = 6) {
  return "rated_strength_kN = 100\n[[conductor.layer]]\nwires = 1\ndiameter_mm = 3.5\nyoung_GPa = 200\n"
         "density_kg_per_m3 = 7800\n[[conductor.layer]]\ndiameter_mm = 3.5\nyoung_GPa = 69\n"
         "density_kg_per_m3 = 2700\n" +
         fmt::format("wires = {}\n", wires) + outer;
}

}  // namespace

TEST_CASE("no conductor of the catalogue is unusual") {
  for (const auto& entry : conductor::catalogue()) {
    CAPTURE(entry.name);
    CHECK(warnings_of(fmt::format("catalogue = \"{}\"\n", entry.name)).empty());
  }
}

TEST_CASE("what is unusual is warned of with its range") {
  check_only(warnings_of(two_layers("lay_angle_deg = 10\nfriction_inner = 7\n")), "friction_inner = 7 is unusual");
  check_only(warnings_of(two_layers("lay_angle_deg = -40\n", 4)), "lies between 0 and 30 degrees");
  check_only(warnings_of("catalogue = \"curlew\"\nmass_kg_per_m = 2.5\n"),
             "26 % more than the 1.988 kg/m of the wires");
  check_only(warnings_of("catalogue = \"curlew\"\n", "", "400"), "stretches the span by 6.3 %");
  check_only(warnings_of("catalogue = \"curlew\"\n", "[[load]]\ntype = \"static-force\"\nat_m = 5\nforce_N = 0\n"),
             "load[0] is 0: it does nothing");
}
