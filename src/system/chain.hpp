#pragma once
/// \file The mechanics of one kind of chain: from nodal unknowns to strains of all section points, and from their
/// resultants back to nodal forces. One object per `System`, asked once for the whole chain: nothing in a loop over
/// elements is virtual.

#include <memory>
#include <vector>

#include "strandyn/section/batch.hpp"
#include "strandyn/system/system.hpp"

namespace strandyn::system {

/// The loads of a model: what weighs alike at any time is put together, once.
struct Loads {
  std::size_t count = 0;              ///< of the model's loads when they were looked at
  Vector dead;                        ///< [N] per unknown
  std::vector<std::size_t> changing;  ///< places of the others in the model
};
Loads loads_of(const model::Model& model);

class Chain {
 public:
  virtual ~Chain() = default;

  Loads loads;  ///< on its nodes, set by whoever makes the chain

  virtual section::Dimension dimension() const = 0;
  /// Strains of all section points; keeps the kinematics for the two functions that follow.
  virtual void find_strains(const double* u, section::Field& strains) = 0;
  virtual void add_internal_force(const section::Field& stresses, double* f) const = 0;
  virtual void add_stiffness(const section::Field& stresses, const section::TangentField& tangents,
                             Matrix& K) const = 0;

  virtual void add_inertia_force(const State& m, double* f) const = 0;
  virtual void add_inertia_tangent(const State& m, InertiaFactors factors, Matrix& K) const = 0;
  virtual void add_mass(const double* u, Matrix& M) const = 0;
  virtual double kinetic_energy(const double* u, const double* v) const = 0;
  /// Does the unknown of place `i` carry inertia?
  virtual bool has_mass(std::size_t i) const = 0;

  /// Adds the generalized force of a moment whose direction stays in space. [N m]
  virtual void add_moment(std::size_t node, const Eigen::Vector3d& moment, const double* u, double* f) const = 0;
  virtual void subtract_moment_tangent(std::size_t, const Eigen::Vector3d&, const double*, Matrix&) const {}
  virtual bool shorten_rotations(const std::vector<bool>&, double*, double*) const { return false; }
};

std::unique_ptr<Chain> make_planar_chain(const model::Model& model);
std::unique_ptr<Chain> make_spatial_chain(const model::Model& model);
std::unique_ptr<Chain> make_transverse_chain(const model::Model& model);

}  // namespace strandyn::system
