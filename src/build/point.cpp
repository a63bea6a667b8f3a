#include "strandyn/build/point.hpp"

#include <cmath>
#include <numbers>

#include "strandyn/analysis/methods.hpp"

namespace strandyn::build {

using casefile::Scene;
using std::numbers::pi;

namespace {

void move_places(Scene& scene, double old_length, double new_length) {
  const auto move = [&](double& at) {
    if (at > old_length / 2) at += new_length - old_length;
  };
  for (casefile::Load& load : scene.loads) {
    if (load.at) move(*load.at);
  }
  for (casefile::Motion& motion : scene.motions) {
    if (motion.at) move(*motion.at);
  }
  for (casefile::Body& body : scene.bodies) move(body.at);
}

}  // namespace

SpanOfPoint span_of_point(const Scene& scene, const PointAsk& point) {
  const casefile::Span& span = *scene.span;
  if (point.mode) return {.mode = *point.mode, .length = *span.length};
  const double mass = *casefile::mass_per_length(scene);
  const double EI = build::section_numbers(scene).EI_max;
  const double k = analysis::wavenumber({.tension = point.tension, .mass_per_length = mass, .EI = EI}, point.frequency);
  // k L = n pi + atan(k/q) for each clamped end, where the boundary layers of the two do not meet.
  const double q = std::sqrt(k * k + point.tension / EI);
  const int clamped =
      (span.left == casefile::Support::clamped ? 1 : 0) + (span.right == casefile::Support::clamped ? 1 : 0);
  const double turn = clamped * std::atan(k / q);
  const int mode = std::max(1, static_cast<int>(std::lround((k * *span.length - turn) / pi)));
  return {.mode = mode, .length = (mode * pi + turn) / k};
}

Scene scene_of_point(const Scene& scene, const PointAsk& point) {
  const SpanOfPoint wanted = span_of_point(scene, point);
  Scene own = scene;
  move_places(own, *scene.span->length, wanted.length);
  own.span->length = wanted.length;
  own.span->tension = point.tension;
  own.span->tension_rts.reset();
  own.span->unstressed_length.reset();
  const ShakerKey shaker = shaker_of(scene);
  if (!shaker.is_given()) {
    casefile::Load force;
    force.type = casefile::LoadType::harmonic_force;
    force.at = shaker_place * wanted.length / wanted.mode;
    force.amplitude = 1;
    force.direction = casefile::Vector3{0, 1, 0};
    own.loads.push_back(force);
  }
  // The mesh looks at the drive for the waves that it must carry.
  const auto at_mode = [&wanted](auto& drive) {
    drive.frequency.reset();
    drive.frequency_mode = wanted.mode;
  };
  shaker.motion ? at_mode(own.motions[*shaker.motion])
                : at_mode(shaker.load ? own.loads[*shaker.load] : own.loads.back());
  return own;
}

}  // namespace strandyn::build
