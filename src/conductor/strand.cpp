#include "strandyn/conductor/strand.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace strandyn::conductor {
namespace {

constexpr double pi = std::numbers::pi;

/// How many wires have room side by side. Round ones touch at the radius
///     R_n = d/2 sqrt(1 + tan^2(pi/2 - pi/n)/cos^2 alpha)                                              [Costello 1997]
/// and those of another shape fill the ring of their height at the most. Diameters are rounded, and equal wires in all
/// layers are a convention: a twentieth is allowed for.
double most_wires(const Layer& layer) {
  constexpr double room = 1.05;
  const double R = room * layer.helix_radius;
  const double cosine = std::cos(layer.lay_angle);
  if (layer.shape != WireShape::round) {
    return std::floor(room * 2 * pi * layer.helix_radius * layer.diameter * cosine / layer.wire_area);
  }
  const double ratio = 2 * R / layer.diameter;
  if (ratio <= 1) return 1;
  // tan(pi/2 - pi/n) = cot(pi/n)
  const double n = pi / std::atan(1 / (cosine * std::sqrt(ratio * ratio - 1)));
  return std::max(1.0, std::floor(n));
}

std::optional<std::string> find_fault(const Layer& layer, bool core) {
  if (layer.wires < 1) return fmt::format("it has {} wires; give at least 1", layer.wires);
  if (!(layer.diameter > 0)) return "the wire diameter must be above 0";
  if (!(layer.young > 0)) return "Young's modulus must be above 0";
  if (!(layer.wire_area > 0) || !(layer.wire_inertia > 0)) return "the wire's area and inertia must be above 0";
  if (!(layer.poisson > -1 && layer.poisson <= 0.5)) return "Poisson's ratio must be above -1 and at most 0.5";
  if (!(layer.residual_force >= 0)) return "the residual force must be at least 0: it presses the wire inward";
  if (!(layer.friction_inner >= 0)) return "the friction coefficient must be at least 0";
  if (core && (layer.wires != 1 || layer.lay_angle != 0)) return "the core is one straight wire: 1 wire, lay angle 0";
  if (!core && !(layer.helix_radius > 0)) return "the helix radius must be above 0";
  if (!(std::abs(layer.lay_angle) < pi / 2)) return "the lay angle must lie between -90 and 90 degrees";
  if (!core) {
    const double kappa = std::pow(std::sin(layer.lay_angle), 2) / layer.helix_radius;
    if (kappa * layer.diameter >= 2) {
      return "the wire is thicker than its helix allows (kappa d >= 2: no inner contact line); "
             "reduce the lay angle or the diameter";
    }
    const double most = most_wires(layer);
    if (layer.wires > most) {
      return fmt::format(
          "{} wires of {:g} mm do not fit round a helix of radius {:.4g} mm; at most {:g} do: give that many, thinner "
          "ones or a larger helix_radius_mm",
          layer.wires, 1e3 * layer.diameter, 1e3 * layer.helix_radius, most);
    }
  }
  return std::nullopt;
}

}  // namespace

double round_area(double diameter) {
  return pi * diameter * diameter / 4;
}

double round_inertia(double diameter) {
  return pi * std::pow(diameter, 4) / 64;
}

double trapezoid_inertia(double area, double height) {
  const double width = area / height;
  return area * (height * height + width * width) / 24;
}

double lay_angle_from_length(double radius, double lay_length) {
  return std::atan(2 * pi * radius / lay_length);
}

double Strand::outer_diameter() const {
  if (layers.empty()) return 0;
  return 2 * layers.back().helix_radius + layers.back().diameter;
}

std::optional<double> Strand::geometric_mass() const {
  double mass = 0;
  for (const Layer& layer : layers) {
    if (layer.density <= 0) return std::nullopt;
    mass += layer.wires * layer.wire_area * layer.density / std::cos(layer.lay_angle);
  }
  return mass;
}

void fill_helix_radii(Strand& strand) {
  for (std::size_t j = 1; j < strand.layers.size(); ++j) {
    Layer& layer = strand.layers[j];
    const Layer& below = strand.layers[j - 1];
    if (layer.helix_radius == 0) layer.helix_radius = below.helix_radius + (below.diameter + layer.diameter) / 2;
  }
}

std::optional<std::string> find_fault(const Strand& strand) {
  if (strand.layers.empty()) return "the strand has no wires: give [[conductor.layer]] tables, core first";
  for (std::size_t j = 0; j < strand.layers.size(); ++j) {
    if (auto fault = find_fault(strand.layers[j], j == 0)) {
      return fmt::format("layer {} ({}): {}", j, j == 0 ? "core" : "counted from the core", *fault);
    }
  }
  return std::nullopt;
}

}  // namespace strandyn::conductor
