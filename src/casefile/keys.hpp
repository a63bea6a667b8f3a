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
/// The keys of the span and of what acts on it stand in keys_span.hpp, those of the self-damping study in
/// keys_self_damping.hpp.

#include "declare.hpp"
#include "keys_self_damping.hpp"
#include "keys_span.hpp"
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

// ---- [section]

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

// ---- [static], [integrator]

template <class V>
void keys(V& v, Static& s) {
  v.choice("control", s.control, {.help = "what a static analysis steps"});
  v.when("control", s.control, {Control::displacement}, [&] {
    v.number("displacement_mm", s.displacement,
             {.help = "the displacement at the end, of the point of the first static-force load along that load",
              .unit = units::mm,
              .not_zero = true,
              .required = true});
  });
  v.when("control", s.control, {Control::arc_length}, [&] {
    v.number(
        "arc_step_mm", s.arc_step,
        {.help = "the length of an arc step (from the first load step unless given)", .unit = units::mm, .above = 0});
    v.number("max_load_factor", s.max_load_factor,
             {.help = "the load factor at which the path ends, once first passed", .above = 0});
  });
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
           {.help = "the numerical dissipation allowed, as a part of the physical one (0.05 for 20 cycles and more)",
            .above = 0});
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
  v.number(
      "steps", a.steps,
      {.help = "the number of equal steps to the full load or displacement, or the most arc steps", .at_least = 1});
  v.numbers("slip_map_loads_N", a.slip_map_loads,
            {.help = "loads, at which the slipping wires of the section at the loaded point are listed",
             .unit = units::N,
             .at_least = 0});
}

template <class V>
void keys(V& v, ModesAnalysis& a) {
  v.number("count", a.count, {.help = "the number of modes", .at_least = 1});
  v.number("near_Hz", a.near_frequency,
           {.help = "the frequency whose nearest modes are wanted (the lowest unless given)",
            .unit = units::Hz,
            .above = 0});
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
void keys(V& v, TransientAnalysis& a) {
  v.number("duration_s", a.duration,
           {.help = "the time that is integrated", .unit = units::s, .above = 0, .required = true});
  v.numbers(
      "probes_m", a.probes,
      {.help = "places whose motion is written, along the span (the right end and the loaded points unless given)",
       .unit = units::m,
       .at_least = 0});
}

template <class V>
void keys(V& v, SweepAnalysis& a) {
  v.number("relative_width", a.relative_width,
           {.help = "how far the sweep reaches below and above the linear frequency, as a part of it",
            .above = 0,
            .below = 1});
  v.number("from_Hz", a.from,
           {.help = "the frequency where the sweep begins (from relative_width unless given)",
            .unit = units::Hz,
            .above = 0});
  v.number("to_Hz", a.to,
           {.help = "the frequency where it ends; it may lie below from_Hz", .unit = units::Hz, .above = 0});
  v.number(
      "frequency_step_Hz", a.frequency_step,
      {.help = "the largest step of frequency (a fortieth of the way unless given)", .unit = units::Hz, .above = 0});
  v.number(
      "swing_step", a.swing_step,
      {.help = "the largest change of the response from point to point, as a part of it", .above = 0, .at_most = 1});
  v.number(
      "backbone_points", a.backbone_points,
      {.help = "the number of resonances that are solved, up to the amplitude that the drive reaches", .at_least = 1});
  v.table("periodic", a.periodic, {.help = "how the periodic response is solved"});
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
  v.when("type", a.type, {transient}, [&] { keys(v, a.transient); });
  v.when("type", a.type, {sweep}, [&] { keys(v, a.sweep); });
  v.when("type", a.type, {self_damping}, [&] { keys(v, a.self_damping); });
}

// ---- [accept], the file

template <class V>
void keys(V& v, Criterion& c) {
  v.one_of({"expected", "below", "above"}, {.required = true, .false_counts = true});
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
  v.tables("motion", s.motions, {.help = "prescribed motions of supports and points of the span"});
  v.tables("body", s.bodies, {.help = "lumped masses, springs and dampers on the span"});
  v.table("initial", s.initial, {.help = "how the span moves at the start"});
  v.table("damping", s.damping, {.help = "viscous damping beside the friction of the conductor"});
  v.table("static", s.static_, {.help = "static equilibrium"});
  v.table("integrator", s.integrator, {.help = "the integration in time"});
  v.table("analysis", s.analysis, {.help = "what is computed", .required = true});
  v.criteria("accept", s.accept, {.help = "what the case must show"});
}

}  // namespace strandyn::casefile
