#include "strandyn/solver/time/ida.hpp"

#include "checkpoint.hpp"
#include "ida_session.hpp"
#include "strandyn/core/error.hpp"

namespace strandyn::solver {

using system::Vector;

namespace {

class Run {
 public:
  Run(system::System& system, const InitialMotion& initial, const IntegratorOptions& options,
      std::span<observe::Observer* const> observers)
      : system_(system),
        options_(options),
        observers_(observers),
        session_(system, initial, options),
        u_(initial.u),
        v_(Eigen::Map<const Vector>(session_.v(), u_.size())),
        a_(Eigen::Map<const Vector>(session_.a(), u_.size())),
        stops_(corner_times(system.model(), options.end_time)) {}

  IntegratorSummary go() {
    begin();
    // A step that ends within rounding of the end time has arrived.
    const double rounding = 1e-12 * options_.end_time + 1e-9 * options_.step;
    while (summary_.end_time < options_.end_time - rounding) {
      if (!session_.step(stops_[next_stop_])) {
        summary_.ending = Ending::failed;
        summary_.failure = session_.failure();
        break;
      }
      accept();
      if (options_.stop && options_.stop()) summary_.ending = Ending::stopped;
      pass_corner();
      keep_checkpoint(options_.checkpoints, system_, *this, observers_);
      if (summary_.ending == Ending::stopped) break;
    }
    summary_.rejected_steps = session_.rejected_steps();
    summary_.newton_iterations = session_.newton_iterations();
    return summary_;
  }

  void archive(Archive& a) {
    a.same(std::string("ida"), "integrator");
    a(session_, next_stop_, second_order_reached_, summary_.steps, summary_.order_one_steps, summary_.end_time);
  }

 private:
  void begin() {
    const observe::StepRecord start{
        .time = 0, .step = 0, .order = 0, .u = u_, .v = v_, .a = a_, .accepted = system_.commit(u_.data())};
    for (observe::Observer* observer : observers_) observer->begin(system_, start);
    resume(options_.checkpoints, system_, *this, observers_);
  }

  /// Commits the state at the end of the step and tells the observers.
  void accept() {
    ++summary_.steps;
    summary_.end_time = session_.time();
    const int order = session_.last_order();
    second_order_reached_ = second_order_reached_ || order == 2;
    if (second_order_reached_ && order == 1) ++summary_.order_one_steps;
    u_ = Eigen::Map<const Vector>(session_.u(), u_.size());
    v_ = Eigen::Map<const Vector>(session_.v(), v_.size());
    a_ = Eigen::Map<const Vector>(session_.a(), a_.size());
    const observe::StepRecord record{.time = session_.time(),
                                     .step = session_.last_step(),
                                     .order = order,
                                     .u = u_,
                                     .v = v_,
                                     .a = a_,
                                     .accepted = system_.commit(u_.data())};
    const Stopwatch::Lap lap(system_.stopwatch(), Part::observers);
    for (observe::Observer* observer : observers_) observer->step(system_, record);
  }

  /// A multistep formula starts anew at a corner: its older steps lie on another line.
  void pass_corner() {
    const bool corner = summary_.end_time >= stops_[next_stop_] && next_stop_ + 1 < stops_.size();
    if (corner) ++next_stop_;
    if (system_.shorten_rotations(u_.data(), v_.data()) || corner) {
      session_.restart(u_, v_);
      second_order_reached_ = false;
    }
  }

  system::System& system_;
  const IntegratorOptions& options_;
  std::span<observe::Observer* const> observers_;
  IdaSession session_;
  Vector u_, v_, a_;
  std::vector<double> stops_;
  std::size_t next_stop_ = 0;
  bool second_order_reached_ = false;
  IntegratorSummary summary_;
};

}  // namespace

IntegratorSummary integrate_ida(system::System& system, const InitialMotion& initial, const IntegratorOptions& options,
                                std::span<observe::Observer* const> observers) {
  const Checkpoints& checkpoints = options.checkpoints;
  if ((checkpoints.due || !checkpoints.resume.empty()) && !ida_has_checkpoints()) {
    throw InputError(
        "integrator.checkpoint_every_s: this program was built with a SUNDIALS whose IDA cannot be kept midway (6.4 "
        "can); leave the key out, or take [integrator] method = \"generalized-alpha\"");
  }
  return Run(system, initial, options, observers).go();
}

}  // namespace strandyn::solver
