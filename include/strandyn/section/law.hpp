#pragma once
/// \file What every section law offers: strain and committed history in, resultants and energies out.
///
/// A law is pure in the committed history: the integrator may evaluate trial states that it rejects, as often as it
/// likes and in any order. `commit` is the only function that writes history; it is called once per accepted step.
/// Every law passes the battery of tests/section/battery.hpp.

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "strandyn/section/batch.hpp"
#include "strandyn/section/wire_state.hpp"

namespace strandyn::section {

/// The committed memory of a batch of points. Only the law that made it knows its layout; for everybody else it is a
/// row of doubles that can be copied, compared and written to a file.
struct History {
  std::size_t points = 0;
  AlignedVector data;
};

/// What the evaluations cost. An evaluation is one point, one call; a sweep is one that marched through the layers.
struct Effort {
  std::uint64_t evaluations = 0;
  std::uint64_t sweeps = 0;

  Effort& operator+=(const Effort& other) {
    evaluations += other.evaluations;
    sweeps += other.sweeps;
    return *this;
  }
};

/// Energies of an accepted step, per unit length of strand, one entry per point. [J/m]
struct StepEnergy {
  explicit StepEnergy(std::size_t points = 0)
      : stored(padded(points)), dissipated(padded(points)), quadrature_error(padded(points)) {}

  AlignedVector stored;            ///< potential of the state that was committed, axial and bending
  AlignedVector dissipated;        ///< friction dissipation of the step; never negative
  AlignedVector quadrature_error;  ///< >= 0; stored change + dissipated - this = trapezoidal work of the resultants
};

class Law {
 public:
  virtual ~Law() = default;

  virtual std::string_view name() const = 0;
  virtual Dimension dimension() const = 0;

  /// The history of a virgin strand that was brought straight to the axial part of `strains`, and from there in one
  /// step to their bending: friction acts on that step, but nobody books its loss.
  virtual History start(const Field& strains) const = 0;

  /// Resultants of a trial state and, where `tangents` is not null, their derivatives. Pure.
  virtual Effort respond(const History& history, const Field& strains, Field& stresses,
                         TangentField* tangents) const = 0;

  /// Accepts `strains` as the end of a step: advances the history and tells the energies of that step.
  virtual Effort commit(History& history, const Field& strains, StepEnergy& energy) const = 0;

  /// The wires of one point as the commit of `committed_strains` left them. Most laws know no wires.
  virtual WireState wires(const History& /*history*/, const Field& /*committed_strains*/, std::size_t /*point*/) const {
    throw std::logic_error("this law knows no wires");
  }
};

}  // namespace strandyn::section
