#pragma once
/// \file The compliant law a second time: one point, one loop inside the other. A cell is solved wire by wire, each by
/// halving while the others wait, round and round until nobody moves. In space the march is repeated until the force of
/// every layer closes around the turn.
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
    double chi3 = 0;  ///< this and the twist: in space
    double twist = 0;
  };
  struct Step {
    double M = 0;
    double M3 = 0;
    double stored = 0;  ///< axial and bending
    double lost = 0;    ///< what the springs lose less the error of the trapezoid
  };

  /// Cells of a side: those of a quarter turn in the plane, of half a turn in space.
  enum Turn { planar = 4, spatial = 2 };

  PlainCompliant(const conductor::Strand& strand, const section::CompliantOptions& options, double strain,
                 Turn turn = planar)
      : strand_(strand),
        options_(options),
        turn_(turn),
        cells_(options.points / turn),
        faces_(conductor::interfaces(strand)),
        constants_(conductor::section_constants(strand)),
        peak_(strain) {
    // The layers' own chains: cubes of the cosines tell how much of the grading each angle covers.
    const double ratio = std::pow(options.smallest_slip, -1.0 / (options.springs - 2));
    const auto usual = conductor::contact_forces(strand, conductor::axial_wire_forces(strand, 1e-3, 0));
    const int quarter = options.points / 4;
    double total = 0;
    for (int i = 0; i < quarter; ++i) total += std::pow(cosine(i), 3);
    double before = 0;
    std::vector<double> phases;
    for (int i = 0; i < quarter; ++i) {
      const double own = std::pow(cosine(i), 3) / total;
      const double phase = before + own / 2 - std::log(cosine(i)) / std::log(ratio);
      phases.push_back(phase - std::floor(phase));
      before += own;
    }
    for (int i = 0; i < cells_; ++i) {
      const double phase = phases[static_cast<std::size_t>(i < quarter ? i : 2 * quarter - 1 - i)];
      chains_.emplace_back(strand.layers.size());
      chains_of_other_side_.emplace_back(strand.layers.size());
      for (std::size_t j = 1; j < strand.layers.size(); ++j) {
        const auto curve = faces_[j].line ? conductor::SlipCurve::line(faces_[j].along.slip_logarithm(usual[j].f_int))
                                          : conductor::SlipCurve::spot();
        conductor::ChainPlan plan{.springs = options.springs, .smallest_slip = options.smallest_slip, .phase = phase};
        chains_.back()[j] = conductor::spring_chain(curve, plan);
        plan.phase = phase < 0.5 ? phase + 0.5 : phase - 0.5;
        chains_of_other_side_.back()[j] = conductor::spring_chain(curve, plan);
      }
    }
    start_.assign(strand.layers.size(), 0.0);
    mean_.assign(strand.layers.size(), 0.0);
    T_.assign(2 * static_cast<std::size_t>(cells_),
              std::vector<std::vector<double>>(strand.layers.size(),
                                               std::vector<double>(static_cast<std::size_t>(options.springs), 0.0)));
  }

  Step step(const Strain& to) {
    const std::size_t layers = strand_.layers.size();
    const double peak = std::max(peak_, to.eps);
    const std::vector<double> K_now = stiffness(peak);
    if (std::hypot(to.chi, to.chi3) >= 1e-12) phi_ = std::atan2(to.chi3, to.chi);
    std::vector<Cell> cells = march(to, K_now);
    // The force of a wire is the same after a turn, and has zero mean over the two neutral points.
    for (int round = 0; turn_ == spatial && round < 400; ++round) {
      double off = 0;
      for (std::size_t j = 1; j < layers; ++j) {
        const double step = strand_.layers[j].helix_radius * 2 * std::numbers::pi / options_.points / sine(j);
        double mean = 0;
        for (const Cell& cell : cells) mean += gradient(j, cell.now) / options_.points;
        const double neutral = force_at(j, cells, phi_) + force_at(j, cells, phi_ + std::numbers::pi);
        off = std::max({off, std::abs(mean - mean_[j]) * step * options_.points, std::abs(neutral)});
        mean_[j] = mean;
        start_[j] -= neutral / 2;
      }
      if (off < 1e-12) break;
      cells = march(to, K_now);
    }
    const Step result = book(to, cells, K_now);
    for (std::size_t i = 0; i < cells.size(); ++i) T_[i] = cells[i].now;
    chi_ = to.chi;
    chi3_ = to.chi3;
    peak_ = peak;
    return result;
  }

 private:
  struct Cell {
    std::size_t angle;
    std::vector<std::vector<double>> before, now;  ///< [layer][spring] of the interface inside the layer
    std::vector<double> K, slip, stick, F_edge;    ///< [layer]
    double dS = 0;                                 ///< signed dtheta
  };

  /// Side by side: the cell at theta, then the one at -theta.
  std::vector<Cell> march(const Strain& to, const std::vector<double>& K_now) const {
    const std::size_t layers = strand_.layers.size();
    const double dtheta = 2 * std::numbers::pi / options_.points;
    std::vector<Cell> cells(T_.size());
    for (int side : {+1, -1}) {
      std::vector<double> F_edge = start_;
      for (std::size_t j = 1; j < layers; ++j) F_edge[j] += axial_force(j, to);
      for (int i = 0; i < cells_; ++i) {
        const std::size_t at = index(i, side);
        Cell& cell = cells[at];
        cell = {.angle = static_cast<std::size_t>(i),
                .before = T_[at],
                .now = T_[at],
                .K = K_now,
                .slip = std::vector<double>(layers, 0.0),
                .stick = std::vector<double>(layers, 0.0),
                .F_edge = F_edge,
                .dS = dtheta * side};
        const double e = cosine(i) * (to.chi - chi_) + side * std::sin(angle(i)) * (to.chi3 - chi3_);
        for (std::size_t j = 1; j < layers; ++j) cell.stick[j] = gradient(j, cell.before) + k(j) * e;
        solve(cell);
        for (std::size_t j = 1; j < layers; ++j) {
          F_edge[j] += (gradient(j, cell.now) - mean_[j]) * strand_.layers[j].helix_radius * cell.dS / sine(j);
        }
      }
    }
    return cells;
  }

  /// F_b of a layer at a polar angle, straight between the edges of the cells. Both sides start at theta = 0.
  double force_at(std::size_t j, const std::vector<Cell>& cells, double theta) const {
    const double dtheta = 2 * std::numbers::pi / options_.points;
    theta = std::remainder(theta, 2 * std::numbers::pi);
    const int side = theta < 0 ? -1 : 1;
    double left = std::abs(theta) / dtheta;
    double force = start_[j];
    for (int i = 0; i < cells_ && left > 0; ++i, left -= 1) {
      const Cell& cell = cells[index(i, side)];
      const double full = (gradient(j, cell.now) - mean_[j]) * strand_.layers[j].helix_radius * cell.dS / sine(j);
      force += std::min(left, 1.0) * full;
    }
    return force;
  }

  Step book(const Strain& to, const std::vector<Cell>& cells, const std::vector<double>& K_now) const {
    Step result{.M = constants_.EI_min * to.chi, .M3 = constants_.EI_min * to.chi3};
    const std::vector<double> K_before = stiffness(peak_);
    result.stored = constants_.EA * to.eps * to.eps / 2 + constants_.C_AT * to.eps * to.twist +
                    constants_.GJ * to.twist * to.twist / 2 +
                    constants_.EI_min * (to.chi * to.chi + to.chi3 * to.chi3) / 2;
    const double weight = 1.0 / static_cast<double>(cells.size());
    for (const Cell& cell : cells) {
      const int i = static_cast<int>(cell.angle);
      for (std::size_t j = 1; j < strand_.layers.size(); ++j) {
        const double w = interface_slip(j, cell.slip);
        const conductor::SpringChain& chain = chain_of(cell, j);
        for (std::size_t s = 0; s < chain.limit.size(); ++s) {
          const double K0 = chain.stiffness[s] * K_before[j];
          const double K1 = chain.stiffness[s] * K_now[j];
          const double f0 = cell.before[j][s];
          const double f1 = cell.now[j][s];
          const double held = K1 > 0 ? f1 * f1 / (2 * K1) : 0;
          const double gained = held - (K0 > 0 ? f0 * f0 / (2 * K0) : 0);
          result.stored += wires_per_length(j) * weight * held;
          result.lost += wires_per_length(j) * weight * ((f0 + f1) / 2 * w - gained);
        }
        const double q = gradient(j, cell.now);
        const double R = strand_.layers[j].helix_radius;
        const double C = strand_.layers[j].wires * R * R * std::cos(strand_.layers[j].lay_angle) / sine(j);
        result.M += C * weight * cosine(i) * q;
        result.M3 += C * weight * std::sin(angle(i)) * (cell.dS > 0 ? q : -q);
        result.stored += C * weight * q * q / (2 * k(j));
      }
    }
    return result;
  }

  static std::size_t index(int i, int side) { return static_cast<std::size_t>(2 * i + (side == 1 ? 0 : 1)); }
  double angle(int i) const { return (i + 0.5) * 2 * std::numbers::pi / options_.points; }
  double cosine(int i) const { return std::cos(angle(i)); }
  double sine(std::size_t j) const { return std::abs(std::sin(strand_.layers[j].lay_angle)); }
  double k(std::size_t j) const {
    return strand_.layers[j].EA_wire() * std::pow(std::cos(strand_.layers[j].lay_angle), 2) * sine(j);
  }
  double k_w(std::size_t j) const {
    return strand_.layers[j].EA_wire() * std::pow(sine(j) / strand_.layers[j].helix_radius, 2);
  }
  double axial_force(std::size_t j, const Strain& to) const {
    const conductor::Layer& wire = strand_.layers[j];
    const double straight = std::pow(std::cos(wire.lay_angle), 2) * to.eps;
    return wire.EA_wire() *
           (straight + wire.helix_radius * std::sin(wire.lay_angle) * std::cos(wire.lay_angle) * to.twist);
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

  const conductor::SpringChain& chain_of(const Cell& cell, std::size_t j) const {
    return (cell.dS > 0 ? chains_ : chains_of_other_side_)[cell.angle][j];
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
      const double F = cell.F_edge[j] + (q - mean_[j]) * wire.helix_radius * cell.dS / sine(j) / 2;
      const double c_int = 1 - kappa(j) * wire.diameter / 2;
      const double load = std::max(0.0, kappa(j) * F + outer + c_int * wire.residual_force);
      if (j > 1) outer = share(j - 1) * load;
      if (j > of + 1 || j < of) continue;
      const double w = interface_slip(j, cell.slip);
      const conductor::SpringChain& chain = chain_of(cell, j);
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
  Turn turn_;
  int cells_;
  std::vector<conductor::Interface> faces_;
  conductor::SectionConstants constants_;
  std::vector<std::vector<conductor::SpringChain>>
      chains_,  ///< [angle][layer]: contact of the layer with the one inside
      chains_of_other_side_;
  std::vector<double> start_, mean_;  ///< [layer] F_b at theta = 0, mean q
  double phi_ = 0;                    ///< where the neutral plane lies
  double chi_ = 0;
  double chi3_ = 0;
  double peak_ = 0;
  std::vector<std::vector<std::vector<double>>> T_;  ///< [angle and side][layer][spring]
};

}  // namespace strandyn::test
