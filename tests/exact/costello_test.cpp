#include "strandyn/exact/costello.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "conductor/strands.hpp"
#include "strandyn/conductor/constants.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using namespace strandyn::exact;
using strandyn::test::check_close;

namespace {

AxialTorsionResponse fixed_end(const conductor::Strand& strand, double strain,
                               Contraction contraction = Contraction::poisson) {
  return costello(strand, {.strain = strain, .twist = 0}, contraction);
}

conductor::Strand left_hand(conductor::Strand strand) {
  strand.layers[1].lay_angle *= -1;
  return strand;
}

}  // namespace

TEST_CASE("Costello: the 1/6 strand at small and at large strain, with Poisson contraction") {
  const auto strand = test::steel_1x6();
  struct Known {
    double strain, fixed_k1_kN, fixed_k2_per_mm, free_k1_kN;
  };
  for (const Known& known : {Known{1e-6, 13707, 1.579, 9160}, Known{0.005, 13712, 1.591, 9376}}) {
    // The last digit given.
    const auto fixed = fixed_end(strand, known.strain);
    check_close(fixed.k1() / 1e3, known.fixed_k1_kN, {.absolute = 0.5}, "fixed end k1");
    check_close(fixed.k2() / 1e3, known.fixed_k2_per_mm, {.absolute = 5e-4}, "fixed end k2");
    check_close(costello_free_end(strand, known.strain, Contraction::poisson).k1() / 1e3, known.free_k1_kN,
                {.absolute = 0.5}, "free end k1");
  }
}

TEST_CASE("Costello: a free end carries no torque and unwinds the lay") {
  const auto strand = test::steel_1x6();
  const auto free = costello_free_end(strand, 0.002, Contraction::poisson);
  check_close(free.M, 0, {.absolute = 1e-12 * fixed_end(strand, 0.002).M});
  CHECK(free.deformation.twist < 0);
  CHECK(costello_free_end(strand, -0.002, Contraction::poisson).deformation.twist > 0);
}

TEST_CASE("Costello: a left-hand lay is the mirror image") {
  const auto strand = test::steel_1x6();
  const AxialTorsion right{.strain = 0.003, .twist = -0.4};
  const AxialTorsion left{.strain = 0.003, .twist = 0.4};
  const auto a = costello(strand, right, Contraction::poisson);
  const auto b = costello(left_hand(strand), left, Contraction::poisson);
  check_close(b.N, a.N, {.relative = 1e-15});
  check_close(b.M, -a.M, {.relative = 1e-15});
  check_close(costello_free_end(left_hand(strand), 0.003, Contraction::poisson).k1(),
              costello_free_end(strand, 0.003, Contraction::poisson).k1(), {.relative = 1e-14});
}

TEST_CASE("Costello: without contraction the small-strain stiffness is the linearised one") {
  const auto strand = test::steel_1x6();
  const auto linear = conductor::section_constants(strand);
  const conductor::Layer& layer = strand.layers[1];
  const double h = 1e-7;  // second order in the strain and 1e-16/h of rounding both stay below 1e-5
  const double c = std::cos(layer.lay_angle);
  const double s = std::sin(layer.lay_angle);
  const double r = layer.helix_radius;
  const double EI = layer.EI_wire();
  const double GJ = EI / (1 + layer.poisson);

  // Per unit of strain the lay closes by s c: bending, torsion and shear force of a wire, by hand.
  const auto stretched = costello(strand, {.strain = h, .twist = 0}, Contraction::none);
  const double G = -2 * EI * s * s * c * c / r;
  const double H = -GJ * (c * c - s * s) * s * c / r;
  const double N_2 = (H * s * s - G * s * c) / r;
  check_close(stretched.N / h, linear.EA + layer.wires * N_2 * s, {.relative = 1e-5});
  check_close(stretched.M / h, linear.C_AT + layer.wires * (H * c + G * s - r * N_2 * c), {.relative = 1e-5});

  // The constants of `conductor` leave the shear force of the wires out of N: 0.3 % of C_AT (measured).
  const double turn = h / r;
  const auto twisted = costello(strand, {.strain = 0, .twist = turn}, Contraction::none);
  check_close(twisted.N / turn, linear.C_AT, {.relative = 0.004});
}

TEST_CASE("Costello: straight wires stretch and twist apart") {
  auto strand = test::steel_1x6();
  strand.layers[1].lay_angle = 0;
  const auto linear = conductor::section_constants(strand);
  const auto pulled = costello(strand, {.strain = 0.001, .twist = 0}, Contraction::none);
  check_close(pulled.N, linear.EA * 0.001, {.relative = 1e-14});
  check_close(pulled.M, 0, {});
  check_close(costello_free_end(strand, 0.001, Contraction::none).deformation.twist, 0, {});
}

TEST_CASE("Costello: refuses a strand of several layers") {
  CHECK_THROWS_AS(fixed_end(test::curlew(), 0.001), std::invalid_argument);
}
