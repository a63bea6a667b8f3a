#pragma once
/// \file Where the nodes of a span lie: finer toward clamped ends, where bending dies out within sqrt(EI/T).

#include <cstddef>
#include <vector>

namespace strandyn::model {

/// [m] Places no farther apart are one place, and no element made for a place is shorter: half a millimetre, or a
/// thousandth of a span below half a metre. What lies between them is rounding of what somebody typed.
constexpr double same_place(double length) {
  return length < 0.5 ? 1e-3 * length : 5e-4;
}

struct MeshOptions {
  double length = 0;         ///< [m]
  std::size_t elements = 0;  ///< >= 1
  double end_size = 0;       ///< [m] wanted size of the element at a graded end; 0: uniform
  bool grade_left = false;   ///< is the left end graded
  bool grade_right = false;
  double growth = 0.25;          ///< [-] how fast the size grows with the distance from a graded end
  std::vector<double> stations;  ///< [m] places that must be nodes, such as load points; of several near ones the first
};

/// Positions [m] of `elements` + 1 nodes from 0 to length. Sizes follow min(end_size + growth * distance, middle), with
/// `middle` such that the number of elements comes out; where there are too few elements for that, all sizes grow
/// alike.
std::vector<double> span_mesh(const MeshOptions& options);

/// Number of elements for which the largest is `middle` [m] long.
std::size_t elements_for(const MeshOptions& options, double middle);

}  // namespace strandyn::model
