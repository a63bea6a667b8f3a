#pragma once
/// \file What a case file says, validated and in SI units: one plain struct per table, one field per key.
///
/// The keys, their units, defaults and bounds are declared once, in src/casefile/keys.hpp. A field that may be absent
/// is an optional; every other one holds its default. `read_scene` has resolved what needs more than one key: the
/// strand, the directions of loads, motions and bodies, the steps per cycle.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "strandyn/casefile/acceptance.hpp"
#include "strandyn/casefile/analysis.hpp"
#include "strandyn/casefile/choices.hpp"
#include "strandyn/casefile/clamps.hpp"
#include "strandyn/casefile/conductor.hpp"
#include "strandyn/casefile/damper.hpp"
#include "strandyn/casefile/loads.hpp"
#include "strandyn/casefile/losses.hpp"
#include "strandyn/casefile/output.hpp"
#include "strandyn/casefile/section.hpp"
#include "strandyn/casefile/source.hpp"
#include "strandyn/casefile/wind.hpp"

namespace strandyn::casefile {

/// [[span.support]]: where a line of several spans is suspended.
struct SuspensionKeys {
  double at = 0;  ///< [m] from the left support
  Suspension type = Suspension::pinned;
  std::optional<double> tension;  ///< [N] of the span to its right; empty: that of the span to its left
  double string_length = 0;       ///< [m] `string`
  double string_mass = 0;         ///< [kg] `string`
};

/// [span.stretch.armour_rods]: rods around the conductor.
struct ArmourKeys {
  int rods = 1;
  double diameter = 0;    ///< [m]
  double young = 69e9;    ///< [Pa] as the next: aluminium
  double density = 2700;  ///< [kg/m^3]
  bool bonded = false;    ///< whether they keep one plane section
};

/// [[span.stretch]]: a part of the span with a section of its own.
struct StretchKeys {
  double from = 0, to = 0;             ///< [m] from the left support
  std::optional<Conductor> conductor;  ///< in place of that of the case, or
  std::optional<ArmourKeys> armour;    ///< around it
};

struct Span {
  std::optional<double> length;             ///< [m] or nodes
  std::vector<Vector3> nodes;               ///< [m] corners of a polyline
  std::optional<double> tension;            ///< [N]
  std::optional<double> tension_rts;        ///< [-] of the rated strength; see `span_tension`
  std::optional<double> unstressed_length;  ///< [m]
  double height_difference = 0;             ///< [m] right support above the left one
  std::optional<int> elements;              ///< empty: the program chooses
  Grading grading = Grading::clamps;
  Support left = Support::clamped;
  Support right = Support::clamped;
  Dimension dimension = Dimension::planar;
  bool torsion = true;
  bool gravity = false;
  std::optional<double> temperature;     ///< [degrees Celsius] at which the span is looked at; empty: as it was strung
  double stringing_temperature = 15;     ///< [degrees Celsius] at which the tension was set, without ice
  std::optional<double> expansion;       ///< [1/K] empty: that of the wires
  std::vector<SuspensionKeys> supports;  ///< between the ends, from left to right
  std::vector<StretchKeys> stretches;    ///< from left to right
  double ice = 0;                        ///< [kg/m]
  double ice_density = 900;              ///< [kg/m^3]
  double wind = 0;                       ///< [m/s] a steady wind along z, which pushes the span sideways
  double drag_coefficient = 1;           ///< [-] of that
  MassMatrix mass = MassMatrix::consistent;
  bool rotary_inertia = false;
  bool condense_axial = false;
  /// Where the program chooses the elements: of a loop of the highest mode that is asked for. No key; a target of
  /// accuracy gives it. Empty: 10, and as many loops as the twelfth mode has at least.
  std::optional<double> elements_per_loop;

  /// [m] between the supports, along the corners if there are any.
  double total_length() const;
};

/// [[body]]: a lumped mass, or a spring and damper to the ground, at a point of the span.
struct Body {
  double at = 0;                     ///< [m] from the left support, along the span
  double mass = 0;                   ///< [kg]
  double inertia = 0;                ///< [kg m^2] about every axis
  double stiffness = 0;              ///< [N/m] along `direction`
  double damping = 0;                ///< [N s/m] along `direction`
  std::optional<Vector3> direction;  ///< [-] unit vector; always set after reading
};

struct Initial {
  int velocity_mode = 1;
  double antinode_velocity = 0;  ///< [m/s]
};

struct Rayleigh {
  double mass = 0;       ///< [1/s]
  double stiffness = 0;  ///< [s]
};

struct Damping {
  std::vector<std::array<double, 2>> modal;  ///< mode (from 1), damping ratio [-]
  std::optional<Rayleigh> rayleigh;
  double drag = 0;  ///< [N s/m^2]
};

struct Static {
  Control control = Control::load;
  double displacement = 0;         ///< [m] `displacement`: of the point of the first static force, along it, at the end
  std::optional<double> arc_step;  ///< [m] `arc-length`: of an arc; empty: that of the first load step
  double max_load_factor = 1;      ///< [-] `arc-length`: the path ends where the load factor first passes it
};

/// [-] bound of the numerical share where the case gives none: of what is lost over `cycles_of_default_share` cycles,
/// or of `part_of_energy` of the greatest energy where that is more and the run is shorter, or where nothing is lost.
inline constexpr double default_numerical_share = 0.05;
inline constexpr double part_of_energy = 0.1;
inline constexpr std::size_t cycles_of_default_share = 20;

/// Where the case gives no step.
inline constexpr int default_steps_per_cycle = 200;

struct Integrator {
  Method method = Method::ida;
  double rho_inf = 0.9;         ///< [-] `generalized-alpha`
  bool fits_frequency = false;  ///< `generalized-alpha`
  StepRule step = StepRule::fixed;
  std::optional<int> steps_per_cycle;         ///< `fixed`: this or
  std::optional<double> step_size;            ///< [s]
  double rtol = 1e-6;                         ///< [-] `adaptive`
  double newton_tolerance = 1e-12;            ///< [m, rad]
  std::optional<double> max_numerical_share;  ///< [-] of the physical dissipation over the last cycles; empty: default
  std::optional<double> checkpoint_every;     ///< [s] of wall time; empty: none
};

struct Scene {
  std::string title;                   ///< the file's name unless said
  std::optional<Scalar> accuracy;      ///< as the file says it; see `target_error`
  std::optional<Conductor> conductor;  ///< may be empty for the laws that need none
  Section section;
  std::optional<Span> span;  ///< may be empty for the analyses of a section
  std::vector<Load> loads;
  std::vector<Motion> motions;
  std::vector<Body> bodies;
  std::vector<DamperKeys> dampers;
  std::optional<Initial> initial;
  Damping damping;
  std::optional<Air> air;
  std::vector<WindKeys> winds;  ///< none or one
  std::optional<Material> material;
  std::optional<ClampKeys> clamps;
  std::optional<OutputKeys> output;
  Static static_;
  Integrator integrator;
  Analysis analysis;
  Acceptance accept;
  Source source;
  std::vector<std::string> notes;     ///< what a reader of the case should know: old names that were used
  std::vector<std::string> warnings;  ///< what is possible and unusual

  /// The chosen analysis; `as` where it is known to be this one.
  template <class T>
  bool is() const {
    return std::holds_alternative<T>(analysis);
  }
  template <class T>
  const T& as() const {
    return std::get<T>(analysis);
  }
};

/// [-] the error of the dissipation that the case asks for, by a word or a number; empty where it asks for none.
std::optional<double> target_error(const Scene& scene);

/// [N] tension of the span, given as such or by rated strength; empty where an unstressed length sets it.
std::optional<double> span_tension(const Scene& scene);

/// [N] tensions of a `section` analysis, however given.
std::vector<double> section_tensions(const Scene& scene);

/// Number of the first static-force load, whose point displacement control moves and slip maps look at.
std::optional<std::size_t> first_static_force(const Scene& scene);

/// [kg/m] of unstressed length, ice and thermal strain in it: of the section, else of the conductor; empty where
/// neither says.
std::optional<double> mass_per_length(const Scene& scene);
/// The same as it was strung.
std::optional<double> strung_mass_per_length(const Scene& scene);

/// [m] that the air meets, a sleeve of ice in it: sqrt(D^2 + 4 m_ice/(pi rho_ice)); 0 without a conductor.
double outer_diameter(const Scene& scene);

/// [-] of the span since it was strung; 0 where the case gives no temperature. Of wires without a key of its own:
/// sum EA a/sum EA with the EA of the layers along the strand, a = 23e-6/K (aluminium), 11.5e-6/K (steel).
double thermal_strain(const Scene& scene);

}  // namespace strandyn::casefile
