#pragma once
/// \file The compliant law a second time: one point, one loop inside the other. A cell is solved wire by wire, each by
/// halving while the others wait, round and round until nobody moves.
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
    T_.assign(2 * static_cast<std::size_t>(cells_),
              std::vector<std::vector<double>>(strand.layers.size(),
                                               std::vector<double>(static_cast<std::size_t>(options.springs), 0.0)));
  }

  Step step(const Strain& to) {
    Step result;
    const double dtheta = std::numbers::pi / 2 / cells_;
    const double peak = std::max(peak_, to.eps);
    const std::vector<double> K_before = stiffness(peak_);
    const std::vector<double> K_now = stiffness(peak);
    const std::size_t layers = strand_.layers.size();
    double M = 0;
    double stored = 0;
    for (int side : {+1, -1}) {
      std::vector<double> F_edge(layers, 0.0);
      for (std::size_t j = 1; j < layers; ++j) F_edge[j] = axial_force(j, to.eps);
      for (int i = 0; i < cells_; ++i) {
        std::vector<std::vector<double>>& springs = T_[static_cast<std::size_t>(2 * i + (side == 1 ? 0 : 1))];
        Cell cell{.angle = static_cast<std::size_t>(i),
                  .before = springs,
                  .now = springs,
                  .K = K_now,
                  .slip = std::vector<double>(layers, 0.0),
                  .stick = std::vector<double>(layers, 0.0),
                  .F_edge = F_edge,
                  .dS = dtheta * side};
        for (std::size_t j = 1; j < layers; ++j) {
          cell.stick[j] = gradient(j, cell.before) + k(j) * cosine(i) * (to.chi - chi_);
        }
        solve(cell);
        const double weight = 1.0 / (2 * cells_);
        for (std::size_t j = 1; j < layers; ++j) {
          const double w = interface_slip(j, cell.slip);
          const conductor::SpringChain& chain = chains_[static_cast<std::size_t>(i)][j];
          for (std::size_t s = 0; s < chain.limit.size(); ++s) {
            const double K0 = chain.stiffness[s] * K_before[j];
            const double K1 = chain.stiffness[s] * K_now[j];
            const double f0 = cell.before[j][s];
            const double f1 = cell.now[j][s];
            const double held = K1 > 0 ? f1 * f1 / (2 * K1) : 0;
            const double gained = held - (K0 > 0 ? f0 * f0 / (2 * K0) : 0);
            stored += wires_per_length(j) * weight * held;
            result.lost += wires_per_length(j) * weight * ((f0 + f1) / 2 * w - gained);
          }
          const double q = gradient(j, cell.now);
          const double sine = std::abs(std::sin(strand_.layers[j].lay_angle));
          const double R = strand_.layers[j].helix_radius;
          const double C = strand_.layers[j].wires * R * R * std::cos(strand_.layers[j].lay_angle) / sine;
          M += C * weight * cosine(i) * q;
          stored += C * weight * q * q / (2 * k(j));
          F_edge[j] += side * q * R * dtheta / sine;
        }
        springs = cell.now;
      }
    }
    chi_ = to.chi;
    peak_ = peak;
    result.M = constants_.EI_min * to.chi + M;
    result.stored = stored + constants_.EA * to.eps * to.eps / 2 + constants_.EI_min * to.chi * to.chi / 2;
    return result;
  }

 private:
  struct Cell {
    std::size_t angle;
    std::vector<std::vector<double>> before, now;  ///< [layer][spring] of the interface inside the layer
    std::vector<double> K, slip, stick, F_edge;    ///< [layer]
    double dS = 0;                                 ///< signed dtheta
  };

  double cosine(int i) const { return std::cos((i + 0.5) * std::numbers::pi / 2 / cells_); }
  double sine(std::size_t j) const { return std::abs(std::sin(strand_.layers[j].lay_angle)); }
  double k(std::size_t j) const {
    return strand_.layers[j].EA_wire() * std::pow(std::cos(strand_.layers[j].lay_angle), 2) * sine(j);
  }
  double k_w(std::size_t j) const {
    return strand_.layers[j].EA_wire() * std::pow(sine(j) / strand_.layers[j].helix_radius, 2);
  }
  double axial_force(std::size_t j, double eps) const {
    return strand_.layers[j].EA_wire() * std::pow(std::cos(strand_.layers[j].lay_angle), 2) * eps;
  }
  double kappa(std::size_t j) const { return sine(j) * sine(j) / strand_.layers[j].helix_radius; }
  double wires_per_length(std::size_t j) const {
    return strand_.layers[j].wires / std::cos(strand_.layers[j].lay_angle);
  }
  double hand(std::size_t j) const { return strand_.layers[j].lay_angle < 0 ? -1 : 1; }

  /// What a force per length of the inner contact helix of layer j+1's wires is on each wire of layer j, per length.
  double share(std::size_t j) const {
    const double c_ext = 1 + kappa(j) * strand_.layers[j].diameter / 2;
    const double c_int = 1 - kappa(j + 1) * strand_.layers[j + 1].diameter / 2;
    return c_ext / c_int * strand_.layers[j + 1].wires / strand_.layers[j].wires;
  }

  /// Gradient of a wire of layer j, along its own demand: what its interfaces do to it.
  double gradient(std::size_t j, const std::vector<std::vector<double>>& springs) const {
    const auto sum = [&](std::size_t l) {
      double all = 0;
      for (double f : springs[l]) all += f;
      return all;
    };
    if (j + 1 == strand_.layers.size()) return sum(j);
    return sum(j) - hand(j) * hand(j + 1) * share(j) * sum(j + 1);
  }

  /// The slip that the traction of interface j does its work on, per length of wire of layer j.
  double interface_slip(std::size_t j, const std::vector<double>& u) const {
    if (j == 1) return u[1];
    const double back = share(j - 1) * wires_per_length(j - 1) / wires_per_length(j);
    return u[j] - hand(j) * hand(j - 1) * back * u[j - 1];
  }

  /// Moves all springs to the slips; answers k_w u + q - k e of layer `of`.
  double unbalance(Cell& cell, std::size_t of) const {
    double outer = 0;
    for (std::size_t j = strand_.layers.size() - 1; j >= 1; --j) {
      const conductor::Layer& wire = strand_.layers[j];
      const double q = cell.stick[j] - k_w(j) * cell.slip[j];
      const double F = cell.F_edge[j] + q * wire.helix_radius * cell.dS / sine(j) / 2;
      const double c_int = 1 - kappa(j) * wire.diameter / 2;
      const double load = std::max(0.0, kappa(j) * F + outer + c_int * wire.residual_force);
      if (j > 1) outer = share(j - 1) * load;
      if (j > of + 1 || j < of) continue;
      const double w = interface_slip(j, cell.slip);
      const conductor::SpringChain& chain = chains_[cell.angle][j];
      for (std::size_t s = 0; s < chain.limit.size(); ++s) {
        const double most = chain.limit[s] * wire.friction_inner * load;
        cell.now[j][s] = std::clamp(cell.before[j][s] + cell.K[j] * chain.stiffness[s] * w, -most, most);
      }
    }
    return gradient(of, cell.now) + k_w(of) * cell.slip[of] - cell.stick[of];
  }

  void solve(Cell& cell) const {
    for (int sweep = 0; sweep < 4000; ++sweep) {
      double moved = 0;
      for (std::size_t j = strand_.layers.size() - 1; j >= 1; --j) {
        const double start = cell.slip[j];
        double low = start;
        double high = start;
        for (double reach = 1e-15; unbalance(cell, j) > 0; reach *= 4) cell.slip[j] = low = start - reach;
        cell.slip[j] = start;
        for (double reach = 1e-15; unbalance(cell, j) < 0; reach *= 4) cell.slip[j] = high = start + reach;
        while (high - low > 1e-20) {
          const double middle = (low + high) / 2;
          if (middle <= low || middle >= high) break;
          cell.slip[j] = middle;
          (unbalance(cell, j) < 0 ? low : high) = middle;
        }
        cell.slip[j] = (low + high) / 2;
        moved = std::max(moved, std::abs(cell.slip[j] - start));
      }
      if (moved < 1e-19) break;
    }
    for (std::size_t j = 1; j < strand_.layers.size(); ++j) unbalance(cell, j);
  }

  /// Of each interface, per length of a wire of the layer outside it, when the strand is straight under `strain`.
  std::vector<double> stiffness(double strain) const {
    const auto forces = conductor::contact_forces(strand_, conductor::axial_wire_forces(strand_, strain, 0));
    const auto geometry = conductor::contact_geometry(strand_);
    std::vector<double> all(strand_.layers.size());
    for (std::size_t j = 1; j < all.size(); ++j) {
      const double load = geometry[j].c_int * forces[j].f_int;
      all[j] = faces_[j].stiffness(load, faces_[j].per_outer_wire).value / options_.compliance_scale;
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
  std::vector<std::vector<std::vector<double>>> T_;  ///< [angle and side][layer][spring]
};

}  // namespace strandyn::test
