#include "strandyn/beam/planar_lanes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "beam/states.hpp"
#include "support/check_close.hpp"

using namespace strandyn::beam;
using strandyn::test::check_close;
using strandyn::test::RandomBeam;

namespace {

constexpr Inertia inertia{.mass = 2, .rotary = 0};

/// A chain of any elements whose nodes lie anywhere: turned up to two turns, elements bent by a fraction of a radian.
struct Chain {
  Chain(unsigned seed, std::size_t elements) : random(seed) {
    double turn = random.between(-12, 12);
    u.assign(3, 0.0);
    u[2] = turn;
    for (std::size_t e = 0; e < elements; ++e) {
      element.push_back(random.element());
      const Eigen::Vector2d chord = strandyn::test::turned(element[e].span, turn + random.between(-0.1, 0.1));
      turn += random.between(-0.2, 0.2);
      const std::size_t last = 3 * e;
      u.push_back(u[last] + chord.x() - element[e].span.x() + random.between(-0.05, 0.05));
      u.push_back(u[last + 1] + chord.y() - element[e].span.y() + random.between(-0.05, 0.05));
      u.push_back(turn);
    }
    v = numbers(2);
    a = numbers(3);
  }
  std::vector<double> numbers(double size) {
    std::vector<double> out(u.size());
    std::generate(out.begin(), out.end(), [&] { return random.between(-size, size); });
    return out;
  }
  /// Of a batch: as many as two for each element, in whole blocks of eight.
  strandyn::AlignedVector points(double size) {
    strandyn::AlignedVector out((2 * element.size() + 7) / 8 * 8, 0.0);
    std::generate(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(2 * element.size()),
                  [&] { return random.between(-size, size); });
    return out;
  }
  static PlanarVector of(const std::vector<double>& all, std::size_t e) {
    return Eigen::Map<const PlanarVector>(all.data() + 3 * e);
  }

  RandomBeam random;
  std::vector<PlanarElement> element;
  std::vector<double> u, v, a;
};

void add(const PlanarVector& force, std::size_t e, std::vector<double>& f) {
  Eigen::Map<PlanarVector>(f.data() + 3 * e) += force;
}

void check_same(const PlanarMatrix& K, const PlanarMatrix& expected) {
  check_close((K - expected).norm(), 0, {.absolute = 1e-14 * expected.norm()});
}

void check_same(const std::vector<double>& values, const std::vector<double>& expected) {
  REQUIRE(values.size() == expected.size());
  double size = 0;
  for (double x : expected) size = std::max(size, std::abs(x));
  for (std::size_t i = 0; i < values.size(); ++i) check_close(values[i], expected[i], {.absolute = 1e-14 * (1 + size)});
}

}  // namespace

TEST_CASE("planar lanes: strains and internal forces are those of every element by itself") {
  for (const std::size_t elements : {1u, 3u, 4u, 5u, 17u}) {
    Chain chain(static_cast<unsigned>(elements), elements);
    PlanarLanes lanes(chain.element, inertia.mass);
    strandyn::AlignedVector eps = chain.points(1);
    strandyn::AlignedVector chi = eps;
    const strandyn::AlignedVector N = chain.points(5);
    const strandyn::AlignedVector M = chain.points(5);
    lanes.find_strains(chain.u.data(), eps.data(), chi.data());
    std::vector<double> f = chain.numbers(1);
    std::vector<double> expected = f;
    lanes.add_internal_force(N.data(), M.data(), f.data());
    for (std::size_t e = 0; e < elements; ++e) {
      const PlanarKinematics k = kinematics(chain.element[e], Chain::of(chain.u, e));
      const PlanarKinematics here = lanes.kinematics(e);
      check_close(here.chord, k.chord, {.relative = 1e-14});
      check_close((here.direction - k.direction).norm(), 0, {.absolute = 1e-14});
      check_close(here.eps, k.eps, {.absolute = 1e-14});
      for (std::size_t g = 0; g < gauss_points; ++g) {
        check_close(here.rotation[g], k.rotation[g], {.absolute = 1e-14});
        check_close(here.chi[g], k.chi[g], {.absolute = 1e-13});
        CHECK(eps[2 * e + g] == here.eps);
        CHECK(chi[2 * e + g] == here.chi[g]);
      }
      const PlanarResultants r{.N = {N[2 * e], N[2 * e + 1]}, .M = {M[2 * e], M[2 * e + 1]}};
      add(internal_force(chain.element[e], k, r), e, expected);
    }
    for (std::size_t point = 2 * elements; point < eps.size(); ++point) {
      CHECK(eps[point] == 0);
      CHECK(chi[point] == 0);
    }
    check_same(f, expected);
  }
}

TEST_CASE("planar lanes: inertia is that of every element by itself, at one position after the other") {
  for (const std::size_t elements : {1u, 4u, 6u}) {
    Chain chain(static_cast<unsigned>(elements), elements);
    PlanarLanes lanes(chain.element, inertia.mass);
    for (int position = 0; position < 3; ++position) {
      std::vector<double> f = chain.numbers(1);
      std::vector<double> expected = f;
      double energy = 0;
      lanes.add_inertia_force(chain.u.data(), chain.v.data(), chain.a.data(), f.data());
      for (std::size_t e = 0; e < elements; ++e) {
        const PlanarElement& element = chain.element[e];
        const PlanarMotion m{.q = Chain::of(chain.u, e), .v = Chain::of(chain.v, e), .a = Chain::of(chain.a, e)};
        add(consistent_inertia_force(element, inertia, m), e, expected);
        energy += kinetic_energy(element, inertia, m.q, m.v);
      }
      check_same(f, expected);
      check_close(lanes.kinetic_energy(chain.u.data(), chain.v.data()), energy, {.relative = 1e-13});
      // One rotation alone is another position.
      chain.u[3 * static_cast<std::size_t>(position) % chain.u.size() + 2] += 0.3;
    }
  }
}

TEST_CASE("planar lanes: tangents are those of every element by itself, for any section and any factors") {
  for (const std::size_t elements : {1u, 4u, 7u}) {
    Chain chain(static_cast<unsigned>(elements), elements);
    PlanarLanes lanes(chain.element, inertia.mass);
    strandyn::AlignedVector eps = chain.points(1);
    strandyn::AlignedVector chi = eps;
    const strandyn::AlignedVector N = chain.points(5), M = chain.points(5);
    const strandyn::AlignedVector N_eps = chain.points(9), N_chi = chain.points(9), M_eps = chain.points(9),
                                  M_chi = chain.points(9);
    const InertiaFactors factors{.acceleration = 1.3, .velocity = 0.7, .position = 1.9};
    lanes.find_strains(chain.u.data(), eps.data(), chi.data());
    lanes.find_tangents(N.data(), M.data(),
                        {.N_eps = N_eps.data(), .N_chi = N_chi.data(), .M_eps = M_eps.data(), .M_chi = M_chi.data()});
    lanes.find_inertia_tangents(chain.u.data(), chain.v.data(), chain.a.data(), factors);
    for (std::size_t e = 0; e < elements; ++e) {
      const PlanarElement& element = chain.element[e];
      const PlanarMotion m{.q = Chain::of(chain.u, e), .v = Chain::of(chain.v, e), .a = Chain::of(chain.a, e)};
      const auto two = [e](const strandyn::AlignedVector& x) { return std::array{x[2 * e], x[2 * e + 1]}; };
      check_same(lanes.tangent(e),
                 tangent(element, kinematics(element, m.q), {.N = two(N), .M = two(M)},
                         {.N_eps = two(N_eps), .N_chi = two(N_chi), .M_eps = two(M_eps), .M_chi = two(M_chi)}));
      check_same(lanes.inertia_tangent(e), consistent_inertia_tangent(element, inertia, m, factors));
    }
  }
}

TEST_CASE("planar lanes: a chain at rest has no strain, and one that turns as a body keeps none") {
  const std::vector<PlanarElement> straight(5, {.span = {0.3, 0}, .length = 0.3, .rest_angle = 0});
  PlanarLanes lanes(straight, inertia.mass);
  strandyn::AlignedVector eps(16, 1.0);
  strandyn::AlignedVector chi(16, 1.0);
  std::vector<double> u(18, 0.0);
  lanes.find_strains(u.data(), eps.data(), chi.data());
  for (std::size_t point = 0; point < 10; ++point) {
    CHECK(eps[point] == 0);
    CHECK(chi[point] == 0);
  }
  for (const double turn : {0.7, 1.6, 3.1, -3.1, 9.0, -40.0}) {
    for (std::size_t node = 0; node < 6; ++node) {
      const double x = 0.3 * static_cast<double>(node);
      u[3 * node] = x * std::cos(turn) - x;
      u[3 * node + 1] = x * std::sin(turn);
      u[3 * node + 2] = turn;
    }
    lanes.find_strains(u.data(), eps.data(), chi.data());
    for (std::size_t point = 0; point < 10; ++point) {
      check_close(eps[point], 0, {.absolute = 1e-14});
      check_close(chi[point], 0, {.absolute = 1e-12});
    }
  }
}
