#pragma once
/// \file What a scene is: a chain of nodes and elements, its supports, masses, loads and section law. Constant in a
/// run.

#include <Eigen/Dense>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "strandyn/air/still_air.hpp"
#include "strandyn/beam/planar_element.hpp"
#include "strandyn/beam/spatial_element.hpp"
#include "strandyn/beam/spatial_inertia.hpp"
#include "strandyn/core/words.hpp"
#include "strandyn/math/time_function.hpp"
#include "strandyn/model/freedom.hpp"
#include "strandyn/model/wind.hpp"
#include "strandyn/section/law.hpp"
#include "strandyn/section/material_damping.hpp"

namespace strandyn::model {

using math::Constant;
using math::Drive;
using math::Driven;
using math::Harmonic;
using math::Tabulated;
using math::TimeFunction;

using strandyn::MassMatrix;

/// Holds unknowns of a node at their reference value. Entries that the chain does not have count for nothing.
struct Support {
  std::size_t node = 0;
  std::array<bool, unknown_kinds> fixed{};  ///< in the order of Unknown
};

/// Moves one unknown of a node as given, which holds it: amplitude times a function of time, eased in.
struct PrescribedMotion {
  std::size_t node = 0;
  Unknown unknown = Unknown::y;
  double amplitude = 0;  ///< [m] or [rad]
  TimeFunction history = Constant{};
  math::Ease ease = {};

  /// [m] or [rad], and its derivative by time, under the drives of a run.
  double at(double time, std::span<const Drive> drives) const {
    return amplitude * ease.at(time) * math::evaluate(history, time, drives);
  }
  double rate(double time, std::span<const Drive> drives) const {
    return amplitude * (ease.at(time) * math::rate(history, time, drives) +
                        ease.rate(time) * math::evaluate(history, time, drives));
  }
};

/// Force [N] and moment [N m] on a node, times a function of time. Both keep their direction in space.
struct Load {
  std::size_t node = 0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  TimeFunction history = Constant{};
  bool dead = false;  ///< acts in full from the beginning of a static analysis: weight
};

/// Something fixed to a node: a mass, or a spring and a damper to ground along a direction.
struct Body {
  std::size_t node = 0;
  double mass = 0;     ///< [kg]
  double inertia = 0;  ///< [kg m^2] about every axis through its centre of mass
  /// [m] from the node to the centre of mass in the reference configuration; it turns with the node. Chains in a
  /// plane only.
  Eigen::Vector2d eccentricity = Eigen::Vector2d::Zero();
  double stiffness = 0;  ///< [N/m] of the spring, without force where the displacement is zero
  double damping = 0;    ///< [N s/m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitY();
};

/// The air around the chain.
struct Surroundings {
  air::StillAir air;
  double diameter = 0;  ///< [m] of the conductor
};

/// Element i joins the nodes i and i + 1.
struct Model {
  Freedom freedom = Freedom::planar;
  std::vector<Eigen::Vector3d> nodes;          ///< [m] reference positions: the displacements count from here
  std::vector<beam::SpatialElement> elements;  ///< planar chains use what lies in the plane
  std::vector<Support> supports;
  std::vector<PrescribedMotion> motions;
  std::vector<Load> loads;
  std::vector<Body> bodies;
  std::shared_ptr<const section::Law> law;
  beam::SpatialSectionInertia inertia = {};
  MassMatrix mass_matrix = MassMatrix::lumped;
  double drag = 0;  ///< [N s/m^2] force per length against the velocity of the centre line
  std::optional<Surroundings> surroundings = {};
  std::optional<Wind> wind = {};
  section::MaterialBranches material = {};  ///< of all sections, beside the law

  std::size_t unknowns_per_node() const { return unknowns_of(freedom).size(); }
  std::size_t unknowns() const { return nodes.size() * unknowns_per_node(); }
  /// Index of an unknown in the vectors, where the chain has it.
  std::optional<std::size_t> index(std::size_t node, Unknown unknown) const;
  Unknown kind(std::size_t index) const { return unknowns_of(freedom)[index % unknowns_per_node()]; }
  std::string unknown_name(std::size_t index) const;  ///< "node 41 rotation z": how messages name an unknown
  double unstressed_length() const;                   ///< [m]
  /// [m] displacement of a node; components that the chain does not have are zero.
  Eigen::Vector3d displacement(const double* u, std::size_t node) const;
  /// [rad] rotation vector of a node, likewise.
  Eigen::Vector3d rotation(const double* u, std::size_t node) const;
};

/// A straight chain between two points, every element stretched by `strain` from its unstressed length.
struct StraightSpan {
  std::vector<double> positions;     ///< [m] of the nodes along the chain, from 0
  double strain = 0;                 ///< [-] so that the tension is EA strain; below 0 for a cable longer than its span
  std::vector<double> strains = {};  ///< [-] of each element, where they differ
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< unit vector
};
void lay_out(Model& model, const StraightSpan& span);

/// An unstressed chain along a polyline: a frame, or a bend of straight pieces. Corners are stiff.
struct Polyline {
  std::vector<Eigen::Vector3d> corners;  ///< [m]
  std::vector<double> positions;         ///< [m] of the nodes along it, from 0; every corner is one of them
};
void lay_out(Model& model, const Polyline& line);

/// [m] along the reference configuration from the first node.
std::vector<double> arc_lengths(const Model& model);

/// [m] of unstressed chain that each node stands for: half of the elements beside it.
std::vector<double> node_lengths(const Model& model);

/// The node nearest to `position` [m] along the reference configuration.
std::size_t nearest_node(const Model& model, double position);

}  // namespace strandyn::model
