#include <fmt/format.h>

#include <cmath>

#include "refusals.hpp"
#include "resolve.hpp"

namespace strandyn::casefile {
namespace {

/// Where the case says what it says: the source, and the path of the table there.
struct At {
  const Source& source;
  const std::string& path;

  std::string layer(std::size_t j) const { return fmt::format("{}.layer[{}]", path, j); }
};

conductor::Layer layer_of(const LayerKeys& keys) {
  conductor::Layer layer;
  layer.wires = keys.wires;
  layer.diameter = keys.diameter;
  layer.lay_angle = keys.lay_angle.value_or(0.0);
  layer.helix_radius = keys.helix_radius.value_or(0.0);
  layer.young = keys.young;
  layer.poisson = keys.poisson;
  layer.density = keys.density;
  layer.residual_force = keys.residual_force;
  layer.shape = keys.shape;
  layer.wire_area = keys.area.value_or(conductor::round_area(keys.diameter));
  layer.wire_inertia = keys.shape == WireShape::round ? conductor::round_inertia(keys.diameter)
                                                      : conductor::trapezoid_inertia(layer.wire_area, keys.diameter);
  return layer;
}

/// Coefficient of the contact below layer j: what the layer says of it, else what the layer below says of its contacts.
double friction_below(const Conductor& conductor, std::size_t j) {
  const LayerKeys& layer = conductor.layers[j];
  if (layer.friction_inner) return *layer.friction_inner;
  if (layer.friction) return *layer.friction;
  if (j > 0 && conductor.layers[j - 1].friction) return *conductor.layers[j - 1].friction;
  return conductor.friction;
}

void resolve_lay(const LayerKeys& keys, conductor::Layer& layer, std::size_t j, const At& at) {
  if (j == 0 && (keys.lay_length || keys.lay_ratio)) {
    refuse(at.source, at.layer(j) + (keys.lay_length ? ".lay_length_mm" : ".lay_ratio"), "is a lay of the core",
           "remove it: the core is straight");
  }
  if (j > 0 && !keys.lay_angle && !keys.lay_length && !keys.lay_ratio) {
    refuse(at.source, at.layer(j), "its lay is missing",
           "give lay_angle_deg, lay_length_mm or lay_ratio, 0 degrees for straight wires");
  }
  if (keys.lay_ratio) {
    const double outer_diameter = 2 * layer.helix_radius + layer.diameter;
    layer.lay_angle = conductor::lay_angle_from_length(layer.helix_radius, *keys.lay_ratio * outer_diameter);
  }
  if (!keys.lay_length) return;
  if (*keys.lay_length == 0) {
    refuse(at.source, at.layer(j) + ".lay_length_mm", "must not be 0",
           "give the length of one turn in millimetres, negative for a left-hand lay");
  }
  layer.lay_angle = conductor::lay_angle_from_length(layer.helix_radius, *keys.lay_length);
}

void refuse_impossible_strand(const conductor::Strand& strand, const At& at) {
  conductor::Strand inner;
  for (std::size_t j = 0; j < strand.layers.size(); ++j) {
    inner.layers.push_back(strand.layers[j]);
    const auto fault = conductor::find_fault(inner);
    if (!fault) continue;
    const std::size_t remedy = fault->find("; ");  // some faults name their own
    refuse(at.source, at.layer(j), fault->substr(0, remedy),
           remedy == std::string::npos ? "correct this layer" : fault->substr(remedy + 2));
  }
}

}  // namespace

void resolve_conductor(Conductor& conductor, const Source& source, const std::string& path) {
  const At at{source, path};
  conductor::Strand& strand = conductor.strand;
  strand.name = conductor.catalogue.value_or(conductor.title.value_or("own conductor"));
  for (const LayerKeys& keys : conductor.layers) strand.layers.push_back(layer_of(keys));
  conductor::fill_helix_radii(strand);
  Refusals refusals;
  for (std::size_t j = 0; j < strand.layers.size(); ++j) {
    conductor::Layer& layer = strand.layers[j];
    refusals.hold([&] { resolve_lay(conductor.layers[j], layer, j, at); });
    layer.friction_inner = friction_below(conductor, j);
    if (!conductor.residual_forces) layer.residual_force = 0;
  }
  refusals.pass_on();
  refuse_impossible_strand(strand, at);
  strand.rated_strength = conductor.rated_strength.value_or(0.0);
  if (!conductor.mass_per_length) conductor.mass_per_length = strand.geometric_mass();
  strand.mass_per_length = conductor.mass_per_length.value_or(0.0);

  for (std::size_t j = 0; j < strand.layers.size(); ++j) {
    LayerKeys& keys = conductor.layers[j];
    const conductor::Layer& layer = strand.layers[j];
    keys.lay_angle = layer.lay_angle;
    keys.lay_length.reset();
    keys.lay_ratio.reset();
    keys.helix_radius = layer.helix_radius;
    keys.residual_force = layer.residual_force;
    keys.friction_inner = layer.friction_inner;
    keys.friction.reset();
  }
}

}  // namespace strandyn::casefile
