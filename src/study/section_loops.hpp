#pragma once
/// \file Moment against curvature in the last cycle of a vibration, where the span bends most: beside a support, and in
/// the free span.

#include "strandyn/observe/step_record.hpp"
#include "strandyn/study/analysis.hpp"

namespace strandyn::study {

class SectionLoops final : public observe::Observer {
 public:
  /// `frequency` [Hz] of the cycle; places within `loop` [m] of the ends count as beside a support.
  SectionLoops(double frequency, double loop) : frequency_(frequency), loop_(loop) {}

  void begin(const system::System& system, const observe::StepRecord& initial) override;
  void step(const system::System& system, const observe::StepRecord& record) override;
  void archive(Archive& a) override;
  /// section_loops.csv and its figure, of the last whole cycle.
  void add_to(Outcome& outcome) const;
  /// Of all steps of the last whole cycle; empty before one has ended.
  const std::vector<section::Field>& strains() const { return last_.strains; }

 private:
  /// What all sections do in a cycle, moment by moment.
  struct Cycle {
    std::vector<section::Field> strains;
    std::vector<std::vector<double>> moment;  // [N m]
  };
  std::size_t most_bent(bool beside_support) const;

  double frequency_, loop_;
  std::vector<double> places_;  // [m] of the section points
  double length_ = 0;           // [m]
  section::Dimension dimension_ = section::Dimension::planar;
  std::size_t cycles_ = 0;
  Cycle now_, last_;
};

}  // namespace strandyn::study
