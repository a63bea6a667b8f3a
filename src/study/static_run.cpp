#include <fmt/format.h>

#include <cmath>

#include "parts.hpp"
#include "slip_map.hpp"
#include "strandyn/solver/static/equilibrium.hpp"

namespace strandyn::study {

using casefile::Scene;
using json = nlohmann::ordered_json;

namespace {

/// What the steps of a static analysis are told by: the first load that grows, or else the first motion.
class Follower {
 public:
  Follower(const Scene& scene, const SpanAtRest& span) : span_(span), rest_(span.u) {
    for (const model::Load& load : span.built.model.loads) {
      if (!load.dead && !load_) load_ = &load;
    }
    if (!load_ && !span.built.model.motions.empty()) motion_ = &span.built.model.motions.front();
    if (!load_ && !motion_ && !scene.span->gravity) {
      refuse(scene.source, "analysis.type", "there is nothing that acts",
             "give a [[load]] of type \"static-force\", a [[motion]] of type \"static-motion\", or gravity = true");
    }
    if (load_) {
      turns_ = load_->force.isZero(0);
      const Eigen::Vector3d vector = turns_ ? load_->moment : load_->force;
      size_ = vector.norm();
      if (size_ > 0) direction_ = vector / size_;
    } else if (motion_) {
      turns_ = model::is_rotation(motion_->unknown);
      direction_ = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(motion_->unknown) % 3);
    }
  }

  std::size_t node() const { return load_ ? load_->node : motion_ ? motion_->node : 0; }
  const Eigen::Vector3d& direction() const { return direction_; }
  bool turns() const { return turns_; }

  /// [N] or [N m]: the load, or what the moved support does.
  double load(const system::Vector& u, double factor) const {
    if (load_) return factor * size_;
    if (!motion_) return 0;
    system::Vector force = span_.system.make_vector();
    span_.system.internal_force(u.data(), force.data());
    return along(force);
  }
  /// [m] or [rad] from the state of rest, along the load.
  double displacement(const system::Vector& u) const { return along(u - rest_); }

 private:
  double along(const system::Vector& vector) const {
    const model::Model& model = span_.built.model;
    return direction_.dot(turns_ ? model.rotation(vector.data(), node()) : model.displacement(vector.data(), node()));
  }

  const SpanAtRest& span_;
  system::Vector rest_;
  const model::Load* load_ = nullptr;
  const model::PrescribedMotion* motion_ = nullptr;
  bool turns_ = false;
  double size_ = 0;
  Eigen::Vector3d direction_ = Eigen::Vector3d::UnitY();
};

struct PathStep {
  double load = 0;
  double displacement = 0;
};

/// Maxima and minima of the load along the path, each by the parabola through its three nearest steps.
json limit_points(const std::vector<PathStep>& path, bool turns) {
  json list = json::array();
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const double before = path[i].load - path[i - 1].load;
    const double after = path[i + 1].load - path[i].load;
    if (before * after >= 0) continue;
    // Load over the number of the step, at i + s.
    const double slope = (before + after) / 2;
    const double bend = after - before;
    const double s = -slope / bend;
    const double displacement = path[i].displacement + s * (path[i + 1].displacement - path[i - 1].displacement) / 2;
    list.push_back({{turns ? "load_N_m" : "load_N", path[i].load - slope * slope / (2 * bend)},
                    {turns ? "rotation_rad" : "displacement_m", displacement}});
  }
  return list;
}

/// What a bending test tells: the stiffness of the first step, and the load of the first step in which a wire slips.
void add_onset(const std::vector<PathStep>& path, std::optional<double> first_slip, bool turns, CaseResult& result) {
  if (path.size() > 1 && path[1].displacement != 0) {
    result.summary[turns ? "initial_stiffness_N_m_per_rad" : "initial_stiffness_N_per_m"] =
        path[1].load / path[1].displacement;
  }
  if (first_slip) result.summary[turns ? "first_slip_load_N_m" : "first_slip_load_N"] = *first_slip;
}

solver::EquilibriumOptions options_of(const Scene& scene, const SpanAtRest& span, const Follower& follower) {
  using casefile::Control;
  solver::EquilibriumOptions options{.steps = scene.analysis.static_.steps};
  if (scene.static_.control == Control::displacement) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const auto i = span.built.model.index(follower.node(), static_cast<model::Unknown>(axis));
      if (follower.direction()(axis) == 0 || (i && !span.system.is_held(*i))) continue;
      refuse(scene.source, "static.control", "a support holds the point whose displacement is to be led",
             "move the first static-force load away from the support");
    }
    options.control = solver::Control::displacement;
    options.point = {.node = follower.node(), .direction = follower.direction(), .target = scene.static_.displacement};
  } else if (scene.static_.control == Control::arc_length) {
    options.control = solver::Control::arc_length;
    options.arc_step = scene.static_.arc_step.value_or(0);
    options.max_load_factor = scene.static_.max_load_factor;
  }
  return options;
}

}  // namespace

void run_static(const Scene& scene, const Hooks& hooks, CaseResult& result) {
  SpanAtRest span(scene);
  add_rest(span, result);
  const Follower follower(scene, span);
  SlipMap slip_map(scene, span, follower.node());
  const char* load_name = follower.turns() ? "load_N_m" : "load_N";
  const char* displacement_name = follower.turns() ? "rotation_rad" : "displacement_m";
  results::Table table({load_name, displacement_name, "load_factor", "sections_slipping"});
  json steps = json::array();
  std::vector<PathStep> path = {{.load = 0, .displacement = 0}};

  solver::EquilibriumOptions options = options_of(scene, span, follower);
  if (options.control == solver::Control::displacement) {
    // The target counts from the state of rest.
    options.point.target +=
        options.point.direction.dot(span.built.model.displacement(span.u.data(), options.point.node));
  }
  options.stop = hooks.stop;
  double factor = 0;
  std::optional<double> first_slip;
  options.watch = [&](const solver::EquilibriumStep& step, const system::Vector& u, double done) {
    factor = step.load_factor;
    path.push_back({.load = follower.load(u, factor), .displacement = follower.displacement(u)});
    steps.push_back({{load_name, path.back().load},
                     {displacement_name, path.back().displacement},
                     {"load_factor", factor},
                     {"sections_slipping", step.sections_slipping}});
    table.append(
        std::array{path.back().load, path.back().displacement, factor, static_cast<double>(step.sections_slipping)});
    if (step.sections_slipping > 0 && !first_slip) first_slip = path.back().load;
    slip_map.watch(path.back().load);
    if (hooks.progress) hooks.progress(done, fmt::format("step {}, load factor {:.4g}", steps.size(), factor));
  };
  const solver::EquilibriumSummary found = solver::find_equilibrium(span.system, span.u, options);

  result.summary["steps"] = steps;
  add_onset(path, first_slip, follower.turns(), result);
  result.summary["stable"] = solver::is_stable(span.system, span.u, factor);
  if (!result.summary["stable"]) {
    result.summary["warnings"].push_back(
        "the last state is an unstable equilibrium: beyond a limit or a buckling load the span would leave it");
  }
  if (options.control != solver::Control::load) {
    result.summary["limit_points"] = limit_points(path, follower.turns());
  }
  add_shape(span, factor, result);
  slip_map.add_to(result);
  result.summary["cost"]["steps"] = found.steps.size();
  add_effort(span.system, result.summary["cost"]);
  result.tables.push_back({"steps.csv", std::move(table)});
  if (found.stopped) {
    result.exit_code = ExitCode::interrupted;
    result.message = fmt::format("interrupted after {} steps; what was computed is kept", found.steps.size());
  }
}

}  // namespace strandyn::study
