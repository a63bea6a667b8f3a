#pragma once
/// \file From a validated scene to what runs: the section law and the chain. Whatever this version cannot model is an
/// InputError at the key that asks for it.

#include <memory>
#include <optional>

#include "strandyn/casefile/scene.hpp"
#include "strandyn/model/model.hpp"
#include "strandyn/section/law.hpp"

namespace strandyn::build {

/// The numbers of the section that everything else refers to.
struct SectionNumbers {
  double EA = 0;        ///< [N]
  double GJ = 0;        ///< [N m^2]
  double C_AT = 0;      ///< [N m]
  double EI_min = 0;    ///< [N m^2] for laws without a strand: what remains when all slips
  double EI_max = 0;    ///< [N m^2] what acts while nothing slips
  double diameter = 0;  ///< [m] outer; 0 where no conductor is given
};
SectionNumbers section_numbers(const casefile::Scene& scene);

/// Whether the wires of such a law can be looked at (section::Law::wires).
bool has_wires(casefile::Law law);

/// The law of the scene; `strand`, where given, stands for the scene's own (a variant of it).
std::shared_ptr<const section::Law> build_law(const casefile::Scene& scene, section::Dimension dimension,
                                              const conductor::Strand* strand = nullptr);

/// A span and what was decided on the way.
struct BuiltSpan {
  model::Model model;
  double tension = 0;                  ///< [N] of a straight span, the horizontal component of a hanging one
  double length = 0;                   ///< [m] between the supports, along the corners if there are any
  double end_size = 0;                 ///< [m] wanted size of the elements at graded ends; 0: uniform
  std::vector<std::size_t> load_of;    ///< for each entry of model.loads, the [[load]] it came from
  std::vector<std::size_t> motion_of;  ///< for each entry of model.motions, the [[motion]]
  /// All unknowns near the shape in which the span hangs, and of the straight chain; empty where it does
  /// not hang: then it is at rest with all unknowns zero.
  Eigen::VectorXd hanging, straight;
  std::optional<double> catenary_sag;  ///< [m] of the flexible cable that has given `hanging`
};

/// The chain of a scene with [span]. Loads at the frequency of a mode get it later, by `set_load_frequency`: modes need
/// the chain first.
BuiltSpan build_span(const casefile::Scene& scene);

/// Builds what the analysis needs and throws it away: an InputError for whatever this version cannot model.
void check_buildable(const casefile::Scene& scene);

/// Gives the entries that came from [[load]] or [[motion]] number `number` their frequency [Hz].
void set_load_frequency(BuiltSpan& span, std::size_t number, double frequency);
void set_motion_frequency(BuiltSpan& span, std::size_t number, double frequency);

/// Speed of transverse waves [m/s], tension and mass only; and half a wave length [m] at a frequency [Hz].
double wave_speed(const casefile::Scene& scene, double tension);
double loop_length(const casefile::Scene& scene, double tension, double frequency);

}  // namespace strandyn::build
