#include <doctest/doctest.h>

#include <numbers>
#include <string>

#include "support/check_close.hpp"
#include "texts.hpp"

using namespace strandyn::casefile;
using strandyn::test::beam;
using strandyn::test::check_close;
using strandyn::test::contains;
using strandyn::test::read;
using strandyn::test::refusal;

namespace {

constexpr double degree = std::numbers::pi / 180;  // the reader's own has one more rounding: 1e-15 below

// Each begins on line 11 of its case, as `beam` has 10 lines.
const std::string shaker =
    "[[motion]]\ntype = \"harmonic-motion\"\nat = \"left\"\namplitude_mm = 3\nfrequency_Hz = 24\n";
const std::string offset = "[[motion]]\ntype = \"static-motion\"\nat_m = 12.5\ndisplacement_mm = -40\n";
const std::string recorded = "[[motion]]\ntype = \"table\"\nat = \"right\"\nhistory = [[0, 0], [1.5, -20]]\n";
const std::string damper = "[[body]]\nat_m = 1.2\nmass_kg = 4\n";

const std::string spatial = "span.dimension=spatial";
const std::string twist = "section.GJ_N_m2=500";

}  // namespace

TEST_CASE("a shaken support has an amplitude across the span and a frequency") {
  const Motion motion = read(beam + shaker).motions.at(0);
  CHECK(motion.type == MotionType::harmonic_motion);
  CHECK(motion.support == End::left);
  CHECK_FALSE(motion.at.has_value());
  CHECK(motion.amplitude == 0.003);
  CHECK(motion.value() == 0.003);
  CHECK(motion.frequency == 24.0);
  CHECK_FALSE(motion.is_rotation());
  CHECK(motion.direction == Vector3{0, 1, 0});
  CHECK(read(beam + shaker, {"motion[0].frequency=mode 12"}).motions[0].frequency_mode == 12);
}

TEST_CASE("a support that rocks turns about z unless the motion names an axis") {
  const Motion motion = read(beam + shaker, {"motion[0].amplitude_deg=2"}).motions.at(0);
  CHECK(motion.is_rotation());
  check_close(motion.value(), 2 * degree, {.relative = 1e-15});
  CHECK(motion.direction == Vector3{0, 0, 1});
  const Motion twisted =
      read(beam + shaker, {"motion[0].amplitude_deg=2", "motion[0].direction=[-3, 0, 0]", spatial, twist}).motions[0];
  CHECK(twisted.direction == Vector3{-1, 0, 0});
}

TEST_CASE("a point of the span is moved by a signed displacement or rotation") {
  const Motion motion = read(beam + offset).motions.at(0);
  CHECK(motion.at == 12.5);
  CHECK_FALSE(motion.support.has_value());
  CHECK(motion.value() == -0.04);
  check_close(read(beam + offset, {"motion[0].rotation_deg=-5"}).motions[0].value(), -5 * degree, {.relative = 1e-15});
}

TEST_CASE("the history of a motion is in millimetres, or in degrees of rotation") {
  const Motion moved = read(beam + recorded).motions.at(0);
  REQUIRE(moved.history.size() == 2);
  CHECK(moved.history[1] == std::array{1.5, -0.02});
  CHECK(moved.value() == 1.0);
  const Motion turned = read(beam + recorded + "rotation = true\n").motions.at(0);
  CHECK(turned.is_rotation());
  CHECK(turned.history[1][0] == 1.5);
  check_close(turned.history[1][1], -20 * degree, {.relative = 1e-15});
  CHECK(turned.direction == Vector3{0, 0, 1});
}

TEST_CASE("a shaken support sets the cycle of a forced vibration") {
  CHECK(refusal(beam + shaker, {"analysis.type=forced", "analysis.cycles=5"}) == "accepted");
  CHECK(contains(refusal(beam + offset, {"analysis.type=forced", "analysis.cycles=5"}), "has no load that sets the"));
}

TEST_CASE("a motion lacks neither its kind nor its place nor its size") {
  CHECK(contains(refusal(beam + "[[motion]]\nat = \"left\"\n"),
                 "case.toml:11:1: motion[0].type: is missing; choose one of \"static-motion\", \"harmonic-motion\""));
  CHECK(contains(refusal(beam + "[[motion]]\ntype = \"static-motion\"\ndisplacement_mm = 1\n"),
                 "case.toml:11:1: motion[0]: one of `at`, `at_m` is missing"));
  CHECK(contains(refusal(beam + "[[motion]]\ntype = \"static-motion\"\nat = \"left\"\n"),
                 "motion[0]: one of `displacement_mm`, `rotation_deg` is missing"));
  CHECK(contains(refusal(beam + "[[motion]]\ntype = \"harmonic-motion\"\nat = \"left\"\nfrequency_Hz = 1\n"),
                 "motion[0]: one of `amplitude_mm`, `amplitude_deg` is missing"));
  CHECK(contains(refusal(beam + "[[motion]]\ntype = \"harmonic-motion\"\nat = \"left\"\namplitude_mm = 1\n"),
                 "motion[0]: one of `frequency_Hz`, `frequency` is missing"));
  CHECK(contains(refusal(beam + "[[motion]]\ntype = \"table\"\nat = \"left\"\n"),
                 "motion[0]: one of `history`, `history_file` is missing"));
}

TEST_CASE("a motion says its place, its size and its frequency once") {
  CHECK(contains(refusal(beam + shaker + "at_m = 3\n"),
                 "motion[0].at_m = 3: excludes `motion[0].at`, and both are given; keep one of `at`, `at_m`"));
  CHECK(contains(refusal(beam + shaker + "amplitude_deg = 3\n"), "excludes `motion[0].amplitude_mm`"));
  CHECK(contains(refusal(beam + shaker + "frequency = \"mode 2\"\n"), "excludes `motion[0].frequency_Hz`"));
  CHECK(contains(refusal(beam + offset + "rotation_deg = 3\n"), "excludes `motion[0].displacement_mm`"));
}

TEST_CASE("a motion refuses keys of another kind and values out of bounds") {
  CHECK(contains(refusal(beam + offset + "frequency_Hz = 3\n"), "belongs to type = \"harmonic-motion\""));
  CHECK(contains(refusal(beam + shaker + "rotation = true\n"), "belongs to type = \"table\""));
  CHECK(contains(refusal(beam + shaker, {"motion[0].frequency_Hz=0"}), "must be above 0; give the frequency in hertz"));
  CHECK(contains(refusal(beam + shaker, {"motion[0].frequency=mode"}), "must be \"mode \" and a number"));
  CHECK(contains(refusal(beam + shaker, {"motion[0].at=top"}), "is not a choice; choose one of \"left\", \"right\""));
  CHECK(
      contains(refusal(beam + offset, {"motion[0].at_m=-1"}),
               "must be at least 0; give the distance from the left support to the point that moves in metres, along"));
  CHECK(
      contains(refusal(beam + offset, {"motion[0].at_m=30.1"}),
               "motion[0].at_m = 30.1: lies outside the span; give a distance from the left support between 0 and 30"));
  CHECK(refusal(beam + offset, {"motion[0].at_m=30"}) == "accepted");
}

TEST_CASE("a history of motion has rising times and numbers in its rows") {
  CHECK(contains(refusal(beam + recorded, {"motion[0].history=[[0, 0], [1, 2], [1, 3]]"}),
                 "motion[0].history[2] = [1, 3]: its time does not come after the one before; give rows of rising"));
  CHECK(contains(refusal(beam + recorded, {"motion[0].history=[[0, 0, 0]]"}), "must be a row of 2 numbers"));
  CHECK(contains(refusal(beam + recorded, {"motion[0].history=[[0, \"x\"]]"}), "give displacement in millimetres"));
  CHECK(contains(refusal(beam + recorded + "rotation = true\n", {"motion[0].history=[[0, \"x\"]]"}),
                 "give rotation in degrees"));
}

TEST_CASE("a motion follows one axis and stays in the plane of a planar span") {
  const auto along = [](const char* direction, const std::string& motion = offset) {
    return refusal(beam + motion + "direction = " + direction + "\n");
  };
  CHECK(along("[2, 0, 0]") == "accepted");
  CHECK(along("[0, -1, 0]") == "accepted");
  CHECK(contains(along("[3, 4, 0]"),
                 "case.toml:15:1: motion[0].direction = [3, 4, 0]: does not lie along x, y or z; give one [[motion]] "
                 "per axis"));
  CHECK(contains(along("[0, 0, 0]"), "has no length"));
  CHECK(contains(along("[0, 0, 1]"), "motion[0].direction = [0, 0, 1]: leaves the plane of x and y"));
  const std::string turned = "[[motion]]\ntype = \"static-motion\"\nat = \"left\"\nrotation_deg = 1\n";
  CHECK(contains(along("[0, 1, 0]", turned), "turns the span out of the plane"));
  CHECK(contains(along("[1, 0, 0]", turned), "turns the span out of the plane"));
  CHECK(along("[0, 0, -1]", turned) == "accepted");
  CHECK(refusal(beam + offset, {"motion[0].direction=[0, 0, 1]", spatial, twist}) == "accepted");
  CHECK(contains(refusal(beam + offset, {"motion[0].direction=[0, 1, 1]", spatial, twist}), "does not lie along"));
}

TEST_CASE("a body has a mass or an inertia or a spring and a damper to the ground") {
  const Body body = read(beam + damper, {"body[0].inertia_kg_m2=0.02", "body[0].stiffness_N_per_m=1e4",
                                         "body[0].damping_N_s_per_m=30", "body[0].direction=[3, 4, 0]"})
                        .bodies.at(0);
  CHECK(body.at == 1.2);
  CHECK(body.mass == 4.0);
  CHECK(body.inertia == 0.02);
  CHECK(body.stiffness == 1e4);
  CHECK(body.damping == 30.0);
  check_close(body.direction.value()[0], 0.6, {.relative = 1e-15});
  check_close(body.direction.value()[1], 0.8, {.relative = 1e-15});
  CHECK(read(beam + damper).bodies[0].direction == Vector3{0, 1, 0});
  for (const char* one : {"mass_kg", "inertia_kg_m2", "stiffness_N_per_m", "damping_N_s_per_m"}) {
    CHECK(refusal(beam + "[[body]]\nat_m = 1\n" + one + " = 1\n") == "accepted");
  }
}

TEST_CASE("a body that is nothing or nowhere is refused") {
  CHECK(contains(refusal(beam + damper, {"body[0].mass_kg=0"}),
                 "body[0]: has neither mass nor spring nor damper; give one of mass_kg, inertia_kg_m2, "
                 "stiffness_N_per_m, damping_N_s_per_m above 0"));
  CHECK(contains(refusal(beam + "[[body]]\nmass_kg = 1\n"), "case.toml:11:1: body[0].at_m: is missing"));
  CHECK(contains(refusal(beam + damper, {"body[0].at_m=31"}), "body[0].at_m = 31: lies outside the span"));
  for (const char* key : {"mass_kg", "inertia_kg_m2", "stiffness_N_per_m", "damping_N_s_per_m", "at_m"}) {
    CHECK(contains(refusal(beam + damper, {std::string("body[0].") + key + "=-1"}), "must be at least 0; give the "));
  }
  CHECK(contains(refusal(beam + damper, {"body[0].direction=[0, 0, 1]"}), "body[0].direction = [0, 0, 1]: leaves the"));
  CHECK(contains(refusal(beam + damper, {"body[0].direction=[0, 0, 0]"}), "has no length"));
  CHECK(refusal(beam + damper, {"body[0].direction=[0, 1, 1]", spatial, twist}) == "accepted");
}
