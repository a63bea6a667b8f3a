// Large rotations, in the plane and in space.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene.hpp"
#include "strandyn/exact/elastica.hpp"
#include "themes.hpp"

namespace strandyn::extremes {
namespace {

using std::numbers::pi;

/// An end moment of 2 pi n EI/L: n turns, the tip back at the clamp.
Found rolled_up(int turns) {
  const auto text = [](int n, int elements, int steps) {
    return fmt::format(
        "[section]\nlaw = \"elastic\"\nEA_N = 1e6\nEI_N_m2 = 100\n[span]\nlength_m = 10\ntension_kN = 0\nelements = "
        "{}\ngrading = \"uniform\"\n"
        "left = \"clamped\"\nright = \"free\"\n[[load]]\ntype = \"static-force\"\nat_m = 10\nmoment_N_m = "
        "{:.17g}\n[analysis]\n"
        "type = \"static\"\nsteps = {}\n",
        elements, 20 * pi * n, steps);
  };
  const Run run(text(turns, 20 * turns, 10 * turns)), ordinary(text(1, 20, 10));
  return Found{}
      .close("rotation (rad)", run.at("steps[-1].rotation_rad"), 2 * pi * turns, 1e-9)
      .most("tip from the clamp (m)", std::hypot(run.at("right_end_m[0]"), run.at("right_end_m[1]")), 1e-5)
      .costs(evaluations_per_step(run, ordinary));
}

Found elastica(double load) {
  const auto text = [](double P) {
    return fmt::format(
        "[section]\nlaw = \"elastic\"\nEA_N = 1e9\nEI_N_m2 = 1\n[span]\nlength_m = 1\ntension_kN = 0\nelements = "
        "200\nleft = \"clamped\"\n"
        "right = \"free\"\n[[load]]\ntype = \"static-force\"\nat_m = 1\nforce_N = {}\n[analysis]\ntype = "
        "\"static\"\nsteps = 20\n",
        P);
  };
  const Run run(text(load)), ordinary(text(1));
  const auto exact = exact::cantilever_elastica({.force = load, .EI = 1, .length = 1});
  return Found{}
      .close("deflection of the tip (m)", run.at("steps[-1].displacement_m"), exact.deflection, 1e-3)
      .most("the other coordinate of the tip off by (m)", std::abs(run.at("right_end_m[0]") - 1 - exact.shortening),
            1e-3)
      .costs(evaluations(run, ordinary));
}

std::string written(const Eigen::Vector3d& v) {
  return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v.x(), v.y(), v.z());
}

/// An arc of 45 degrees bent out of its plane by a force on its tip, the whole scene turned in space.
Run bend(const Eigen::Matrix3d& turn, int pieces) {
  std::string nodes;
  for (int i = 0; i <= pieces; ++i) {
    const double a = pi / 4 * i / pieces;
    nodes += (i ? ", " : "") + written(turn * Eigen::Vector3d(100 * std::sin(a), 100 * (1 - std::cos(a)), 0));
  }
  const double length = 200 * pieces * std::sin(pi / 8 / pieces) * (1 - 1e-12);
  return Run(
      fmt::format("[section]\nlaw = \"elastic\"\nEA_N = 1e7\nEI_N_m2 = 8.333e5\nGJ_N_m2 = 8.333e5\n[span]\nnodes_m = "
                  "[{}]\nelements = {}\n"
                  "left = \"clamped\"\nright = \"free\"\ndimension = \"spatial\"\n[[load]]\ntype = "
                  "\"static-force\"\nat_m = {:.17g}\nforce_N = 600\n"
                  "direction = {}\n[analysis]\ntype = \"static\"\nsteps = 6\n",
                  nodes, pieces, length, written(turn * Eigen::Vector3d::UnitZ())));
}
Eigen::Vector3d tip_of(const Run& run) {
  return {run.at("right_end_m[0]"), run.at("right_end_m[1]"), run.at("right_end_m[2]")};
}
/// [-] how far the tip of the turned scene, turned back, lies from that of the plain one, over its distance.
double turned_off(const Eigen::Matrix3d& turn, int pieces) {
  return (turn.transpose() * tip_of(bend(turn, pieces)) - tip_of(bend(Eigen::Matrix3d::Identity(), pieces))).norm() /
         73;
}

/// Turned about the normal of its plane: nothing but the axes has changed.
Found turned_axes() {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Run plain = bend(Eigen::Matrix3d::Identity(), 16), turned = bend(turn, 16);
  const Eigen::Vector3d exact(47.15215, 15.68536, 53.47176);  // Kirchhoff rod
  return Found{}
      .most("tip turned back off by, over its distance", turned_off(turn, 16), 1e-12)
      .most("tip off the exact rod's by, over its distance", (tip_of(plain) - exact).norm() / 73, 1e-3)
      .costs(evaluations(turned, plain));
}

/// Any other turn gives the sections other axes 2 and 3; an element that bends and twists feels that to fourth order.
Found turned_sections() {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, -2, 0.7).normalized()).toRotationMatrix();
  return Found{}
      .most("tip turned back off by, over its distance, 32 elements", turned_off(turn, 32), 1e-7)
      .within("ratio when the elements halve, 16 to 32", turned_off(turn, 16) / turned_off(turn, 32), 14, 18)
      .costs(evaluations(bend(turn, 32), bend(Eigen::Matrix3d::Identity(), 32)));
}

/// A free beam in space, thrown and twisted by a force and moments at one end: momentum is the impulse.
Found flies(const std::string& method, double tolerance) {
  const auto text = [&](double size) {
    return fmt::format(
        "[section]\nlaw = \"elastic\"\nEA_N = 1e4\nEI_N_m2 = 500\nGJ_N_m2 = 500\nmass_kg_per_m = 1\nrotary_kg_m = "
        "10\npolar_kg_m = 10\n[span]\n"
        "nodes_m = [[0, 8, 0], [6, 0, 0]]\nelements = 12\nleft = \"free\"\nright = \"free\"\ndimension = "
        "\"spatial\"\nmass = \"lumped\"\n"
        "rotary_inertia = true\n[[load]]\ntype = \"table\"\nat_m = 10\nhistory = [[0, 0], [2.5, {0}], [5, "
        "0]]\ndirection = [1, 0, 0]\n"
        "[[load]]\ntype = \"table\"\nat_m = 10\nmoment = true\nhistory = [[0, 0], [2.5, {1}], [5, 0]]\ndirection = [0, "
        "0, 1]\n"
        "[[load]]\ntype = \"table\"\nat_m = 10\nmoment = true\nhistory = [[0, 0], [2.5, {2}], [5, 0]]\ndirection = [0, "
        "1, 0]\n"
        "[integrator]\n{3}step_s = 0.005\nmax_numerical_share = 1e9\n[analysis]\ntype = \"transient\"\nduration_s = "
        "7\n",
        20 * size, -200 * size, -100 * size, method);
  };
  const Run run(text(1)), ordinary(text(1e-3));
  return Found{}
      .close("momentum (kg m/s)", run.at("momentum.linear_kg_m_per_s[0]"), 50, 1e-5)
      .most("momentum across the force, over it",
            std::hypot(run.at("momentum.linear_kg_m_per_s[1]"), run.at("momentum.linear_kg_m_per_s[2]")) / 50, 1e-7)
      .most("energy above what came in", run.energy_above_input(), tolerance)
      .costs(evaluations_per_step(run, ordinary));
}

/// A stiff free bar that is set spinning: its energy is that of its spin, p^2/2 m + H^2/2 I, turn after turn.
Found spins() {
  const auto text = [](double moment) {
    return fmt::format(
        "[section]\nlaw = \"elastic\"\nEA_N = 1e8\nEI_N_m2 = 1e6\nmass_kg_per_m = 1\nrotary_kg_m = "
        "0.001\n[span]\nlength_m = 2\ntension_kN = 0\nelements = 4\n"
        "left = \"free\"\nright = \"free\"\nmass = \"consistent\"\nrotary_inertia = true\n[[load]]\ntype = "
        "\"table\"\nat_m = 1\nmoment = true\n"
        "history = [[0, 0], [0.5, {0}], [1, 0], [20, 0]]\n[integrator]\n{1}step_s = 1e-3\n[analysis]\ntype = "
        "\"transient\"\nduration_s = 20\n",
        moment, conserving);
  };
  const Run run(text(20)), ordinary(text(0.02));
  const double H = 10, I = 8.0 / 12 + 2 * 0.001;
  return Found{}
      .close("energy after some fifty turns (J)", run.at("energy.kinetic_J") + run.at("energy.elastic_J"),
             H * H / (2 * I), 1e-3)
      .most("energy above what came in", run.energy_above_input(), 1e-4)
      .costs(evaluations_per_step(run, ordinary));
}

}  // namespace

std::vector<Extreme> rotation_rows() {
  const std::string input = "no step has more energy than came in";
  return {
      {"rotations/rolled-up-1", "a cantilever rolled up once", "M L/EI, the tip at the clamp",
       [] { return rolled_up(1); }},
      {"rotations/rolled-up-10", "a cantilever rolled up ten times", "M L/EI, the tip at the clamp",
       [] { return rolled_up(10); }},
      {"rotations/elastica-10", "P L^2/EI = 10", "the elastica, elliptic integrals", [] { return elastica(10); }},
      {"rotations/elastica-1000", "P L^2/EI = 1000", "the elastica, elliptic integrals", [] { return elastica(1000); }},
      {"rotations/turned-axes", "a bend in space, its scene turned by 143 degrees about the normal of its plane",
       "a turn of the scene turns the answer; the exact rod", turned_axes},
      {"rotations/turned-sections", "the same about an axis aslant",
       "a turn of the scene turns the answer, to fourth order of the elements", turned_sections},
      {"rotations/flight-conserving", "a free beam that flies and tumbles in space, trapezoidal rule",
       "momentum is the impulse; " + input, [] { return flies(conserving, 1e-2); }, Pace::slow},
      {"rotations/flight-ida", "a free beam that flies and tumbles in space, IDA", "momentum is the impulse; " + input,
       [] { return flies("method = \"ida\"\n", 1e-4); }, Pace::slow},
      {"rotations/spin", "a stiff bar that spins fifty times", "the energy of its spin stays; " + input, spins,
       Pace::slow},
  };
}

}  // namespace strandyn::extremes
