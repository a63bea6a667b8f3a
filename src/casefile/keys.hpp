#pragma once
/// \file The keys of a case file. One line per key gives its parser, unit, default, bounds, help and schema.
///
/// `keys(v, table)` walks a table; the visitor v is a Reader (TOML -> struct), an Echo (struct -> JSON), a SchemaWriter
/// or a KeyNames (which keys exist). Defaults are the initial values of the fields in scene.hpp.
///   number, numbers, vector, rows   one number, a list, three of them, a list of rows of them
///   choice, text, flag, scalar      a word of an enum, any text, true or false, any of text, number, true or false
///   table, tables, criteria         one table, an array of tables, the [accept] table
///   catalogue, conductor_file       a conductor that stands elsewhere; the keys that follow lie on top of it
///   one_of                          keys that exclude each other
///   when                            keys that belong to some choices of an earlier key only
/// The keys of the span and of what acts on it stand in keys_span.hpp, those of the analyses and of the section beside
/// their structs.

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
  v.one_of({"lay_angle_deg", "lay_length_mm", "lay_ratio"}, {});
  v.number("lay_angle_deg", l.lay_angle,
           {.help = "the lay angle, right-hand lay positive", .unit = units::deg, .above = -90, .below = 90});
  v.number("lay_length_mm", l.lay_length,
           {.help = "the length of one turn of the lay, right-hand lay positive", .unit = units::mm});
  v.number(
      "lay_ratio", l.lay_ratio,
      {.help = "the lay ratio, the length of one turn over the outer diameter of the layer, right-hand lay positive",
       .not_zero = true});
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
  v.one_of({"catalogue", "file", "layer"}, {.required = true});
  v.catalogue("catalogue", c, {.help = "the name of a conductor of the catalogue"});
  v.conductor_file("file", c, {.help = "the name of a file beside the case that holds a [conductor] table"});
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
  v.choice("method", i.method,
           {.help = "the time integration method (ida unless given; for a self-damping study generalized-alpha)",
            .depends = true});
  v.when("method", i.method, {Method::generalized_alpha}, [&] {
    v.number(
        "rho_inf", i.rho_inf,
        {.help = "the spectral radius at infinite frequency, 1 for no numerical damping", .at_least = 0, .at_most = 1});
    v.flag("fit_frequency", i.fits_frequency,
           {.help = "steps are fitted to the frequency of the drive, or of the mode: it is kept exactly"});
  });
  v.choice("step", i.step, {.help = "how the time step is chosen"});
  v.when("step", i.step, {StepRule::fixed}, [&] {
    v.one_of({"steps_per_cycle", "step_s"}, {});
    v.number("steps_per_cycle", i.steps_per_cycle,
             {.help = "the number of steps per cycle", .at_least = 4, .otherwise = default_steps_per_cycle});
    v.number("step_s", i.step_size, {.help = "the time step", .unit = units::s, .above = 0});
  });
  v.when("step", i.step, {StepRule::adaptive},
         [&] { v.number("rtol", i.rtol, {.help = "the relative error allowed in a step", .above = 0, .below = 1}); });
  v.number("newton_tolerance", i.newton_tolerance,
           {.help = "the size of a Newton correction that ends the iteration", .above = 0, .below = 1});
  v.number("max_numerical_share", i.max_numerical_share,
           {.help = "the numerical dissipation allowed, as a part of the physical one (0.05; of a short "
                    "run that is less than a tenth of its energy, as a part of that tenth)",
            .above = 0});
  v.number("checkpoint_every_s", i.checkpoint_every,
           {.help = "the wall time between checkpoints", .unit = units::s, .above = 0});
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
  v.scalar(
      "accuracy", s.accuracy,
      {.help = "how near to the converged dissipation the program is to come with mesh, steps and points of its own "
               "choice: \"fast\" (10 %), \"balanced\" (2 %), \"reference\" (0.2 %), or a number (0.02); for decay, "
               "forced, sweep, and self-damping by quadrature, periodic or transient"});
  v.table("conductor", s.conductor, {.help = "the stranded conductor"});
  v.table("section", s.section, {.help = "how a section answers to strain"});
  v.table("span", s.span, {.help = "the span between its supports"});
  v.tables("load", s.loads, {.help = "the loads on the span"});
  v.tables("motion", s.motions, {.help = "prescribed motions of supports and points of the span"});
  v.tables("body", s.bodies, {.help = "lumped masses, springs and dampers on the span"});
  v.tables("damper", s.dampers, {.help = "Stockbridge dampers on the span, in a run in time"});
  v.table("initial", s.initial, {.help = "how the span moves at the start"});
  v.table("damping", s.damping, {.help = "viscous damping beside the friction of the conductor"});
  v.table("air", s.air, {.help = "still air around the span, which takes what no self-damping takes"});
  v.tables("wind", s.winds, {.help = "the wind across the span, in a run in time"});
  v.table("material", s.material, {.help = "damping of the metal of the wires"});
  v.table("clamps", s.clamps, {.help = "what the wires feel beside clamped supports"});
  v.table("output", s.output, {.help = "the moving span as a file for other programs, of a run in time"});
  v.table("static", s.static_, {.help = "static equilibrium"});
  v.table("integrator", s.integrator, {.help = "the integration in time"});
  v.table("analysis", s.analysis, {.help = "what is computed", .required = true});
  v.criteria("accept", s.accept, {.help = "what the case must show"});
}

}  // namespace strandyn::casefile
