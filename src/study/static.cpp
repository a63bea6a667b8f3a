#include <fmt/format.h>

#include <cmath>

#include "cautions.hpp"
#include "entries.hpp"
#include "findings.hpp"
#include "outlook.hpp"
#include "share.hpp"
#include "slip_map.hpp"
#include "strandyn/solver/static/equilibrium.hpp"

namespace strandyn::study {

using casefile::Scene;

namespace {

/// What the steps of a static analysis are told by: the first load that grows, or else the first motion.
class Follower {
 public:
  explicit Follower(const span::SpanAtRest& span) : span_(span), rest_(span.u) {
    for (const model::Load& load : span.built.model.loads) {
      if (!load.dead && !load_) load_ = &load;
    }
    if (!load_ && !span.built.model.motions.empty()) motion_ = &span.built.model.motions.front();
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

  const span::SpanAtRest& span_;
  system::Vector rest_;
  const model::Load* load_ = nullptr;
  const model::PrescribedMotion* motion_ = nullptr;
  bool turns_ = false;
  double size_ = 0;
  Eigen::Vector3d direction_ = Eigen::Vector3d::UnitY();
};

/// One converged step; a load that is a moment turns, and has names of its own.
struct StepRow {
  bool turns = false;
  double load = 0, displacement = 0, load_factor = 0;
  std::size_t sections_slipping = 0;
};
template <class V>
void members(V& v, StepRow& s) {
  if (s.turns) {
    v.value("load_N_m", s.load, {.what = "the moment"});
    v.value("rotation_rad", s.displacement, {.what = "of the loaded point, along it"});
  } else {
    v.value("load_N", s.load, {.what = "the load, or what the moved support does"});
    v.value("displacement_m", s.displacement, {.what = "of the loaded point, along it"});
  }
  v.value("load_factor", s.load_factor, {.what = "of all loads that grow"});
  v.value("sections_slipping", s.sections_slipping, {.what = "section points that dissipate in the step"});
}

/// A maximum or minimum of the load along the path.
struct LimitRow {
  bool turns = false;
  double load = 0, displacement = 0;
};
template <class V>
void members(V& v, LimitRow& l) {
  v.value(l.turns ? "load_N_m" : "load_N", l.load, {.what = "the largest or smallest load"});
  v.value(l.turns ? "rotation_rad" : "displacement_m", l.displacement, {.what = "where it is reached"});
}

struct StaticSummary {
  std::optional<span::Rest> rest{};
  std::vector<StepRow> steps{};
  std::optional<double> stiffness{}, first_slip{};
  bool turns = false, stable = false;
  std::optional<std::vector<LimitRow>> limit_points{};
  span::Components right_end{};
  span::Reactions reactions{};
};
template <class V>
void members(V& v, StaticSummary& s) {
  v.record("rest", s.rest, {.what = "how a hanging span hangs"});
  v.list("steps", s.steps, {.what = "the path"});
  v.value(s.turns ? "initial_stiffness_N_m_per_rad" : "initial_stiffness_N_per_m", s.stiffness,
          {.what = "load over displacement of a thousandth of the first step", .shown = "initial stiffness"});
  v.value(s.turns ? "first_slip_load_N_m" : "first_slip_load_N", s.first_slip,
          {.what = "load at which the first wire slips, to 0.1 %; 0 where contacts give at any load",
           .shown = "load of first slip"});
  v.value("stable", s.stable, {.what = "whether the last state is a stable equilibrium"});
  v.list("limit_points", s.limit_points, {.what = "maxima and minima of the load, by parabolas through three steps"});
  v.value("right_end_m", s.right_end, {.what = "where the right end is at last"});
  v.record("reactions", s.reactions, {.what = "of the supports at last"});
}

std::vector<std::string> findings_of(const StaticSummary& summary) {
  if (summary.steps.empty()) return {};
  const StepRow& last = summary.steps.back();
  std::string text = summary.turns ? fmt::format("At the end of the path a moment of {} turns its point by {:.3g} rad",
                                                 amount(last.load, "N m"), last.displacement)
                                   : fmt::format("At the end of the path a load of {} moves its point by {}",
                                                 amount(last.load, "N"), amount(last.displacement, "m"));
  if (summary.first_slip) {
    text += fmt::format("; the first wire slips at {}", amount(*summary.first_slip, summary.turns ? "N m" : "N"));
  }
  const std::size_t turns = summary.limit_points ? summary.limit_points->size() : 0;
  if (turns > 0) text += fmt::format("; the load turns {} times on the way", turns);
  return {text + "."};
}

/// Each by the parabola through its three nearest steps; the path begins at nothing.
std::vector<LimitRow> limit_points(std::vector<StepRow> path, bool turns) {
  path.insert(path.begin(), StepRow{});
  std::vector<LimitRow> list;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const double before = path[i].load - path[i - 1].load;
    const double after = path[i + 1].load - path[i].load;
    if (before * after >= 0) continue;
    // Load over the number of the step, at i + s.
    const double slope = (before + after) / 2;
    const double bend = after - before;
    const double s = -slope / bend;
    list.push_back(
        {.turns = turns,
         .load = path[i].load - slope * slope / (2 * bend),
         .displacement = path[i].displacement + s * (path[i + 1].displacement - path[i - 1].displacement) / 2});
  }
  return list;
}

/// The beginning of the path, looked at by trials from the state of rest whatever steps the path itself takes.
class Beginning {
 public:
  Beginning(const build::BuiltSpan& built, const Stop& stop)
      : stop_(stop), span_(built), follower_(span_), rest_(span_.u) {
    span_.system.archive(at_rest_);
  }

  struct Trial {
    double load = 0, displacement = 0;
    bool slips = false;
  };
  /// One step from rest to a load factor; rest is restored. Throws ComputationError where there is no way, Interrupted.
  Trial to(double factor) {
    end_if_asked(stop_);
    system::Vector u = rest_;
    Trial trial;
    solver::EquilibriumOptions options{.max_load_factor = factor};
    options.stop = stop_;
    options.watch = [&](const solver::EquilibriumStep& step, const system::Vector& at, double) {
      trial = {.load = follower_.load(at, factor),
               .displacement = follower_.displacement(at),
               .slips = trial.slips || step.sections_slipping > 0};
    };
    const bool stopped = solver::find_equilibrium(span_.system, u, options).stopped;
    evaluations_ += span_.system.effort().evaluations;
    Archive back(at_rest_.bytes());
    span_.system.archive(back);
    if (stopped) end_if_asked(stop_);
    return trial;
  }
  /// The load of the first slip, which happens before `slipping` (a load factor).
  double first_slip(double slipping) {
    // Contacts that give slip from the first load on; below `nothing` rounding hides what they lose.
    constexpr double precision = 1e-3, nothing = 1e-4;
    if (to(nothing * slipping).slips) return 0;
    double low = nothing * slipping, high = slipping;
    while (high / low > 1 + precision) {
      // Geometric while the bracket is wide: slip may begin early in a large step.
      const double middle = high / low > 2 ? std::sqrt(low * high) : (low + high) / 2;
      (to(middle).slips ? high : low) = middle;
    }
    return to(high).load;
  }
  /// Of sections, in all trials.
  std::uint64_t evaluations() const { return evaluations_; }

 private:
  const Stop& stop_;
  span::SpanAtRest span_;
  Follower follower_;
  system::Vector rest_;
  Archive at_rest_;
  std::uint64_t evaluations_ = 0;
};

solver::EquilibriumOptions options_of(const Scene& scene, const Follower& follower) {
  using casefile::Control;
  solver::EquilibriumOptions options{.steps = scene.as<casefile::StaticAnalysis>().steps};
  if (scene.static_.control == Control::displacement) {
    options.control = solver::Control::displacement;
    options.point = {.node = follower.node(), .direction = follower.direction(), .target = scene.static_.displacement};
  } else if (scene.static_.control == Control::arc_length) {
    options.control = solver::Control::arc_length;
    options.arc_step = scene.static_.arc_step.value_or(0);
    options.max_load_factor = scene.static_.max_load_factor;
  }
  return options;
}

/// First slip and initial stiffness. Where no way leads straight from rest to the first slip, because the path has
/// turned before it, the load of the first step that slips stands for it.
void look_at_beginning(const build::BuiltSpan& built, const Stop& stop, StaticSummary& summary, Outcome& outcome) {
  if (summary.steps.empty()) return;
  const auto slipping =
      std::ranges::find_if(summary.steps, [](const StepRow& row) { return row.sections_slipping > 0; });
  Beginning beginning(built, stop);
  try {
    constexpr double little = 1e-3;
    const Beginning::Trial first = beginning.to(little * summary.steps.front().load_factor);
    if (first.displacement != 0) summary.stiffness = first.load / first.displacement;
    if (slipping != summary.steps.end()) summary.first_slip = beginning.first_slip(slipping->load_factor);
  } catch (const ComputationError&) {
    if (slipping != summary.steps.end()) summary.first_slip = slipping->load;
    outcome.warnings.emplace_back(
        "the load of first slip is that of the first step that slips: give more analysis.steps");
  }
  outcome.cost.section_evaluations += beginning.evaluations();
}

class Static final : public Analysis {
 public:
  explicit Static(const Scene& scene) : scene_(scene), built_(build::build_span(scene)) {
    const model::Model& model = built_.model;
    const bool loaded = std::ranges::any_of(model.loads, [](const model::Load& load) { return !load.dead; });
    if (!loaded && model.motions.empty() && !scene.span->gravity) {
      refuse(scene.source, "analysis.type", "there is nothing that acts",
             "give a [[load]] of type \"static-force\", a [[motion]] of type \"static-motion\", or gravity = true");
    }
    check_slip_map(scene);
    if (scene.static_.control == casefile::Control::displacement) check_led_point();
  }

  Outlook outlook() override {
    Outlook outlook;
    add_span(built_, outlook);
    const span::SpanAtRest span(built_);
    // Three to nine iterations a step, two questions to the law each; a path that is cut back takes more.
    const double steps = scene_.as<casefile::StaticAnalysis>().steps;
    expect(outlook, 7 * steps * static_cast<double>(built_.section_points()), 3);
    // Not all of the span slips; solution and tables of a step take about as much as the law at rest.
    const SlippingCycle cycle{.axial_strain = built_.tension / built_.numbers.EA, .tangents = true};
    outlook.seconds_per_evaluation =
        evaluation_time(span) + 0.6 * slipping_time(*built_.model.law, built_.section_points(), cycle);
    return outlook;
  }

  void run(const Hooks& hooks, Outcome& outcome) override;

 private:
  void check_led_point() const {
    const system::System system(built_.model);
    for (const model::Load& load : built_.model.loads) {
      if (load.dead) continue;
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const auto i = built_.model.index(load.node, static_cast<model::Unknown>(axis));
        if (load.force(axis) == 0 || (i && !system.is_held(*i))) continue;
        refuse(scene_.source, "static.control", "a support holds the point whose displacement is to be led",
               "move the first static-force load away from the support");
      }
      return;
    }
  }

  const Scene& scene_;
  build::BuiltSpan built_;
};

void Static::run(const Hooks& hooks, Outcome& outcome) {
  span::SpanAtRest span(built_);
  StaticSummary summary{.rest = span::rest_of(span)};
  const Follower follower(span);
  summary.turns = follower.turns();
  SlipMap slip_map(scene_, span, follower.node());
  solver::EquilibriumOptions options = options_of(scene_, follower);
  if (options.control == solver::Control::displacement) {
    // The target counts from the state of rest.
    options.point.target +=
        options.point.direction.dot(span.built.model.displacement(span.u.data(), options.point.node));
  }
  options.stop = hooks.stop;
  double factor = 0;
  options.watch = [&](const solver::EquilibriumStep& step, const system::Vector& u, double done) {
    factor = step.load_factor;
    summary.steps.push_back({.turns = follower.turns(),
                             .load = follower.load(u, factor),
                             .displacement = follower.displacement(u),
                             .load_factor = factor,
                             .sections_slipping = step.sections_slipping});
    const StepRow& row = summary.steps.back();
    slip_map.watch(row.load);
    if (hooks.progress) {
      hooks.progress(done, fmt::format("step {}, load factor {:.4g}", summary.steps.size(), factor));
    }
  };
  const solver::EquilibriumSummary found = solver::find_equilibrium(span.system, span.u, options);
  warn_of_strength(scene_, span, largest_tension(span), "at the end of the path", outcome);
  summary.stable = solver::is_stable(span.system, span.u, factor);
  if (!summary.stable) {
    outcome.warnings.emplace_back(
        "the last state is an unstable equilibrium: beyond a limit or a buckling load the span would leave it");
  }
  if (options.control != solver::Control::load) summary.limit_points = limit_points(summary.steps, follower.turns());
  summary.right_end = span::right_end_of(span);
  summary.reactions = span::reactions_of(span, factor);
  add_effort(span.system, outcome.cost);
  bool stopped = found.stopped;
  if (!stopped) {
    try {
      look_at_beginning(built_, hooks.stop, summary, outcome);
    } catch (const Interrupted&) {
      stopped = true;
    }
  }
  outcome.tell(summary);
  outcome.findings = findings_of(summary);
  outcome.tables.push_back({.file = "shape.csv", .table = span::shape_of(span)});
  slip_map.add_to(outcome);
  outcome.cost.steps = found.steps.size();
  results::Table table(results::ColumnReader::of(StepRow{.turns = follower.turns()}).names);
  for (const StepRow& row : summary.steps) table.append(results::ColumnReader::of(row).values);
  const std::vector<std::string> names = table.names();
  outcome.tables.push_back({.file = "steps.csv", .table = std::move(table)});
  outcome.figures.push_back({.name = "load_displacement",
                             .title = "Load and displacement",
                             .table = "steps.csv",
                             .x = names[1],
                             .y = {names[0]},
                             .caption = "Load against the displacement of the loaded point."});
  outcome.figures.push_back({.name = "shape",
                             .title = "The span in its last state",
                             .table = "shape.csv",
                             .x = "x_m",
                             .y = {"y_m"},
                             .caption = "Places of the nodes under the last load."});
  outcome.shown.push_back({.title = "The path", .table = "steps.csv", .columns = names});
  if (!stopped) return;
  outcome.exit_code = ExitCode::interrupted;
  outcome.message = fmt::format("interrupted after {} steps; what was computed is kept", found.steps.size());
}

}  // namespace

std::vector<results::MemberNote> notes_of_static() {
  std::vector<results::MemberNote> notes = results::ReferenceWriter::of<StaticSummary>();
  std::ranges::move(SlipMap::notes(), std::back_inserter(notes));
  return notes;
}

std::unique_ptr<Analysis> prepare_static(const Scene& scene) {
  return std::make_unique<Static>(scene);
}

}  // namespace strandyn::study
