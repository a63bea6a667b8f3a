#pragma once
/// \file All elements of a chain in space side by side: the formulas of spatial_element.hpp, spatial_inertia.hpp and
/// rigid_inertia.hpp with elements and nodes in lanes, from nodal vectors to nodal vectors and blocks. Element e lies
/// between the nodes e and e + 1. One source for every instruction set; each answers to rounding as the functions of
/// one element do. Rotations and spins of a node are found once for a state, whoever asks.

#include <array>
#include <span>
#include <vector>

#include "strandyn/beam/rigid_inertia.hpp"
#include "strandyn/beam/spatial_element.hpp"
#include "strandyn/beam/spatial_inertia.hpp"
#include "strandyn/core/aligned.hpp"

namespace strandyn::beam {

class SpatialLanes {
 public:
  /// Unknowns of a node in the vectors: six, or five without the rotation about x, which stays zero; then nothing
  /// twists.
  enum class Unknowns : std::size_t { all = 6, untwisted = 5 };

  struct Chain {
    std::span<const SpatialElement> elements;
    SpatialSectionInertia inertia;           ///< of the consistent inertia
    std::span<const RigidInertia> at_nodes;  ///< what turns with the nodes; their mass is left to others
    Unknowns unknowns = Unknowns::all;
  };
  explicit SpatialLanes(const Chain& chain);

  /// Of section points, two per element, entries up to a multiple of eight: N [N] and moments [N m], or derivatives of
  /// one of them by the four strains.
  struct Points {
    const double *axial, *torsion, *bending2, *bending3;
  };
  struct Strains {
    double *eps, *chi1, *chi2, *chi3;  ///< [-], [1/m]
  };
  /// Of N, M1, M2, M3.
  using PointTangents = std::array<Points, 4>;
  /// The blocks of a block-tridiagonal matrix, each column by column: on the diagonal, beside it node i by node i + 1,
  /// node i + 1 by node i.
  struct Blocks {
    double *diagonal, *upper, *lower;
    std::size_t nodal_unknowns;
  };

  /// What is beyond the points is set to zero. Keeps the kinematics for the two functions that follow.
  void find_strains(const double* u, const Strains& strains);
  /// Adds the work of the resultants, at the position of `find_strains`.
  void add_internal_force(const Points& resultants, double* f);
  /// Adds its derivative.
  void add_stiffness(const Points& resultants, const PointTangents& tangents, const Blocks& K);

  /// Add the consistent inertia force, or that of what turns with the nodes. They take a state of their own.
  void add_inertia_force(const double* u, const double* v, const double* a, double* f);
  void add_rotary_force(const double* u, const double* v, const double* a, double* f);
  /// Add their derivatives by positions, velocities, accelerations, times their factors.
  void add_inertia_tangent(const double* u, const double* v, const double* a, const InertiaFactors& factors,
                           const Blocks& K);
  void add_rotary_tangent(const double* u, const double* v, const double* a, const InertiaFactors& factors,
                          const Blocks& K);
  /// [J] of the consistent inertia.
  double kinetic_energy(const double* u, const double* v);

 private:
  double* row(std::size_t row) { return rows_.data() + row * stride_; }
  double at(std::size_t row, std::size_t place) const { return rows_[row * stride_ + place]; }
  bool take(std::size_t first_row, const double* nodal, std::vector<double>& last);
  void see_position(const double* u);
  void see_motion(const double* u, const double* v, const double* a);
  void add_to_nodes(double* f) const;
  Points without_twist(Points points) const;

  std::size_t elements_, stride_, unknowns_;
  AlignedVector rows_;
  AlignedVector none_;             // zeros for points
  std::vector<double> u_, v_, a_;  // of the rows at hand
  bool kinematics_known_ = false, spins_known_ = false;
};

}  // namespace strandyn::beam
