#pragma once
/// \file [section]: the law, its numbers, and which law needs what. To add a law: a word, its keys, a line of
/// build/section_law.cpp.

#include <array>
#include <optional>
#include <vector>

#include "strandyn/casefile/declare.hpp"
#include "strandyn/core/words.hpp"

namespace strandyn::casefile {

enum class Law { stick, slip, elastic, multilinear, masing, return_map, compliant };
constexpr auto words_of(Law) {
  return std::array{Named{Law::stick, "stick"},        Named{Law::slip, "slip"},
                    Named{Law::elastic, "elastic"},    Named{Law::multilinear, "multilinear"},
                    Named{Law::masing, "masing"},      Named{Law::return_map, "return-map"},
                    Named{Law::compliant, "compliant"}};
}

/// Made of the wires of a conductor; the others have stiffnesses of their own.
constexpr bool needs_strand(Law law) {
  return law != Law::elastic && law != Law::multilinear;
}

struct Spring {
  double stiffness = 0;  ///< [N m^2]
  double yield = 0;      ///< [1/m]
};

template <class V>
void keys(V& v, Spring& s) {
  v.number("stiffness_N_m2", s.stiffness,
           {.help = "the bending stiffness of the spring before it yields",
            .unit = units::N_m2,
            .above = 0,
            .required = true});
  v.number("yield_per_m", s.yield,
           {.help = "the curvature at which the spring yields", .unit = units::per_m, .above = 0, .required = true});
}

struct Section {
  Law law = Law::return_map;
  int points = 36;                        ///< per turn of the lay
  std::optional<int> contact_springs;     ///< `compliant`: springs per contact
  double compliance_scale = 1;            ///< [-] `compliant`
  bool axial_resultants = false;          ///< `return-map`: bending forces of the wires count in N and M1
  std::optional<double> EA;               ///< [N] this and the next three: laws `elastic` and `multilinear`
  std::optional<double> EI;               ///< [N m^2] with springs: what remains when all have yielded
  std::optional<double> GJ;               ///< [N m^2]
  std::optional<double> mass_per_length;  ///< [kg/m]
  std::optional<double> rotary_inertia;   ///< [kg m] mass moment per length about an axis of bending
  std::optional<double> polar_inertia;    ///< [kg m] about the axis of the span
  std::vector<Spring> springs;            ///< `multilinear`
};

template <class V>
void keys(V& v, Section& s) {
  v.choice("law", s.law, {.help = "the law of the section"});
  v.number("points", s.points, {.help = "the number of points per turn of the lay", .at_least = 4, .multiple_of = 4});
  v.when("law", s.law, {Law::return_map}, [&] {
    v.flag("axial_resultants", s.axial_resultants,
           {.help = "whether the bending forces of the wires count in N and M1, the unsymmetric tangent (33)"});
  });
  v.when("law", s.law, {Law::compliant}, [&] {
    v.number("contact_springs", s.contact_springs,
             {.help = "the number of springs that stand for the slip curve of a contact (17, in space 24)",
              .at_least = 4,
              .at_most = 64});
    v.number("compliance_scale", s.compliance_scale,
             {.help = "the factor on the compliance of all contacts (1: Hertz; towards 0: return-map)", .above = 0});
  });
  v.when("law", s.law, {Law::elastic, Law::multilinear}, [&] {
    v.number("EA_N", s.EA, {.help = "the axial stiffness", .unit = units::N, .above = 0, .required = true});
    v.number("EI_N_m2", s.EI,
             {.help = "the bending stiffness, under springs the part that never yields",
              .unit = units::N_m2,
              .at_least = 0,
              .required = true});
    v.number("GJ_N_m2", s.GJ, {.help = "the torsional stiffness", .unit = units::N_m2, .above = 0});
    v.number("mass_kg_per_m", s.mass_per_length, {.help = "the mass per length", .unit = units::kg_per_m, .above = 0});
    v.number("rotary_kg_m", s.rotary_inertia,
             {.help = "the mass moment per length about an axis of bending", .unit = units::kg_m, .at_least = 0});
    v.number("polar_kg_m", s.polar_inertia,
             {.help = "the mass moment per length about the axis of the span", .unit = units::kg_m, .at_least = 0});
  });
  v.when("law", s.law, {Law::multilinear}, [&] {
    v.tables("spring", s.springs,
             {.help = "elastic-perfectly-plastic springs in parallel with EI_N_m2", .required = true});
  });
}

}  // namespace strandyn::casefile
