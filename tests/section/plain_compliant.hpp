#pragma once
/// \file The compliant law a second time, one point, one loop inside the other, each cell solved by halving.
///
/// It shares the strand, the contacts' stiffness (hertz.hpp) and the chains with the library, and nothing else.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "strandyn/conductor/constants.hpp"
#include "strandyn/conductor/contact.hpp"
#include "strandyn/conductor/hertz.hpp"
#include "strandyn/section/compliant.hpp"

namespace strandyn::test {

class PlainCompliant {
 public:
  struct Strain {
    double eps = 0;
    double chi = 0;
  };
  struct Step {
    double M = 0;
    double stored = 0;  ///< axial and bending
    double lost = 0;    ///< what the springs lose less the error of the trapezoid
  };

  PlainCompliant(const conductor::Strand& strand, const section::CompliantOptions& options, double strain)
      : strand_(strand),
        options_(options),
        cells_(options.points / 4),
        faces_(conductor::interfaces(strand)),
        constants_(conductor::section_constants(strand)),
        peak_(strain) {
    // The layers' own chains: cubes of the cosines tell how much of the grading each angle covers.
    const double ratio = std::pow(options.smallest_slip, -1.0 / (options.springs - 2));
    const auto usual = conductor::contact_forces(strand, conductor::axial_wire_forces(strand, 1e-3, 0));
    std::vector<double> part;
    double total = 0;
    for (int i = 0; i < cells_; ++i) total += std::pow(cosine(i), 3);
    double before = 0;
    for (int i = 0; i < cells_; ++i) {
      const double own = std::pow(cosine(i), 3) / total;
      double phase = before + own / 2 - std::log(cosine(i)) / std::log(ratio);
      phase -= std::floor(phase);
      before += own;
      chains_.emplace_back(strand.layers.size());
      for (std::size_t j = 1; j < strand.layers.size(); ++j) {
        const auto curve = faces_[j].line ? conductor::SlipCurve::line(faces_[j].along.slip_logarithm(usual[j].f_int))
                                          : conductor::SlipCurve::spot();
        chains_.back()[j] = conductor::spring_chain(
            curve, {.springs = options.springs, .smallest_slip = options.smallest_slip, .phase = phase});
      }
    }
    const auto springs = static_cast<std::size_t>(options.springs);
    f_.assign(strand.layers.size() * 2 * static_cast<std::size_t>(cells_), std::vector<double>(2 * springs, 0.0));
  }

  Step step(const Strain& to) {
    Step result;
    const double dtheta = std::numbers::pi / 2 / cells_;
    const double peak = std::max(peak_, to.eps);
    const std::vector<Stiffness> K_before = stiffness(peak_);
    const std::vector<Stiffness> K_now = stiffness(peak);
    double f_int_outside = 0;
    double M = 0;
    double stored = 0;
    for (std::size_t j = strand_.layers.size() - 1; j >= 1; --j) {
      const conductor::Layer& wire = strand_.layers[j];
      const bool outermost = j + 1 == strand_.layers.size();
      const double sine = std::abs(std::sin(wire.lay_angle));
      const double cos_lay = std::cos(wire.lay_angle);
      const double R = wire.helix_radius;
      const double kappa = sine * sine / R;
      const double c_int = 1 - kappa * wire.diameter / 2;
      const double c_ext = 1 + kappa * wire.diameter / 2;
      const double outer_load =
          outermost ? 0 : c_ext * f_int_outside * strand_.layers[j + 1].wires / static_cast<double>(wire.wires);
      const double limit_outside = outermost ? 0 : strand_.layers[j + 1].friction_inner * outer_load;
      const double F_at = wire.EA_wire() * cos_lay * cos_lay * to.eps;
      const double k = wire.EA_wire() * cos_lay * cos_lay * sine;
      const double k_w = wire.EA_wire() * sine * sine / (R * R);
      const double dS = R * dtheta / sine;
      const double C = wire.wires * R * R * cos_lay / sine;
      const double wires_per_length = wire.wires / cos_lay;
      const auto press = [&](double F) { return kappa * F + outer_load + c_int * wire.residual_force; };
      double sum_of_F = 0;
      for (int side : {+1, -1}) {
        double F_edge = F_at;
        for (int i = 0; i < cells_; ++i) {
          std::vector<double>& f =
              f_[(j * 2 + (side == 1 ? 0 : 1)) * static_cast<std::size_t>(cells_) + static_cast<std::size_t>(i)];
          const std::vector<double> f0 = f;
          double q0 = 0;
          for (double one : f0) q0 += one;
          const double de = cosine(i) * (to.chi - chi_);
          const auto springs = [&](auto&& each) {
            const std::size_t n = f.size() / 2;
            for (std::size_t s = 0; s < (outermost ? n : 2 * n); ++s) {
              const conductor::SpringChain& chain = chains_[static_cast<std::size_t>(i)][s < n ? j : j + 1];
              each(s, s < n, chain.stiffness[s % n], chain.limit[s % n]);
            }
          };
          const auto traction = [&](double slip) {
            const double q = q0 + k * de - k_w * slip;
            const double limit_inside = wire.friction_inner * std::max(0.0, press(F_edge + side * q * dS / 2));
            double sum = 0;
            springs([&](std::size_t s, bool inside, double kappa_s, double phi) {
              const double most = phi * (inside ? limit_inside : limit_outside);
              const double K = inside ? K_now[j].inner : K_now[j].outer;
              f[s] = std::clamp(f0[s] + K * kappa_s * slip, -most, most);
              sum += f[s];
            });
            return sum - q;
          };
          double low = -1;
          double high = 1;
          for (int round = 0; round < 200; ++round) {
            const double middle = (low + high) / 2;
            (traction(middle) < 0 ? low : high) = middle;
          }
          const double slip = (low + high) / 2;
          traction(slip);
          double q = 0;
          for (double one : f) q += one;
          const double weight = 1.0 / (2 * cells_);
          springs([&](std::size_t s, bool inside, double kappa_s, double) {
            const double K0 = kappa_s * (inside ? K_before[j].inner : K_before[j].outer);
            const double K1 = kappa_s * (inside ? K_now[j].inner : K_now[j].outer);
            const double work = (f0[s] + f[s]) / 2 * slip;
            const double gained = (K1 > 0 ? f[s] * f[s] / (2 * K1) : 0) - (K0 > 0 ? f0[s] * f0[s] / (2 * K0) : 0);
            stored += wires_per_length * weight * (K1 > 0 ? f[s] * f[s] / (2 * K1) : 0);
            result.lost += wires_per_length * weight * (work - gained);
          });
          M += C * weight * cosine(i) * q;
          stored += C * weight * q * q / (2 * k);
          sum_of_F += F_edge + side * q * dS / 2;
          F_edge += side * q * dS;
        }
      }
      f_int_outside = std::max(0.0, press(sum_of_F / (2 * cells_))) / c_int;
    }
    chi_ = to.chi;
    peak_ = peak;
    result.M = constants_.EI_min * to.chi + M;
    result.stored = stored + constants_.EA * to.eps * to.eps / 2 + constants_.EI_min * to.chi * to.chi / 2;
    return result;
  }

 private:
  struct Stiffness {
    double inner = 0;
    double outer = 0;
  };

  double cosine(int i) const { return std::cos((i + 0.5) * std::numbers::pi / 2 / cells_); }

  /// Of the contacts of each layer when the strand is straight under `strain`. The load of an inner contact counts per
  /// length of the wire, c_int f_int.
  std::vector<Stiffness> stiffness(double strain) const {
    const auto forces = conductor::contact_forces(strand_, conductor::axial_wire_forces(strand_, strain, 0));
    const auto geometry = conductor::contact_geometry(strand_);
    std::vector<Stiffness> all(strand_.layers.size());
    for (std::size_t j = 1; j < all.size(); ++j) {
      const double inner = geometry[j].c_int * forces[j].f_int;
      all[j].inner = faces_[j].stiffness(inner, faces_[j].per_outer_wire).value / options_.compliance_scale;
      if (j + 1 == all.size()) continue;
      const double outer = geometry[j].c_ext * forces[j].f_ext;
      all[j].outer = faces_[j + 1].stiffness(outer, faces_[j + 1].per_inner_wire).value / options_.compliance_scale;
    }
    return all;
  }

  conductor::Strand strand_;
  section::CompliantOptions options_;
  int cells_;
  std::vector<conductor::Interface> faces_;
  conductor::SectionConstants constants_;
  std::vector<std::vector<conductor::SpringChain>>
      chains_;  ///< [angle][layer]: contact of the layer with the one inside
  double chi_ = 0;
  double peak_ = 0;
  std::vector<std::vector<double>> f_;  ///< per layer, side, angle: springs inside, springs outside
};

}  // namespace strandyn::test
