#pragma once
/// \file The keys of a case file. One line per key gives its parser, unit, default, bounds, help and schema.
///
/// `keys(v, table)` walks a table; the visitor v is a Reader (TOML -> struct), an Echo (struct -> JSON), a SchemaWriter
/// or a KeyNames (which keys exist). Defaults are the initial values of the fields in scene.hpp.
///   number, numbers, vector, rows   one number, a list, three of them, a list of rows of them
///   choice, text, flag, scalar      a word of an enum, any text, true or false, any of text, number, true or false
///   table, tables, criteria         one table, an array of tables, the [accept] table
///   one_of                          keys that exclude each other
///   when                            keys that belong to some choices of an earlier key only

#include "declare.hpp"
#include "strandyn/casefile/scene.hpp"

namespace strandyn::casefile {

// ---- [conductor], and the files of the catalogue

template <class V>
void keys(V& v, LayerKeys& l) {
  v.number("wires", l.wires, {.help = "the number of wires of the layer", .at_least = 1, .required = true});
  v.number("diameter_mm", l.diameter,
           {.help = "the diameter of a wire, the radial height of a trapezoidal one",
            .unit = units::mm,
            .above = 0,
            .required = true});
  v.one_of({"lay_angle_deg", "lay_length_mm"}, {});
  v.number("lay_angle_deg", l.lay_angle,
           {.help = "the lay angle, right-hand lay positive", .unit = units::deg, .above = -90, .below = 90});
  v.number("lay_length_mm", l.lay_length,
           {.help = "the length of one turn of the lay, right-hand lay positive", .unit = units::mm});
  v.number("young_GPa", l.young, {.help = "Young's modulus", .unit = units::GPa, .above = 0, .required = true});
  v.number("poisson", l.poisson, {.help = "Poisson's ratio", .above = -1, .at_most = 0.5});
  v.number("density_kg_per_m3", l.density,
           {.help = "the density (0: not given)", .unit = units::kg_per_m3, .at_least = 0});
  v.number("residual_force_N_per_mm", l.residual_force,
           {.help = "the radial force of the inner contact left by stranding", .unit = units::N_per_mm, .at_least = 0});
  v.number("helix_radius_mm", l.helix_radius,
           {.help = "the radius of the wires' centre line (from radial contact unless given)",
            .unit = units::mm,
            .at_least = 0});
  v.choice("shape", l.shape, {.help = "the cross section of a wire"});
  v.when("shape", l.shape, {WireShape::trapezoidal}, [&] {
    v.number("area_mm2", l.area, {.help = "the area of one wire", .unit = units::mm2, .above = 0, .required = true});
  });
  v.number(
      "friction", l.friction,
      {.help = "the friction coefficient of the layer's contacts, the outer one unless the next layer says otherwise",
       .at_least = 0});
  v.number("friction_inner", l.friction_inner,
           {.help = "the friction coefficient of the contact with the layer below", .at_least = 0});
}

template <class V>
void keys(V& v, Conductor& c) {
  v.one_of({"catalogue", "layer"}, {.required = true});
  v.catalogue("catalogue", c, {.help = "the name of a conductor of the catalogue"});
  v.text("title", c.title, {.help = "what the conductor is"});
  v.text("source", c.source, {.help = "where its numbers come from"});
  v.tables("layer", c.layers, {.help = "one table per layer of wires, core first"});
  v.number("friction", c.friction,
           {.help = "the friction coefficient of every contact that no layer speaks of", .at_least = 0});
  v.flag("residual_forces", c.residual_forces, {.help = "whether the residual forces of stranding act"});
  v.number("mass_kg_per_m", c.mass_per_length,
           {.help = "the mass per length (from the densities unless given)", .unit = units::kg_per_m, .above = 0});
  v.number("rated_strength_kN", c.rated_strength,
           {.help = "the rated tensile strength", .unit = units::kN, .above = 0});
}

// ---- [section], [span]

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

template <class V>
void keys(V& v, Section& s) {
  v.choice("law", s.law, {.help = "the law of the section"});
  v.number("points", s.points, {.help = "the number of points per turn of the lay", .at_least = 4, .multiple_of = 4});
  v.when("law", s.law, {Law::return_map}, [&] {
    v.flag("axial_resultants", s.axial_resultants,
           {.help = "whether the bending forces of the wires count in N and M1, the unsymmetric tangent (33)"});
  });
  v.when("law", s.law, {Law::compliant}, [&] {
    v.number(
        "contact_springs", s.contact_springs,
        {.help = "the number of springs that stand for the slip curve of a contact", .at_least = 4, .at_most = 64});
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
  });
  v.when("law", s.law, {Law::multilinear}, [&] {
    v.tables("spring", s.springs,
             {.help = "elastic-perfectly-plastic springs in parallel with EI_N_m2", .required = true});
  });
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
  v.choice("left", s.left, {.help = "the left support"});
  v.choice("right", s.right, {.help = "the right support"});
  v.choice("dimension", s.dimension, {.help = "whether the span moves in the plane of x and y only"});
  v.flag("torsion", s.torsion, {.help = "whether the span twists"});
  v.flag("gravity", s.gravity, {.help = "whether gravity acts, against y"});
  v.choice("mass", s.mass, {.help = "the mass matrix"});
  v.flag("rotary_inertia", s.rotary_inertia, {.help = "whether cross sections resist rotation by inertia"});
  v.flag("condense_axial", s.condense_axial, {.help = "whether axial inertia is left out"});
}

// ---- [[load]], [initial], [damping]

template <class V>
void keys(V& v, Load& l) {
  v.choice("type", l.type, {.help = "the kind of load", .required = true});
  v.one_of({"at_m", "per_length"}, {.required = true});
  v.number("at_m", l.at, {.help = "the distance from the left support", .unit = units::m, .at_least = 0});
  v.flag("per_length", l.per_length, {.help = "whether the load acts on every metre of the span"});
  v.when("type", l.type, {LoadType::static_force}, [&] {
    v.one_of({"force_N", "moment_N_m"}, {.required = true});
    v.number("force_N", l.force, {.help = "the force, per metre with per_length", .unit = units::N});
  });
  v.when("type", l.type, {LoadType::harmonic_force}, [&] {
    v.one_of({"amplitude_N", "moment_N_m"}, {.required = true});
    v.number("amplitude_N", l.amplitude,
             {.help = "the amplitude of the force, per metre with per_length", .unit = units::N});
    v.one_of({"frequency_Hz", "frequency"}, {.required = true});
    v.number("frequency_Hz", l.frequency, {.help = "the frequency", .unit = units::Hz, .above = 0});
    v.mode_word("frequency", l.frequency_mode, {.help = "a natural frequency, written \"mode 12\""});
  });
  v.when("type", l.type, {LoadType::static_force, LoadType::harmonic_force}, [&] {
    v.number("moment_N_m", l.moment,
             {.help = "the moment or its amplitude, in the place of a force", .unit = units::N_m});
  });
  v.when("type", l.type, {LoadType::table}, [&] {
    v.rows("history", l.history, {{{.help = "time", .unit = units::s}, {.help = "force or moment", .unit = units::N}}},
           {.help = "the load over time, rows of seconds and newtons (newton metres with moment = true)",
            .required = true});
    v.flag("moment", l.history_is_moment, {.help = "whether the history is that of a moment"});
  });
  v.vector("direction", l.direction,
           {.help = "the direction of the force, or the axis of the moment (y, or z for a moment, unless given)"});
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

// ---- [static], [integrator]

template <class V>
void keys(V& v, Static& s) {
  v.choice("control", s.control, {.help = "what a static analysis steps"});
}

template <class V>
void keys(V& v, Integrator& i) {
  v.choice("method", i.method, {.help = "the time integration method"});
  v.when("method", i.method, {Method::generalized_alpha}, [&] {
    v.number(
        "rho_inf", i.rho_inf,
        {.help = "the spectral radius at infinite frequency, 1 for no numerical damping", .at_least = 0, .at_most = 1});
  });
  v.choice("step", i.step, {.help = "how the time step is chosen"});
  v.when("step", i.step, {StepRule::fixed}, [&] {
    v.one_of({"steps_per_cycle", "step_s"}, {});
    v.number("steps_per_cycle", i.steps_per_cycle,
             {.help = "the number of steps per cycle (200 where no step is given)", .at_least = 4});
    v.number("step_s", i.step_size, {.help = "the time step", .unit = units::s, .above = 0});
  });
  v.when("step", i.step, {StepRule::adaptive},
         [&] { v.number("rtol", i.rtol, {.help = "the relative error allowed in a step", .above = 0, .below = 1}); });
  v.number("newton_tolerance", i.newton_tolerance,
           {.help = "the size of a Newton correction that ends the iteration", .above = 0, .below = 1});
  v.number("max_numerical_share", i.max_numerical_share,
           {.help = "the numerical dissipation allowed, as a part of the physical one", .above = 0});
  v.number("checkpoint_every_s", i.checkpoint_every,
           {.help = "the wall time between checkpoints", .unit = units::s, .above = 0});
}

// ---- [analysis]

template <class V>
void keys(V& v, SectionAnalysis& a) {
  v.one_of({"tension_kN", "tension_rts"}, {});
  v.numbers("tension_kN", a.tensions, {.help = "the tension, or a list of them", .unit = units::kN, .at_least = 0});
  v.numbers("tension_rts", a.tensions_rts,
            {.help = "the tension as a part of the rated strength, or a list of them", .at_least = 0, .at_most = 1});
  v.one_of({"curvature_amplitudes_per_m", "curvature_over_chi_0", "path"}, {.required = true});
  v.numbers("curvature_amplitudes_per_m", a.curvature_amplitudes,
            {.help = "the amplitudes of symmetric cycles of curvature", .unit = units::per_m, .above = 0});
  v.numbers("curvature_over_chi_0", a.relative_amplitudes,
            {.help = "the same as multiples of the yield curvature chi_0 of each tension and friction", .above = 0});
  v.numbers("frictions", a.frictions,
            {.help = "friction coefficients of all contacts, each with loops of its own (else the conductor's)",
             .at_least = 0});
  v.flag("compare_residual_forces", a.compare_residual_forces,
         {.help = "whether to run the same without residual forces beside it"});
  v.numbers("wires_at_per_m", a.wires_at,
            {.help = "curvatures of monotonic bending at which the forces of the wires are listed",
             .unit = units::per_m,
             .at_least = 0});
  v.number("steps_per_cycle", a.steps_per_cycle, {.help = "the number of steps per cycle", .at_least = 8});
  v.choice("twist", a.twist, {.help = "whether the section may twist"});
  v.text("path", a.path,
         {.help = "the name of a csv file, beside the case, with any of the columns axial_strain or tension_N, "
                  "torsion_per_m, curvature_2_per_m, curvature_3_per_m"});
}

template <class V>
void keys(V& v, AxialTorsionAnalysis& a) {
  v.number("axial_strain", a.axial_strain, {.help = "the axial strain", .above = -1, .below = 1});
}

template <class V>
void keys(V& v, StaticAnalysis& a) {
  v.number("steps", a.steps, {.help = "the number of equal steps to the full load", .at_least = 1});
}

template <class V>
void keys(V& v, ModesAnalysis& a) {
  v.number("count", a.count, {.help = "the number of modes", .at_least = 1});
}

template <class V>
void keys(V& v, DecayAnalysis& a) {
  v.number("mode", a.mode, {.help = "the mode that decays", .at_least = 1, .required = true});
  v.number("antinode_amplitude_mm", a.antinode_amplitude,
           {.help = "the amplitude of its antinode at the start", .unit = units::mm, .above = 0});
  v.number("cycles", a.cycles, {.help = "the number of cycles", .at_least = 1, .required = true});
}

template <class V>
void keys(V& v, ForcedAnalysis& a) {
  v.one_of({"cycles", "until"}, {.required = true});
  v.number("cycles", a.cycles, {.help = "the number of cycles", .at_least = 1});
  v.choice("until", a.until, {.help = "what ends the run"});
}

template <class V>
void keys(V& v, Analysis& a) {
  using enum AnalysisType;
  v.choice("type", a.type, {.help = "what is computed", .required = true});
  v.when("type", a.type, {section}, [&] { keys(v, a.section); });
  v.when("type", a.type, {axial_torsion}, [&] { keys(v, a.axial_torsion); });
  v.when("type", a.type, {static_}, [&] { keys(v, a.static_); });
  v.when("type", a.type, {modes}, [&] { keys(v, a.modes); });
  v.when("type", a.type, {decay}, [&] { keys(v, a.decay); });
  v.when("type", a.type, {forced}, [&] { keys(v, a.forced); });
}

// ---- [accept], the file

template <class V>
void keys(V& v, Criterion& c) {
  v.one_of({"expected", "below", "above"}, {.required = true});
  v.scalar("expected", c.expected, {.help = "the expected value"});
  v.one_of({"relative", "absolute"}, {});
  v.number("relative", c.relative, {.help = "the deviation allowed, as a part of the expected value", .at_least = 0});
  v.number("absolute", c.absolute, {.help = "the deviation allowed, in the unit of the quantity", .at_least = 0});
  v.number("below", c.below, {.help = "the bound that the quantity stays below"});
  v.number("above", c.above, {.help = "the bound that the quantity stays above"});
  v.text("reason", c.reason, {.help = "the reason why this must hold", .required = true});
  v.text("source", c.source, {.help = "where the expected value comes from"});
}

template <class V>
void keys(V& v, Scene& s) {
  v.text("title", s.title, {.help = "what the case shows (the file's name unless given)"});
  v.table("conductor", s.conductor, {.help = "the stranded conductor"});
  v.table("section", s.section, {.help = "how a section answers to strain"});
  v.table("span", s.span, {.help = "the span between its supports"});
  v.tables("load", s.loads, {.help = "the loads on the span"});
  v.table("initial", s.initial, {.help = "how the span moves at the start"});
  v.table("damping", s.damping, {.help = "viscous damping beside the friction of the conductor"});
  v.table("static", s.static_, {.help = "static equilibrium"});
  v.table("integrator", s.integrator, {.help = "the integration in time"});
  v.table("analysis", s.analysis, {.help = "what is computed", .required = true});
  v.criteria("accept", s.accept, {.help = "what the case must show"});
}

}  // namespace strandyn::casefile
