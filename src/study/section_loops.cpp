#include "section_loops.hpp"

#include <algorithm>
#include <cmath>

#include "strandyn/core/error.hpp"

namespace strandyn::study {

using enum section::Component;

namespace {

/// About the axis of bending in the plane of the span.
std::vector<double> row_of(const section::Field& field) {
  return {field[bending2].begin(), field[bending2].begin() + static_cast<std::ptrdiff_t>(field.points())};
}

double amplitude(const std::vector<section::Field>& cycle, std::size_t point) {
  double low = cycle.front()[bending2][point], high = low;
  for (const section::Field& strains : cycle) {
    low = std::min(low, strains[bending2][point]);
    high = std::max(high, strains[bending2][point]);
  }
  return (high - low) / 2;
}

}  // namespace

void SectionLoops::begin(const system::System& system, const observe::StepRecord&) {
  const model::Model& model = system.model();
  const std::vector<double> arc = model::arc_lengths(model);
  length_ = arc.back();
  dimension_ = system.committed_strains()[bending3].empty() ? section::Dimension::planar : section::Dimension::spatial;
  for (std::size_t e = 0; e + 1 < arc.size(); ++e) {
    for (const double part : beam::gauss_position) places_.push_back(std::lerp(arc[e], arc[e + 1], part));
  }
}

void SectionLoops::step(const system::System& system, const observe::StepRecord& record) {
  now_.strains.push_back(system.committed_strains());
  now_.moment.push_back(row_of(system.last_stresses()));
  constexpr double rounding = 1e-6;
  if (record.time * frequency_ + rounding < static_cast<double>(cycles_ + 1)) return;
  ++cycles_;
  last_ = std::move(now_);
  now_ = {};
}

void SectionLoops::archive(Archive& a) {
  a(cycles_);
  for (Cycle* cycle : {&now_, &last_}) {
    std::size_t count = cycle->moment.size();
    a(count);
    constexpr std::size_t most = 1000000;  // a count may come from a file
    if (count > most) throw FileError("a cycle of the state has more steps than a cycle can have");
    if (a.reads()) *cycle = {};
    for (std::size_t step = 0; step < count; ++step) {
      if (a.reads()) {  // one by one: a file that ends early makes no large rows
        cycle->moment.emplace_back(places_.size());
        cycle->strains.emplace_back(dimension_, places_.size());
      }
      a(cycle->moment[step]);
      for (const section::Component c : {axial, torsion, bending2, bending3}) {
        if (section::carries(dimension_, c)) a(cycle->strains[step][c]);
      }
    }
  }
}

std::size_t SectionLoops::most_bent(bool beside_support) const {
  std::size_t most = places_.size();
  double largest = -1;
  for (std::size_t point = 0; point < places_.size(); ++point) {
    const bool beside = std::min(places_[point], length_ - places_[point]) < loop_;
    if (beside != beside_support) continue;
    const double size = amplitude(last_.strains, point);
    if (size > largest) most = point, largest = size;
  }
  return most;
}

void SectionLoops::add_to(Outcome& outcome) const {
  if (last_.strains.empty()) return;
  results::Table table({"x_m", "curvature_per_m", "moment_N_m"});
  for (const bool beside_support : {true, false}) {
    const std::size_t point = most_bent(beside_support);
    if (point == places_.size()) continue;
    for (std::size_t i = 0; i < last_.strains.size(); ++i) {
      table.append(std::array{places_[point], last_.strains[i][bending2][point], last_.moment[i][point]});
    }
  }
  if (table.rows() < 2) return;
  outcome.tables.push_back({.file = "section_loops.csv", .table = std::move(table)});
  outcome.figures.push_back({.name = "section_loops",
                             .title = "Moment against curvature, last cycle",
                             .kind = "section",
                             .table = "section_loops.csv",
                             .x = "curvature_per_m",
                             .y = {"moment_N_m"},
                             .series = {"x_m"},
                             .caption = "The section that bends most in the loops at the supports, and the one between "
                                        "them: the area of a loop is what friction takes from a metre."});
}

}  // namespace strandyn::study
