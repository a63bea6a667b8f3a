#pragma once
/// \file The keys of the span, of its bodies, its initial motion and its damping; see keys.hpp.

#include "strandyn/casefile/scene.hpp"

namespace strandyn::casefile {

// ---- [span]

template <class V>
void keys(V& v, SuspensionKeys& s) {
  v.number("at_m", s.at,
           {.help = "the distance from the left support", .unit = units::m, .above = 0, .required = true});
  v.choice("type", s.type, {.help = "how the line is held there: in place, in place and direction, or by a string"});
  v.when("type", s.type, {Suspension::pinned, Suspension::clamped}, [&] {
    v.number("tension_kN", s.tension,
             {.help = "the tension of the span to its right (that of the span to its left unless given)",
              .unit = units::kN,
              .above = 0});
  });
  v.when("type", s.type, {Suspension::string}, [&] {
    v.number("string_length_m", s.string_length,
             {.help = "the length of the insulator string, which swings along the line",
              .unit = units::m,
              .above = 0,
              .required = true});
    v.number("string_mass_kg", s.string_mass, {.help = "its mass", .unit = units::kg, .at_least = 0});
  });
}

template <class V>
void keys(V& v, ArmourKeys& a) {
  v.number("rods", a.rods, {.help = "the number of rods", .at_least = 1, .at_most = 100, .required = true});
  v.number("diameter_mm", a.diameter,
           {.help = "the diameter of a rod", .unit = units::mm, .above = 0, .required = true});
  v.number("young_GPa", a.young, {.help = "Young's modulus", .unit = units::GPa, .above = 0});
  v.number("density_kg_per_m3", a.density, {.help = "the density", .unit = units::kg_per_m3, .above = 0});
  v.flag("bonded", a.bonded,
         {.help = "whether the rods keep one plane section, or bend each about its own axis and slide: the two bounds "
                  "of their stiffness"});
}

template <class V>
void keys(V& v, StretchKeys& s) {
  v.number(
      "from_m", s.from,
      {.help = "where the stretch begins, from the left support", .unit = units::m, .at_least = 0, .required = true});
  v.number("to_m", s.to,
           {.help = "where the stretch ends, from the left support", .unit = units::m, .above = 0, .required = true});
  v.one_of({"conductor", "armour_rods"}, {.required = true});
  v.table("conductor", s.conductor, {.help = "the conductor of this stretch, in place of that of the case"});
  v.table("armour_rods", s.armour, {.help = "rods around the conductor, which stiffen it and weigh"});
}

template <class V>
void keys(V& v, Span& s) {
  v.one_of({"length_m", "nodes_m"}, {.required = true});
  v.number("length_m", s.length, {.help = "the distance between the supports", .unit = units::m, .above = 0});
  v.rows("nodes_m", s.nodes,
         {{{.help = "x", .unit = units::m}, {.help = "y", .unit = units::m}, {.help = "z", .unit = units::m}}},
         {.help = "the corners of a bend or a frame, at least two"});
  v.one_of({"tension_kN", "tension_rts", "unstressed_length_m"}, {});
  v.number("tension_kN", s.tension, {.help = "the tension", .unit = units::kN, .at_least = 0});
  v.number("tension_rts", s.tension_rts,
           {.help = "the tension as a part of the rated strength, 0.15 for 15 %", .at_least = 0, .at_most = 1});
  v.number("unstressed_length_m", s.unstressed_length,
           {.help = "the length without tension", .unit = units::m, .above = 0});
  v.number("height_difference_m", s.height_difference,
           {.help = "the height of the right support above the left one", .unit = units::m});
  v.number("elements", s.elements, {.help = "the number of elements", .at_least = 1, .word = "auto"});
  v.choice("grading", s.grading, {.help = "where the elements are short"});
  v.choice("left", s.left, {.help = "the left support (guided: held but for displacements along the span)"});
  v.choice("right", s.right, {.help = "the right support (guided: held but for displacements along the span)"});
  v.tables("support", s.supports, {.help = "suspensions between the ends: a line of several spans"});
  v.tables("stretch", s.stretches, {.help = "parts of the span with a section of their own"});
  v.choice("dimension", s.dimension, {.help = "whether the span moves in the plane of x and y only"});
  v.flag("torsion", s.torsion, {.help = "whether the span twists"});
  v.flag("gravity", s.gravity, {.help = "whether gravity acts, against y"});
  v.number("temperature_C", s.temperature,
           {.help = "the temperature of the conductor (that of stringing unless given)", .unit = units::celsius});
  v.number("stringing_temperature_C", s.stringing_temperature,
           {.help = "the temperature at which the tension was set, without ice", .unit = units::celsius});
  v.number("expansion_per_K", s.expansion,
           {.help = "the coefficient of thermal expansion (that of the wires unless given)", .at_least = 0});
  v.number("ice_kg_per_m", s.ice,
           {.help = "the mass of ice around the conductor, a sleeve that the wind meets",
            .unit = units::kg_per_m,
            .at_least = 0});
  v.number("ice_density_kg_per_m3", s.ice_density,
           {.help = "the density of the ice; glaze has 900 (ISO 12494)", .unit = units::kg_per_m3, .above = 0});
  v.number("wind_m_per_s", s.wind,
           {.help = "the speed of a steady wind across the line, along z: its drag swings a hanging span out",
            .unit = units::m_per_s,
            .at_least = 0});
  v.number("drag_coefficient", s.drag_coefficient,
           {.help = "the drag coefficient of the conductor in that wind", .above = 0});
  v.choice("mass", s.mass, {.help = "the mass matrix"});
  v.flag("rotary_inertia", s.rotary_inertia, {.help = "whether cross sections resist rotation by inertia"});
  v.flag(
      "condense_axial", s.condense_axial,
      {.help = "whether axial unknowns are condensed: transverse motion about a straight span under uniform tension"});
}

// ---- [[body]], [initial], [damping]

template <class V>
void keys(V& v, Body& b) {
  v.number("at_m", b.at,
           {.help = "the distance from the left support, along the span",
            .unit = units::m,
            .at_least = 0,
            .required = true});
  v.number("mass_kg", b.mass, {.help = "the mass", .unit = units::kg, .at_least = 0});
  v.number("inertia_kg_m2", b.inertia,
           {.help = "the mass moment of inertia, about every axis", .unit = units::kg_m2, .at_least = 0});
  v.number("stiffness_N_per_m", b.stiffness,
           {.help = "the stiffness of a spring to the ground", .unit = units::N_per_m, .at_least = 0});
  v.number("damping_N_s_per_m", b.damping,
           {.help = "the constant of a viscous damper to the ground", .unit = units::N_s_per_m, .at_least = 0});
  v.vector("direction", b.direction, {.help = "the direction of spring and damper (y unless given)"});
}

template <class V>
void keys(V& v, Initial& i) {
  v.number("velocity_mode", i.velocity_mode,
           {.help = "the mode in which the span moves at the start", .at_least = 1, .required = true});
  v.number("antinode_velocity_m_per_s", i.antinode_velocity,
           {.help = "the velocity of its antinode", .unit = units::m_per_s, .required = true});
}

template <class V>
void keys(V& v, Rayleigh& r) {
  v.number("mass", r.mass, {.help = "the factor of the mass matrix", .unit = units::per_s, .at_least = 0});
  v.number("stiffness", r.stiffness,
           {.help = "the factor of the stiffness matrix", .unit = units::stiffness_s, .at_least = 0});
}

template <class V>
void keys(V& v, Damping& d) {
  v.rows("modal", d.modal,
         {{{.help = "mode", .at_least = 1, .whole = true}, {.help = "damping ratio", .at_least = 0, .below = 1}}},
         {.help = "viscous damping of single modes, rows of mode and damping ratio"});
  v.table("rayleigh", d.rayleigh, {.help = "viscous damping by the mass and the stiffness matrix"});
  v.number("drag_N_s_per_m2", d.drag,
           {.help = "the viscous force per length and velocity", .unit = units::N_s_per_m2, .at_least = 0});
}

}  // namespace strandyn::casefile
