#include "strandyn/system/eccentric_bodies.hpp"

#include <stdexcept>

namespace strandyn::system {

using Eigen::Vector2d;

EccentricBodies::EccentricBodies(const model::Model& model) {
  using model::Unknown;
  for (const model::Body& body : model.bodies) {
    if (body.mass == 0 || body.eccentricity.isZero(0)) continue;
    if (model::is_spatial(model.freedom)) throw std::invalid_argument("a body beside its node: in a plane only");
    bodies_.push_back({.x = model.index(body.node, Unknown::x),
                       .y = *model.index(body.node, Unknown::y),
                       .turn = *model.index(body.node, Unknown::rotation_z),
                       .mass = body.mass,
                       .r = body.eccentricity});
  }
}

void EccentricBodies::add_inertia_force(const double* u, const double* v, const double* a, double* f) const {
  for (const Body& b : bodies_) {
    const Vector2d c = b.arm(u);
    const double spin_up = a[b.turn];
    f[b.y] += b.mass * spin_up * c.x();
    f[b.turn] += b.mass * (c.x() * a[b.y] + c.squaredNorm() * spin_up);
    if (b.is_small()) continue;
    const double spin = v[b.turn];
    f[*b.x] -= b.mass * (spin_up * c.y() + spin * spin * c.x());
    f[b.y] -= b.mass * spin * spin * c.y();
    f[b.turn] -= b.mass * c.y() * a[*b.x];
  }
}

void EccentricBodies::add_inertia_tangent(const double* u, const double* v, const double* a,
                                          beam::InertiaFactors factors, math::ChainMatrix& K) const {
  for (const Body& b : bodies_) {
    const Vector2d c = b.arm(u);
    const double m = b.mass;
    K.add_at_node(b.y, b.turn, m * factors.acceleration * c.x());
    K.add_at_node(b.turn, b.y, m * factors.acceleration * c.x());
    K.add_at_node(b.turn, b.turn, m * factors.acceleration * c.squaredNorm());
    if (b.is_small()) continue;
    const std::size_t x = *b.x;
    const double spin = v[b.turn];
    const double spin_up = a[b.turn];
    K.add_at_node(x, b.turn,
                  m * (-factors.acceleration * c.y() - factors.velocity * 2 * spin * c.x() +
                       factors.position * (-spin_up * c.x() + spin * spin * c.y())));
    K.add_at_node(
        b.y, b.turn,
        m * (-factors.velocity * 2 * spin * c.y() - factors.position * (spin_up * c.y() + spin * spin * c.x())));
    K.add_at_node(b.turn, x, -m * factors.acceleration * c.y());
    K.add_at_node(b.turn, b.turn, -m * factors.position * (c.y() * a[b.y] + c.x() * a[x]));
  }
}

void EccentricBodies::add_mass(const double* u, math::ChainMatrix& M) const {
  for (const Body& b : bodies_) {
    const Vector2d c = b.arm(u);
    const auto couple = [&](std::size_t at, double value) {
      M.add_at_node(at, b.turn, b.mass * value);
      M.add_at_node(b.turn, at, b.mass * value);
    };
    couple(b.y, c.x());
    if (!b.is_small()) couple(*b.x, -c.y());
    M.add_at_node(b.turn, b.turn, b.mass * c.squaredNorm());
  }
}

double EccentricBodies::kinetic_energy(const double* u, const double* v) const {
  double sum = 0;
  for (const Body& b : bodies_) {
    const Vector2d c = b.arm(u);
    const double spin = v[b.turn];
    sum += b.mass * spin * (c.x() * v[b.y] + c.squaredNorm() * spin / 2);
    if (!b.is_small()) sum -= b.mass * spin * c.y() * v[*b.x];
  }
  return sum;
}

}  // namespace strandyn::system
