#include "strandyn/observe/checkpoint_check.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace strandyn::observe {
namespace {

// The program that reads is the one that has written, so that only the order of a sum may differ.
constexpr double same_energy = 1e-9;    // relative to the larger of both
constexpr double least_energy = 1e-15;  // [J] that rounding leaves of a span at rest
constexpr double same_strain = 1e-9;    // relative to the largest of its kind
constexpr double least_strain = 1e-13;  // [-], [1/m]

[[noreturn]] void refuse(const std::string& what) {
  throw InputError("its numbers do not belong together: " + what);
}

bool is_same(double x, double y, double scale) {
  return std::abs(x - y) <= same_energy * std::max({std::abs(x), std::abs(y), scale}) + least_energy;
}

}  // namespace

void CheckpointCheck::begin(const system::System& system, const StepRecord& initial) {
  system_ = &system;
  u_ = &initial.u;
  v_ = &initial.v;
  time_ = initial.time;
  elastic_ = initial_elastic_ = initial.accepted.elastic;
}

void CheckpointCheck::step(const system::System&, const StepRecord& record) {
  if (takes_up_ && std::abs(record.time - record.step - time_) > 1e-6 * record.step) {
    refuse("the next step does not begin at the time of the last one");
  }
  takes_up_ = false;
  time_ = record.time;
  elastic_ = record.accepted.elastic;
}

void CheckpointCheck::ended(double time) {
  if (takes_up_ && std::abs(time - time_) > 1e-9 * end_time_) refuse("it counts steps that it has not taken");
  takes_up_ = false;
}

double CheckpointCheck::kinetic() const {
  return system_->kinetic_energy(u_->data(), v_->data());
}

/// As `commit` sums it up, the sections asked anew.
CheckpointCheck::Stored CheckpointCheck::stored_by_law() const {
  const system::System& system = *system_;
  section::History history = system.history();
  section::StepEnergy energy(system.committed_strains().points());
  system.model().law->commit(history, system.committed_strains(), energy);
  Stored sum{.elastic = system.elastic_energy(energy.stored, u_->data())};
  for (std::size_t point = 0; point < system.committed_strains().points(); ++point) {
    sum.of_sections += system.point_length(point) * std::abs(energy.stored[point]);
  }
  return sum;
}

void CheckpointCheck::archive(Archive& a) {
  double kinetic_written = a.reads() ? 0 : kinetic();
  a(time_, kinetic_written, elastic_);
  if (!a.reads()) return;
  check_numbers();
  check_state(kinetic_written, elastic_);
}

void CheckpointCheck::check_numbers() const {
  if (time_ < 0) refuse("it was left before the run began");
  if (time_ > end_time_ * (1 + 1e-9)) refuse("it was left after the end of the run");
  const Account& now = ledger_.now();
  if (now.friction < 0 || now.material < 0 || now.air < 0) refuse("friction, metal or air have given energy");
}

void CheckpointCheck::check_state(double kinetic_written, double elastic_written) const {
  section::Field strains = system_->committed_strains();
  system_->strains(u_->data(), strains);
  for (std::size_t c = 0; c < section::component_count; ++c) {
    const auto& committed = system_->committed_strains()[section::Component{c}];
    double largest = 0, apart = 0;
    for (std::size_t point = 0; point < committed.size(); ++point) {
      largest = std::max(largest, std::abs(committed[point]));
      apart = std::max(apart, std::abs(committed[point] - strains[section::Component{c}][point]));
    }
    if (!(apart <= same_strain * largest + least_strain)) refuse("the strains are not those of the displacements");
  }
  const Account& now = ledger_.now();
  const double kinetic_found = kinetic();
  const Stored found = stored_by_law();
  if (!is_same(kinetic_found, kinetic_written, 0) || !is_same(kinetic_found, now.kinetic, 0)) {
    refuse("the kinetic energy is not that of the velocities");
  }
  if (!is_same(found.elastic, elastic_written, found.of_sections) ||
      !is_same(found.elastic - initial_elastic_, now.elastic, found.of_sections)) {
    refuse("the stored energy is not that of the sections");
  }
}

}  // namespace strandyn::observe
