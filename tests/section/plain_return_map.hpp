#pragma once
/// \file The planar return map a second time, one point, one loop inside the other, as one would write it on paper.
///
/// Nothing is shared with the library but the strand's data: no coefficients, no closed form, no stick range. The limit
/// of a cell depends on the force at its own middle; it is found by repetition, each round gaining a factor
/// b = mu |sin a| dtheta/2 (1/20 and less for a strand).

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "strandyn/conductor/constants.hpp"
#include "strandyn/conductor/strand.hpp"

namespace strandyn::test {

class PlainReturnMap {
 public:
  struct Strain {
    double eps = 0;
    double chi = 0;
  };
  /// What a step answers.
  struct Step {
    double M = 0;
    double stored = 0;  ///< axial and bending
    double dissipated = 0;
    double quadrature_error = 0;
    bool slips = false;    ///< somewhere the trial gradient passes the limit
    double nearest = 1e9;  ///< smallest distance of a trial gradient from its limit, over the limit
  };

  PlainReturnMap(const conductor::Strand& strand, int points)
      : strand_(strand), cells_(points / 4), constants_(conductor::section_constants(strand)) {
    q_.assign(strand.layers.size(), std::vector<double>(2 * static_cast<std::size_t>(cells_), 0.0));
  }

  Step try_step(const Strain& to) const {
    PlainReturnMap copy = *this;
    return copy.step(to);
  }

  Step step(const Strain& to) {
    Step result;
    double friction_moment = 0;
    double stored = 0;
    double f_int_outside = 0;
    const double dtheta = std::numbers::pi / 2 / cells_;
    for (std::size_t j = strand_.layers.size() - 1; j >= 1; --j) {
      const conductor::Layer& wire = strand_.layers[j];
      const bool outermost = j + 1 == strand_.layers.size();
      const double sine = std::max(std::abs(std::sin(wire.lay_angle)), 1e-9);
      const double cosine = std::cos(wire.lay_angle);
      const double R = wire.helix_radius;
      const double kappa = sine * sine / R;
      const double c_int = 1 - kappa * wire.diameter / 2;
      const double c_ext = 1 + kappa * wire.diameter / 2;
      const double mu_ext = outermost ? 0 : strand_.layers[j + 1].friction_inner;
      const double f_ext =
          outermost ? 0 : f_int_outside * strand_.layers[j + 1].wires / static_cast<double>(wire.wires);
      const double F_at = wire.EA_wire() * cosine * cosine * to.eps;
      const double k = wire.EA_wire() * cosine * cosine * sine;
      const double dS = R * dtheta / sine;
      const double C = wire.wires * R * R * cosine / sine;
      const auto press = [&](double F) {  // c_int f_int, not yet clamped
        return kappa * F + c_ext * f_ext + c_int * wire.residual_force;
      };
      const auto limit = [&](double F) {
        return wire.friction_inner * std::max(0.0, press(F)) + mu_ext * c_ext * f_ext;
      };
      double sum_of_F = 0;
      for (int side : {+1, -1}) {
        double F_edge = F_at;
        for (int i = 0; i < cells_; ++i) {
          const double weight = std::cos((i + 0.5) * dtheta);
          double& q = q_[j][static_cast<std::size_t>(side == 1 ? i : cells_ + i)];
          const double before = q;
          const double trial = before + k * weight * (to.chi - chi_);
          q = before;
          for (int round = 0; round < 40; ++round) {
            const double most = limit(F_edge + side * q * dS / 2);
            q = std::clamp(trial, -most, most);
          }
          const double at_trial = limit(F_edge + side * trial * dS / 2);
          result.slips = result.slips || std::abs(trial) > at_trial;
          if (at_trial > 0) result.nearest = std::min(result.nearest, std::abs(std::abs(trial) / at_trial - 1));
          const double slip = (trial - q) / k;
          const double at_mean = (before + q) / 2 * slip;
          result.dissipated += C * std::max(q * slip, at_mean) / (2 * cells_);
          result.quadrature_error += C * (std::max(q * slip, at_mean) - at_mean) / (2 * cells_);
          friction_moment += C * weight * q / (2 * cells_);
          stored += C * q * q / (2 * k) / (2 * cells_);
          sum_of_F += F_edge + side * q * dS / 2;
          F_edge += side * q * dS;
        }
      }
      f_int_outside = std::max(0.0, press(sum_of_F / (2 * cells_))) / c_int;
    }
    chi_ = to.chi;
    result.M = constants_.EI_min * to.chi + friction_moment;
    result.stored = stored + constants_.EA * to.eps * to.eps / 2 + constants_.EI_min * to.chi * to.chi / 2;
    return result;
  }

 private:
  conductor::Strand strand_;
  int cells_;
  conductor::SectionConstants constants_;
  double chi_ = 0;
  std::vector<std::vector<double>> q_;  ///< per layer: tension side, then compression side, from the neutral plane
};

}  // namespace strandyn::test
