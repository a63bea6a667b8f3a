#include "slip_cycle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "cross_section.hpp"
#include "strandyn/build/section_law.hpp"

namespace strandyn::study {
namespace {

constexpr std::size_t most_moments = 36;
constexpr std::size_t most_places = 120;

struct SlipCycleSummary {
  SlipCycleRow slip_cycle;
};
template <class V>
void members(V& v, SlipCycleSummary& s) {
  v.record("slip_cycle", s.slip_cycle, {.what = "which wires slip in the last cycle, where the law knows wires"});
}

/// The cycle, gone through once more.
class Replay {
 public:
  Replay(const casefile::Scene& scene, const span::SpanAtRest& span, const std::vector<section::Field>& strains)
      : law_(*span.built.model.law), strand_(scene.conductor->strand), wires_(wires_of(strand_)) {
    const std::vector<double> arc = model::arc_lengths(span.built.model);
    for (std::size_t e = 0; e + 1 < arc.size(); ++e) {
      for (const double part : beam::gauss_position) {
        place_.push_back(std::lerp(arc[e], arc[e + 1], part));
        length_.push_back((arc[e + 1] - arc[e]) / beam::gauss_points);
      }
    }
    double lay = 0;
    for (const Wire& wire : wires_) lay = std::max(lay, std::abs(wire.lay));
    beside_ = std::min(lay, arc.back() / 2);
    std::set<std::size_t> shown;
    for (const std::size_t p : results::evenly_spaced(place_.size(), most_places)) shown.insert(p);
    for (std::size_t p = 0; p < place_.size() && place_[p] <= beside_; ++p) shown.insert(p);
    shown_.assign(shown.begin(), shown.end());
    march(span.system.history(), strains);
  }

  const SlipCycleRow& row() const { return row_; }
  double beside() const { return beside_; }  // [m] from the left support: one lay length
  results::Table map() const { return map_; }

  /// How much of the cycle each wire slips, at the places beside the support.
  results::Table wire_map() const {
    results::Table table({"x_m", "wire", "layer", "slipping_share"});
    for (std::size_t i = 0; i < shown_.size() && place_[shown_[i]] <= beside_; ++i) {
      for (std::size_t w = 0; w < wires_.size(); ++w) {
        table.append(std::array{place_[shown_[i]], static_cast<double>(w + 1), static_cast<double>(wires_[w].layer),
                                share(i, w)});
      }
    }
    return table;
  }

  /// Of the cycle, how much a wire slips in the cross-section where most do.
  double share_where_most(std::size_t wire) const {
    const auto most = static_cast<std::size_t>(std::ranges::find(place_, row_.at) - place_.begin());
    return share(static_cast<std::size_t>(std::ranges::find(shown_, most) - shown_.begin()), wire);
  }

 private:
  double share(std::size_t place, std::size_t wire) const { return slipped_[place][wire] / moments_; }

  void march(section::History history, const std::vector<section::Field>& strains) {
    slipped_.assign(shown_.size(), std::vector<double>(wires_.size()));
    section::StepEnergy energy(place_.size());
    const auto moments = results::evenly_spaced(strains.size(), most_moments);
    moments_ = static_cast<double>(moments.size());
    std::size_t moment = 0;
    for (std::size_t step = 0; step < strains.size(); ++step) {
      law_.commit(history, strains[step], energy);
      for (std::size_t p = 0; p < place_.size(); ++p) row_.friction += energy.dissipated[p] * length_[p];
      if (moment == moments.size() || moments[moment] != step) continue;
      ++moment;
      look(history, strains[step], 360.0 * static_cast<double>(step + 1) / static_cast<double>(strains.size()));
    }
  }

  void look(const section::History& history, const section::Field& strains, double phase) {
    for (std::size_t i = 0; i < shown_.size(); ++i) {
      const double x = place_[shown_[i]];
      const section::WireState state = law_.wires(history, strains, shown_[i]);
      const double share = slipping_share(state);
      map_.append(std::array{x, phase, share});
      if (share > row_.largest_share) row_.largest_share = share, row_.at = x;
      for (std::size_t w = 0; w < wires_.size(); ++w) slipped_[i][w] += slips(state, wires_[w], x) ? 1 : 0;
    }
  }

  const section::Law& law_;
  const conductor::Strand& strand_;
  std::vector<Wire> wires_;
  std::vector<double> place_, length_;  // [m] of all section points
  std::vector<std::size_t> shown_;
  double beside_ = 0, moments_ = 1;
  SlipCycleRow row_;
  results::Table map_{std::vector<std::string>{"x_m", "phase_deg", "slipping_share"}};
  std::vector<std::vector<double>> slipped_;  // moments, by shown place and wire
};

void add_figures(const Replay& replay, Outcome& outcome) {
  results::Figure map{.name = "slip_map",
                      .title = "Slip along the span in a cycle",
                      .kind = "map",
                      .table = "slip_map.csv",
                      .x = "x_m",
                      .y = {"phase_deg", "slipping_share"},
                      .caption = "The share of the wires around the lay that slip, by position and time."};
  outcome.figures.push_back(map);
  map.name = "slip_map_near_support";
  map.title = "Slip beside the support in a cycle";
  map.caption = "The same within a lay length of the left support.";
  map.x_range = {0, replay.beside()};
  outcome.figures.push_back(map);
  outcome.figures.push_back({.name = "wire_map",
                             .title = "Slip of each wire beside the support",
                             .kind = "map",
                             .table = "wire_map.csv",
                             .x = "x_m",
                             .y = {"wire", "slipping_share"},
                             .caption = "The share of the cycle in which each wire slips, over a lay length. Wires are "
                                        "counted from the core outward, layer by layer."});
}

}  // namespace

void add_slip_cycle(const casefile::Scene& scene, const span::SpanAtRest& span,
                    const std::vector<section::Field>& strains, Outcome& outcome) {
  if (!build::has_wires(scene.section.law) || !scene.conductor || strains.empty()) return;
  const Replay replay(scene, span, strains);
  outcome.tell(SlipCycleSummary{.slip_cycle = replay.row()});
  if (replay.row().largest_share == 0) return;
  outcome.tables.push_back({.file = "slip_map.csv", .table = replay.map()});
  outcome.tables.push_back({.file = "wire_map.csv", .table = replay.wire_map()});
  add_figures(replay, outcome);
  add_cross_section(
      scene.conductor->strand, replay.row().at, [&](std::size_t wire) { return replay.share_where_most(wire); },
      "The cross-section that slips most",
      fmt::format(
          "At {:.3g} m; the colour is the share of the cycle in which a wire slips, and an empty circle does not.",
          replay.row().at),
      outcome);
}

std::vector<results::MemberNote> notes_of_slip_cycle() {
  return results::ReferenceWriter::of<SlipCycleSummary>();
}

}  // namespace strandyn::study
