#include "strandyn/span/modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "cautions.hpp"
#include "entries.hpp"
#include "findings.hpp"
#include "outlook.hpp"
#include "share.hpp"

namespace strandyn::study {

using casefile::Scene;

namespace {

struct ModesSummary {
  std::optional<span::Rest> rest{};
  std::vector<double> frequencies{};
  std::vector<span::ModeRow> modes{};
};
template <class V>
void members(V& v, ModesSummary& s) {
  v.record("rest", s.rest, {.what = "how a hanging span hangs"});
  v.value("frequencies_Hz", s.frequencies, {.what = "the natural frequencies, ascending"});
  v.list("modes", s.modes, {.what = "each mode"});
}

class Modes final : public Analysis {
 public:
  explicit Modes(const Scene& scene) : scene_(scene), built_(build::build_span(scene)) {
    const auto& keys = scene.as<casefile::ModesAnalysis>();
    const bool planar = !model::is_spatial(built_.model.freedom);
    // In a plane and from the lowest up, modes along the span are left out: what is counted is vibration across it.
    across_only_ = planar && !keys.near_frequency && scene.span->nodes.empty();
    if (across_only_) {
      build::require_modes(scene, built_, keys.count, "analysis.count");
      return;
    }
    const system::System system(built_.model);
    std::size_t with_mass = 0;
    for (std::size_t i = 0; i < system.unknowns(); ++i) with_mass += system.has_mass(i) ? 1 : 0;
    if (static_cast<std::size_t>(keys.count) < with_mass) return;
    refuse(scene.source, "analysis.count",
           fmt::format("asks for {} modes, and the mesh has only {} unknowns with mass", keys.count, with_mass),
           "give more [span] elements, or fewer modes");
  }

  Outlook outlook() override {
    Outlook outlook;
    add_span(built_, outlook);
    const span::SpanAtRest span(built_);
    const double points = static_cast<double>(built_.section_points());
    // A few evaluations for the state of rest, one tangent for the modes; a hanging span asks for its rest first.
    expect(outlook, (built_.hanging.size() > 0 ? 35 : 6) * points, 3.1);
    const double loops = std::max(1, scene_.as<casefile::ModesAnalysis>().count);
    outlook.seconds_per_evaluation = (20 + loops) * evaluation_time(span);
    return outlook;
  }

  void run(const Hooks& hooks, Outcome& outcome) override {
    span::SpanAtRest span(built_);
    ModesSummary summary{.rest = span::rest_of(span)};
    span.apply_static_loads();
    warn_of_rest(scene_, span, outcome);
    const auto& keys = scene_.as<casefile::ModesAnalysis>();
    const auto count = static_cast<std::size_t>(keys.count);
    std::vector<solver::Mode> modes;
    if (across_only_) {
      modes = solver::rigid_modes(span.system, span.u);
      modes.resize(std::min(modes.size(), count));
      std::ranges::move(span::modes_across(span, keys.count - static_cast<int>(modes.size()), hooks.stop),
                        std::back_inserter(modes));
    } else {
      modes = solver::find_modes(span.system, span.u,
                                 {.count = count, .near = keys.near_frequency.value_or(0), .stop = hooks.stop});
    }
    for (const solver::Mode& mode : modes) summary.frequencies.push_back(mode.frequency);
    summary.modes = span::rows_of(span, modes);
    add_effort(span.system, outcome.cost);
    results::Table shapes = span::shapes_of(span, modes);
    add_figure(modes, outcome);
    outcome.tables.push_back({.file = "modes.csv", .table = std::move(shapes)});
    results::Table list({"mode", "half_waves", "frequency_Hz", "modal_mass_kg"});
    for (const span::ModeRow& mode : summary.modes) {
      list.append(std::array{static_cast<double>(mode.number), static_cast<double>(mode.half_waves), mode.frequency,
                             mode.modal_mass});
    }
    outcome.tables.push_back({.file = "frequencies.csv", .table = std::move(list)});
    outcome.tell(summary);
    outcome.findings = findings_of(summary.modes);
    outcome.shown.push_back({.title = "Natural frequencies",
                             .table = "frequencies.csv",
                             .columns = {"mode", "half_waves", "frequency_Hz"}});
  }

 private:
  /// The lowest shapes, each along the axis in which it moves.
  static void add_figure(const std::vector<solver::Mode>& modes, Outcome& outcome) {
    constexpr std::size_t most = 6;
    results::Figure figure{.name = "modes",
                           .title = "Mode shapes",
                           .table = "modes.csv",
                           .x = "arc_m",
                           .y = {},
                           .caption = "Modes of the span about its static state."};
    for (std::size_t i = 0; i < modes.size() && i < most; ++i) {
      const bool along = modes[i].kind == solver::ModeKind::axial;
      const bool out = modes[i].kind == solver::ModeKind::out_of_plane;
      figure.y.push_back(fmt::format("mode_{}_{}", i + 1, along ? "x" : out ? "z" : "y"));
    }
    if (!figure.y.empty()) outcome.figures.push_back(std::move(figure));
  }

  const Scene& scene_;
  build::BuiltSpan built_;
  bool across_only_ = true;
};

}  // namespace

std::vector<results::MemberNote> notes_of_modes() {
  return results::ReferenceWriter::of<ModesSummary>();
}

std::unique_ptr<Analysis> prepare_modes(const Scene& scene) {
  return std::make_unique<Modes>(scene);
}

}  // namespace strandyn::study
