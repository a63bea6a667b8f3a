#pragma once
/// \file What a scene is: a chain of nodes and elements, its supports, masses, loads and section law. Constant in a
/// run.

#include <Eigen/Dense>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "strandyn/beam/planar_element.hpp"
#include "strandyn/beam/planar_inertia.hpp"
#include "strandyn/model/time_function.hpp"
#include "strandyn/section/law.hpp"

namespace strandyn::model {

/// Unknowns of a node of a planar chain, in this order.
enum class Unknown : std::size_t { x, y, rotation };
inline constexpr std::size_t unknowns_per_node = 3;

enum class MassMatrix { lumped, consistent };

/// Holds unknowns of a node at their reference value.
struct Support {
  std::size_t node = 0;
  std::array<bool, unknowns_per_node> fixed{};
};

/// Force (x, y) [N] and moment [N m] on a node, times a function of time.
struct Load {
  std::size_t node = 0;
  Eigen::Vector3d amplitude = Eigen::Vector3d::Zero();
  TimeFunction history = Constant{};
};

/// Element i joins the nodes i and i + 1.
struct Model {
  std::vector<Eigen::Vector2d> nodes;  ///< [m] reference positions: the displacements count from here
  std::vector<beam::PlanarElement> elements;
  std::vector<Support> supports;
  std::vector<Load> loads;
  std::shared_ptr<const section::Law> law;
  beam::Inertia inertia;
  MassMatrix mass_matrix = MassMatrix::lumped;
  double drag = 0;  ///< [N s/m^2] force per length against the velocity of the centre line

  std::size_t unknowns() const { return nodes.size() * unknowns_per_node; }
  double unstressed_length() const;  ///< [m]
};

/// "node 41 rotation": how messages name an unknown.
std::string unknown_name(std::size_t index);

/// A straight chain along x whose ends are `length` apart, every element stretched by `strain` from its unstressed
/// length.
struct StraightSpan {
  std::vector<double> positions;  ///< [m] of the nodes, from 0
  double strain = 0;              ///< [-] so that the tension is EA strain
};
void lay_out(Model& model, const StraightSpan& span);

/// The node nearest to `position` [m] along x.
std::size_t nearest_node(const Model& model, double position);

}  // namespace strandyn::model
