#pragma once
/// \file A second way to the hysteretic reference beam: its own elements, law and trapezoidal rule, in the plane, with
/// nothing of the program's but the block solver.
///
/// Two choices that other beam codes make differently are open here: how many sections an element has, and whether the
/// tension acts on the element's own deflection (as in planar_element.hpp) or on its chord only.

#include <cstddef>

namespace strandyn::bench {

struct PlainBeam {
  int elements = 100;
  int sections = 2;  ///< Gauss points of an element, 2 or 3
  bool tension_on_deflection = true;
  double step = 1.0 / 1200;  ///< [s]
  std::size_t steps = 2000;
};

struct PlainWork {
  double bending = 0;   ///< [J] sum of M dkappa, trapezoidal
  double friction = 0;  ///< [J] of the springs
};

/// Throws std::runtime_error where Newton's method does not arrive.
PlainWork plain_work(const PlainBeam& beam);

}  // namespace strandyn::bench
