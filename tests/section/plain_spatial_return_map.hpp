#pragma once
/// \file The spatial return map a second time, one point, as one would write it on paper.
///
/// Nothing is shared with the library but the strand's data. The force along the turn is found by repetition: q from
/// the limits at the last force, the force by summing q from one cell to the next, then its mean and its neutral
/// points. Each round gains a factor of mu |sin a| or so.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "strandyn/conductor/constants.hpp"
#include "strandyn/conductor/strand.hpp"

namespace strandyn::test {

class PlainSpatialReturnMap {
 public:
  struct Strain {
    double eps = 0;
    double chi1 = 0;
    double chi2 = 0;
    double chi3 = 0;
  };
  struct Step {
    double M2 = 0;
    double M3 = 0;
    double stored = 0;  ///< friction part
    double dissipated = 0;
    double quadrature_error = 0;
    double mean_over_limit = 0;                      ///< largest |mean q| over the mean limit of a layer
    std::vector<std::vector<double>> bending_force;  ///< per layer of the strand
  };

  PlainSpatialReturnMap(const conductor::Strand& strand, int points)
      : strand_(strand), points_(points), EI_min_(conductor::section_constants(strand).EI_min) {
    q_.assign(strand.layers.size(), std::vector<double>(static_cast<std::size_t>(points), 0.0));
  }

  Step step(const Strain& to) {
    Step result;
    result.M2 = EI_min_ * to.chi2;
    result.M3 = EI_min_ * to.chi3;
    result.bending_force.resize(strand_.layers.size());
    if (std::hypot(to.chi2, to.chi3) > 1e-12) neutral_ = std::atan2(to.chi3, to.chi2);
    const double dtheta = 2 * std::numbers::pi / points_;
    double f_int_outside = 0;
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
      const double F_at = wire.EA_wire() * (cosine * cosine * to.eps + R * std::sin(wire.lay_angle) * cosine * to.chi1);
      const double k = wire.EA_wire() * cosine * cosine * sine;
      const double C = wire.wires * R * R * cosine / sine;
      const auto press = [&](double F) { return kappa * F + c_ext * f_ext + c_int * wire.residual_force; };
      const auto limit = [&](double F) {
        return wire.friction_inner * std::max(0.0, press(F)) + mu_ext * c_ext * f_ext;
      };

      const std::vector<double> before = q_[j];
      std::vector<double>& q = q_[j];
      std::vector<double> F_b(q.size(), 0.0);
      double mean = 0;
      for (int round = 0; round < 200; ++round) {
        mean = 0;
        for (std::size_t i = 0; i < q.size(); ++i) {
          const double theta = (static_cast<double>(i) + 0.5) * dtheta;
          const double de = std::cos(theta) * (to.chi2 - last_.chi2) + std::sin(theta) * (to.chi3 - last_.chi3);
          const double most = limit(F_at + F_b[i]);
          q[i] = std::clamp(before[i] + k * de, -most, most);
          mean += q[i] / points_;
        }
        // Integral of q - mean from theta = 0 to theta, whatever theta.
        const auto integral = [&](double theta) {
          const double turned = theta - 2 * std::numbers::pi * std::floor(theta / (2 * std::numbers::pi));
          double sum = 0;
          for (std::size_t i = 0; i < q.size(); ++i) {
            const double part = std::clamp(turned / dtheta - static_cast<double>(i), 0.0, 1.0);
            sum += part * (q[i] - mean) * R * dtheta / sine;
          }
          return sum;
        };
        const double at_neutral = (integral(neutral_) + integral(neutral_ + std::numbers::pi)) / 2;
        double change = 0;
        double running = 0;
        for (std::size_t i = 0; i < q.size(); ++i) {
          const double part = (q[i] - mean) * R * dtheta / sine;
          const double F = running + part / 2 - at_neutral;
          running += part;
          change = std::max(change, std::abs(F - F_b[i]));
          F_b[i] = F;
        }
        if (change < 1e-13 * wire.EA_wire() * 1e-3) break;
      }
      double sum_of_F = 0;
      double sum_of_limit = 0;
      for (std::size_t i = 0; i < q.size(); ++i) {
        const double theta = (static_cast<double>(i) + 0.5) * dtheta;
        const double de = std::cos(theta) * (to.chi2 - last_.chi2) + std::sin(theta) * (to.chi3 - last_.chi3);
        const double slip = (before[i] + k * de - q[i]) / k;
        const double at_mean = (before[i] + q[i]) / 2 * slip;
        result.dissipated += C * std::max(q[i] * slip, at_mean) / points_;
        result.quadrature_error += C * (std::max(q[i] * slip, at_mean) - at_mean) / points_;
        result.stored += C * q[i] * q[i] / (2 * k) / points_;
        result.M2 += C * std::cos(theta) * q[i] / points_;
        result.M3 += C * std::sin(theta) * q[i] / points_;
        sum_of_F += F_at + F_b[i];
        sum_of_limit += limit(F_at + F_b[i]);
      }
      if (sum_of_limit > 0) {
        result.mean_over_limit = std::max(result.mean_over_limit, std::abs(mean) * points_ / sum_of_limit);
      }
      result.bending_force[j] = F_b;
      f_int_outside = std::max(0.0, press(sum_of_F / points_)) / c_int;
    }
    last_ = to;
    return result;
  }

 private:
  conductor::Strand strand_;
  int points_;
  double EI_min_;
  double neutral_ = 0;
  Strain last_;
  std::vector<std::vector<double>> q_;
};

}  // namespace strandyn::test
