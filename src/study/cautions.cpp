#include "cautions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace strandyn::study {

double largest_tension(const span::SpanAtRest& span) {
  system::Vector force = span.system.make_vector();
  span.system.internal_force(span.u.data(), force.data());
  const AlignedVector& axial = span.system.last_stresses()[section::Component::axial];
  const std::size_t points = span.built.section_points();
  double largest = 0;
  for (std::size_t point = 0; point < points && point < axial.size(); ++point) {
    largest = std::max(largest, axial[point]);
  }
  return largest;
}

void warn_of_strength(const casefile::Scene& scene, const span::SpanAtRest& span, double tension, const char* when,
                      Outcome& outcome) {
  const double strength = scene.conductor ? scene.conductor->strand.rated_strength : 0;
  if (strength > 0 && tension > strength) {
    outcome.warnings.push_back(fmt::format(
        "the tension reaches {:.4g} kN {}, {:.3g} times the rated strength of {:.4g} kN: this strand breaks",
        tension / 1e3, when, tension / strength, strength / 1e3));
    return;
  }
  constexpr double breaks = 0.05;  // steel and aluminium wires part at 1 to 5 %
  const double strain = tension / span.built.numbers.EA;
  if (strength > 0 || strain <= breaks) return;
  outcome.warnings.push_back(fmt::format(
      "the strain reaches {:.3g} % {}: wires of steel or aluminium part at 1 to 5 %, and the law knows no such end",
      100 * strain, when));
}

void warn_of_rest(const casefile::Scene& scene, const span::SpanAtRest& span, Outcome& outcome) {
  warn_of_strength(scene, span, largest_tension(span), "at rest", outcome);
  const std::optional<span::Rest> rest = span::rest_of(span);
  if (!rest || !rest->catenary_sag || !rest->sag) return;
  constexpr double much = 0.1;
  const double sag = *rest->sag / *rest->catenary_sag - 1;
  const double tension = *rest->horizontal_tension / *rest->catenary_horizontal_tension - 1;
  if (std::abs(sag) <= much && std::abs(tension) <= much) return;
  outcome.warnings.push_back(fmt::format(
      "bending stiffness rules this span: it hangs {:.4g} m deep under {:.4g} N, a flexible cable would hang "
      "{:.4g} m deep under {:.4g} N",
      *rest->sag, *rest->horizontal_tension, *rest->catenary_sag, *rest->catenary_horizontal_tension));
}

namespace {

/// [m/s] or [rad/s]
double largest_jump(const model::PrescribedMotion& motion, std::span<const model::Drive> drives, double end) {
  const double size = std::abs(motion.amplitude);
  const bool eased = motion.ease.duration > 0;
  const auto* table = std::get_if<math::Tabulated>(&motion.history);
  if (!table) return eased ? 0 : std::abs(motion.rate(0, drives));
  if (!eased || table->slope.empty() || table->time.front() > 0) return size * table->largest_jump(end);
  math::Tabulated rest = *table;  // its begin is eased
  rest.slope.front() = 0;
  return size * rest.largest_jump(end);
}

}  // namespace

bool warn_of_blows(const build::BuiltSpan& built, std::span<const model::Drive> drives, double end, Outcome& outcome) {
  const model::Model& model = built.model;
  constexpr double nothing = 1e-6;
  bool any = false;
  for (const model::PrescribedMotion& motion : model.motions) {
    const double jump = largest_jump(motion, drives, end);
    if (jump <= nothing) continue;
    any = true;
    outcome.warnings.push_back(fmt::format(
        "the velocity of {} jumps by {:.4g} {}: a blow, whose friction and waves depend on the time step; give the "
        "[[motion]] an ease_s, interpolation = \"smooth\", or rows without corners",
        model.unknown_name(*model.index(motion.node, motion.unknown)), jump,
        model::is_rotation(motion.unknown) ? "rad/s" : "m/s"));
  }
  return any;
}

}  // namespace strandyn::study
