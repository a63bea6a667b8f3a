#include "strandyn/casefile/echo.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "strandyn/results/json.hpp"
#include "texts.hpp"

using namespace strandyn;
using nlohmann::ordered_json;
using strandyn::test::beam;
using strandyn::test::bend;
using strandyn::test::lab_span;
using strandyn::test::pushed;
using strandyn::test::read;

namespace {

/// JSON values are TOML values but for the colon in a table.
ordered_json json_of(const casefile::Scene& scene) {
  return ordered_json::parse(results::to_text(casefile::case_as_run(scene)));
}

std::string to_toml(const ordered_json& value) {
  std::string text;
  if (value.is_object()) {
    for (const auto& [key, child] : value.items())
      text += (text.empty() ? "" : ", ") + ordered_json(key).dump() + " = " + to_toml(child);
    return "{" + text + "}";
  }
  if (value.is_array()) {
    for (const auto& child : value) text += to_toml(child) + ", ";
    return "[" + text + "]";
  }
  return value.dump();
}

std::string case_of(const ordered_json& echo) {
  std::string text;
  for (const auto& [key, child] : echo.items()) text += key + " = " + to_toml(child) + "\n";
  return text;
}

}  // namespace

TEST_CASE("the case as run speaks in the case's own keys and units, defaults filled in") {
  const ordered_json echo = json_of(read(lab_span));
  CHECK(echo["span"]["tension_kN"].dump() == "24.4");
  CHECK(echo["span"]["elements"].dump() == "80");
  CHECK(echo["span"]["left"] == "clamped");
  CHECK(echo["span"]["gravity"] == false);
  CHECK(echo["conductor"]["catalogue"] == "curlew");
  CHECK(echo["integrator"]["steps_per_cycle"] == 200);
  CHECK_FALSE(echo["span"].contains("tension_rts"));
  CHECK_FALSE(echo["analysis"].contains("count"));
  CHECK(json_of(read(beam))["span"]["elements"] == "auto");
}

TEST_CASE("the case as run shows the layers of the conductor as resolved") {
  const ordered_json layer = json_of(read(lab_span))["conductor"]["layer"][4];
  CHECK(layer["lay_angle_deg"].dump() == "-14.2");
  CHECK(layer["helix_radius_mm"].dump() == "14.08");
  CHECK(layer["friction_inner"].dump() == "0.7");
  CHECK(layer["residual_force_N_per_mm"].dump() == "0.333");
  const ordered_json bare = json_of(read(lab_span, {"conductor.residual_forces=false"}));
  CHECK(bare["conductor"]["layer"][4]["residual_force_N_per_mm"] == 0);
}

TEST_CASE("the case as run shows motions and bodies in their units, with the direction that they took") {
  const ordered_json echo = json_of(read(bend));
  CHECK(echo["motion"][0].dump() == R"({"type":"static-motion","at":"left","rotation_deg":2.5,"direction":[-1,0,0]})");
  CHECK(
      echo["motion"][1].dump() ==
      R"({"type":"harmonic-motion","at_m":0.5,"amplitude_mm":3,"frequency":"mode 2","ease_s":0,"direction":[0,1,0]})");
  CHECK(echo["motion"][2]["history"].dump() == "[[0,0],[1.5,2.5]]");
  CHECK(echo["body"][0]["direction"].dump() == "[0.6,0,0.8]");
  CHECK(echo["static"].dump() == R"({"control":"arc-length","arc_step_mm":0.7,"max_load_factor":1})");
  CHECK(echo["span"]["right"] == "guided");
  const ordered_json other = json_of(read(pushed));
  CHECK(other["static"].dump() == R"({"control":"displacement","displacement_mm":-3})");
  CHECK(other["analysis"]["slip_map_loads_N"].dump() == "[10,20]");
  const ordered_json modes = json_of(read(beam, {"analysis.near_Hz=24", "section.rotary_kg_m=1e-4"}));
  CHECK(modes["analysis"]["near_Hz"].dump() == "24");
  CHECK(modes["section"]["rotary_kg_m"].dump() == "0.0001");
  CHECK_FALSE(modes["section"].contains("polar_kg_m"));
}

TEST_CASE("the case as run, read again, is the same case") {
  for (const std::string& text : {lab_span, beam, bend, pushed}) {
    ordered_json echo = json_of(read(text));
    if (echo.contains("conductor")) echo["conductor"].erase("catalogue");  // its layers stand there too
    CAPTURE(case_of(echo));
    CHECK(json_of(read(case_of(echo))).dump() == echo.dump());
  }
}
