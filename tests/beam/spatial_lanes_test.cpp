#include "strandyn/beam/spatial_lanes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "beam/spatial_states.hpp"
#include "support/check_close.hpp"

using namespace strandyn::beam;
using strandyn::AlignedVector;
using strandyn::test::check_close;
using strandyn::test::RandomSpatialBeam;

namespace {

constexpr SpatialSectionInertia inertia{.mass = 2, .rotary = 0, .polar = 0.7};

struct Nodal {
  std::vector<double> u, v, a;
};

/// A chain of any elements, its nodes turned by up to `turn` [rad] in total and by `bend` from node to node, chords by
/// `lean` against these.
struct Scene {
  Scene(unsigned seed, std::size_t elements, double turn, double bend, double lean = 0) : random(seed) {
    Eigen::Matrix3d rotation = strandyn::math::rotation(turn * random.direction());
    Eigen::Vector3d shift = random.vector(1);
    for (std::size_t e = 0; e <= elements; ++e) {
      const Eigen::Vector3d psi = strandyn::math::rotation_vector(rotation);
      for (const Eigen::Vector3d& of_node : {shift, psi}) state.u.insert(state.u.end(), of_node.begin(), of_node.end());
      at_nodes.push_back({.mass = 0, .moment = moment()});
      if (e == elements) break;
      element.push_back(random.element());
      const Eigen::Matrix3d ahead = rotation * strandyn::math::rotation(random.between(0, bend) * random.direction());
      const Eigen::Matrix3d aside = strandyn::math::rotation(lean * random.direction());
      const Eigen::Vector3d chord = aside * (0.5 * (rotation + ahead) * element[e].span);
      shift += chord - element[e].span + random.vector(0.05);
      rotation = ahead;
    }
    state.v = numbers(2);
    state.a = numbers(3);
  }
  Eigen::Matrix3d moment() {
    const Eigen::Matrix3d axes = strandyn::math::rotation(random.vector(2));
    return axes * Eigen::Vector3d(0.4, 0.9, 1.1).asDiagonal() * axes.transpose();
  }
  std::vector<double> numbers(double size) {
    std::vector<double> out(state.u.size());
    std::ranges::generate(out, [&] { return random.between(-size, size); });
    return out;
  }
  /// Of a batch: as many as two for each element, in whole blocks of eight.
  AlignedVector points(double size) {
    AlignedVector out((2 * element.size() + 7) / 8 * 8, 0.0);
    std::generate(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(2 * element.size()),
                  [&] { return random.between(-size, size); });
    return out;
  }
  SpatialLanes lanes() const { return SpatialLanes({.elements = element, .inertia = inertia, .at_nodes = at_nodes}); }
  static SpatialVector of(const std::vector<double>& all, std::size_t e) {
    return Eigen::Map<const SpatialVector>(all.data() + 6 * e);
  }
  SpatialMotion motion(std::size_t e) const { return {.q = of(state.u, e), .v = of(state.v, e), .a = of(state.a, e)}; }
  RotationMotion turning(std::size_t node) const {
    const auto at = [node](const std::vector<double>& x) {
      return Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(x.data() + 6 * node + 3));
    };
    return {.psi = at(state.u), .rate = at(state.v), .acceleration = at(state.a)};
  }

  RandomSpatialBeam random;
  std::vector<SpatialElement> element;
  std::vector<RigidInertia> at_nodes;
  Nodal state;
};

/// Small swings, turns beyond the series' short cut, elements bent by more than a right angle, many, and elements whose
/// nodes stand across the chord or look backwards.
const Scene scenes[] = {Scene(1, 1, 0.1, 0.1),   Scene(2, 3, 1, 0.3),     Scene(3, 4, 2.5, 1),
                        Scene(4, 5, 3.1, 2.2),   Scene(5, 17, 0.3, 0.05), Scene(6, 9, 2, 0.3, 1.5),
                        Scene(8, 9, 1, 0.2, 2.5)};

using Dense = Eigen::MatrixXd;

/// Blocks of a chain, and the same as one matrix.
struct Blocks {
  explicit Blocks(std::size_t nodes, std::size_t unknowns = 6)
      : B(unknowns), diagonal(nodes * B * B, 0.0), upper(diagonal.size() - B * B, 0.0), lower(upper) {}
  SpatialLanes::Blocks view() { return {diagonal.data(), upper.data(), lower.data(), B}; }
  Dense dense() const {
    const auto n = static_cast<Eigen::Index>(diagonal.size() / B);
    const auto b = static_cast<Eigen::Index>(B);
    Dense all = Dense::Zero(n, n);
    for (Eigen::Index i = 0; i < n / b; ++i) {
      all.block(b * i, b * i, b, b) = Eigen::Map<const Dense>(diagonal.data() + b * b * i, b, b);
      if (i + 1 == n / b) break;
      all.block(b * i, b * i + b, b, b) = Eigen::Map<const Dense>(upper.data() + b * b * i, b, b);
      all.block(b * i + b, b * i, b, b) = Eigen::Map<const Dense>(lower.data() + b * b * i, b, b);
    }
    return all;
  }
  std::size_t B;
  std::vector<double> diagonal, upper, lower;
};

void add(const SpatialMatrix& K, std::size_t e, Dense& all) {
  all.block<12, 12>(static_cast<Eigen::Index>(6 * e), static_cast<Eigen::Index>(6 * e)) += K;
}

void check_same(const Dense& K, const Dense& expected) {
  check_close((K - expected).norm(), 0, {.absolute = 3e-14 * expected.norm()});
}

void check_same(const std::vector<double>& values, const std::vector<double>& expected) {
  REQUIRE(values.size() == expected.size());
  double size = 0;
  for (double x : expected) size = std::max(size, std::abs(x));
  for (std::size_t i = 0; i < values.size(); ++i) check_close(values[i], expected[i], {.absolute = 3e-14 * (1 + size)});
}

struct Section {
  explicit Section(Scene& scene, double size = 5) {
    for (AlignedVector& row : stress) row = scene.points(size);
    for (auto& row : C) {
      for (AlignedVector& entry : row) entry = scene.points(9);
    }
  }
  static SpatialLanes::Points view(const std::array<AlignedVector, 4>& x) {
    return {x[0].data(), x[1].data(), x[2].data(), x[3].data()};
  }
  SpatialResultants resultants(std::size_t e) const {
    SpatialResultants r;
    for (std::size_t g = 0; g < 2; ++g) {
      r.N[g] = stress[0][2 * e + g];
      r.M1[g] = stress[1][2 * e + g];
      r.M2[g] = stress[2][2 * e + g];
      r.M3[g] = stress[3][2 * e + g];
    }
    return r;
  }
  SpatialLanes::PointTangents tangents() const { return {view(C[0]), view(C[1]), view(C[2]), view(C[3])}; }
  SpatialSectionTangent tangent(std::size_t e) const {
    SpatialSectionTangent t;
    for (std::size_t g = 0; g < 2; ++g) {
      for (std::size_t r = 0; r < 4; ++r) {
        for (std::size_t c = 0; c < 4; ++c) t.C[g](static_cast<int>(r), static_cast<int>(c)) = C[r][c][2 * e + g];
      }
    }
    return t;
  }
  std::array<AlignedVector, 4> stress;
  std::array<std::array<AlignedVector, 4>, 4> C;
};

}  // namespace

TEST_CASE("spatial lanes: strains, forces and stiffness are those of every element by itself, for any section") {
  for (Scene scene : scenes) {
    const std::size_t elements = scene.element.size();
    CAPTURE(elements);
    SpatialLanes lanes = scene.lanes();
    std::array<AlignedVector, 4> strain;
    for (AlignedVector& row : strain) row = scene.points(1);
    const Section section(scene);
    lanes.find_strains(scene.state.u.data(), {strain[0].data(), strain[1].data(), strain[2].data(), strain[3].data()});
    std::vector<double> f = scene.numbers(1);
    std::vector<double> expected_f = f;
    lanes.add_internal_force(Section::view(section.stress), f.data());
    Blocks K(elements + 1);
    lanes.add_stiffness(Section::view(section.stress), section.tangents(), K.view());
    Dense expected_K = Dense::Zero(K.dense().rows(), K.dense().cols());
    for (std::size_t e = 0; e < elements; ++e) {
      const SpatialKinematics k = kinematics(scene.element[e], Scene::of(scene.state.u, e));
      for (std::size_t g = 0; g < 2; ++g) {
        const Eigen::Vector4d expected = strandyn::test::strain(k, g);
        for (std::size_t c = 0; c < 4; ++c) {
          check_close(strain[c][2 * e + g], expected(static_cast<int>(c)), {.absolute = 3e-14});
        }
      }
      Eigen::Map<SpatialVector>(expected_f.data() + 6 * e) +=
          internal_force(scene.element[e], k, section.resultants(e));
      add(tangent(scene.element[e], k, section.resultants(e), section.tangent(e)), e, expected_K);
    }
    for (const AlignedVector& row : strain) {
      for (std::size_t point = 2 * elements; point < row.size(); ++point) CHECK(row[point] == 0);
    }
    check_same(f, expected_f);
    check_same(K.dense(), expected_K);
  }
}

TEST_CASE("spatial lanes: inertia is that of every element and node by itself, at one state after the other") {
  const InertiaFactors factors{.acceleration = 1.3, .velocity = 0.7, .position = 1.9};
  for (Scene scene : scenes) {
    const std::size_t elements = scene.element.size();
    SpatialLanes lanes = scene.lanes();
    for (std::size_t state = 0; state < 3; ++state) {
      const Nodal& now = scene.state;
      std::vector<double> f = scene.numbers(1);
      std::vector<double> expected_f = f;
      Blocks K(elements + 1);
      Dense expected_K = Dense::Zero(K.dense().rows(), K.dense().cols());
      double energy = 0;
      lanes.add_inertia_force(now.u.data(), now.v.data(), now.a.data(), f.data());
      lanes.add_rotary_force(now.u.data(), now.v.data(), now.a.data(), f.data());
      lanes.add_inertia_tangent(now.u.data(), now.v.data(), now.a.data(), factors, K.view());
      lanes.add_rotary_tangent(now.u.data(), now.v.data(), now.a.data(), factors, K.view());
      for (std::size_t e = 0; e < elements; ++e) {
        const SpatialMotion m = scene.motion(e);
        Eigen::Map<SpatialVector>(expected_f.data() + 6 * e) += consistent_inertia_force(scene.element[e], inertia, m);
        add(consistent_inertia_tangent(scene.element[e], inertia, m, factors), e, expected_K);
        energy += m.v.dot(consistent_mass(scene.element[e], inertia, m.q) * m.v) / 2;
      }
      for (std::size_t node = 0; node <= elements; ++node) {
        const RotationMotion m = scene.turning(node);
        Eigen::Map<Eigen::Vector3d>(expected_f.data() + 6 * node + 3) += rotary_force(scene.at_nodes[node], m);
        const RotaryTangent t = rotary_tangent(scene.at_nodes[node], m);
        const auto at = static_cast<Eigen::Index>(6 * node + 3);
        expected_K.block<3, 3>(at, at) +=
            factors.acceleration * t.mass + factors.velocity * t.velocity + factors.position * t.position;
      }
      check_same(f, expected_f);
      check_same(K.dense(), expected_K);
      check_close(lanes.kinetic_energy(now.u.data(), now.v.data()), energy, {.relative = 1e-13});
      // One number alone makes another state.
      std::vector<double>& changed = state == 0 ? scene.state.v : state == 1 ? scene.state.a : scene.state.u;
      changed[6 * elements + 4] += 0.3;
    }
  }
}

TEST_CASE("spatial lanes: without twist the rows and columns of the rotation about x are left out") {
  Scene scene(7, 6, 0.4, 0.2);
  for (std::size_t node = 0; node <= 6; ++node) {
    for (std::vector<double>* x : {&scene.state.u, &scene.state.v, &scene.state.a}) (*x)[6 * node + 3] = 0;
  }
  const auto kept = [](const std::vector<double>& all) {
    std::vector<double> out;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i % 6 != 3) out.push_back(all[i]);
    }
    return out;
  };
  const Nodal five{.u = kept(scene.state.u), .v = kept(scene.state.v), .a = kept(scene.state.a)};
  SpatialLanes all = scene.lanes();
  SpatialLanes lanes({.elements = scene.element,
                      .inertia = inertia,
                      .at_nodes = scene.at_nodes,
                      .unknowns = SpatialLanes::Unknowns::untwisted});
  Section section(scene);
  std::array<AlignedVector, 4> strain;
  for (AlignedVector& row : strain) row = scene.points(1);
  const SpatialLanes::Strains strains{strain[0].data(), strain[1].data(), strain[2].data(), strain[3].data()};
  const InertiaFactors factors{.acceleration = 1.3, .velocity = 0.7, .position = 1.9};
  const auto forces_and_matrix = [&](SpatialLanes& of, const Nodal& m, std::vector<double>& f, Blocks& K) {
    of.find_strains(m.u.data(), strains);
    of.add_internal_force(Section::view(section.stress), f.data());
    of.add_stiffness(Section::view(section.stress), section.tangents(), K.view());
    of.add_inertia_force(m.u.data(), m.v.data(), m.a.data(), f.data());
    of.add_rotary_force(m.u.data(), m.v.data(), m.a.data(), f.data());
    of.add_inertia_tangent(m.u.data(), m.v.data(), m.a.data(), factors, K.view());
    of.add_rotary_tangent(m.u.data(), m.v.data(), m.a.data(), factors, K.view());
  };
  std::vector<double> f(five.u.size(), 0.0);
  Blocks K(7, 5);
  forces_and_matrix(lanes, five, f, K);
  for (double twist : strain[1]) CHECK(twist == 0);
  // The whole chain, whose sections do not feel twist.
  std::ranges::fill(section.stress[1], 0.0);
  for (std::size_t c = 0; c < 4; ++c) {
    std::ranges::fill(section.C[1][c], 0.0);
    std::ranges::fill(section.C[c][1], 0.0);
  }
  std::vector<double> f_of_all(scene.state.u.size(), 0.0);
  Blocks K_of_all(7);
  forces_and_matrix(all, scene.state, f_of_all, K_of_all);
  check_same(f, kept(f_of_all));
  std::vector<Eigen::Index> places;
  for (Eigen::Index i = 0; i < 42; ++i) {
    if (i % 6 != 3) places.push_back(i);
  }
  check_same(K.dense(), K_of_all.dense()(places, places));
}
