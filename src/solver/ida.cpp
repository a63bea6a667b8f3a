#include "strandyn/solver/ida.hpp"

#include "ida_session.hpp"

namespace strandyn::solver {

using system::Vector;

IdaSummary integrate_ida(system::System& system, const InitialMotion& initial, const IdaOptions& options,
                         std::span<Observer* const> observers) {
  IdaSession session(system, initial, options);
  Vector u = initial.u;
  Vector v = Vector::Zero(u.size());
  for (std::size_t i = 0; i < system.unknowns(); ++i) {
    if (system.has_mass(i)) v(static_cast<Eigen::Index>(i)) = initial.v(static_cast<Eigen::Index>(i));
  }
  const StepRecord start{.time = 0, .step = 0, .order = 0, .u = u, .v = v, .accepted = system.commit(u.data())};
  for (Observer* observer : observers) observer->begin(system, start);

  IdaSummary summary;
  bool second_order_reached = false;
  // A step that ends within rounding of the end time has arrived.
  const double arrived = options.end_time * (1 - 1e-12) - 1e-9 * options.step;
  while (summary.end_time < arrived) {
    if (!session.step()) {
      summary.ending = Ending::failed;
      summary.failure = session.failure();
      break;
    }
    ++summary.steps;
    summary.end_time = session.time();
    const int order = session.last_order();
    second_order_reached = second_order_reached || order == 2;
    if (second_order_reached && order == 1) ++summary.order_one_steps;
    u = Eigen::Map<const Vector>(session.u(), u.size());
    v = Eigen::Map<const Vector>(session.v(), v.size());
    const StepRecord record{.time = session.time(),
                            .step = session.last_step(),
                            .order = order,
                            .u = u,
                            .v = v,
                            .accepted = system.commit(u.data())};
    {
      const Stopwatch::Lap lap(system.stopwatch(), Part::observers);
      for (Observer* observer : observers) observer->step(system, record);
    }
    if (options.stop && options.stop()) {
      summary.ending = Ending::stopped;
      break;
    }
  }
  summary.rejected_steps = session.rejected_steps();
  summary.newton_iterations = session.newton_iterations();
  return summary;
}

}  // namespace strandyn::solver
