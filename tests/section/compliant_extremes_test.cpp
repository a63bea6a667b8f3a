// Bounds of the compliant law, and strands and states at the ends of what a user can give.
#include <cmath>
#include <numbers>

#include "conductor/strands.hpp"
#include "section/battery.hpp"
#include "section/one_point.hpp"
#include "section/random_paths.hpp"
#include "strandyn/conductor/constants.hpp"
#include "strandyn/conductor/contact.hpp"
#include "strandyn/conductor/hertz.hpp"
#include "strandyn/section/compliant.hpp"
#include "support/check_close.hpp"

using namespace strandyn::section;
using strandyn::conductor::Layer;
using strandyn::conductor::section_constants;
using strandyn::conductor::SectionConstants;
using strandyn::conductor::Strand;
using strandyn::test::check_close;
using strandyn::test::curlew;
using strandyn::test::degrees;
using strandyn::test::OnePoint;
using strandyn::test::round_layer;
using strandyn::test::steel_1x6;

namespace {

Strand one_wire() {
  Strand strand;
  strand.layers = {round_layer(1, 4e-3, 0, 200e9)};
  return strand;
}

Strand straight_wires(double residual_force) {
  Strand strand = curlew({.residual_forces = false});
  for (Layer& layer : strand.layers) layer.lay_angle = 0;
  strand.layers.back().residual_force = residual_force;
  return strand;
}

/// Stiffness of Curlew while no spring slides: k e = q + k_w u of every layer, found by going round and round. Slips
/// count along the strand, so that the interface between two layers sees their difference, whatever the lays.
double stiffness_of_elastic_contacts(const Strand& strand, double eps) {
  using namespace strandyn::conductor;
  const SectionConstants c = section_constants(strand);
  const auto forces = contact_forces(strand, axial_wire_forces(strand, eps, 0));
  const auto geometry = contact_geometry(strand);
  const auto faces = interfaces(strand);
  const std::size_t layers = strand.layers.size();
  std::vector<double> K(layers + 1), demand(layers), k_w(layers), length(layers), ratio(layers + 1, 1.0), U(layers + 1);
  for (std::size_t j = 1; j < layers; ++j) {
    const Layer& wire = strand.layers[j];
    const double sine = std::sin(wire.lay_angle);
    length[j] = wire.wires / geometry[j].cos_lay;
    K[j] = length[j] * faces[j].stiffness(geometry[j].c_int * forces[j].f_int, faces[j].per_outer_wire).value;
    demand[j] = length[j] * wire.EA_wire() * geometry[j].cos_lay * geometry[j].cos_lay * sine;
    k_w[j] = length[j] * wire.EA_wire() * std::pow(sine / wire.helix_radius, 2);
    // The two contact helices of an interface differ in length by a hair.
    if (j > 1) {
      ratio[j] = geometry[j - 1].c_ext / geometry[j].c_int * geometry[j].cos_lay / geometry[j - 1].cos_lay;
    }
  }
  for (int round = 0; round < 2000; ++round) {
    for (std::size_t j = 1; j < layers; ++j) {
      const double pull = demand[j] + K[j] * ratio[j] * U[j - 1] + K[j + 1] * ratio[j + 1] * U[j + 1];
      U[j] = pull / (k_w[j] + K[j] + K[j + 1] * ratio[j + 1] * ratio[j + 1]);
    }
  }
  double EI = c.EI_min;
  for (std::size_t j = 1; j < layers; ++j) EI += c.EI_friction[j] * (1 - k_w[j] * U[j] / demand[j]);
  return EI;
}

}  // namespace

TEST_CASE("compliant law: options that cannot be are refused in words") {
  CHECK_FALSE(find_fault(CompliantOptions{}));
  CHECK(find_fault(CompliantOptions{.points = 34}));
  CHECK(find_fault(CompliantOptions{.springs = 3}));
  CHECK(find_fault(CompliantOptions{.smallest_slip = 1}));
  CHECK(find_fault(CompliantOptions{.compliance_scale = 0}));
  Strand strand = curlew();
  while (strand.layers.size() <= most_compliant_layers + 1) strand.layers.push_back(strand.layers.back());
  CHECK_THROWS_AS(CompliantLaw{strand}, std::invalid_argument);
}

TEST_CASE("compliant law: of all springs of a contact the smallest one is the first to slide") {
  // What bounds the springs that slide on takes it for granted.
  for (const Strand& strand : {curlew(), steel_1x6()}) {
    for (int springs : {4, 17, 64}) {
      for (double smallest : {1e-6, 3e-5, 0.03}) {
        const auto c = compliant_coefficients(strand, {.springs = springs, .smallest_slip = smallest});
        for (const auto& layer : c.layers) {
          for (const SpringTable& table : layer.chains) {
            for (std::size_t side : {0U, 1U}) {
              const auto pull = [&](std::size_t i) {
                const double* row = table.row(i);
                return row[2 * SpringTable::kappa + side] / row[2 * SpringTable::phi + side];
              };
              for (std::size_t i = 1; i < table.springs(); ++i) CHECK(pull(i) < pull(0));
            }
          }
        }
      }
    }
  }
}

TEST_CASE("compliant law: a small curvature meets the wires and their elastic contacts in series, less than EI_max") {
  const Strand strand = curlew();
  const CompliantLaw law(strand);
  OnePoint point(law, {.eps = 5e-4, .chi = 0});
  const double EI = stiffness_of_elastic_contacts(strand, 5e-4);
  CHECK(EI < section_constants(strand).EI_max);
  CHECK(EI > 0.75 * section_constants(strand).EI_max);
  check_close(point.respond({.eps = 5e-4, .chi = 0}).dM_dchi, EI, {.relative = 1e-12});
  check_close(point.respond({.eps = 5e-4, .chi = 1e-12}).M, EI * 1e-12, {.relative = 1e-12});
  CHECK(point.commit({.eps = 5e-4, .chi = 1e-12}).dissipated == 0);
}

TEST_CASE("compliant law: at constant tension the tangent stays between EI_min and EI_max, and M below EI_max chi") {
  // The limits follow the bending force, too, and could soften a section below EI_min; on these paths they do not.
  const Strand strand = curlew();
  const SectionConstants c = section_constants(strand);
  const CompliantLaw law(strand);
  const strandyn::test::LawDescription what{.curvature = 0.1, .strain = 5e-4};
  const auto path = strandyn::test::random_paths(Dimension::planar, what,
                                                 {.points = 200, .steps = 60, .axial_moves = false, .stream = 51});
  History history = law.start(path[0]);
  StepEnergy energy(200);
  Field stresses(Dimension::planar, 200);
  TangentField tangents(Dimension::planar, 200);
  double least = 1e9;
  double most = 0;
  for (const Field& strains : path) {
    law.respond(history, strains, stresses, &tangents);
    law.commit(history, strains, energy);
    for (std::size_t i = 0; i < 200; ++i) {
      least = std::min(least, tangents(Component::bending2, Component::bending2)[i]);
      most = std::max(most, tangents(Component::bending2, Component::bending2)[i]);
    }
  }
  MESSAGE("tangent from ", least / c.EI_min, " EI_min to ", most / c.EI_max, " EI_max");
  CHECK(least >= c.EI_min);
  CHECK(most <= c.EI_max);
  for (double chi : {1e-6, 1e-3, 0.01, 0.1, 1.0, 100.0}) {
    const OnePoint point(law, {.eps = 5e-4, .chi = 0});
    CHECK(point.respond({.eps = 5e-4, .chi = chi}).M < c.EI_max * chi);
    CHECK(point.respond({.eps = 5e-4, .chi = chi}).M > c.EI_min * chi);
  }
}

TEST_CASE("compliant law: from 1e-12 to 1e2 1/m, under tension, slack and compression, everything is finite") {
  for (const Strand& strand : {curlew(), curlew({.residual_forces = false}), curlew({.friction = 1000}), steel_1x6(),
                               one_wire(), straight_wires(0), straight_wires(100)}) {
    REQUIRE_FALSE(find_fault(strand));
    const CompliantLaw law(strand);
    for (double start : {5e-4, 0.0, -5e-4}) {
      OnePoint point(law, {.eps = start, .chi = 0});
      for (double chi : {1e-12, -1e-12, 1e-6, 100.0, -100.0, 1e-12, 0.0}) {
        for (double eps : {start, 2e-3, 0.0, -2e-3}) {
          const auto answer = point.respond({.eps = eps, .chi = chi});
          CHECK(std::isfinite(answer.M));
          CHECK(std::isfinite(answer.dM_dchi));
          CHECK(std::isfinite(answer.dM_deps));
          const auto loss = point.commit({.eps = eps, .chi = chi});
          CHECK(std::isfinite(loss.stored));
          CHECK(std::isfinite(loss.dissipated));
          CHECK(std::isfinite(loss.quadrature_error));
          CHECK(loss.dissipated >= 0);
          CHECK(loss.quadrature_error >= 0);
        }
      }
    }
  }
}

TEST_CASE("compliant law: without friction EI_min is left and nothing is lost") {
  const Strand strand = curlew({.friction = 0});
  const CompliantLaw law(strand);
  OnePoint point(law, {.eps = 5e-4, .chi = 0});
  for (double chi : {0.0, 1e-9, 0.05, -0.1}) {
    CHECK(point.respond({.eps = 5e-4, .chi = chi}).M == section_constants(strand).EI_min * chi);
    CHECK(point.respond({.eps = 5e-4, .chi = chi}).dM_dchi == section_constants(strand).EI_min);
    CHECK(point.commit({.eps = 5e-4, .chi = chi}).dissipated == 0);
  }
}

TEST_CASE("compliant law: with friction beyond bounds the contacts are springs and lose nothing that counts") {
  const Strand strand = curlew({.friction = 1e8});
  const CompliantLaw law(strand);
  const double EI = stiffness_of_elastic_contacts(strand, 5e-4);
  OnePoint point(law, {.eps = 5e-4, .chi = 0});
  // At 0.04 1/m bending would unload wires on the compression side so far that contacts open.
  for (double chi : {1e-6, 0.02, -0.02}) {
    check_close(point.respond({.eps = 5e-4, .chi = chi}).M, EI * chi, {.relative = 1e-6});
    CHECK(point.commit({.eps = 5e-4, .chi = chi}).dissipated < 1e-6 * EI * chi * chi);
  }
}

TEST_CASE("compliant law: compression that opens every contact leaves EI_min, and loses all that friction had stored") {
  const SectionConstants c = section_constants(curlew());
  const CompliantLaw law(curlew());
  OnePoint point(law, {.eps = 5e-4, .chi = 0});
  const double stored = point.commit({.eps = 5e-4, .chi = 0.03}).stored;
  const auto opened = point.respond({.eps = -5e-3, .chi = 0.03});
  check_close(opened.M, c.EI_min * 0.03, {.relative = 1e-14});
  CHECK(opened.dM_dchi == c.EI_min);
  const double linear = c.EA * 5e-4 * 5e-4 / 2 + c.EI_min * 0.03 * 0.03 / 2;
  const auto loss = point.commit({.eps = -5e-3, .chi = 0.03});
  check_close(loss.dissipated - loss.quadrature_error - (stored - linear), 0, {.absolute = 1e-9 * stored});
}

TEST_CASE("compliant law: a single wire is a rod") {
  const CompliantLaw law(one_wire());
  const double EI = section_constants(one_wire()).EI_min;
  OnePoint point(law, {.eps = 5e-4, .chi = 0});
  check_close(point.respond({.eps = 5e-4, .chi = 0.1}).M, EI * 0.1, {.relative = 1e-15});
  CHECK(point.commit({.eps = 5e-4, .chi = 0.1}).dissipated == 0);
}

TEST_CASE("compliant law: a strand that starts slack and is pulled has the contacts of the tension it has come to") {
  const Strand strand = curlew();
  const CompliantLaw law(strand);
  OnePoint pulled(law, {.eps = -5e-3, .chi = 0});  // every contact open
  pulled.commit({.eps = 5e-4, .chi = 0});
  const OnePoint there(law, {.eps = 5e-4, .chi = 0});
  for (double chi : {1e-4, 0.03}) {
    CHECK(pulled.respond({.eps = 5e-4, .chi = chi}).M == there.respond({.eps = 5e-4, .chi = chi}).M);
  }
}

TEST_CASE("compliant law: a tension that vibrates does not wear out a force that is locked in") {
  const CompliantLaw law(curlew());
  OnePoint point(law, {.eps = 5e-4, .chi = 0});
  point.commit({.eps = 5e-4, .chi = 0.01});
  point.commit({.eps = 4.5e-4, .chi = 0.01});  // here the outermost springs give way to the lower limits, once
  point.commit({.eps = 5e-4, .chi = 0.01});
  const double M = point.respond({.eps = 5e-4, .chi = 0.01}).M;
  for (int cycle = 0; cycle < 100; ++cycle) {
    CHECK(point.commit({.eps = 4.5e-4, .chi = 0.01}).dissipated < 1e-13);
    point.commit({.eps = 5e-4, .chi = 0.01});
  }
  check_close(point.respond({.eps = 5e-4, .chi = 0.01}).M, M, {.relative = 1e-12});
}

TEST_CASE("compliant law: ten thousand cycles leave the loop where it was") {
  const CompliantLaw law(curlew());
  OnePoint point(law, {.eps = 5e-4, .chi = 0});
  const auto loop = [&] {
    double area = 0;
    for (double part : {0.5, 1.0, 0.5, 0.0, -0.5, -1.0, -0.5, 0.0}) {
      area += point.commit({.eps = 5e-4, .chi = 0.03 * part}).dissipated;
    }
    return area;
  };
  for (int cycle = 0; cycle < 10; ++cycle) loop();  // wires come to terms with each other
  const double second = loop();
  const double M = point.respond({.eps = 5e-4, .chi = 0}).M;
  for (int cycle = 0; cycle < 10'000; ++cycle) loop();
  check_close(loop(), second, {.relative = 1e-12});
  check_close(point.respond({.eps = 5e-4, .chi = 0}).M, M, {.relative = 1e-12});
}
