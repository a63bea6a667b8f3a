// A section under given tension and moments, twist held: what the couplings between tension and bending do to the
// answer, and what a Jacobian without them costs in iterations.
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "ladder.hpp"
#include "strandyn/exact/full_slip.hpp"
#include "strandyn/section/spatial_return_map.hpp"

namespace strandyn::bench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using section::Component;
using section::Dimension;

/// The unknowns (eps, chi2, chi3) and their conjugates (N, M2, M3).
constexpr std::array components = {Component::axial, Component::bending2, Component::bending3};

enum class Jacobian {
  exact,
  no_strain_columns,  ///< without dM/d eps
  symmetric,          ///< (35): no couplings, the bending block made symmetric
  stick_weights,      ///< no couplings; C_j k mean of cos^2, sin^2, sin cos over the angles that stick
  paper,              ///< (36) as printed: no couplings, diagonal, sin^2 for chi2 and cos^2 for chi3
};

struct Variant {
  const char* label;
  bool axial_resultants;
  Jacobian jacobian;
};
constexpr std::array variants = {
    Variant{"off, exact", false, Jacobian::exact},
    Variant{"off, no dM/d eps", false, Jacobian::no_strain_columns},
    Variant{"off, stick weights", false, Jacobian::stick_weights},
    Variant{"on, exact", true, Jacobian::exact},
    Variant{"on, (35)", true, Jacobian::symmetric},
    Variant{"on, stick weights", true, Jacobian::stick_weights},
    Variant{"on, (36)", true, Jacobian::paper},
};
constexpr std::size_t off = 0;  // the variants whose answers are compared
constexpr std::size_t on = 3;

struct Drive {
  const char* conductor;
  double eta;            ///< mean tension over the rated strength
  double tension_swing;  ///< of the mean, at twice the frequency of bending
  double moment_over_M_0;
  bool circular;
};

constexpr int steps_per_cycle = 100;
constexpr int ramp = steps_per_cycle / 4;
constexpr int last_step = ramp + 2 * steps_per_cycle;

/// (N, M2, M3) at a step: a straight way to the amplitude, then two cycles.
Vector3d load(const Drive& drive, double tension, double M_0, int step) {
  const double M = drive.moment_over_M_0 * M_0;
  if (step < ramp) return {tension, M * step / ramp, 0};
  const double phase = 2 * std::numbers::pi * (step - ramp) / steps_per_cycle;
  return {tension * (1 + drive.tension_swing * std::sin(2 * phase)), M * std::cos(phase),
          drive.circular ? M * std::sin(phase) : 0};
}

struct Run {
  int iterations = 0;
  int most = 0;  ///< in one step
  int failures = 0;
  std::vector<Vector3d> strains;  ///< at each step
  double loss = 0;                ///< [J/m] friction, last cycle
  double bending_work = 0;        ///< [J/m] of N_bending, last cycle
  double lowest_N_bending = 0;    ///< [N] last cycle
  double highest_N_bending = 0;   ///< [N]
};

/// One section point that is brought from load to load.
class Section {
 public:
  Section(const section::SpatialReturnMap& law, Jacobian jacobian, double tension, double M_0)
      : law_(law), jacobian_(jacobian), scale_(tension, M_0, M_0) {
    strains_ = {tension / law.coefficients().EA, 0, 0};
    history_ = law.start(field(strains_));
  }

  const Vector3d& strains() const { return strains_; }
  section::WireState wires() const { return law_.wires(history_, field(strains_), 0); }

  /// Newton's method from the committed strains, undamped. False where it does not converge in 50 iterations.
  bool solve(const Vector3d& wanted, int& iterations) { return newton(wanted, jacobian_, 1, 50, iterations); }

  /// For a step that `solve` gave up: the exact tangent, in ever shorter strides.
  void rescue(const Vector3d& wanted) {
    int iterations = 0;
    for (double stride : {1.0, 0.5, 0.2, 0.05}) {
      if (newton(wanted, Jacobian::exact, stride, 1000, iterations)) return;
    }
    throw std::runtime_error("a step of the coupling benchmark has no answer");
  }

  double commit() {
    section::StepEnergy energy(1);
    law_.commit(history_, field(trial_), energy);
    strains_ = trial_;
    return energy.dissipated[0];
  }

 private:
  static section::Field field(const Vector3d& strains) {
    section::Field f(Dimension::spatial, 1);
    for (int i = 0; i < 3; ++i) f[components[static_cast<std::size_t>(i)]][0] = strains[i];
    return f;
  }

  bool newton(const Vector3d& wanted, Jacobian jacobian, double stride, int limit, int& iterations) {
    constexpr double tolerance = 1e-9;  // of the mean tension and of M_0
    trial_ = strains_;
    for (iterations = 0; iterations <= limit; ++iterations) {
      section::Field stresses(Dimension::spatial, 1);
      section::TangentField tangents(Dimension::spatial, 1);
      law_.respond(history_, field(trial_), stresses, &tangents);
      Vector3d residual;
      Matrix3d K;
      for (int r = 0; r < 3; ++r) {
        const Component row = components[static_cast<std::size_t>(r)];
        residual[r] = stresses[row][0] - wanted[r];
        for (int c = 0; c < 3; ++c) K(r, c) = tangents(row, components[static_cast<std::size_t>(c)])[0];
      }
      if (!residual.allFinite()) return false;
      if (residual.cwiseQuotient(scale_).cwiseAbs().maxCoeff() < tolerance) return true;
      trial_ -= stride * approximate(K, jacobian).partialPivLu().solve(residual);
    }
    return false;
  }

  Matrix3d approximate(Matrix3d K, Jacobian jacobian) const {
    if (jacobian == Jacobian::exact) return K;
    K.bottomLeftCorner<2, 1>().setZero();
    if (jacobian == Jacobian::no_strain_columns) return K;
    K.topRightCorner<1, 2>().setZero();
    if (jacobian == Jacobian::symmetric) {
      K(1, 2) = K(2, 1) = (K(1, 2) + K(2, 1)) / 2;
      return K;
    }
    K(0, 0) = law_.coefficients().EA;
    K.bottomRightCorner<2, 2>() = stick_stiffness(jacobian);
    return K;
  }

  /// Bending stiffness from the angles that stick. Without an increment all do.
  Eigen::Matrix2d stick_stiffness(Jacobian jacobian) const {
    const section::SpatialCoefficients& c = law_.coefficients();
    section::History history = history_;
    section::StepEnergy energy(1);
    law_.commit(history, field(trial_), energy);
    const section::WireState state = law_.wires(history, field(trial_), 0);
    const bool moved = trial_ != strains_;
    Eigen::Matrix2d K = c.EI_min * Eigen::Matrix2d::Identity();
    for (std::size_t j = 0; j < state.layers.size(); ++j) {
      // The coefficients begin with the outermost layer.
      const auto& layer = c.layers[state.layers.size() - 1 - j];
      for (std::size_t i = 0; i < state.theta.size(); ++i) {
        if (moved && state.layers[j].slips[i]) continue;
        const double cosine = std::cos(state.theta[i]);
        const double sine = std::sin(state.theta[i]);
        const double stiffness = layer.weight * layer.k;
        if (jacobian == Jacobian::paper) {
          K.diagonal() += stiffness * Eigen::Vector2d(sine * sine, cosine * cosine);
        } else {
          const Eigen::Vector2d direction(cosine, sine);
          K += stiffness * direction * direction.transpose();
        }
      }
    }
    return K;
  }

  const section::SpatialReturnMap& law_;
  Jacobian jacobian_;
  Vector3d scale_;
  Vector3d strains_;
  Vector3d trial_;
  section::History history_;
};

Run run(const Drive& drive, const Variant& variant) {
  const conductor::Strand strand = catalogue_strand(drive.conductor);
  const double tension = drive.eta * strand.rated_strength;
  const double M_0 = exact::full_slip(strand, tension).M_0;
  const section::SpatialReturnMap law(strand, {.points = 36, .axial_resultants = variant.axial_resultants});
  Section section(law, variant.jacobian, tension, M_0);
  Run run;
  double N_before = 0;
  for (int step = 1; step <= last_step; ++step) {
    const Vector3d wanted = load(drive, tension, M_0, step);
    int iterations = 0;
    if (section.solve(wanted, iterations)) {
      run.iterations += iterations;
      run.most = std::max(run.most, iterations);
    } else {
      ++run.failures;
      section.rescue(wanted);
    }
    const double eps_before = section.strains()[0];
    const double loss = section.commit();
    const double N_bending = section.wires().N_bending;
    if (step > last_step - steps_per_cycle) {
      const bool first = step == last_step - steps_per_cycle + 1;
      run.lowest_N_bending = first ? N_bending : std::min(run.lowest_N_bending, N_bending);
      run.highest_N_bending = first ? N_bending : std::max(run.highest_N_bending, N_bending);
      run.loss += loss;
      run.bending_work += (N_before + N_bending) / 2 * (section.strains()[0] - eps_before);
    }
    N_before = N_bending;
    run.strains.push_back(section.strains());
  }
  return run;
}

std::string name_of(const Drive& d) {
  return fmt::format("{} | {} | {} | {} M_0 {}", d.conductor, d.eta,
                     d.tension_swing > 0 ? fmt::format("+-{} %", 100 * d.tension_swing) : "constant", d.moment_over_M_0,
                     d.circular ? "circle" : "plane");
}

std::vector<Drive> drives() {
  std::vector<Drive> list;
  for (const char* conductor : {"curlew", "steel-1x6"}) {
    for (double swing : {0.0, 0.1}) {
      for (double moment : {0.6, 0.9, 1.2}) {
        for (bool circular : {false, true}) {
          const Drive drive{.conductor = conductor,
                            .eta = 0.15,
                            .tension_swing = swing,
                            .moment_over_M_0 = moment,
                            .circular = circular};
          // The single layer slips beyond 0.78 M_0 only.
          if (drive.conductor != std::string_view("steel-1x6") || moment > 0.8) list.push_back(drive);
        }
      }
    }
  }
  return list;
}

/// What turning the couplings on changes, and the work that N_bending does.
void print_effect(const Drive& drive, const Run& without, const Run& with) {
  double chi = 0, chi_moved = 0, eps_moved = 0;
  for (std::size_t i = 0; i < with.strains.size(); ++i) {
    const Vector3d d = with.strains[i] - without.strains[i];
    chi = std::max(chi, without.strains[i].tail<2>().norm());
    chi_moved = std::max(chi_moved, d.tail<2>().norm());
    eps_moved = std::max(eps_moved, std::abs(d[0]));
  }
  const conductor::Strand strand = catalogue_strand(drive.conductor);
  const double tension = drive.eta * strand.rated_strength;
  const double chi_0 = exact::full_slip(strand, tension).chi_0;
  fmt::print("| {} | {:.2f} | {:.2f} | {:+.2f} | {:.2f} | {:+.2f} .. {:+.2f} | {:.3f} |\n", name_of(drive), chi / chi_0,
             100 * chi_moved / chi, 100 * (with.loss / without.loss - 1),
             100 * eps_moved / strain_at(strand, drive.eta), 100 * with.lowest_N_bending / tension,
             100 * with.highest_N_bending / tension, 100 * std::abs(with.bending_work) / with.loss);
}

}  // namespace

void print_coupling_tables() {
  std::vector<std::array<Run, variants.size()>> runs;
  fmt::print("\nIterations of a load step, mean/most (and steps that failed); axial resultants off or on, Jacobian.\n");
  fmt::print("\n| conductor | eta | tension | moment |");
  for (const Variant& variant : variants) fmt::print(" {} |", variant.label);
  fmt::print("\n| --- | --- | --- | --- |");
  for (std::size_t i = 0; i < variants.size(); ++i) fmt::print(" --- |");
  for (const Drive& drive : drives()) {
    fmt::print("\n| {} |", name_of(drive));
    runs.emplace_back();
    for (std::size_t v = 0; v < variants.size(); ++v) {
      const Run& r = runs.back()[v] = run(drive, variants[v]);
      const int solved = last_step - r.failures;
      fmt::print(" {:.1f}/{}{} |", solved > 0 ? static_cast<double>(r.iterations) / solved : 0.0, r.most,
                 r.failures > 0 ? fmt::format(" ({} failed)", r.failures) : "");
    }
  }
  fmt::print("\n\nThe axial resultants of bending on, against off.\n\n");
  fmt::print(
      "| conductor | eta | tension | moment | chi_max/chi_0 | chi moves, % of chi_max | loss per cycle, % | "
      "eps moves, % of the mean | N_bending of the last cycle, % of the mean tension | its work, % of the loss |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  const std::vector<Drive> list = drives();
  for (std::size_t i = 0; i < list.size(); ++i) print_effect(list[i], runs[i][off], runs[i][on]);
}

}  // namespace strandyn::bench
