// The compliant law against itself written another way.
#include "conductor/strands.hpp"
#include "section/one_point.hpp"
#include "section/one_spatial_point.hpp"
#include "section/plain_compliant.hpp"
#include "section/random_paths.hpp"
#include "strandyn/section/spatial_compliant.hpp"
#include "support/check_close.hpp"

using namespace strandyn::section;
using strandyn::conductor::section_constants;
using strandyn::conductor::Strand;
using strandyn::test::check_close;
using strandyn::test::curlew;
using strandyn::test::OnePoint;
using strandyn::test::OneSpatialPoint;
using strandyn::test::PlainCompliant;
using strandyn::test::Random;
using strandyn::test::steel_1x6;

TEST_CASE("compliant law: equals the plain one on random paths with moving tension and opening contacts") {
  const CompliantOptions options{.points = 8, .springs = 6, .smallest_slip = 1e-2};
  std::uint64_t stream = 40;
  for (const Strand& strand : {curlew(), curlew({.friction = 0.3, .residual_forces = false}), steel_1x6()}) {
    const CompliantLaw law(strand, options);
    Random random(++stream);
    const double EI = section_constants(strand).EI_max;
    for (double width : {0.002, 0.02, 0.1}) {
      OnePoint point(law, {.eps = 5e-4, .chi = 0});
      PlainCompliant plain(strand, options, 5e-4);
      double before = plain.step({.eps = 5e-4, .chi = 0}).stored;
      double chi = 0;
      for (int s = 0; s < 40; ++s) {
        chi += width * random.between(-1, 1);
        const double eps = 5e-4 * random.between(-0.3, 2);
        const double M = point.respond({.eps = eps, .chi = chi}).M;
        const auto loss = point.commit({.eps = eps, .chi = chi});
        const auto expected = plain.step({.eps = eps, .chi = chi});
        check_close(M, expected.M, {.absolute = 1e-10 * EI * 0.1}, "M");
        check_close(loss.stored, expected.stored, {.relative = 1e-10}, "stored");
        check_close(loss.dissipated - loss.quadrature_error, expected.lost, {.absolute = 1e-10 * before}, "loss");
        before = expected.stored;
      }
    }
  }
}

TEST_CASE("compliant law in space: equals the plain one on random paths with tension, twist and opening contacts") {
  const CompliantOptions options{.points = 8, .springs = 6, .smallest_slip = 1e-2};
  std::uint64_t stream = 60;
  for (const Strand& strand : {curlew(), curlew({.friction = 0.3, .residual_forces = false}), steel_1x6()}) {
    const SpatialCompliantLaw law(strand, options);
    Random random(++stream);
    const double EI = section_constants(strand).EI_max;
    for (double width : {0.002, 0.02, 0.1}) {
      OneSpatialPoint point(law, {.eps = 5e-4});
      PlainCompliant plain(strand, options, 5e-4, PlainCompliant::spatial);
      double before = plain.step({.eps = 5e-4}).stored;
      double chi2 = 0;
      double chi3 = 0;
      for (int s = 0; s < 10; ++s) {
        chi2 += width * random.between(-1, 1);
        chi3 += width * random.between(-1, 1);
        const double eps = 5e-4 * random.between(-0.3, 2);
        const double twist = 0.02 * random.between(-1, 1);
        const auto got = point.respond({.eps = eps, .chi1 = twist, .chi2 = chi2, .chi3 = chi3});
        const auto loss = point.commit({.eps = eps, .chi1 = twist, .chi2 = chi2, .chi3 = chi3});
        const auto expected = plain.step({.eps = eps, .chi = chi2, .chi3 = chi3, .twist = twist});
        check_close(got.M2, expected.M, {.absolute = 1e-10 * EI * 0.1}, "M2");
        check_close(got.M3, expected.M3, {.absolute = 1e-10 * EI * 0.1}, "M3");
        check_close(loss.stored, expected.stored, {.relative = 1e-10}, "stored");
        check_close(loss.dissipated - loss.quadrature_error, expected.lost, {.absolute = 1e-10 * before}, "loss");
        before = expected.stored;
      }
    }
  }
}
