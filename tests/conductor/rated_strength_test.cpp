// The rated strengths of the catalogue against the formulas of the standards that the entries name.
#include <doctest/doctest.h>
#include <toml++/toml.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "strandyn/conductor/catalogue.hpp"
#include "support/check_close.hpp"

using namespace strandyn;
using strandyn::test::check_close;

namespace {

struct Wires {
  int count = 0;
  double diameter_mm = 0;
  bool steel = false;
};

struct Entry {
  std::vector<Wires> layers;
  double strength_kN = 0;
};

Entry read(const std::string& name) {
  const conductor::CatalogueEntry* found = conductor::find_entry(name);
  REQUIRE(found != nullptr);
  const toml::table data = toml::parse(found->text);
  Entry entry{.layers = {}, .strength_kN = data["rated_strength_kN"].value_or(0.0)};
  for (const toml::node& node : *data["layer"].as_array()) {
    const toml::table& layer = *node.as_table();
    entry.layers.push_back({.count = layer["wires"].value_or(0),
                            .diameter_mm = layer["diameter_mm"].value_or(0.0),
                            .steel = layer["density_kg_per_m3"].value_or(0.0) > 5000});
  }
  return entry;
}

/// Strength [MPa] of the first row whose diameter [mm] is not exceeded.
using Rows = std::vector<std::pair<double, double>>;
double look_up(const Rows& rows, double diameter) {
  for (const auto& [most, value] : rows) {
    if (diameter <= most + 1e-6) return value;
  }
  FAIL("no row");
  return 0;
}

double area_mm2(double diameter_mm) {
  return std::numbers::pi * diameter_mm * diameter_mm / 4;
}

// Least tensile strengths of EN 60889 and EN 50183, stresses at 1 % extension of EN 50189.
const Rows AL1 = {{1.25, 200}, {1.5, 195}, {1.75, 190}, {2, 185}, {2.25, 180},
                  {2.5, 175},  {3, 170},   {3.5, 165},  {5, 160}};
const Rows AL4 = {{3.5, 325}, {5, 315}};
const Rows ST1A = {{2.25, 1170}, {3, 1140}, {5.5, 1100}};
const Rows ST6C = {{2.25, 1450}, {3, 1410}, {3.5, 1380}, {5.5, 1340}};

double strength_of_EN_50182(const Entry& entry, const Rows& aluminium, const Rows& steel) {
  double sum = 0;
  for (const Wires& w : entry.layers) {
    sum += w.count * area_mm2(w.diameter_mm) * look_up(w.steel ? steel : aluminium, w.diameter_mm);
  }
  return sum / 1e3;
}

// In inches and ksi: least averages of ASTM B230, stress at 1 % extension of ASTM B498, class A.
const Rows B230 = {{0.08, 28}, {0.09, 27.5}, {0.1, 27}, {0.11, 26}, {0.12, 25.5}, {0.14, 25}, {0.15, 24.5}, {0.21, 24}};
const Rows B498 = {{0.0899, 190}, {0.1199, 185}, {0.1399, 180}, {0.19, 170}};

double strength_of_ASTM_B232(const Entry& entry) {
  constexpr double MPa_per_ksi = 6.894757, mm_per_inch = 25.4;
  constexpr double share[] = {0.96, 0.96, 0.93, 0.91, 0.90};  // by the number of layers, a single wire as one
  double aluminium = 0, steel = 0;
  std::size_t aluminium_layers = 0, steel_layers = 0;
  for (std::size_t j = 0; j < entry.layers.size(); ++j) {
    const Wires& w = entry.layers[j];
    const double stress = look_up(w.steel ? B498 : B230, w.diameter_mm / mm_per_inch) * MPa_per_ksi;
    (w.steel ? steel : aluminium) += w.count * area_mm2(w.diameter_mm) * stress;
    if (j > 0) ++(w.steel ? steel_layers : aluminium_layers);
  }
  return (share[aluminium_layers] * aluminium + share[steel_layers] * steel) / 1e3;
}

}  // namespace

TEST_CASE("rated strengths by EN 50182 are the sum over the wires of their areas and least stresses") {
  const auto check = [](const std::vector<const char*>& names, const Rows& aluminium, const Rows& steel) {
    for (const char* name : names) {
      const Entry entry = read(name);
      check_close(entry.strength_kN, strength_of_EN_50182(entry, aluminium, steel), {.relative = 1e-4}, name);
    }
  };
  check({"squirrel", "weasel", "rabbit", "raccoon", "dog", "wolf", "panther", "zebra", "moose", "tern", "rail", "bear",
         "goat", "tiger", "mink", "hare", "horse", "canna-288"},
        AL1, ST1A);
  check({"crocus-288", "crocus-297", "crocus-412", "crocus-612", "orchid", "messenger-19-190", "messenger-19-225",
         "messenger-19-240", "messenger-19-265"},
        AL1, ST6C);
  check({"aster-148", "aster-228", "aster-288", "aster-366", "aster-851", "pastel-228", "pastel-288", "pastel-412",
         "petunia-612"},
        AL4, ST6C);
}

TEST_CASE("the sum of EN 50182 finds the printed strengths of IEC 61089") {
  // Their wires are rounded to 0.01 mm: 1/300 of a wire's diameter, twice that of its area.
  for (const char* name : {"iec-315-45-7", "iec-400-45-7", "iec-400-54-7", "iec-450-54-7", "iec-500-45-7",
                           "iec-500-54-7", "iec-560-45-7", "iec-630-45-7"}) {
    const Entry entry = read(name);
    check_close(strength_of_EN_50182(entry, AL1, ST1A), entry.strength_kN, {.relative = 0.03}, name);
  }
}

TEST_CASE("rated strengths by ASTM B232 are shares of the wires' strengths") {
  for (const char* name : {"condor", "thrasher", "bluebird", "chukar", "falcon",   "lapwing", "parrot",  "nuthatch",
                           "plover", "bobolink", "martin",   "dipper", "pheasant", "bittern", "skylark", "grackle",
                           "pigeon", "guinea",   "minorca",  "raven",  "sparrow",  "swan"}) {
    const Entry entry = read(name);
    check_close(entry.strength_kN, strength_of_ASTM_B232(entry), {.relative = 1e-4}, name);
  }
}

TEST_CASE("the sum of EN 50182 finds the strength of the reference list's alloy conductor") {
  const Entry entry = read("aster-570");  // four digits there
  check_close(entry.strength_kN, strength_of_EN_50182(entry, AL4, ST6C), {.relative = 5e-4}, "aster-570");
}

TEST_CASE("the shares of ASTM B232 find the strengths of the reference list") {
  // The list has them as tables print them, to three digits.
  for (const char* name : {"drake", "cardinal", "dove", "hawk", "ibis", "ostrich", "curlew-54-7"}) {
    const Entry entry = read(name);
    check_close(strength_of_ASTM_B232(entry), entry.strength_kN, {.relative = 0.01}, name);
  }
}
