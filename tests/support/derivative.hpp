#pragma once
/// \file Derivatives by differences, for tests that hold a tangent against its function.

#include <type_traits>

namespace strandyn::test {

/// df/ds at s = 0 of a function of a number that returns a number or an Eigen vector. Fourth order: for functions of
/// order 1 that vary over lengths of 1, h = 1e-3 leaves an error of some 1e-12, rounding included.
template <class F>
auto derivative(F&& f, double h = 1e-3) {
  using Value = std::decay_t<decltype(f(h))>;
  const Value near = f(h) - f(-h);
  const Value far = f(2 * h) - f(-2 * h);
  return Value((8 * near - far) / (12 * h));
}

}  // namespace strandyn::test
