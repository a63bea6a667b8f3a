#pragma once
/// \file The block elimination of block_tridiagonal.hpp for blocks of five and six, a column of one in a register or
/// two: the same sums, compiled once per instruction set.

#include <cstddef>

namespace strandyn::math::wide_blocks {

/// Blocks of B x B that follow each other, each column by column.
struct Chain {
  std::size_t nodes;
  const double *diagonal, *upper, *lower;  ///< couples node i to i + 1; node i + 1 to i
};

/// Writes the inverse of every pivot and, from the second node on, what the equations before are taken off by. False
/// where a pivot is singular. B = 5, 6.
template <int B>
bool eliminate(const Chain& a, double* inverse, double* lower);
template <>
bool eliminate<5>(const Chain& a, double* inverse, double* lower);
template <>
bool eliminate<6>(const Chain& a, double* inverse, double* lower);

/// Overwrites the right-hand side with the solution.
template <int B>
void substitute(std::size_t nodes, const double* inverse, const double* lower, const double* upper, double* x);
template <>
void substitute<5>(std::size_t nodes, const double* inverse, const double* lower, const double* upper, double* x);
template <>
void substitute<6>(std::size_t nodes, const double* inverse, const double* lower, const double* upper, double* x);

}  // namespace strandyn::math::wide_blocks
