#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "findings.hpp"
#include "loop_row.hpp"
#include "section_parts.hpp"
#include "strandyn/exact/full_slip.hpp"

namespace strandyn::study {

using casefile::Scene;
using section::Component;
using section::Field;

namespace {

/// One symmetric loop of curvature at constant tension.
struct Loop {
  double tension = 0;         ///< [N]
  double amplitude = 0;       ///< [1/m]
  double over_chi_0 = 0;      ///< [-] the same by chi_0; 0 where there is no strand
  double chi_0 = 0;           ///< [1/m]
  double M_0 = 0;             ///< [N m]
  double area = 0;            ///< [J/m] of the second cycle
  double largest_moment = 0;  ///< [N m] in it

  double secant() const { return largest_moment / amplitude; }
};

/// The same strand with one friction coefficient, with or without its residual forces.
struct Variant {
  std::optional<double> friction;  ///< [-] of all contacts; empty: as given
  bool residual_forces = true;
  std::optional<conductor::Strand> strand;
  std::vector<Loop> loops;
};

std::vector<Variant> variants_of(const Scene& scene) {
  const casefile::SectionAnalysis& a = scene.as<casefile::SectionAnalysis>();
  std::vector<std::optional<double>> frictions(a.frictions.begin(), a.frictions.end());
  if (frictions.empty()) frictions.push_back(std::nullopt);
  std::vector<Variant> variants;
  for (const std::optional<double>& friction : frictions) {
    for (bool residual_forces : {true, false}) {
      if (!residual_forces && !a.compare_residual_forces) continue;
      Variant v{.friction = friction, .residual_forces = residual_forces, .strand = {}, .loops = {}};
      if (scene.conductor) {
        v.strand = scene.conductor->strand;
        for (conductor::Layer& layer : v.strand->layers) {
          if (friction) layer.friction_inner = *friction;
          if (!residual_forces) layer.residual_force = 0;
        }
      }
      variants.push_back(std::move(v));
    }
  }
  return variants;
}

void add_loops(const Scene& scene, Variant& variant) {
  const casefile::SectionAnalysis& a = scene.as<casefile::SectionAnalysis>();
  std::vector<double> tensions = casefile::section_tensions(scene);
  if (tensions.empty()) tensions.push_back(0);
  for (double tension : tensions) {
    Loop loop{.tension = tension};
    if (variant.strand) {
      const exact::FullSlip slip = exact::full_slip_at_points(*variant.strand, tension, scene.section.points);
      loop.chi_0 = slip.chi_0;
      loop.M_0 = slip.M_0;
    }
    for (double amplitude : a.curvature_amplitudes) {
      loop.amplitude = amplitude;
      loop.over_chi_0 = loop.chi_0 > 0 ? amplitude / loop.chi_0 : 0;
      variant.loops.push_back(loop);
    }
    for (double over_chi_0 : a.relative_amplitudes) {
      loop.amplitude = over_chi_0 * loop.chi_0;
      loop.over_chi_0 = over_chi_0;
      if (loop.chi_0 > 0) variant.loops.push_back(loop);
    }
  }
}

/// chi/amplitude at a step of the path: 0, 1, -1, 1, -1, ... in straight lines, a quarter cycle to the first peak.
double triangle(int step, int steps_per_cycle) {
  const double phase = std::fmod(static_cast<double>(step) / steps_per_cycle, 1.0);
  if (phase <= 0.25) return 4 * phase;
  if (phase <= 0.75) return 2 - 4 * phase;
  return 4 * phase - 4;
}

/// All loops of a variant side by side, one section point each. The first cycle starts virgin; the second is measured.
class March {
 public:
  March(const Scene& scene, Variant& variant)
      : loops_(variant.loops),
        steps_per_cycle_(scene.as<casefile::SectionAnalysis>().steps_per_cycle),
        law_(build::build_law(scene, dimension_of(scene), variant.strand ? &*variant.strand : nullptr)),
        strains_(law_->dimension(), loops_.size()),
        stresses_(law_->dimension(), loops_.size()),
        energy_(loops_.size()) {
    const build::SectionNumbers numbers = build::section_numbers(scene);
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      const AxialState state = axial_state(numbers, scene.as<casefile::SectionAnalysis>().twist, loops_[i].tension);
      strains_[Component::axial][i] = state.strain;
      if (law_->dimension() == section::Dimension::spatial) strains_[Component::torsion][i] = state.twist;
    }
    memory_ = law_->start(strains_);
  }

  /// Measures the loops; appends every state to `history`, loops numbered from `first`. False where it was stopped.
  bool run(std::size_t first, const Hooks& hooks, results::Table& history) {
    record(first, history);
    const int start_of_second = steps_per_cycle_ + steps_per_cycle_ / 4;  // peak to peak: a closed loop
    const int last = start_of_second + steps_per_cycle_;
    for (int step = 1; step <= last; ++step) {
      if (hooks.stop && hooks.stop()) return false;
      if (hooks.progress && step % 1000 == 0) {
        hooks.progress(static_cast<double>(step) / last,
                       fmt::format("loops from {}, step {} of {}", first + 1, step, last));
      }
      for (std::size_t i = 0; i < loops_.size(); ++i) {
        strains_[Component::bending2][i] = loops_[i].amplitude * triangle(step, steps_per_cycle_);
      }
      effort_ += law_->commit(memory_, strains_, energy_);
      record(first, history);
      for (std::size_t i = 0; i < loops_.size() && step >= start_of_second; ++i) {
        loops_[i].largest_moment = std::max(loops_[i].largest_moment, stresses_[Component::bending2][i]);
        // The trapezoidal work around a closed loop is what was dissipated less the error of the steps.
        if (step > start_of_second) loops_[i].area += energy_.dissipated[i] - energy_.quadrature_error[i];
      }
    }
    return true;
  }
  section::Effort effort() const { return effort_; }

 private:
  void record(std::size_t first, results::Table& history) {
    effort_ += law_->respond(memory_, strains_, stresses_, nullptr);
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      history.append(std::array{static_cast<double>(first + i + 1), loops_[i].tension, strains_[Component::bending2][i],
                                stresses_[Component::bending2][i]});
    }
  }

  std::vector<Loop>& loops_;
  int steps_per_cycle_;
  std::shared_ptr<const section::Law> law_;
  Field strains_, stresses_;
  section::StepEnergy energy_;
  section::History memory_;
  section::Effort effort_;
};

/// The members of `loops`.
LoopRow row_of(const Variant& variant, const Loop& loop) {
  LoopRow row{.tension = loop.tension,
              .friction = variant.friction,
              .residual_forces = variant.residual_forces,
              .curvature = loop.amplitude,
              .area = loop.area,
              .secant = loop.secant()};
  if (variant.strand) {
    row.chi_0 = loop.chi_0;
    row.M_0 = loop.M_0;
    row.over_chi_0 = loop.over_chi_0;
  }
  return row;
}

/// With residual forces against without, at equal curvature over chi_0: what neglecting them does.
struct ResidualRow {
  double tension = 0, over_chi_0 = 0, area_lower = 0, secant_ratio = 0, chi_0_lower = 0;
};
template <class V>
void members(V& v, ResidualRow& r) {
  v.value("tension_N", r.tension, {.what = "the tension"});
  v.value("curvature_over_chi_0", r.over_chi_0, {.what = "the amplitude over the yield curvature"});
  v.value("area_lower", r.area_lower, {.what = "by what part the area is lower without"});
  v.value("secant_ratio", r.secant_ratio, {.what = "secant stiffness without over with"});
  v.value("chi_0_lower", r.chi_0_lower, {.what = "by what part the yield curvature is lower without"});
}

std::vector<ResidualRow> residual_comparison(const std::vector<Variant>& variants) {
  std::vector<ResidualRow> rows;
  for (std::size_t v = 0; v + 1 < variants.size(); v += 2) {
    const std::size_t count = std::min(variants[v].loops.size(), variants[v + 1].loops.size());
    for (std::size_t i = 0; i < count; ++i) {
      const Loop& with = variants[v].loops[i];
      const Loop& without = variants[v + 1].loops[i];
      if (without.tension != with.tension) continue;
      rows.push_back({.tension = with.tension,
                      .over_chi_0 = with.over_chi_0,
                      .area_lower = 1 - without.area / with.area,
                      .secant_ratio = without.secant() / with.secant(),
                      .chi_0_lower = 1 - without.chi_0 / with.chi_0});
    }
  }
  return rows;
}

struct Samples {
  std::vector<double> x, y;
};

/// R^2 of the least-squares line; nothing for fewer than three samples.
std::optional<double> r_squared(const Samples& s) {
  const double n = static_cast<double>(s.x.size());
  if (s.x.size() < 3) return std::nullopt;
  double mx = 0, my = 0, sxx = 0, sxy = 0, syy = 0;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    mx += s.x[i] / n;
    my += s.y[i] / n;
  }
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    sxx += (s.x[i] - mx) * (s.x[i] - mx);
    sxy += (s.x[i] - mx) * (s.y[i] - my);
    syy += (s.y[i] - my) * (s.y[i] - my);
  }
  if (sxx == 0 || syy == 0) return std::nullopt;
  return sxy * sxy / (sxx * syy);
}

/// The lowest R^2 of straight lines.
struct LinearRow {
  std::optional<double> chi_0{}, M_0{};
  void keep_lowest(std::optional<double>& kept, const Samples& samples) {
    if (const auto r2 = r_squared(samples)) kept = std::min(*r2, kept.value_or(*r2));
  }
};
template <class V>
void members(V& v, LinearRow& l) {
  v.value("chi_0_r2", l.chi_0, {.what = "of the yield curvature"});
  v.value("M_0_r2", l.M_0, {.what = "of the yield moment"});
}
/// How straight chi_0 and M_0 run over the tension (per friction) and over the friction (per tension).
struct LinearityRow {
  std::optional<LinearRow> over_tension{}, over_friction{};
};
template <class V>
void members(V& v, LinearityRow& l) {
  v.record("over_tension", l.over_tension, {.what = "at each friction, the lowest"});
  v.record("over_friction", l.over_friction, {.what = "at each tension, the lowest"});
}

LinearityRow linearity(const Scene& scene, const std::vector<Variant>& variants) {
  LinearRow over_tension, over_friction;
  const std::vector<double> tensions = casefile::section_tensions(scene);
  const auto sample = [&](const Variant& v, double tension) {
    return exact::full_slip_at_points(*v.strand, tension, scene.section.points);
  };
  for (const Variant& v : variants) {
    Samples chi_0, M_0;
    for (double tension : tensions) {
      const exact::FullSlip slip = sample(v, tension);
      chi_0.x.push_back(tension);
      chi_0.y.push_back(slip.chi_0);
      M_0.y.push_back(slip.M_0);
    }
    M_0.x = chi_0.x;
    over_tension.keep_lowest(over_tension.chi_0, chi_0);
    over_tension.keep_lowest(over_tension.M_0, M_0);
  }
  for (double tension : tensions) {
    for (bool residual_forces : {true, false}) {
      Samples chi_0, M_0;
      for (const Variant& v : variants) {
        if (!v.friction || v.residual_forces != residual_forces) continue;
        const exact::FullSlip slip = sample(v, tension);
        chi_0.x.push_back(*v.friction);
        chi_0.y.push_back(slip.chi_0);
        M_0.y.push_back(slip.M_0);
      }
      M_0.x = chi_0.x;
      over_friction.keep_lowest(over_friction.chi_0, chi_0);
      over_friction.keep_lowest(over_friction.M_0, M_0);
    }
  }
  LinearityRow out;
  if (over_tension.chi_0 || over_tension.M_0) out.over_tension = over_tension;
  if (over_friction.chi_0 || over_friction.M_0) out.over_friction = over_friction;
  return out;
}

struct CyclesSummary {
  std::optional<double> chi_0{}, M_0{};
  std::vector<LoopRow> loops;
  std::optional<std::vector<ResidualRow>> without_residual_forces{};
  std::optional<LinearityRow> linearity{};
};
template <class V>
void members(V& v, CyclesSummary& s) {
  v.value("chi_0_per_m", s.chi_0, {.what = "yield curvature of the first loop", .shown = "curvature of full slip"});
  v.value("M_0_N_m", s.M_0, {.what = "its moment", .shown = "moment of full slip"});
  v.list("loops", s.loops, {.what = "each symmetric cycle"});
  v.list("without_residual_forces", s.without_residual_forces, {.what = "what neglecting them does"});
  v.record("linearity", s.linearity, {.what = "R^2 of straight lines of chi_0 and M_0"});
}

}  // namespace

std::vector<results::MemberNote> notes_of_cycles() {
  return results::ReferenceWriter::of<CyclesSummary>();
}

void check_cycles(const Scene& scene) {
  const auto& keys = scene.as<casefile::SectionAnalysis>();
  if (keys.steps_per_cycle % 4 != 0) {
    refuse(scene.source, "analysis.steps_per_cycle", "the peaks of the path fall between steps",
           "give a multiple of 4");
  }
  build::build_law(scene, dimension_of(scene));
}

double expected_of_cycles(const Scene& scene) {
  const auto& keys = scene.as<casefile::SectionAnalysis>();
  const int steps = keys.steps_per_cycle + keys.steps_per_cycle / 4 + keys.steps_per_cycle;
  double loops = 0;
  for (Variant& variant : variants_of(scene)) {
    add_loops(scene, variant);
    loops += static_cast<double>(variant.loops.size());
  }
  return loops * (2.0 * steps + 1);
}

void run_cycles(const Scene& scene, const Hooks& hooks, Outcome& outcome) {
  std::vector<Variant> variants = variants_of(scene);
  results::Table history({"loop", "tension_N", "curvature_per_m", "moment_N_m"});
  CyclesSummary summary;
  section::Effort effort;
  for (Variant& variant : variants) {
    add_loops(scene, variant);
    if (!variant.loops.empty()) {
      March march(scene, variant);
      const bool whole = march.run(summary.loops.size(), hooks, history);
      effort += march.effort();
      if (!whole) {
        outcome.exit_code = ExitCode::interrupted;
        outcome.message =
            fmt::format("interrupted; {} loops are finished, and loop.csv has what there is", summary.loops.size());
        break;
      }
    }
    for (const Loop& loop : variant.loops) summary.loops.push_back(row_of(variant, loop));
  }
  if (variants.front().strand && !variants.front().loops.empty()) {
    summary.chi_0 = variants.front().loops.front().chi_0;
    summary.M_0 = variants.front().loops.front().M_0;
  }
  const bool finished = outcome.exit_code == ExitCode::done;
  if (finished && scene.as<casefile::SectionAnalysis>().compare_residual_forces) {
    summary.without_residual_forces = residual_comparison(variants);
  }
  if (variants.front().strand) {
    const LinearityRow straight = linearity(scene, variants);
    if (straight.over_tension || straight.over_friction) summary.linearity = straight;
  }
  outcome.tell(summary);
  outcome.cost.section_evaluations = effort.evaluations;
  outcome.cost.section_sweeps = effort.sweeps;
  outcome.tables.push_back({.file = "loop.csv", .table = std::move(history)});
  outcome.tables.push_back({.file = "loops.csv", .table = results::table_of(summary.loops, "loop")});
  outcome.figures.push_back({.name = "loops",
                             .title = "Hysteresis of the cross section",
                             .table = "loop.csv",
                             .x = "curvature_per_m",
                             .y = {"moment_N_m"},
                             .series = {"loop", "tension_N"},
                             .caption = "Bending moment against curvature over closed cycles. The area of a loop is "
                                        "the energy that friction takes from a metre of conductor in that cycle."});
  outcome.shown.push_back(
      {.title = "Loops",
       .table = "loops.csv",
       .columns = {"loop", "tension_N", "curvature_per_m", "area_J_per_m", "secant_stiffness_N_m2"}});
  outcome.findings = findings_of(summary.loops);
}

}  // namespace strandyn::study
