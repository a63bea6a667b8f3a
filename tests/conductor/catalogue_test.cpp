#include "strandyn/conductor/catalogue.hpp"

#include <doctest/doctest.h>
#include <toml++/toml.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "strandyn/conductor/metals.hpp"
#include "strandyn/conductor/strand.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using strandyn::test::check_close;

namespace {

constexpr double pi = std::numbers::pi;

/// What a name promises: wires of each metal and the diameter over the outermost layer as tables print it, 0 where the
/// source of the entry prints none.
struct Promise {
  int steel;
  int aluminium;
  double outer_diameter_mm;
};

const std::map<std::string, Promise> promises = {{"acss-bluebird", {19, 84, 44.75}},
                                                 {"acss-canary", {7, 54, 29.51}},
                                                 {"acss-canvasback", {19, 30, 0}},
                                                 {"acss-partridge", {7, 26, 16.31}},
                                                 {"aster-148", {0, 19, 0}},
                                                 {"aster-228", {0, 37, 0}},
                                                 {"aster-288", {0, 37, 0}},
                                                 {"aster-366", {0, 37, 0}},
                                                 {"aster-570", {0, 61, 31.05}},
                                                 {"aster-851", {0, 91, 0}},
                                                 {"bear", {7, 30, 23.45}},
                                                 {"bersfort", {7, 48, 35.6}},
                                                 {"bersimis", {7, 42, 35.1}},
                                                 {"bittern", {7, 45, 34.16}},
                                                 {"bluebird", {19, 84, 44.75}},
                                                 {"bobolink", {7, 45, 36.25}},
                                                 {"canna-288", {7, 30, 0}},
                                                 {"cardinal", {7, 54, 30.4}},
                                                 {"centipede", {0, 37, 26.46}},
                                                 {"chickadee", {1, 18, 18.87}},
                                                 {"chukar", {19, 84, 40.69}},
                                                 {"condor", {7, 54, 27.72}},
                                                 {"crocus-288", {7, 30, 0}},
                                                 {"crocus-297", {19, 36, 0}},
                                                 {"crocus-412", {19, 32, 0}},
                                                 {"crocus-612", {19, 66, 0}},
                                                 {"curlew", {7, 54, 31.68}},
                                                 {"curlew-54-7", {7, 54, 31.62}},
                                                 {"dipper", {7, 45, 35.2}},
                                                 {"dog", {7, 6, 14.15}},
                                                 {"dove", {7, 26, 23.5}},
                                                 {"drake", {7, 26, 28.13}},
                                                 {"falcon", {19, 54, 39.24}},
                                                 {"flicker-tw", {7, 18, 19.71}},
                                                 {"goat", {7, 30, 25.97}},
                                                 {"grackle", {19, 54, 33.99}},
                                                 {"ground-acs-7-5awg", {7, 0, 13.9}},
                                                 {"ground-acs-7-6awg", {7, 0, 12.4}},
                                                 {"ground-steel-7-300", {7, 0, 0}},
                                                 {"ground-steel-7-315", {7, 0, 9.45}},
                                                 {"ground-steel-7-366", {7, 0, 10.98}},
                                                 {"ground-steel-7-406", {7, 0, 12.18}},
                                                 {"guinea", {7, 12, 14.63}},
                                                 {"hare", {1, 6, 14.16}},
                                                 {"hawk", {7, 26, 21.8}},
                                                 {"hawk-tw", {7, 18, 20.04}},
                                                 {"hornet", {0, 19, 16.25}},
                                                 {"horse", {7, 12, 13.95}},
                                                 {"ibis", {7, 26, 19.9}},
                                                 {"iec-160-a2", {0, 19, 17.6}},
                                                 {"iec-315-45-7", {7, 45, 23.9}},
                                                 {"iec-315-a2", {0, 37, 24.7}},
                                                 {"iec-400-45-7", {7, 45, 26.9}},
                                                 {"iec-400-54-7", {7, 54, 27.6}},
                                                 {"iec-400-a2", {0, 37, 27.9}},
                                                 {"iec-450-54-7", {7, 54, 29.3}},
                                                 {"iec-500-45-7", {7, 45, 30.1}},
                                                 {"iec-500-54-7", {7, 54, 30.9}},
                                                 {"iec-500-a2", {0, 37, 31.2}},
                                                 {"iec-560-45-7", {7, 45, 31.8}},
                                                 {"iec-560-54-19", {19, 54, 32.7}},
                                                 {"iec-560-a2", {0, 61, 33}},
                                                 {"iec-630-45-7", {7, 45, 33.8}},
                                                 {"iec-630-54-19", {19, 54, 34.7}},
                                                 {"iec-710-a2", {0, 61, 37.2}},
                                                 {"iec-800-a2", {0, 61, 39.5}},
                                                 {"lapwing", {7, 45, 38.2}},
                                                 {"mars", {0, 7, 11.3}},
                                                 {"martin", {19, 54, 36.17}},
                                                 {"messenger-19-190", {19, 0, 0}},
                                                 {"messenger-19-225", {19, 0, 0}},
                                                 {"messenger-19-240", {19, 0, 0}},
                                                 {"messenger-19-265", {19, 0, 0}},
                                                 {"messenger-7-203", {7, 0, 0}},
                                                 {"messenger-7-264", {7, 0, 0}},
                                                 {"mink", {1, 6, 10.98}},
                                                 {"minorca", {7, 12, 12.22}},
                                                 {"moon", {0, 7, 14.3}},
                                                 {"moose", {7, 54, 31.77}},
                                                 {"neptune", {0, 19, 16.3}},
                                                 {"nuthatch", {7, 45, 37.24}},
                                                 {"oak", {0, 7, 13.95}},
                                                 {"orchid", {0, 37, 0}},
                                                 {"ostrich", {7, 26, 17.3}},
                                                 {"panther", {7, 30, 21}},
                                                 {"parakeet-tw", {7, 18, 21.21}},
                                                 {"parrot", {19, 54, 38.23}},
                                                 {"pastel-228", {7, 30, 0}},
                                                 {"pastel-288", {7, 30, 0}},
                                                 {"pastel-412", {19, 32, 0}},
                                                 {"petunia-612", {19, 66, 0}},
                                                 {"pheasant", {19, 54, 35.1}},
                                                 {"pigeon", {1, 6, 12.75}},
                                                 {"pine", {0, 7, 10.83}},
                                                 {"plover", {19, 54, 37.21}},
                                                 {"pluto", {0, 19, 18.8}},
                                                 {"rabbit", {1, 6, 10.05}},
                                                 {"raccoon", {1, 6, 12.27}},
                                                 {"rail", {7, 45, 29.59}},
                                                 {"raven", {1, 6, 10.11}},
                                                 {"saturn", {0, 37, 21}},
                                                 {"skylark", {1, 36, 33.43}},
                                                 {"sparrow", {1, 6, 8.03}},
                                                 {"squirrel", {1, 6, 6.33}},
                                                 {"steel-1x6", {7, 0, 11.4}},
                                                 {"swan", {1, 6, 6.35}},
                                                 {"taurus", {0, 19, 23.8}},
                                                 {"tern", {7, 45, 27}},
                                                 {"thrasher", {19, 76, 45.77}},
                                                 {"tiger", {7, 30, 16.52}},
                                                 {"uranus", {0, 61, 29.3}},
                                                 {"ursula", {0, 61, 31.5}},
                                                 {"weasel", {1, 6, 7.77}},
                                                 {"wolf", {7, 30, 18.13}},
                                                 {"zebra", {7, 54, 28.62}}};

/// Above the densities of aluminium and its alloys, below steel's.
constexpr double lightest_steel = 5000;

toml::table parse(const conductor::CatalogueEntry& entry) {
  return toml::parse(entry.text, entry.name);
}

double number(const toml::table& table, std::string_view key, double absent = 0) {
  return table[key].value_or(absent);
}

conductor::Strand strand_of(const toml::table& data) {
  conductor::Strand strand;
  for (const toml::node& node : *data["layer"].as_array()) {
    const toml::table& table = *node.as_table();
    conductor::Layer layer;
    layer.wires = table["wires"].value_or(0);
    layer.diameter = number(table, "diameter_mm") * 1e-3;
    layer.density = number(table, "density_kg_per_m3");
    layer.helix_radius = number(table, "helix_radius_mm") * 1e-3;
    layer.young = number(table, "young_GPa") * 1e9;
    layer.poisson = number(table, "poisson");
    layer.residual_force = number(table, "residual_force_N_per_mm") * 1e3;
    layer.wire_area = conductor::round_area(layer.diameter);
    layer.wire_inertia = conductor::round_inertia(layer.diameter);
    if (table["shape"].value_or(std::string{}) == "trapezoidal") {
      layer.shape = conductor::WireShape::trapezoidal;
      layer.wire_area = number(table, "area_mm2") * 1e-6;
      layer.wire_inertia = conductor::trapezoid_inertia(layer.wire_area, layer.diameter);
    }
    layer.lay_angle = number(table, "lay_angle_deg") * pi / 180;
    strand.layers.push_back(layer);
  }
  conductor::fill_helix_radii(strand);
  for (std::size_t j = 0; j < strand.layers.size(); ++j) {
    const toml::table& keys = *(*data["layer"].as_array())[j].as_table();
    conductor::Layer& layer = strand.layers[j];
    const double outer_diameter = 2 * layer.helix_radius + layer.diameter;
    const double lay_length = number(keys, "lay_length_mm") * 1e-3 + number(keys, "lay_ratio") * outer_diameter;
    if (lay_length != 0) layer.lay_angle = conductor::lay_angle_from_length(layer.helix_radius, lay_length);
  }
  return strand;
}

/// Lay length over the outer diameter of the layer.
double lay_ratio(const conductor::Layer& layer) {
  return 2 * pi * layer.helix_radius / std::tan(std::abs(layer.lay_angle)) / (2 * layer.helix_radius + layer.diameter);
}

}  // namespace

TEST_CASE("the catalogue holds the promised conductors, sorted by name") {
  std::vector<std::string> names;
  for (const auto& entry : conductor::catalogue()) names.emplace_back(entry.name);
  std::vector<std::string> expected;
  for (const auto& [name, promise] : promises) expected.push_back(name);
  CHECK(names == expected);
}

TEST_CASE("every catalogue entry says what it is and where its numbers come from") {
  for (const auto& entry : conductor::catalogue()) {
    CAPTURE(entry.name);
    const toml::table data = parse(entry);
    CHECK(!data["title"].value_or(std::string{}).empty());
    CHECK(!data["source"].value_or(std::string{}).empty());
    CHECK(number(data, "rated_strength_kN") > 0);
    CHECK(!data.contains("friction"));  // nobody measures it on a conductor: it is the case's to say
    CHECK(conductor::find_fault(strand_of(data)).value_or("sound") == "sound");
  }
}

TEST_CASE("a mass that the catalogue gives is the mass of the wires, and most have a source of their own") {
  std::size_t printed = 0;
  for (const auto& entry : conductor::catalogue()) {
    const toml::table data = parse(entry);
    if (!data.contains("mass_kg_per_m")) continue;  // that of the wires
    // The masses of the project's reference list are from memory of catalogues.
    const std::string source = data["source"].value_or(std::string{});
    printed +=
        source.starts_with("Wires, mass and rated strength: the reference list") || entry.name == "curlew" ? 0 : 1;
    // 0.5 %: the spread of lay ratios inside the standard's ranges moves the mass by about that much either way.
    check_close(strand_of(data).geometric_mass().value(), number(data, "mass_kg_per_m"), {.relative = 0.005},
                std::string(entry.name));
  }
  CHECK(printed == 74);
  CHECK(conductor::catalogue().size() >= 100);
}

TEST_CASE("the constants of the catalogue's wires are those of their metals") {
  for (const auto& entry : conductor::catalogue()) {
    const std::string name(entry.name);
    if (name == "curlew" || name == "steel-1x6") continue;  // the paper's own
    CAPTURE(name);
    for (const conductor::Layer& layer : strand_of(parse(entry)).layers) {
      const bool clad = name.starts_with("ground-acs");
      const conductor::Metal& metal = *conductor::find_metal(clad                             ? "20SA"
                                                             : layer.density > lightest_steel ? "ST1A"
                                                                                              : "AL1");
      CHECK(layer.young == metal.young);
      CHECK(layer.poisson == metal.poisson);
      CHECK(layer.density == metal.density);
    }
  }
}

TEST_CASE("lay directions reverse layer by layer, the outermost is right-hand but for the paper's Curlew") {
  for (const auto& entry : conductor::catalogue()) {
    CAPTURE(entry.name);
    const std::vector<conductor::Layer> layers = strand_of(parse(entry)).layers;
    CHECK(layers[0].lay_angle == 0);
    for (std::size_t j = 2; j < layers.size(); ++j) CHECK(layers[j].lay_angle * layers[j - 1].lay_angle < 0);
    CHECK((layers.back().lay_angle > 0) == (entry.name != "curlew"));
  }
}

TEST_CASE("lay ratios lie inside the ranges of EN 50182") {
  for (const auto& entry : conductor::catalogue()) {
    // Wire rope strands, no conductors: the standard does not speak of them.
    if (entry.name == "steel-1x6" || entry.name.starts_with("messenger")) continue;
    CAPTURE(entry.name);
    const std::vector<conductor::Layer> layers = strand_of(parse(entry)).layers;
    for (std::size_t j = 1; j < layers.size(); ++j) {
      CAPTURE(j);
      const bool steel = layers[j].density > lightest_steel;
      const double lowest = steel ? 16 : 10;
      const double highest = steel ? 26 : j + 1 == layers.size() ? 14 : 16;  // of layers inside: 10 to 16
      CHECK(lay_ratio(layers[j]) >= lowest);
      CHECK(lay_ratio(layers[j]) <= highest);
    }
  }
}

TEST_CASE("wire counts and outer diameter are those of the name") {
  for (const auto& entry : conductor::catalogue()) {
    const std::string name(entry.name);
    CAPTURE(name);
    const Promise& promise = promises.at(name);
    const conductor::Strand strand = strand_of(parse(entry));
    int steel = 0;
    int aluminium = 0;
    for (const auto& layer : strand.layers) (layer.density > lightest_steel ? steel : aluminium) += layer.wires;
    CHECK(steel == promise.steel);
    CHECK(aluminium == promise.aluminium);
    if (promise.outer_diameter_mm == 0) continue;
    // Tables print the diameter to 0.1 mm, IEC 61089 that of wires before they are rounded to 0.01 mm.
    const double within = name.starts_with("iec") || name.starts_with("ground-acs") ? 0.1 : 0.051;
    check_close(strand.outer_diameter() * 1e3, promise.outer_diameter_mm, {.absolute = within}, name);
  }
}

TEST_CASE("the wires of every layer fit side by side around the layer below") {
  for (const auto& entry : conductor::catalogue()) {
    const std::vector<conductor::Layer> layers = strand_of(parse(entry)).layers;
    for (std::size_t j = 1; j < layers.size(); ++j) {
      CAPTURE(entry.name);
      CAPTURE(j);
      if (layers[j].shape == conductor::WireShape::trapezoidal) {  // of the ring between the radii, as tables have it
        const double ring = 2 * pi * layers[j].helix_radius * layers[j].diameter;
        const double part = layers[j].wires * layers[j].wire_area / std::cos(layers[j].lay_angle) / ring;
        CHECK(part < 1);
        CHECK(part > 0.88);
        continue;
      }
      // Share of the circumference that the obliquely cut wires fill. Six wires around a like core fill it at zero
      // lay; at the shortest lay of the standard (ratio 10, 1/cos(alpha) = 1.022) the same six come to 1.024: they are
      // pressed outward a little. The lowest of the list is 0.980; one wire less of 24 would leave 0.94.
      const double width = layers[j].diameter / std::cos(layers[j].lay_angle);
      const double filled = layers[j].wires * std::asin(width / (2 * layers[j].helix_radius)) / pi;
      CHECK(filled < 1.025);
      CHECK(filled > 0.97);
    }
  }
}
