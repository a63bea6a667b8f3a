#include "alpha_stepper.hpp"

#include <bit>
#include <cmath>
#include <numbers>

#include "strandyn/core/error.hpp"

namespace strandyn::solver {

AlphaStepper::AlphaStepper(system::System& system, const InitialMotion& initial, const IntegratorOptions& options,
                           GeneralizedAlpha method)
    : system_(system),
      drives_(options.drives),
      method_(method),
      alpha_m_(method.alpha_m()),
      alpha_f_(method.alpha_f()),
      gamma_(method.gamma()),
      beta_(method.beta()),
      whole_step_(options.step),
      fitted_(2 * std::numbers::pi * options.fitted_frequency),
      max_iterations_(options.max_newton_iterations),
      test_(options.newton_tolerance, system.unknowns()),
      h_(stretched(options.step)),
      now_{.u = initial.u, .v = initial.v, .w = system.make_vector()},
      next_(now_),
      a_(system.make_vector()),
      next_a_(a_),
      rate_(initial.v),
      K_(system.make_matrix()),
      correction_(system.make_vector()),
      earlier_rates_(system.make_vector()),
      later_rates_(system.make_vector()) {
  for (std::size_t i = 0; i < system.unknowns(); ++i) {
    if (!system.has_mass(i)) now_.v(static_cast<Eigen::Index>(i)) = 0;
  }
  restart();
}

/// Means of one whole step about t, whose sum misses no jump of a prescribed velocity.
void AlphaStepper::held_accelerations(double t, system::Vector& w) {
  system_.held_rates(at(t - whole_step_ / 2), earlier_rates_.data());
  system_.held_rates(at(t + whole_step_ / 2), later_rates_.data());
  for (std::size_t i = 0; i < system_.unknowns(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    if (system_.is_held(i)) w(k) = (later_rates_(k) - earlier_rates_(k)) / whole_step_;
  }
}

void AlphaStepper::restart() {
  system::Vector force = system_.make_vector();
  system_.residual({.u = now_.u.data()}, at(time_), force.data());
  force = -force;
  system::Vector held = system_.make_vector();
  if (system_.has_moving_supports()) {
    system_.held_rates(at(time_), now_.v.data());
    held_accelerations(time_, held);
    system::Matrix M = system_.make_matrix();
    system_.mass_matrix(now_.u.data(), M);
    system::Vector inertia = system_.make_vector();
    M.multiply(held.data(), inertia.data());
    force -= inertia;
  }
  system_.accelerations(now_.u.data(), now_.v.data(), force.data(), now_.w.data());
  now_.w += held;
  a_ = now_.w;
  starting_ = true;
}

bool AlphaStepper::shorten_rotations() {
  next_.u = now_.u;
  if (!system_.shorten_rotations(next_.u.data(), rate_.data())) return false;
  return system_.shorten_rotations(now_.u.data(), now_.v.data());
}

/// All that `adapt_to` and `predict` do not make anew, and the factors, of a state and a history of long ago.
void AlphaStepper::archive(Archive& a) {
  a(time_, length_, multiples_, whole_, rejected_steps_);
  a(h_, now_, a_, starting_, rate_, patience_, factors_, factored_, newton_iterations_);
  if (factored_ != 0 && !factors_.fit(K_)) throw FileError("the factors of its matrix are another system's");
  if (a.reads()) check_steps();
}

/// Whether a run can have come to such a place between two multiples of the step: what is read is divided by.
void AlphaStepper::check_steps() const {
  const auto& [start, done, part] = whole_;
  const bool parted = part >= 1 && part <= parts && std::has_single_bit(static_cast<unsigned>(part)) && done >= 0 &&
                      done < parts && done % part == 0;
  const double behind = static_cast<double>(multiples_) * whole_step_;
  const bool placed =
      behind <= start + rounding() && start <= time_ + rounding() && time_ <= next_multiple() + rounding();
  if (!parted || !placed || !(h_ > 0))
    throw InputError("its numbers do not belong together: it stands where no step of this run ends");
}

double AlphaStepper::stretched(double length) const {
  return length * method_.stretch(fitted_ * length);
}

/// a is the acceleration at a time beside, by a share of the step: where the step changes, so does the distance.
void AlphaStepper::adapt_to(double h) {
  if (h != h_) a_ = now_.w + (h / h_) * (a_ - now_.w);
  h_ = h;
  dv_ = gamma_ / (beta_ * h);
  dw_ = (1 - alpha_m_) / ((1 - alpha_f_) * beta_ * h * h);
}

/// Goes on as in the step before. A constant acceleration would send modes that the step does not resolve far astray.
void AlphaStepper::predict(double end) {
  const double h = h_;
  for (std::size_t n = 0; n < system_.unknowns(); ++n) {
    const auto i = static_cast<Eigen::Index>(n);
    next_.u(i) = now_.u(i) + h * rate_(i);
    if (!system_.has_mass(n)) {
      next_.v(i) = next_.w(i) = next_a_(i) = 0;
      continue;
    }
    const double a0 = a_(i);
    const double a1 = ((rate_(i) - now_.v(i)) / h - (0.5 - beta_) * a0) / beta_;
    next_a_(i) = a1;
    next_.v(i) = now_.v(i) + h * ((1 - gamma_) * a0 + gamma_ * a1);
    next_.w(i) = ((1 - alpha_m_) * a1 + alpha_m_ * a0 - alpha_f_ * now_.w(i)) / (1 - alpha_f_);
  }
  system_.held_values(at(end), next_.u.data());
  if (!system_.has_moving_supports()) return;
  system_.held_rates(at(end), next_.v.data());
  held_accelerations(end, next_.w);
}

/// One Newton correction; `fresh`: with the tangent where it stands. False where that is singular.
bool AlphaStepper::correct(double end, bool fresh) {
  const system::State state{.u = next_.u.data(), .v = next_.v.data(), .a = next_.w.data()};
  if (fresh) {
    system_.residual(state, at(end), correction_.data(), K_);
    system_.add_inertia_and_drag(state, {.acceleration = dw_, .velocity = dv_, .position = 1}, K_);
    const Stopwatch::Lap lap(system_.stopwatch(), Part::factorization);
    system_.hold(K_);
    const bool done = factors_.factorize(K_);
    factored_ = done ? dw_ : 0;
    if (!done) return false;
  } else {
    system_.residual(state, at(end), correction_.data());
  }
  for (std::size_t n = 0; n < system_.unknowns(); ++n) {
    const auto i = static_cast<Eigen::Index>(n);
    correction_(i) = system_.is_held(n) ? 0.0 : -correction_(i);
  }
  const Stopwatch::Lap lap(system_.stopwatch(), Part::solve);
  factors_.solve(correction_.data());
  for (std::size_t n = 0; n < system_.unknowns(); ++n) {
    const auto i = static_cast<Eigen::Index>(n);
    next_.u(i) += correction_(i);
    if (!system_.has_mass(n)) continue;
    next_.v(i) += dv_ * correction_(i);
    next_.w(i) += dw_ * correction_(i);
    next_a_(i) += correction_(i) / (beta_ * h_ * h_);
  }
  return true;
}

/// The end of the step by Newton's method.
bool AlphaStepper::solve(double end) {
  predict(end);
  for (int iteration = 0; iteration < max_iterations_; ++iteration) {
    const bool stale = std::abs(dw_ - factored_) > 1e-6 * factored_;
    ++newton_iterations_;
    if (!correct(end, iteration >= patience_ || stale)) return false;
    const Verdict verdict = test_.judge(iteration, correction_.data());
    if (verdict == Verdict::on_the_way) continue;
    patience_ = old_factors_serve(iteration + 1);
    return verdict == Verdict::arrived;
  }
  return false;
}

/// One step or part of one. False where it did not converge: the state is then what it was.
bool AlphaStepper::advance(double end) {
  adapt_to(stretched(end - time_));
  if (!solve(end)) return false;
  if (starting_) {
    // Where there is no step behind, a first try tells how the acceleration changes, and so what it is at the time of
    // a.
    a_ = now_.w + (alpha_m_ - alpha_f_) * (next_.w - now_.w);
    if (!solve(end)) {
      a_ = now_.w;
      return false;
    }
    starting_ = false;
  }
  rate_ = (next_.u - now_.u) / h_;
  std::swap(now_, next_);
  a_.swap(next_a_);
  length_ = end - time_;
  time_ = end;
  return true;
}

bool AlphaStepper::step(double stop) {
  auto& [start, done, part] = whole_;
  const bool stops = stop <= next_multiple() + rounding();
  const double target = stops ? stop : next_multiple();
  for (;;) {
    const double end = done + part == parts ? target : start + (target - start) * (done + part) / parts;
    tried_ = end - time_;
    if (advance(end)) break;
    ++rejected_steps_;
    part /= 2;
    if (part == 0) return false;
  }
  done += part;
  while (done < parts && done % (2 * part) == 0) part *= 2;
  if (done < parts) return true;
  whole_ = {.start = time_};
  if (!stops) ++multiples_;
  while (stops && next_multiple() <= stop + rounding()) ++multiples_;
  return true;
}

StepFailure AlphaStepper::failure() const {
  return {.length = tried_, .order = {}, .corrections = test_.worst_unknowns(system_.model())};
}

std::unique_ptr<Stepper> make_stepper(const GeneralizedAlpha& method, system::System& system,
                                      const InitialMotion& initial, const IntegratorOptions& options) {
  if (!(method.rho_inf >= 0 && method.rho_inf <= 1)) throw ComputationError("rho_inf of generalized-alpha is 0 to 1");
  return std::make_unique<AlphaStepper>(system, initial, options, method);
}

}  // namespace strandyn::solver
