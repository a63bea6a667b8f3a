#pragma once
/// \file Several laws along one chain: the points of each stretch answer by a law of their own.
///
/// The batch is cut into runs of points, each of them a batch of its own for its law, so that everything that a law
/// promises (law.hpp) holds as it does for that law alone. The history holds those of the runs one after another, each
/// behind its length. Only a chain with stretches pays for the copies.

#include <memory>
#include <vector>

#include "strandyn/section/law.hpp"

namespace strandyn::section {

class LawByPlace final : public Law {
 public:
  /// The next `points` section points answer by `law`.
  struct Run {
    std::shared_ptr<const Law> law;
    std::size_t points = 0;
    std::size_t history = 0;  ///< the doubles that the law remembers of them at least; found here
  };
  /// At least one run; all laws have one dimension. std::invalid_argument otherwise.
  explicit LawByPlace(std::vector<Run> runs);

  /// That of the first run.
  std::string_view name() const override { return runs_.front().law->name(); }
  Dimension dimension() const override { return runs_.front().law->dimension(); }
  History start(const Field& strains) const override;
  Effort respond(const History& history, const Field& strains, Field& stresses, TangentField* tangents) const override;
  Effort commit(History& history, const Field& strains, StepEnergy& energy) const override;
  WireState wires(const History& history, const Field& committed_strains, std::size_t point) const override;

 private:
  std::vector<Run> runs_;
};

}  // namespace strandyn::section
