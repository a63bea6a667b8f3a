#include "strandyn/casefile/read.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "strandyn/conductor/catalogue.hpp"
#include "support/check_close.hpp"
#include "texts.hpp"

using namespace strandyn;
using namespace strandyn::casefile;
using strandyn::test::beam;
using strandyn::test::check_close;
using strandyn::test::lab_span;
using strandyn::test::read;
using strandyn::test::three_layers;

TEST_CASE("a case in the units of its keys becomes a scene in SI") {
  const Scene scene = read(lab_span);
  CHECK(scene.title == "lab span");
  REQUIRE(scene.span);
  CHECK(scene.span->length == 30.0);
  CHECK(scene.span->tension == 24400.0);
  CHECK(scene.span->elements == 80);
  REQUIRE(scene.loads.size() == 1);
  CHECK(scene.loads[0].type == LoadType::harmonic_force);
  CHECK(scene.loads[0].value() == 20.0);
  CHECK(scene.loads[0].frequency == 24.0);
  CHECK(scene.is<ForcedAnalysis>());
  CHECK(scene.as<casefile::ForcedAnalysis>().cycles == 200);
  REQUIRE(scene.conductor);
  const conductor::Layer& outer = scene.conductor->strand.layers.at(4);
  CHECK(outer.diameter == 0.00352);  // the nearest double: millimetres are divided by 1000
  CHECK(outer.young == 69e9);
  CHECK(outer.residual_force == 333.0);
  // One rounding of pi/180, one of the product.
  check_close(outer.lay_angle, -14.2 * std::numbers::pi / 180, {.relative = 1e-15});
}

TEST_CASE("what a case does not say takes its default") {
  const Scene scene = read(beam);
  CHECK(scene.title == "case");
  CHECK(scene.span->grading == Grading::clamps);
  CHECK(scene.span->left == Support::clamped);
  CHECK(scene.span->dimension == Dimension::planar);
  CHECK_FALSE(scene.span->elements.has_value());
  CHECK_FALSE(scene.span->gravity);
  CHECK(scene.integrator.method == Method::ida);
  CHECK(scene.integrator.steps_per_cycle == 200);
  CHECK_FALSE(scene.integrator.max_numerical_share.has_value());
  CHECK(scene.as<casefile::ModesAnalysis>().count == 12);
  CHECK_FALSE(scene.conductor.has_value());
  CHECK(scene.accept.criteria.empty());
}

TEST_CASE("every conductor of the catalogue can be read") {
  for (const conductor::CatalogueEntry& entry : conductor::catalogue()) {
    CAPTURE(entry.name);
    const Scene scene = read(lab_span, {"conductor.catalogue=" + std::string(entry.name), "span.tension_rts=0.2"});
    CHECK(scene.conductor->strand.name == entry.name);
    CHECK(scene.conductor->strand.layers.size() >= 2);
    CHECK(scene.conductor->strand.mass_per_length > 0);
  }
}

TEST_CASE("the tension may be a part of the rated strength") {
  const Scene scene = read(lab_span, {"span.tension_rts=0.15"});
  check_close(span_tension(scene).value(), 0.15 * 162.8e3, {.relative = 1e-15});
}

TEST_CASE("a section analysis takes one tension or a list, in kN or by rated strength") {
  const std::string section =
      "[conductor]\ncatalogue = \"curlew\"\n[analysis]\ntype = \"section\"\n"
      "curvature_amplitudes_per_m = [0.02, 0.05]\n";
  CHECK(section_tensions(read(section + "tension_kN = 24.4")) == std::vector{24400.0});
  CHECK(section_tensions(read(section + "tension_kN = [10, 24.4]")) == std::vector{10000.0, 24400.0});
  const auto by_strength = section_tensions(read(section + "tension_rts = [0.15, 0.4]"));
  REQUIRE(by_strength.size() == 2);
  check_close(by_strength[1], 0.4 * 162.8e3, {.relative = 1e-15});
}

TEST_CASE("a mass left out is that of the wires") {
  const std::string wire =
      "[analysis]\ntype = \"axial-torsion\"\n[[conductor.layer]]\nwires = 1\ndiameter_mm = 4\n"
      "young_GPa = 200\ndensity_kg_per_m3 = 7780\n";
  const Scene scene = read(wire);
  check_close(mass_per_length(scene).value(), std::numbers::pi * 4e-6 * 7780, {.relative = 1e-15});
}

TEST_CASE("a lay length becomes the angle of the helix through the resolved radius") {
  const std::string by_length = three_layers +
                                "[[conductor.layer]]\nwires = 18\ndiameter_mm = 2\nyoung_GPa = 70\n"
                                "lay_length_mm = -150\n";
  const conductor::Strand strand = read(by_length).conductor->strand;
  const double radius = 2e-3 + 3e-3 + 2e-3 + 1e-3;  // core, layer 1, layer 2, half of layer 3
  check_close(strand.layers[3].helix_radius, radius, {.relative = 1e-14});
  check_close(strand.layers[3].lay_angle, std::atan(-2 * std::numbers::pi * radius / 0.15), {.relative = 1e-14});
}

TEST_CASE("trapezoidal wires keep the area that is given") {
  const std::string text = three_layers + "shape = \"trapezoidal\"\narea_mm2 = 3.5\n";
  const conductor::Layer layer = read(text).conductor->strand.layers[2];
  CHECK(layer.wire_area == 3.5e-6);
  CHECK(layer.wire_inertia == conductor::trapezoid_inertia(3.5e-6, 2e-3));
}

TEST_CASE("friction: a layer speaks for its inner contact, and for its outer one unless the next layer does") {
  const auto below = [](const std::string& text) {
    std::vector<double> friction;
    const Scene scene = read(text);
    for (const conductor::Layer& layer : scene.conductor->strand.layers) friction.push_back(layer.friction_inner);
    return std::vector(friction.begin() + 1, friction.end());
  };
  std::string text = three_layers;
  CHECK(below(text) == std::vector{0.5, 0.5});
  text.replace(text.find("lay_angle_deg = 10"), 18, "lay_angle_deg = 10\nfriction = 0.3");
  CHECK(below(text) == std::vector{0.3, 0.3});
  CHECK(below(text + "friction_inner = 0.2\n") == std::vector{0.3, 0.2});
  CHECK(below(text + "friction = 0.1\n") == std::vector{0.3, 0.1});
  CHECK(below(three_layers + "friction_inner = 0.2\n[conductor]\nfriction = 0.9\n") == std::vector{0.9, 0.2});
}

TEST_CASE("residual_forces = false takes them from the strand") {
  const Scene scene = read(lab_span, {"conductor.residual_forces=false"});
  for (const conductor::Layer& layer : scene.conductor->strand.layers) CHECK(layer.residual_force == 0.0);
}

TEST_CASE("the direction of a load becomes a unit vector, across the span unless said") {
  CHECK(read(lab_span).loads[0].direction == Vector3{0, 1, 0});
  const Vector3 slanted = read(lab_span, {"load[0].direction=[3, 4, 0]"}).loads[0].direction.value();
  check_close(slanted[0], 0.6, {.relative = 1e-15});
  check_close(slanted[1], 0.8, {.relative = 1e-15});
  const std::string text = beam + "[[load]]\ntype = \"static-force\"\nat_m = 30\nmoment_N_m = 5\n";
  CHECK(read(text).loads[0].direction == Vector3{0, 0, 1});
}

TEST_CASE("a span of corners is as long as its legs together") {
  const std::string text =
      "[section]\nlaw = \"elastic\"\nEA_N = 1e6\nEI_N_m2 = 1\n[span]\n"
      "nodes_m = [[0, 0, 0], [0, 10, 0], [7.5, 20, 0]]\n[analysis]\ntype = \"static\"\n";
  const Scene scene = read(text);
  CHECK(scene.span->total_length() == 22.5);
  CHECK_FALSE(span_tension(scene).has_value());
}

TEST_CASE("--set changes one key, and a bare word is a string") {
  const Scene scene = read(lab_span, {"section.law=stick", "load[0].amplitude_N=5", "load[0].frequency=mode 12",
                                      "span.elements=auto", "damping.modal=[[1, 0.01], [2, 2e-3]]"});
  CHECK(scene.section.law == Law::stick);
  CHECK(scene.loads[0].value() == 5.0);
  CHECK(scene.loads[0].frequency_mode == 12);
  CHECK_FALSE(scene.span->elements.has_value());
  REQUIRE(scene.damping.modal.size() == 2);
  CHECK(scene.damping.modal[1] == std::array{2.0, 2e-3});
}

TEST_CASE("--set displaces the keys of the file that it excludes") {
  const Scene scene = read(lab_span, {"span.tension_rts=0.2", "analysis.until=steady"});
  CHECK_FALSE(scene.span->tension.has_value());
  CHECK_FALSE(scene.as<casefile::ForcedAnalysis>().cycles.has_value());
  CHECK(scene.as<casefile::ForcedAnalysis>().until == Until::steady);
}

TEST_CASE("--set of a choice drops the keys of the file that belong to another one") {
  const Scene scene = read(lab_span, {"analysis.type=modes"});
  CHECK(scene.is<ModesAnalysis>());
  const std::string fixed = lab_span + "[integrator]\nsteps_per_cycle = 400\n";
  const Integrator adaptive = read(fixed, {"integrator.step=adaptive", "integrator.rtol=1e-5"}).integrator;
  CHECK_FALSE(adaptive.steps_per_cycle.has_value());
  CHECK(adaptive.rtol == 1e-5);
}

TEST_CASE("--set of another conductor brings its own mass and rated strength") {
  const std::string heavy =
      "[conductor]\ncatalogue = \"curlew\"\nmass_kg_per_m = 3\n[analysis]\ntype = "
      "\"axial-torsion\"\n";
  CHECK(mass_per_length(read(heavy)) == 3.0);
  CHECK(mass_per_length(read(heavy, {"conductor.catalogue=drake"})) == 1.628);
}

TEST_CASE("--set reaches an entry of [accept] through its quoted path") {
  const Scene scene = read(lab_span, {R"(accept."cycles[-1].kinetic_J"={below = 1, reason = "r"})"});
  REQUIRE(scene.accept.criteria.size() == 1);
  CHECK(scene.accept.criteria[0].path == "cycles[-1].kinetic_J");
  CHECK(scene.accept.criteria[0].below == 1.0);
}

TEST_CASE("a file that is not there, and a folder, are errors of the file") {
  CHECK_THROWS_AS(read_scene("/nowhere/case.toml"), FileError);
  CHECK_THROWS_AS(read_scene(STRANDYN_SOURCE_DIR), FileError);
}
