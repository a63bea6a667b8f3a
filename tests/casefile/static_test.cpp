#include <doctest/doctest.h>

#include <string>

#include "texts.hpp"

using namespace strandyn::casefile;
using strandyn::test::beam;
using strandyn::test::contains;
using strandyn::test::lab_span;
using strandyn::test::read;
using strandyn::test::refusal;

namespace {

/// A strand and a beam, each pushed at a point.
const std::string push = "[[load]]\ntype = \"static-force\"\nat_m = 15\nforce_N = -200\n";
const std::string pushed_strand =
    lab_span.substr(0, lab_span.find("[[load]]")) + push + "[analysis]\ntype = \"static\"\n";
const std::string pushed_beam = beam.substr(0, beam.find("[analysis]")) + push + "[analysis]\ntype = \"static\"\n";
const std::string weighed_beam = beam.substr(0, beam.find("[analysis]")) +
                                 "[[load]]\ntype = \"static-force\"\nper_length = true\nforce_N = -20\n" +
                                 "[analysis]\ntype = \"static\"\n";

const std::string corners =
    "[section]\nlaw = \"elastic\"\nEA_N = 1e6\nEI_N_m2 = 1\nGJ_N_m2 = 1\n[analysis]\ntype = \"static\"\n"
    "[span]\ndimension = \"spatial\"\nnodes_m = ";

}  // namespace

TEST_CASE("displacement control and arc length have keys of their own") {
  const Static by_displacement =
      read(pushed_beam + "[static]\ncontrol = \"displacement\"\ndisplacement_mm = -250\n").static_;
  CHECK(by_displacement.control == Control::displacement);
  CHECK(by_displacement.displacement == -0.25);
  const Static by_arc = read(pushed_beam + "[static]\ncontrol = \"arc-length\"\narc_step_mm = 5\n").static_;
  CHECK(by_arc.control == Control::arc_length);
  CHECK(by_arc.arc_step == 0.005);
  CHECK(by_arc.max_load_factor == 1.0);
  const Static plain = read(pushed_beam, {"static.control=arc-length", "static.max_load_factor=2.5"}).static_;
  CHECK_FALSE(plain.arc_step.has_value());
  CHECK(plain.max_load_factor == 2.5);
}

TEST_CASE("a control refuses keys of another one and values out of bounds") {
  CHECK(contains(refusal(pushed_beam, {"static.control=displacement"}),
                 "static.displacement_mm: is missing; give the displacement at the end in millimetres, of the point"));
  CHECK(contains(refusal(pushed_beam, {"static.control=displacement", "static.displacement_mm=0"}),
                 "static.displacement_mm = 0: must not be 0; give the displacement"));
  CHECK(contains(refusal(pushed_beam + "[static]\ndisplacement_mm = 3\n"),
                 "belongs to control = \"displacement\", and control is \"load\" here"));
  CHECK(contains(refusal(pushed_beam + "[static]\nmax_load_factor = 3\n"), "belongs to control = \"arc-length\""));
  CHECK(contains(refusal(pushed_beam + "[static]\narc_step_mm = 3\n"), "belongs to control = \"arc-length\""));
  CHECK(contains(refusal(pushed_beam, {"static.control=arc-length", "static.arc_step_mm=0"}),
                 "must be above 0; give the length of an arc step in millimetres"));
  CHECK(contains(refusal(pushed_beam, {"static.control=arc-length", "static.max_load_factor=0"}), "must be above 0"));
}

TEST_CASE("a control other than that of the load needs a static force to go by") {
  const std::string arc = "[static]\ncontrol = \"arc-length\"\n";
  const std::string end = "[static]\ncontrol = \"displacement\"\ndisplacement_mm = 10\n";
  for (const std::string& control : {arc, end}) {
    CHECK(contains(refusal(beam + control, {"analysis.type=static"}), "case.toml:12:1: static.control = "));
    CHECK(contains(refusal(beam + control, {"analysis.type=static"}),
                   "needs a load that is not 0; give a [[load]] with type = \"static-force\""));
    CHECK(contains(refusal(pushed_beam + control, {"load[0].force_N=0"}), "needs a load that is not 0"));
    CHECK(refusal(beam + control) == "accepted");  // modes do not step
  }
  CHECK(refusal(weighed_beam + arc) == "accepted");
  CHECK(
      contains(refusal(weighed_beam + end),
               "load[0]: has no point, and `static.control` needs a force at a point as the first static-force load"));
  CHECK(contains(refusal(pushed_beam + end, {"load[0].moment_N_m=3"}), "load[0]: is a moment, and `static.control`"));
  CHECK(contains(refusal(pushed_beam + push + end, {"load[0].force_N=0"}), "load[0]: is 0, and `static.control`"));
}

TEST_CASE("the first static force is found behind loads of other kinds") {
  const std::string second =
      beam + "[[load]]\ntype = \"harmonic-force\"\nat_m = 1\namplitude_N = 2\nfrequency_Hz = 1\n" + push;
  CHECK(first_static_force(read(second)) == 1);
  CHECK_FALSE(first_static_force(read(lab_span)).has_value());
}

TEST_CASE("slip maps are asked for by load, where a force at a point bends a strand") {
  CHECK(read(pushed_strand + "slip_map_loads_N = [0, 50, 200]\n").as<StaticAnalysis>().slip_map_loads ==
        std::vector{0.0, 50.0, 200.0});
  CHECK(read(pushed_strand).as<StaticAnalysis>().slip_map_loads.empty());
  const std::string key = "analysis.slip_map_loads_N=[10]";
  CHECK(contains(refusal(pushed_strand, {"analysis.slip_map_loads_N=[10, -1]"}),
                 "analysis.slip_map_loads_N[1] = -1: must be at least 0; give loads in newtons, at which"));
  CHECK(contains(refusal(pushed_beam, {key}), "asks for wires, and section.law = \"elastic\" has none"));
  CHECK(contains(refusal(lab_span, {key, "analysis.type=static"}),
                 "analysis.slip_map_loads_N = [10]: needs a load; give a [[load]] with type = \"static-force\""));
  CHECK(contains(refusal(pushed_strand, {key, "load[0].per_length=true"}), "load[0]: has no point"));
  CHECK(contains(refusal(lab_span, {key}), "belongs to type = \"static\", and type is \"forced\" here"));
}

TEST_CASE("modes are the lowest, or those nearest to a frequency") {
  CHECK_FALSE(read(beam).as<ModesAnalysis>().near_frequency.has_value());
  CHECK(read(beam + "near_Hz = 24\n").as<ModesAnalysis>().near_frequency == 24.0);
  CHECK(contains(refusal(beam + "near_Hz = 0\n"),
                 "case.toml:11:1: analysis.near_Hz = 0: must be above 0; give the frequency whose nearest modes are "
                 "wanted in hertz"));
  CHECK(contains(refusal(lab_span + "near_Hz = 3\n"), "belongs to type = \"modes\""));
}

TEST_CASE("a beam may state its rotary inertia") {
  const Section section = read(beam, {"section.rotary_kg_m=1e-4", "section.polar_kg_m=2e-4"}).section;
  CHECK(section.rotary_inertia == 1e-4);
  CHECK(section.polar_inertia == 2e-4);
  CHECK_FALSE(read(beam).section.rotary_inertia.has_value());
  CHECK_FALSE(read(beam).section.polar_inertia.has_value());
  CHECK(contains(refusal(beam, {"section.rotary_kg_m=-1"}),
                 "must be at least 0; give the mass moment per length about an axis of bending in kg m"));
  CHECK(contains(refusal(beam, {"section.polar_kg_m=-1"}), "must be at least 0"));
  CHECK(contains(refusal(lab_span, {"section.rotary_kg_m=1"}), "belongs to law = \"elastic\", \"multilinear\""));
}

TEST_CASE("an end may be guided along the span") {
  CHECK(read(beam, {"span.right=guided"}).span->right == Support::guided);
  CHECK(contains(refusal(beam, {"span.right=guide"}), "is not a choice; choose one of \"guided\""));
}

TEST_CASE("a bend without torsion is refused, corners on a line are none") {
  const auto held = [](const std::string& nodes) { return refusal(corners + nodes + "\ntorsion = false\n"); };
  CHECK(
      contains(held("[[0, 0, 0], [5, 0, 0], [10, 0, 0], [15, 1, 0]]"),
               "case.toml:11:1: span.torsion = false: leaves out torsion, and span.nodes_m[2] is a bend: a bend needs "
               "torsion; remove it, or give corners on a straight line"));
  CHECK(contains(held("[[0, 0, 0], [5, 0, 0], [2, 0, 0]]"), "a bend needs torsion"));  // there and back
  CHECK(held("[[0, 0, 0], [5, 0, 0]]") == "accepted");
  CHECK(held("[[0, 0, 0], [3.333333, 1.111111, 0], [10, 3.333333, 0]]") == "accepted");    // a kink of 4e-8
  CHECK(contains(held("[[0, 0, 0], [5, 0, 0], [10, 1e-4, 0]]"), "a bend needs torsion"));  // of 2e-5
  CHECK(refusal(corners + "[[0, 0, 0], [5, 0, 0], [5, 5, 0]]\n") == "accepted");
}

TEST_CASE("axial unknowns are condensed on a straight level span without weight only") {
  const std::string condensed = "span.condense_axial=true";
  CHECK(read(beam, {condensed}).span->condense_axial);
  CHECK(contains(refusal(beam, {condensed, "span.gravity=true"}),
                 "span.condense_axial = true: excludes `span.gravity`, and both are given; remove one of the two"));
  CHECK(contains(refusal(beam, {condensed, "span.height_difference_m=3"}), "excludes `span.height_difference_m`"));
  CHECK(contains(refusal(corners + "[[0, 0, 0], [5, 0, 0]]\ncondense_axial = true\n"), "excludes `span.nodes_m`"));
}
