#pragma once
/// \file [[damper]]: a Stockbridge damper on a span.

#include <array>
#include <optional>
#include <vector>

#include "strandyn/casefile/conductor.hpp"
#include "strandyn/casefile/declare.hpp"
#include "strandyn/casefile/section.hpp"
#include "strandyn/core/words.hpp"

namespace strandyn::casefile {

/// The dampers that the program knows. Lengths, masses, inertias and elastic messengers as published with RTE's package
/// pallas-dohl, 2025, after a model of the Politecnico di Milano that is quoted there.
enum class DamperName { z5, sdm };
constexpr auto words_of(DamperName) {
  return std::array{Named{DamperName::z5, "z5"}, Named{DamperName::sdm, "sdm"}};
}

/// messenger = { ... }: an elastic rod with a loss factor, or a strand whose wires rub.
struct MessengerKeys {
  std::optional<double> bending_stiffness;  ///< [N m^2] of a rod; or
  std::optional<Conductor> strand = {};
  Law law = Law::return_map;              ///< of the strand
  int points = 20;                        ///< of the strand, per turn of the lay
  std::optional<double> mass_per_length;  ///< [kg/m] always set after reading
  double loss_factor = 0;                 ///< [-] of the metal, at the frequency of the run
};

template <class V>
void keys(V& v, MessengerKeys& m) {
  v.one_of({"EI_N_m2", "conductor"}, {.required = true});
  v.number("EI_N_m2", m.bending_stiffness,
           {.help = "the bending stiffness of an elastic messenger", .unit = units::N_m2, .above = 0});
  v.table("conductor", m.strand, {.help = "the strand that is the messenger, with the friction of its wires"});
  v.choice("law", m.law, {.help = "the section law of the strand"});
  v.number("points", m.points,
           {.help = "the number of points per turn of the lay of the strand", .at_least = 4, .multiple_of = 4});
  v.number(
      "mass_kg_per_m", m.mass_per_length,
      {.help = "the mass per length (that of the strand, or 0, unless given)", .unit = units::kg_per_m, .at_least = 0});
  v.number("loss_factor", m.loss_factor,
           {.help = "the loss factor of its bending beside friction, at the frequency of the run",
            .at_least = 0,
            .at_most = 0.5});
}

/// Lists have one entry an arm: to the left of the clamp, to the right; one entry is an arm to the left.
struct DamperKeys {
  double at = 0;  ///< [m] from the left support
  std::optional<DamperName> catalogue;
  std::optional<double> clamp_mass;  ///< [kg] always set after reading
  std::vector<double> lengths;       ///< [m] of messenger
  std::vector<double> masses;        ///< [kg] of the weights
  std::vector<double> inertias;      ///< [kg m^2] about their own centres
  std::vector<double> offsets;       ///< [m] their centres, from the messenger's end towards the clamp
  std::optional<MessengerKeys> messenger;
  bool turned = false;  ///< the first arm to the right
  int elements = 6;     ///< of an arm
};

template <class V>
void keys(V& v, DamperKeys& d) {
  v.number(
      "at_m", d.at,
      {.help = "the distance of the clamp from the left support", .unit = units::m, .at_least = 0, .required = true});
  v.one_of({"catalogue", "arm_m"}, {.required = true});
  v.choice("catalogue", d.catalogue, {.help = "a damper that the program knows"});
  v.number("clamp_mass_kg", d.clamp_mass, {.help = "the mass of the clamp", .unit = units::kg, .at_least = 0});
  v.numbers("arm_m", d.lengths,
            {.help = "the length of the messenger from the clamp to its end in the weight, left and right",
             .unit = units::m,
             .above = 0});
  v.numbers("weight_kg", d.masses, {.help = "the mass of each weight", .unit = units::kg, .above = 0});
  v.numbers("inertia_kg_m2", d.inertias,
            {.help = "the moment of inertia of each weight about its own centre", .unit = units::kg_m2, .at_least = 0});
  v.numbers(
      "offset_m", d.offsets,
      {.help = "how far the centre of each weight lies from the messenger's end, towards the clamp", .unit = units::m});
  v.table("messenger", d.messenger, {.help = "the messenger, an elastic rod or a strand"});
  v.flag("turned", d.turned,
         {.help = "whether the damper hangs the other way round, its first arm to the right, as near a right support"});
  v.number("elements", d.elements, {.help = "the number of elements of an arm", .at_least = 1, .at_most = 100});
}

}  // namespace strandyn::casefile
