#include "strandyn/exact/elastic_catenary.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "support/check_close.hpp"

using strandyn::exact::Catenary;
using strandyn::exact::CatenarySpan;
using strandyn::exact::ElasticCatenary;
using strandyn::test::check_close;

namespace {

const CatenarySpan drake{.span = 300, .height_difference = 0, .weight_per_length = 1.628 * 9.80665};
constexpr double EA = 29e6;  // [N]

}  // namespace

TEST_CASE("elastic catenary: without stretch it is the catenary") {
  for (double h : {0.0, 40.0, -120.0}) {
    const CatenarySpan span{.span = 300, .height_difference = h, .weight_per_length = 16};
    const Catenary rigid = Catenary::from_horizontal_tension(span, 3e3);
    const ElasticCatenary elastic = ElasticCatenary::from_horizontal_tension(span, 1e18, 3e3);
    check_close(elastic.unstressed_length(), rigid.length(), {.relative = 1e-12});
    check_close(elastic.sag(), rigid.sag(), {.relative = 1e-11});
  }
}

TEST_CASE("elastic catenary: it ends at the right support and its forces balance the weight") {
  for (double h : {0.0, 30.0}) {
    CatenarySpan span = drake;
    span.height_difference = h;
    const ElasticCatenary cable = ElasticCatenary::from_horizontal_tension(span, EA, 28e3);
    const double L = cable.unstressed_length();
    check_close(cable.at(L).x, 300, {.relative = 1e-12});
    CHECK(std::abs(cable.at(L).y - h) < 1e-9);
    const double rise =
        cable.at(L).tension * std::sin(cable.at(L).angle) - cable.at(0).tension * std::sin(cable.at(0).angle);
    check_close(rise, span.weight_per_length * L, {.relative = 1e-12});
  }
}

TEST_CASE("elastic catenary: a piece of it is as long as its strain says") {
  const ElasticCatenary cable = ElasticCatenary::from_horizontal_tension(drake, EA, 28e3);
  const double s = 100;
  const double ds = 1e-3;
  const auto a = cable.at(s - ds);
  const auto b = cable.at(s + ds);
  check_close(std::hypot(b.x - a.x, b.y - a.y) / (2 * ds), 1 + cable.at(s).tension / EA, {.relative = 1e-9});
  check_close(std::atan2(b.y - a.y, b.x - a.x), cable.at(s).angle, {.relative = 1e-7});
}

TEST_CASE("elastic catenary: length and tension lead to each other from taut to nearly folded") {
  for (double H : {60e3, 28e3, 500.0}) {
    const ElasticCatenary cable = ElasticCatenary::from_horizontal_tension(drake, EA, H);
    check_close(ElasticCatenary::from_unstressed_length(drake, EA, cable.unstressed_length()).horizontal_tension(), H,
                {.relative = 1e-8});  // the length of a taut cable hardly says its tension
  }
  // Shorter than its chord: stretched by its tension less what the sag takes up, (w l/H)^2/24 of it.
  const ElasticCatenary taut = ElasticCatenary::from_unstressed_length(drake, EA, 299.0);
  const double H = taut.horizontal_tension();
  const double sag_strain = std::pow(drake.weight_per_length * 300 / H, 2) / 24;
  check_close(H / EA - sag_strain, 300.0 / 299 - 1, {.relative = 1e-3});
}

TEST_CASE("elastic catenary: a metre of cable hangs between supports a millimetre apart") {
  const CatenarySpan span{.span = 1e-3, .height_difference = 0, .weight_per_length = 16};
  const ElasticCatenary cable = ElasticCatenary::from_unstressed_length(span, EA, 1);
  check_close(cable.at(1).x, 1e-3, {.relative = 1e-9});
  CHECK(std::abs(cable.at(1).y) < 1e-9);
  check_close(-cable.at(0.5).y, 0.5, {.relative = 2e-3});
}
