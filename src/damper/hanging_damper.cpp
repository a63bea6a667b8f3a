#include "strandyn/damper/hanging_damper.hpp"

#include <cmath>
#include <limits>

#include "arm_model.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/section/linear_law.hpp"
#include "strandyn/system/system.hpp"
#include "without_axial.hpp"

namespace strandyn::damper {
namespace {

using system::Vector;

/// Displacement [m] and rotation [rad] of the clamp, their rates and the rates of those.
struct ClampMotion {
  Eigen::Vector2d position, rate, acceleration;
};

/// An arm to the right of its clamp.
class ArmInTime {
 public:
  ArmInTime(const Arm& arm, const Messenger& messenger, bool is_elastic, const HangingDamperOptions& options)
      : is_elastic_(is_elastic),
        model_(arm_model(arm, messenger, options.elements, options.frequency)),
        system_(model_),
        at_end_{.u = system_.make_vector(), .v = system_.make_vector(), .a = system_.make_vector()},
        correction_(system_.make_vector()),
        matrix_(system_.make_matrix()) {
    system_.begin(at_end_.u);
    system_.start_clock(0);
    committed_ = at_end_;
  }

  /// [N], [N m] that the clamp needs when it moves like this at a time [s].
  Eigen::Vector2d force(const ClampMotion& clamp, double time) const {
    follow(clamp, time);
    system_.reactions(at_end_.as_state(), {.time = time}, correction_.data());
    return correction_.head<2>();
  }

  system::AttachedEnergy commit(const ClampMotion& clamp, double time) {
    if (!begun_) begin(clamp);
    follow(clamp, time);
    committed_ = at_end_;
    time_ = time;
    const system::Accepted accepted = system_.commit(at_end_.u.data(), time);
    if (!is_elastic_) factored_step_ = 0;
    return {.kinetic = system_.kinetic_energy(at_end_.u.data(), at_end_.v.data()),
            .elastic = accepted.elastic,
            .lost = accepted.friction + accepted.material};
  }

  /// [N/m] and the like: what the clamp needs more of per motion of it at the end of the step, the arm following.
  const Eigen::Matrix2d& tangent() const { return tangent_; }

  void archive(Archive& a) { a(committed_.u, committed_.v, committed_.a, time_, begun_, system_); }

 private:
  struct Motion {
    Vector u, v, a;
    system::State as_state() const { return {.u = u.data(), .v = v.data(), .a = a.data()}; }
  };

  /// A rigid body that moves and turns with its clamp.
  void begin(const ClampMotion& clamp) {
    for (std::size_t node = 0; node < model_.nodes.size(); ++node) {
      const double x = model_.nodes[node].x();
      const auto i = static_cast<Eigen::Index>(2 * node);
      const auto set = [&](Vector& of_arm, const Eigen::Vector2d& of_clamp) {
        of_arm(i) = of_clamp(0) + x * of_clamp(1);
        of_arm(i + 1) = of_clamp(1);
      };
      set(committed_.u, clamp.position);
      set(committed_.v, clamp.rate);
      set(committed_.a, clamp.acceleration);
    }
    begun_ = true;
  }

  static void lead(const ClampMotion& clamp, Motion& motion) {
    motion.u.head<2>() = clamp.position;
    motion.v.head<2>() = clamp.rate;
    motion.a.head<2>() = clamp.acceleration;
  }

  /// Sets the state at the end of the step from the last commit to `time`, with the clamp as given there.
  void follow(const ClampMotion& clamp, double time) const {
    const double h = time - time_;
    at_end_ = committed_;
    lead(clamp, at_end_);
    if (h <= 0) return;
    constexpr int most_iterations = 30;
    constexpr double arrived = 1e-12;  // [m], [rad]
    const Eigen::Index n = at_end_.u.size();
    // Trapezoidal rule, from a first guess of constant acceleration.
    for (Eigen::Index i = 2; i < n; ++i) {
      at_end_.v(i) = committed_.v(i) + h * committed_.a(i);
      at_end_.u(i) = committed_.u(i) + h / 2 * (committed_.v(i) + at_end_.v(i));
    }
    // The matrix of an elastic arm is the same in all steps, that of one whose wires slip serves for a step; the last
    // digits of a step's length do not matter to it, and a run that is resumed has the same.
    const double step = static_cast<float>(h);
    constexpr double contracts = 0.1;
    double last = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      const bool is_old = step != factored_step_;
      if (is_old || (iteration > 0 && last_size_ > contracts * last)) {
        if (!factorize(step, time)) break;
      } else {
        system_.residual(at_end_.as_state(), {.time = time}, correction_.data());
      }
      if (iteration > 0) last = last_size_;
      correction_.head<2>().setZero();
      factors_.solve(correction_.data());
      for (Eigen::Index i = 2; i < n; ++i) {
        at_end_.u(i) -= correction_(i);
        at_end_.v(i) -= 2 / h * correction_(i);
        at_end_.a(i) -= 4 / (h * h) * correction_(i);
      }
      last_size_ = correction_.cwiseAbs().maxCoeff();
      if (last_size_ < arrived) return;
    }
    factored_step_ = 0;
    throw ComputationError("the arm of a damper does not follow its clamp: give more [integrator] steps_per_cycle");
  }

  /// The residual at hand, the factors of its matrix, and what the clamp feels of the arm.
  bool factorize(double h, double time) const {
    system_.residual(at_end_.as_state(), {.time = time}, correction_.data(), matrix_);
    system_.add_inertia_and_drag(at_end_.as_state(), {.acceleration = 4 / (h * h), .velocity = 2 / h, .position = 1},
                                 matrix_);
    const system::Matrix free = matrix_;
    system_.hold(matrix_);
    factored_step_ = 0;
    if (!factors_.factorize(matrix_)) return false;
    factored_step_ = h;
    for (int j = 0; j < 2; ++j) {
      Vector moved = system_.make_vector(), column = moved, back = moved;
      moved(j) = 1;
      free.multiply(moved.data(), column.data());
      Vector follows = column;
      follows.head<2>().setZero();
      factors_.solve(follows.data());
      free.multiply(follows.data(), back.data());
      tangent_.col(j) = column.head<2>() - back.head<2>();
    }
    return true;
  }

  bool is_elastic_;
  model::Model model_;
  system::System system_;
  Motion committed_;
  double time_ = 0;  // [s] of the last commit
  bool begun_ = false;
  mutable Motion at_end_;
  mutable Vector correction_;
  mutable system::Matrix matrix_;
  mutable math::ChainFactors factors_;
  mutable double factored_step_ = 0;  // [s] of the factors; 0: there are none
  mutable double last_size_ = 0;      // of the last correction
  mutable Eigen::Matrix2d tangent_ = Eigen::Matrix2d::Zero();
};

class HangingDamper final : public system::Attachment {
 public:
  HangingDamper(const model::Model& span, const std::vector<HangingArm>& arms, Messenger messenger,
                const HangingDamperOptions& options)
      : across_(span.index(options.node, model::Unknown::y).value()),
        turn_(span.index(options.node, model::Unknown::rotation_z).value()) {
    const bool is_elastic = dynamic_cast<const section::LinearLaw*>(messenger.law.get()) != nullptr;
    messenger.law = std::make_shared<WithoutAxial>(messenger.law);
    for (const HangingArm& hanging : arms) {
      arms_.push_back({.arm = std::make_unique<ArmInTime>(hanging.arm, messenger, is_elastic, options),
                       .hand = hanging.side == Side::right ? 1.0 : -1.0});
    }
  }

  void add_force(const system::State& state, double time, double* f) const override {
    for (const Placed& placed : arms_) {
      const Eigen::Vector2d force = placed.arm->force(clamp_of(state, placed.hand), time);
      f[across_] += force(0);
      f[turn_] += placed.hand * force(1);
    }
  }

  void add_tangent(math::ChainMatrix& K) const override {
    for (const Placed& placed : arms_) {
      const Eigen::Matrix2d& S = placed.arm->tangent();
      K.add_at_node(across_, across_, S(0, 0));
      K.add_at_node(across_, turn_, placed.hand * S(0, 1));
      K.add_at_node(turn_, across_, placed.hand * S(1, 0));
      K.add_at_node(turn_, turn_, S(1, 1));
    }
  }

  system::AttachedEnergy commit(const system::State& state, double time) override {
    system::AttachedEnergy sum;
    for (const Placed& placed : arms_) {
      const system::AttachedEnergy energy = placed.arm->commit(clamp_of(state, placed.hand), time);
      sum.kinetic += energy.kinetic;
      sum.elastic += energy.elastic;
      sum.lost += energy.lost;
    }
    return sum;
  }

  void archive(Archive& a) override {
    for (const Placed& placed : arms_) placed.arm->archive(a);
  }

 private:
  /// Arms to the left are looked at from behind.
  struct Placed {
    std::unique_ptr<ArmInTime> arm;
    double hand = 1;
  };
  ClampMotion clamp_of(const system::State& state, double hand) const {
    const auto pair = [&](const double* x) { return Eigen::Vector2d(x[across_], hand * x[turn_]); };
    return {.position = pair(state.u), .rate = pair(state.v), .acceleration = pair(state.a)};
  }

  std::size_t across_, turn_;  // unknowns of the span
  std::vector<Placed> arms_;
};

}  // namespace

std::unique_ptr<system::Attachment> make_hanging_damper(const model::Model& span, const std::vector<HangingArm>& arms,
                                                        const Messenger& messenger,
                                                        const HangingDamperOptions& options) {
  return std::make_unique<HangingDamper>(span, arms, messenger, options);
}

}  // namespace strandyn::damper
