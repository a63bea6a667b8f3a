#include "strandyn/conductor/hertz.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strandyn::conductor {

using std::numbers::pi;

namespace {

double contact_modulus(const BodyPair& b) {
  const auto compliance = [](const ContactBody& body) { return (1 - body.poisson * body.poisson) / body.young; };
  return 1 / (compliance(b.first) + compliance(b.second));
}

ContactBody body_of(const Layer& layer) {
  return {.radius = layer.diameter / 2, .young = layer.young, .poisson = layer.poisson};
}

/// Complete elliptic integrals K and D = (K - E)/e^2 by the arithmetic-geometric mean, of k = sqrt(1 - e^2).
struct Elliptic {
  double K = 0;
  double D = 0;
};
Elliptic elliptic(double k) {
  double mean = 1;
  double root = k;
  double part = 1;  // c_n^2/e^2 of E = K (1 - sum 2^(n-1) c_n^2)
  double weight = 0.5;
  double sum = 0;
  for (int n = 0; n < 20; ++n) {  // digits double in each
    sum += weight * part;
    const double next = (mean + root) / 2;
    // c_(n+1) = c_n^2/(4 a_(n+1)), so that nothing cancels.
    const double e2 = 1 - k * k;
    part = e2 > 0 ? part * part * e2 / (16 * next * next) : 0;
    root = std::sqrt(mean * root);
    mean = next;
    weight *= 2;
  }
  const double K = pi / (2 * mean);
  return {.K = K, .D = K * sum};
}

/// b/a of the ellipse under surfaces whose distance is A x^2 + B y^2, ratio = B/A >= 1.
double axis_ratio_of(double ratio) {
  double low = 0;  // of -ln k
  double high = 30;
  for (int halving = 0; halving < 100; ++halving) {
    const double middle = (low + high) / 2;
    const double k = std::exp(-middle);
    const Elliptic i = elliptic(k);
    ((i.K - i.D) / (k * k * i.D) < ratio ? low : high) = middle;
  }
  return std::exp(-(low + high) / 2);
}

}  // namespace

SpotContact::SpotContact(const BodyPair& b, double crossing_angle) {
  const double c1 = 1 / b.first.radius;
  const double c2 = 1 / b.second.radius;
  const double sum = (c1 + c2) / 2;
  const double difference = std::sqrt(c1 * c1 + c2 * c2 + 2 * c1 * c2 * std::cos(2 * crossing_angle)) / 2;
  // A B = c1 c2 sin^2(phi)/4: small angles lose no digits.
  const double larger = (sum + difference) / 2;
  const double smaller = c1 * c2 * std::pow(std::sin(crossing_angle), 2) / (4 * larger);
  k_ = axis_ratio_of(std::max(1.0, larger / smaller));
  const Elliptic i = elliptic(k_);
  axis_per_cube_root_ = std::cbrt(3 * i.D / (2 * pi * contact_modulus(b) * smaller));
  for (const ContactBody& body : {b.first, b.second}) {
    compliance_ += ((1 - body.poisson) * i.K + body.poisson * i.D) / body.shear();
  }
}

double SpotContact::long_half_axis(double force) const {
  return axis_per_cube_root_ * std::cbrt(force);
}

Stiffness SpotContact::stiffness(double force) const {
  if (force <= 0) return {};
  const double value = 2 * pi * long_half_axis(force) / compliance_;
  return {.value = value, .slope = value / (3 * force)};
}

LineContact::LineContact(const BodyPair& bodies) : bodies_(bodies) {
  const double R = 1 / (1 / bodies.first.radius + 1 / bodies.second.radius);
  width_per_root_ = std::sqrt(4 * R / (pi * contact_modulus(bodies)));
}

double LineContact::half_width(double load) const {
  return std::min(width_per_root_ * std::sqrt(load), std::min(bodies_.first.radius, bodies_.second.radius));
}

Stiffness LineContact::stiffness(double load) const {
  if (load <= 0) return {};
  const double b = half_width(load);
  double compliance = 0;
  double slope = 0;  // of the compliance
  for (const ContactBody& body : {bodies_.first, bodies_.second}) {
    compliance += (std::log(2 * body.radius / b) + 1.0 / 8) / (pi * body.shear());
    slope -= 1 / (2 * load * pi * body.shear());
  }
  const bool widest = b < width_per_root_ * std::sqrt(load);
  return {.value = 1 / compliance, .slope = widest ? 0 : -slope / (compliance * compliance)};
}

double LineContact::slip_logarithm(double load) const {
  const double b = half_width(load);
  double sum = 0;
  double weight = 0;
  for (const ContactBody& body : {bodies_.first, bodies_.second}) {
    sum += (std::log(2 * body.radius / b) + 5.0 / 8) / body.shear();
    weight += 1 / body.shear();
  }
  return sum / weight;
}

Stiffness Interface::stiffness(double load, double share) const {
  if (share <= 0) return {};
  const Stiffness one = line ? along.stiffness(load / share) : spot.stiffness(load / share);
  return {.value = share * one.value, .slope = one.slope};
}

std::vector<Interface> interfaces(const Strand& strand) {
  std::vector<Interface> all(strand.layers.size());
  for (std::size_t j = 1; j < strand.layers.size(); ++j) {
    const Layer& outer = strand.layers[j];
    const Layer& inner = strand.layers[j - 1];
    const BodyPair bodies{body_of(outer), body_of(inner)};
    const bool on_core = j == 1;
    const double w_outer = std::tan(outer.lay_angle) / outer.helix_radius;
    const double w_inner = on_core ? 0 : std::tan(inner.lay_angle) / inner.helix_radius;
    const double w = std::abs(w_outer - w_inner);

    Interface& face = all[j];
    face.along = LineContact(bodies);
    face.line = on_core || inner.wires * w <= std::abs(w_outer);
    if (face.line) {
      face.per_inner_wire = on_core ? 0 : static_cast<double>(outer.wires) / inner.wires;
      continue;
    }
    const double meet = outer.helix_radius - outer.diameter / 2;
    face.crossing_angle = std::abs(std::atan(w_outer * meet) - std::atan(w_inner * meet));
    face.spot = SpotContact(bodies, face.crossing_angle);
    face.per_outer_wire = inner.wires * w / (2 * pi) * std::cos(outer.lay_angle);
    face.per_inner_wire = outer.wires * w / (2 * pi) * std::cos(inner.lay_angle);
  }
  return all;
}

}  // namespace strandyn::conductor
