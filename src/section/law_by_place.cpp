#include "strandyn/section/law_by_place.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "strandyn/core/error.hpp"

namespace strandyn::section {

namespace {

constexpr std::array components = {Component::axial, Component::torsion, Component::bending2, Component::bending3};

/// Points `first` and on of a row, as many as `part` has.
void take(const AlignedVector& from, std::size_t first, std::size_t points, AlignedVector& part) {
  if (!part.empty()) std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(first), points, part.begin());
}
void put(const AlignedVector& part, std::size_t first, std::size_t points, AlignedVector& to) {
  if (!part.empty()) std::copy_n(part.begin(), points, to.begin() + static_cast<std::ptrdiff_t>(first));
}

Field part_of(const Field& whole, std::size_t first, std::size_t points, Dimension dimension) {
  Field part(dimension, points);
  for (const Component c : components) take(whole[c], first, points, part[c]);
  return part;
}

/// Where the history of a run lies: behind its length, which is a number of doubles.
struct Walk {
  std::size_t at = 0;     // in the data
  std::size_t first = 0;  // section point

  History next(const AlignedVector& data, std::size_t points, std::size_t least) {
    // A history may come from a file, and its lengths say where the laws read.
    const double room = static_cast<double>(data.size()) - static_cast<double>(at) - 1;
    if (!(room >= 0 && data[at] >= static_cast<double>(least) && data[at] <= room)) {
      throw InputError("the memory of the sections is none that these stretches can have");
    }
    const auto begin = data.begin() + static_cast<std::ptrdiff_t>(at) + 1;
    const auto length = static_cast<std::ptrdiff_t>(data[at]);
    at += static_cast<std::size_t>(length) + 1;
    first += points;
    return {.points = points, .data = AlignedVector(begin, begin + length)};
  }
};

void append(const History& run, AlignedVector& data) {
  data.push_back(static_cast<double>(run.data.size()));
  data.insert(data.end(), run.data.begin(), run.data.end());
}

}  // namespace

LawByPlace::LawByPlace(std::vector<Run> runs) : runs_(std::move(runs)) {
  if (runs_.empty()) throw std::invalid_argument("laws by place need a run of points");
  for (const Run& run : runs_) {
    if (run.law->dimension() != dimension()) throw std::invalid_argument("laws by place have one dimension");
  }
  for (Run& run : runs_) run.history = run.law->start(Field(dimension(), run.points)).data.size();
}

History LawByPlace::start(const Field& strains) const {
  History history{.points = strains.points(), .data = {}};
  std::size_t first = 0;
  for (const Run& run : runs_) {
    append(run.law->start(part_of(strains, first, run.points, dimension())), history.data);
    first += run.points;
  }
  if (first != strains.points()) throw std::invalid_argument("laws by place are for another number of points");
  return history;
}

Effort LawByPlace::respond(const History& history, const Field& strains, Field& stresses,
                           TangentField* tangents) const {
  Effort effort;
  Walk walk;
  for (const Run& run : runs_) {
    const std::size_t first = walk.first;
    const History own = walk.next(history.data, run.points, run.history);
    Field answer(dimension(), run.points);
    TangentField slopes;
    if (tangents) slopes = TangentField(dimension(), run.points);
    effort +=
        run.law->respond(own, part_of(strains, first, run.points, dimension()), answer, tangents ? &slopes : nullptr);
    for (const Component row : components) {
      put(answer[row], first, run.points, stresses[row]);
      if (!tangents) continue;
      for (const Component column : components) {
        put(slopes(row, column), first, run.points, (*tangents)(row, column));
      }
    }
  }
  return effort;
}

Effort LawByPlace::commit(History& history, const Field& strains, StepEnergy& energy) const {
  Effort effort;
  Walk walk;
  AlignedVector data;
  data.reserve(history.data.size());
  for (const Run& run : runs_) {
    const std::size_t first = walk.first;
    History own = walk.next(history.data, run.points, run.history);
    StepEnergy step(run.points);
    effort += run.law->commit(own, part_of(strains, first, run.points, dimension()), step);
    put(step.stored, first, run.points, energy.stored);
    put(step.dissipated, first, run.points, energy.dissipated);
    put(step.quadrature_error, first, run.points, energy.quadrature_error);
    append(own, data);
  }
  history.data = std::move(data);
  return effort;
}

WireState LawByPlace::wires(const History& history, const Field& committed_strains, std::size_t point) const {
  Walk walk;
  for (const Run& run : runs_) {
    const std::size_t first = walk.first;
    const History own = walk.next(history.data, run.points, run.history);
    if (point >= walk.first) continue;
    return run.law->wires(own, part_of(committed_strains, first, run.points, dimension()), point - first);
  }
  throw std::out_of_range("no such section point");
}

}  // namespace strandyn::section
