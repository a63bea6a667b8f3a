#include <fmt/format.h>

#include <algorithm>

#include "stepper.hpp"
#include "strandyn/core/error.hpp"

namespace strandyn::solver {
namespace {

/// [s] where a step must end: corners of loads and motions, ascending, and the end.
std::vector<double> stop_times(const model::Model& model, double end_time) {
  std::vector<double> times;
  const auto add = [&](const model::TimeFunction& history) {
    for (double t : math::corners(history)) {
      if (t > 0 && t < end_time) times.push_back(t);
    }
  };
  for (const model::Load& load : model.loads) add(load.history);
  for (const model::PrescribedMotion& motion : model.motions) {
    add(motion.history);
    if (motion.ease.duration > 0 && motion.ease.duration < end_time) times.push_back(motion.ease.duration);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  times.push_back(end_time);
  return times;
}

class TimeLoop {
 public:
  TimeLoop(system::System& system, const InitialMotion& initial, const IntegratorOptions& options,
           const TimeMethod& method, std::span<observe::Observer* const> observers)
      : system_(system),
        options_(options),
        observers_(observers),
        name_(name_of(method)),
        stepper_(std::visit([&](const auto& m) { return make_stepper(m, system, initial, options); }, method)),
        stops_(stop_times(system.model(), options.end_time)) {
    if (std::ranges::any_of(observers, [](const observe::Observer* o) { return o->wants_forces(); })) {
      external_ = internal_ = system.make_vector();
    }
  }

  IntegratorSummary go() {
    tell(&observe::Observer::begin);
    resume();
    // A step that ends within rounding of the end time has arrived.
    const double rounding = 1e-12 * options_.end_time + 1e-9 * options_.step;
    while (summary_.end_time < options_.end_time - rounding && summary_.ending == Ending::finished) {
      if (!stepper_->step(stops_[next_stop_])) {
        fail();
        break;
      }
      accept();
      if (options_.stop && options_.stop()) summary_.ending = Ending::stopped;
      pass_corner();
      keep_checkpoint();
    }
    summary_.rejected_steps = stepper_->rejected_steps();
    summary_.newton_iterations = stepper_->newton_iterations();
    return summary_;
  }

 private:
  void accept() {
    const StepTaken taken = stepper_->last();
    ++summary_.steps;
    summary_.end_time = taken.time;
    second_order_reached_ = second_order_reached_ || taken.order == 2;
    if (second_order_reached_ && taken.order == 1) ++summary_.order_one_steps;
    tell(&observe::Observer::step);
  }

  /// Commits the state at hand and tells the observers.
  void tell(void (observe::Observer::*what)(const system::System&, const observe::StepRecord&)) {
    const system::State state{.u = stepper_->u().data(), .v = stepper_->v().data(), .a = stepper_->a().data()};
    const observe::StepRecord record = record_of(system_.commit(state, stepper_->last().time));
    const Stopwatch::Lap lap(system_.stopwatch(), Part::observers);
    find_forces(record);
    for (observe::Observer* observer : observers_) (observer->*what)(system_, record);
  }

  void tell_exchange() {
    const observe::StepRecord record = record_of({});
    find_forces(record);
    for (observe::Observer* observer : observers_) observer->exchanged(record);
  }

  observe::StepRecord record_of(const system::Accepted& accepted) const {
    const StepTaken taken = stepper_->last();
    return {.time = taken.time,
            .step = taken.length,
            .order = taken.order,
            .u = stepper_->u(),
            .v = stepper_->v(),
            .a = stepper_->a(),
            .external = external_,
            .internal = internal_,
            .accepted = accepted};
  }

  void find_forces(const observe::StepRecord& record) {
    if (external_.size() == 0) return;
    system_.forces({.u = record.u.data(), .v = record.v.data(), .a = record.a.data()},
                   {.time = record.time, .drives = options_.drives}, external_, internal_);
  }

  void pass_corner() {
    const bool corner = summary_.end_time >= stops_[next_stop_] && next_stop_ + 1 < stops_.size();
    if (corner) ++next_stop_;
    const bool shortened = stepper_->shorten_rotations();
    if (shortened) tell_exchange();
    if (!shortened && !corner) return;
    stepper_->restart();
    second_order_reached_ = false;
  }

  void fail() {
    const StepFailure failure = stepper_->failure();
    summary_.ending = Ending::failed;
    summary_.failure = fmt::format(
        "the step at t = {:.6g} s did not converge, even cut to {:.3g} s ({}{} steps cut in all); largest last "
        "corrections: {}; try more [integrator] steps_per_cycle",
        stepper_->last().time, failure.length, failure.order ? fmt::format("order {}, ", *failure.order) : "",
        stepper_->rejected_steps(), failure.corrections);
  }

  void archive(Archive& a) {
    a.same(system_.unknowns(), "number of unknowns");
    a.same(std::string(system_.model().law->name()), "section law");
    a.same(observers_.size(), "number of observers");
    a.same(std::string(name_), "integrator");
    // The system last: IDA's first step, which makes it ready to read, belongs to the initial history.
    stepper_->archive(a);
    a(next_stop_, second_order_reached_, summary_.steps, summary_.order_one_steps, summary_.end_time, system_);
    if (next_stop_ >= stops_.size()) throw FileError("it counts more corners than the run has");
    for (observe::Observer* observer : observers_) observer->archive(a);
  }

  /// After a step.
  void keep_checkpoint() {
    if (!options_.checkpoints.due || !options_.checkpoints.due()) return;
    Archive a;
    archive(a);
    options_.checkpoints.keep(a.bytes());
  }

  /// After the beginning, which every run makes in the same way: sizes are then what they will be.
  void resume() {
    if (options_.checkpoints.resume.empty()) return;
    Archive a(options_.checkpoints.resume);
    archive(a);
    a.finish();
  }

  system::System& system_;
  const IntegratorOptions& options_;
  std::span<observe::Observer* const> observers_;
  const char* name_;
  std::unique_ptr<Stepper> stepper_;
  std::vector<double> stops_;
  system::Vector external_, internal_;  // empty where nobody wants them
  std::size_t next_stop_ = 0;
  bool second_order_reached_ = false;  // since the last corner
  IntegratorSummary summary_;
};

}  // namespace

IntegratorSummary integrate(system::System& system, const InitialMotion& initial, const IntegratorOptions& options,
                            const TimeMethod& method, std::span<observe::Observer* const> observers) {
  const bool keeps = options.checkpoints.due || !options.checkpoints.resume.empty();
  if (keeps && std::holds_alternative<Ida>(method) && !ida_has_checkpoints()) {
    throw InputError(
        "integrator.checkpoint_every_s: this program was built without the memory layout of IDA and cannot keep its "
        "state; leave it out, or give integrator.method = \"generalized-alpha\", whose checkpoints work everywhere");
  }
  system.start_clock(0);
  return TimeLoop(system, initial, options, method, observers).go();
}

}  // namespace strandyn::solver
