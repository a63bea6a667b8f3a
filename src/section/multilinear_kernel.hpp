#pragma once
/// \file The springs of the multilinear law over one batch, compiled once per instruction set.
///
/// An axis history is made of blocks of `axis_rows` rows of `block_lanes` doubles: the committed curvature, then the
/// stretch of each spring. A pair history has two rows where an axis history has one: axis 2, then axis 3.

#include "strandyn/section/multilinear.hpp"

namespace strandyn::section::multilinear_kernel {

inline std::size_t axis_rows(const MultilinearSection& section) {
  return 1 + section.springs.size();
}

struct AxisResponse {
  double* M = nullptr;
  double* dM_dchi = nullptr;  ///< null: no tangent asked for
};

struct Curvatures {
  std::size_t points = 0;
  const double* chi2 = nullptr;
  const double* chi3 = nullptr;
};

struct PairResponse {
  double* M2 = nullptr;
  double* M3 = nullptr;
  double* dM2_dchi2 = nullptr;  ///< null: no tangent asked for
  double* dM2_dchi3 = nullptr;  ///< equal to dM3_dchi2
  double* dM3_dchi3 = nullptr;
};

/// One axis with springs of its own.
void respond_axis(const MultilinearSection& section, const double* history, std::size_t points, const double* chi,
                  const AxisResponse& out);
/// Adds the energies of this axis to `energy`.
void commit_axis(const MultilinearSection& section, double* history, std::size_t points, const double* chi,
                 StepEnergy& energy);

/// Two axes that share their springs.
void respond_pair(const MultilinearSection& section, const double* history, const Curvatures& chi,
                  const PairResponse& out);
void commit_pair(const MultilinearSection& section, double* history, const Curvatures& chi, StepEnergy& energy);

}  // namespace strandyn::section::multilinear_kernel
