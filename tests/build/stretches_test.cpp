#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "casefile/texts.hpp"
#include "strandyn/build/dampers.hpp"
#include "strandyn/build/span.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using section::Component;
using section::Dimension;
using section::Field;
using test::check_close;

namespace {

/// [N m^2] of a virgin section at each point of a span.
std::vector<double> bending_stiffness(const build::BuiltSpan& span) {
  const std::size_t points = span.section_points();
  Field strains(Dimension::planar, points), stresses(Dimension::planar, points);
  section::TangentField tangents(Dimension::planar, points);
  std::ranges::fill(strains[Component::axial], 5e-4);
  const section::History history = span.model.law->start(strains);
  span.model.law->respond(history, strains, stresses, &tangents);
  std::vector<double> EI;
  for (std::size_t i = 0; i < points; ++i) EI.push_back(tangents(Component::bending2, Component::bending2)[i]);
  return EI;
}

double total_mass(const build::BuiltSpan& span) {
  double mass = span.model.inertia.mass * span.model.unstressed_length();
  for (const model::Body& body : span.model.bodies) mass += body.mass;
  return mass;
}

}  // namespace

TEST_CASE("stretches: armour rods stiffen and weigh where they lie and nowhere else") {
  const std::string rods = "[[span.stretch]]\nfrom_m = 10\nto_m = 12.5\narmour_rods = { rods = 12, diameter_mm = 8";
  const build::BuiltSpan bare = build::build_span(test::read(test::lab_span));
  for (const bool bonded : {false, true}) {
    const build::BuiltSpan span =
        build::build_span(test::read(test::lab_span + rods + (bonded ? ", bonded = true }\n" : " }\n")));
    const double area = std::numbers::pi * 16e-6, own = 69e9 * area * 16e-6 / 4;
    const double radius = (bare.numbers.diameter + 8e-3) / 2;
    const double extra = 12 * (own + (bonded ? 69e9 * area * radius * radius / 2 : 0));
    const std::vector<double> EI = bending_stiffness(span);
    const std::vector<double> arc = model::arc_lengths(span.model);
    double stiffened = 0;
    for (std::size_t e = 0; e + 1 < arc.size(); ++e) {
      const double middle = (arc[e] + arc[e + 1]) / 2;
      const bool within = middle > 10 && middle < 12.5;
      if (within) stiffened += arc[e + 1] - arc[e];
      for (const std::size_t g : {0u, 1u}) {
        check_close(EI[2 * e + g], bare.numbers.EI_max + (within ? extra : 0), {.relative = 1e-9});
      }
    }
    check_close(stiffened, 2.5, {.relative = 1e-9});
    const double unstressed = 2.5 / (1 + span.tension / span.numbers.EA);
    check_close(total_mass(span) - total_mass(bare), 12 * area * 2700 * unstressed, {.relative = 1e-9});
  }
}

TEST_CASE("stretches: another conductor has its own stiffness and mass under the same tension") {
  const build::BuiltSpan span = build::build_span(
      test::read(test::lab_span + "[[span.stretch]]\nfrom_m = 20\nto_m = 30\nconductor = { catalogue = \"drake\" }\n"));
  casefile::Scene drake = test::read(test::lab_span);
  drake.conductor = test::read(test::lab_span, {"conductor.catalogue=drake"}).conductor;
  const build::SectionNumbers numbers = build::section_numbers(drake);
  const std::vector<double> EI = bending_stiffness(span);
  check_close(EI.front(), span.numbers.EI_max, {.relative = 1e-9});
  check_close(EI.back(), numbers.EI_max, {.relative = 1e-9});
  double mass = 0;
  for (const beam::SpatialElement& element : span.model.elements) {
    const bool is_drake =
        &element - span.model.elements.data() >= static_cast<long>(model::nearest_node(span.model, 20));
    const double EA = is_drake ? numbers.EA : span.numbers.EA;
    check_close(EA * (element.span.norm() / element.length - 1), 24.4e3, {.relative = 1e-9});
    mass += element.length * (is_drake ? 1.628 : 1.981);
  }
  check_close(total_mass(span), mass, {.relative = 1e-9});
}

TEST_CASE("weight: a hanging line weighs what hangs on it") {
  const std::string hanging = R"([conductor]
catalogue = "drake"
[section]
law = "stick"
[span]
length_m = 100
tension_kN = 20
elements = 100
gravity = true
[analysis]
type = "forced"
cycles = 1
[[load]]
type = "harmonic-force"
at_m = 30
amplitude_N = 20
frequency_Hz = 12
[[body]]
at_m = 50
mass_kg = 5
[[damper]]
at_m = 2
catalogue = "z5"
[[span.stretch]]
from_m = 0
to_m = 1
armour_rods = { rods = 10, diameter_mm = 8 }
)";
  const build::BuiltSpan span = build::build_span(test::read(hanging));
  double weight = 0;
  for (const model::Load& load : span.model.loads) {
    if (load.dead) weight -= load.force.y();
  }
  const double z5 = 0.3532 + 0.8633 + 0.7652 + (0.157 + 0.113) * 7800 * 9.85e-5;
  const double rods = 10 * std::numbers::pi * 16e-6 * 2700 * span.model.unstressed_length() / 100;
  const double own = 1.628 * span.model.unstressed_length();
  check_close(weight, 9.80665 * (own + 5 + z5 + rods), {.relative = 1e-4});
}

TEST_CASE("dampers: a messenger may be a strand of the catalogue") {
  const std::string damper = "[[damper]]\nat_m = 1\ncatalogue = \"z5\"\n";
  const casefile::Scene scene = test::read(
      test::lab_span + damper +
      "messenger = { conductor = { catalogue = \"messenger-19-225\" }, law = \"return-map\", points = 12 }\n");
  const damper::Messenger messenger = build::messenger_of(scene.dampers[0]);
  CHECK(messenger.law->name() == "return-map");
  check_close(messenger.mass_per_length, 0.5986, {.relative = 2e-3});
  CHECK(scene.dampers[0].lengths == std::vector{0.157, 0.113});
  CHECK_THROWS_WITH_AS(
      test::read(test::lab_span + damper +
                 "messenger = { conductor = { catalogue = \"messenger-19-225\" }, law = \"elastic\" }\n"),
      doctest::Contains("damper[0].messenger.law"), InputError);
  CHECK_THROWS_WITH_AS(test::read(test::lab_span + damper +
                                  "messenger = { conductor = { catalogue = \"messenger-19-225\" }, EI_N_m2 = 3 }\n"),
                       doctest::Contains("EI_N_m2"), InputError);
}
