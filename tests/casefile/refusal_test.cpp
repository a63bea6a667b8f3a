#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "strandyn/casefile/read.hpp"
#include "strandyn/core/error.hpp"
#include "texts.hpp"

using namespace strandyn;
using strandyn::test::contains;
using strandyn::test::lab_span;
using strandyn::test::refusal;

TEST_CASE("a refusal is one line: place, key, text found, what is wrong, what would be right") {
  std::string text = lab_span;
  text.replace(text.find("length_m = 30"), 13, "length_m = -4");
  CHECK(refusal(text) ==
        "case.toml:8:1: span.length_m = -4: must be above 0; give the distance between the supports in metres");
}

TEST_CASE("the text found is quoted as written, also behind letters of several bytes") {
  CHECK(contains(
      refusal("section = { law = \"élastique\", points = 36.5 }\n" + test::beam.substr(test::beam.find("[span]"))),
      "section.law = \"élastique\": is not a choice"));
  CHECK(
      contains(refusal("section = { title_ = \"é\", points = 36 }\n"), "case.toml:1:13: unknown key `section.title_`"));
  CHECK(contains(refusal("damping = { drag_N_s_per_m2 = -1_0.50, rayleigh = {} }\n" + test::beam),
                 "damping.drag_N_s_per_m2 = -1_0.50: must be at least 0"));
}

TEST_CASE("an error in an override names the override as its place") {
  CHECK(
      refusal(lab_span, {"span.length_m=-4"}) ==
      "--set span.length_m=-4: span.length_m = -4: must be above 0; give the distance between the supports in metres");
  CHECK(refusal(lab_span, {"section.law=sticky"})
            .starts_with("--set section.law=sticky: section.law = \"sticky\": "
                         "is not a choice; choose one of \"stick\""));
  CHECK(refusal(lab_span, {"spam.x=1"}).starts_with("--set spam.x=1: unknown table `spam`; did you mean `span`?"));
  CHECK(
      refusal(lab_span, {"load[0].force_N=2"}).starts_with("--set load[0].force_N=2: load[0].force_N = 2: belongs to"));
}

TEST_CASE("an override that leads nowhere says what one looks like") {
  for (const char* argument : {"x", "", "=3", "span.=3", "span..length_m=3", "span.length_m=", "span.length_m=[1",
                               "span.length_m=3 4", "span.length_m=1\nx=2", "load[1].at_m=3", "load[x].at_m=3",
                               "load.at_m=3", "span[0].length_m=3", "motion[0].x=1", "accept.\"a=1", "load[3]=1"}) {
    CAPTURE(argument);
    const std::string message = refusal(lab_span, {argument});
    CHECK(message.starts_with(std::string("--set ") + argument + ": "));
    CHECK(contains(message, "write KEY.PATH=VALUE"));
  }
}

TEST_CASE("two overrides that exclude each other are refused") {
  CHECK(contains(refusal(lab_span, {"span.tension_rts=0.2", "span.tension_kN=20"}), "excludes `span.tension_kN`"));
}

TEST_CASE("unknown keys with nothing near list the keys of the table") {
  CHECK(contains(refusal(test::beam + "[static]\nsolver = 1\n"),
                 "unknown key `static.solver`; `static` knows `control`"));
}

TEST_CASE("a key whose needed partner is missing is refused") {
  const auto with = [](const std::string& lines) { return refusal(test::beam + lines); };
  CHECK(contains(with("[initial]\nvelocity_mode = 3\n"), "initial.antinode_velocity_m_per_s: is missing"));
  CHECK(contains(refusal(test::beam, {"analysis.type=decay", "analysis.mode=1", "analysis.cycles=5"}),
                 "nothing else starts the motion"));
  CHECK(
      contains(refusal(test::beam, {"analysis.type=forced", "analysis.cycles=5"}), "has no load that sets the cycle"));
  CHECK(contains(refusal(test::beam, {"section.law=multilinear"}), "section.spring: is missing"));
  CHECK(contains(refusal(test::beam, {"span.dimension=spatial"}), "section.GJ_N_m2: is missing"));
  std::string massless = test::beam;
  massless.erase(massless.find("mass_kg_per_m"), std::string("mass_kg_per_m = 1.98\n").size());
  CHECK(contains(refusal(massless), "section.mass_kg_per_m: is missing, and the span needs a mass"));
  CHECK(refusal(massless, {"analysis.type=static"}) == "accepted");
}

TEST_CASE("a load that the plane cannot take is refused") {
  CHECK(contains(refusal(lab_span, {"load[0].direction=[0, 0, 1]"}), "leaves the plane"));
  CHECK(contains(refusal(lab_span, {"load[0].direction=[0, 0, 0]"}), "has no length"));
  CHECK(contains(refusal(lab_span, {"load[0].direction=[0, 1]"}), "must be three numbers"));
  CHECK(refusal(lab_span, {"load[0].direction=[0, 0, 1]", "span.dimension=spatial"}) == "accepted");
  for (const char* axis : {"[1, 0, 0]", "[0, 1, 0]"}) {
    CHECK(contains(refusal(lab_span, {"load[0].moment_N_m=5", std::string("load[0].direction=") + axis}),
                   "turns the span out of the plane"));
  }
}

TEST_CASE("a history that steps back in time is refused at the row") {
  const std::string load = "[[load]]\ntype = \"table\"\nper_length = true\nhistory = [[0, 0], [1, 5], [1, 6]]\n";
  CHECK(contains(refusal(test::beam + load),
                 "case.toml:14:28: load[0].history[2] = [1, 6]: its time does not come after"));
}

TEST_CASE("a path of [accept] without quotes, or that cannot be read, is refused") {
  CHECK(contains(refusal(test::beam + "[accept]\na.b = { below = 1, reason = \"r\" }\n"),
                 "accept.a: is a path without quotes"));
  CHECK(contains(refusal(test::beam + "[accept]\n\"a[first]\" = { below = 1, reason = \"r\" }\n"),
                 "[first] is none of a whole number, max, min, sum"));
  CHECK(contains(refusal(test::beam + "[accept]\n\"a\" = { below = 1, relative = 0.1, reason = \"r\" }\n"),
                 "has a deviation but no expected number"));
  CHECK(contains(refusal(test::beam + "[accept]\n\"a\" = { below = 1, reason = \" \" }\n"), "must not be empty"));
  CHECK(refusal(test::beam + "[accept]\nexit_code = { expected = 3, reason = \"r\" }\n") == "accepted");
}

TEST_CASE("a model builder can refuse a key later in the same form") {
  const casefile::Scene scene = strandyn::test::read(lab_span);
  const auto message = [&](const char* key) -> std::string {
    try {
      casefile::refuse(scene.source, key, "is wrong", "do it right");
    } catch (const InputError& error) {
      return error.what();
    }
  };
  CHECK(message("span.elements") == "case.toml:10:1: span.elements = 80: is wrong; do it right");
  CHECK(message("span.left") == "case.toml:7:2: span.left: is wrong; do it right");  // not in the file: its table
  CHECK(message("initial.velocity_mode") == "case.toml:1:1: initial.velocity_mode: is wrong; do it right");
}
