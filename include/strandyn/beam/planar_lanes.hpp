#pragma once
/// \file All elements of a planar chain side by side: the formulas of planar_element.hpp and planar_inertia.hpp with
/// elements in lanes, from nodal vectors to nodal vectors. Element e lies between the nodes e and e + 1, whose unknowns
/// (x, y, rotation) follow each other. One source for every instruction set; each answers to rounding as the
/// functions of one element do. Sines, cosines and chords are found once for a position.

#include <span>

#include "strandyn/beam/planar_element.hpp"
#include "strandyn/beam/planar_inertia.hpp"
#include "strandyn/core/aligned.hpp"

namespace strandyn::beam {

class PlanarLanes {
 public:
  /// `mass_per_length` [kg/m] of the consistent inertia, whose sections have no rotary inertia of their own here.
  PlanarLanes(std::span<const PlanarElement> elements, double mass_per_length);

  /// Section points of a batch: two per element, entries up to a multiple of eight; what is beyond the points is set
  /// to zero in `eps` [-] and `chi` [1/m]. Keeps the kinematics for the functions that follow.
  void find_strains(const double* u, double* eps, double* chi);
  /// Adds the work of `N` [N] and `M` [N m] of the same points, at the position of `find_strains`.
  void add_internal_force(const double* N, const double* M, double* f);
  /// At the position of `find_strains`.
  PlanarKinematics kinematics(std::size_t element) const;
  /// Derivatives of the resultants at the same points: N and M by eps and chi.
  struct PointTangents {
    const double *N_eps, *N_chi, *M_eps, *M_chi;
  };
  /// Finds `tangent` of every element, at the position of `find_strains`.
  void find_tangents(const double* N, const double* M, const PointTangents& t);
  PlanarMatrix tangent(std::size_t element) const;

  /// Adds the consistent inertia force. It takes a position of its own.
  void add_inertia_force(const double* u, const double* v, const double* a, double* f);
  /// Finds `inertia_tangent` of every element: derivatives by positions, velocities, accelerations, times their
  /// factors.
  void find_inertia_tangents(const double* u, const double* v, const double* a, const InertiaFactors& factors);
  PlanarMatrix inertia_tangent(std::size_t element) const;
  /// [J] of the consistent inertia.
  double kinetic_energy(const double* u, const double* v);

 private:
  double* row(std::size_t row) { return rows_.data() + row * stride_; }
  double at(std::size_t row, std::size_t element) const { return rows_[row * stride_ + element]; }
  void take(std::size_t first_row, const double* nodal);
  void find_directions(const double* u);
  void add_to_nodes(std::size_t first_row, double* f) const;

  std::size_t elements_;
  std::size_t stride_;
  AlignedVector rows_;
  AlignedVector stiffness_, inertia_;  // of all elements, in tiles
  bool directions_known_ = false;
};

}  // namespace strandyn::beam
