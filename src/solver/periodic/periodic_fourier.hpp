#pragma once
/// \file Harmonics of N samples of a cycle. Coefficient 0 is the mean, 2k - 1 and 2k are cosine and sine of harmonic k.

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace strandyn::solver {

class Fourier {
 public:
  Fourier(int harmonics, int samples)
      : harmonics_(harmonics), basis_(samples, 2 * harmonics + 1), projection_(2 * harmonics + 1, samples) {
    for (int j = 0; j < samples; ++j) {
      const double angle = 2 * std::numbers::pi * j / samples;
      basis_(j, 0) = 1;
      for (int k = 1; k <= harmonics; ++k) {
        basis_(j, 2 * k - 1) = std::cos(k * angle);
        basis_(j, 2 * k) = std::sin(k * angle);
      }
    }
    projection_ = 2.0 / samples * basis_.transpose();
    projection_.row(0) /= 2;
  }

  /// All harmonics that so many samples hold.
  static Fourier of_all(Eigen::Index samples) {
    return {static_cast<int>((samples - 1) / 2), static_cast<int>(samples)};
  }

  int harmonics() const { return harmonics_; }
  Eigen::Index samples() const { return basis_.rows(); }
  Eigen::Index coefficients() const { return basis_.cols(); }
  /// Samples by coefficients: values at the samples of coefficients of one.
  const Eigen::MatrixXd& basis() const { return basis_; }
  /// Coefficients by samples: its inverse on the harmonics that are kept.
  const Eigen::MatrixXd& projection() const { return projection_; }

  /// Samples by 4 H + 1: the means of a quantity and of its products with cosine and sine of the harmonics 1 ... 2 H,
  /// as products of two of the basis need them.
  Eigen::MatrixXd products() const {
    const Fourier twice(2 * harmonics_, static_cast<int>(samples()));
    return twice.basis() / static_cast<double>(samples());
  }

  /// Coefficients of the derivative by w t, one row per quantity.
  static Eigen::MatrixXd derivative(const Eigen::MatrixXd& rows) {
    Eigen::MatrixXd d = Eigen::MatrixXd::Zero(rows.rows(), rows.cols());
    for (Eigen::Index a = 1; a < rows.cols(); a += 2) {
      const double k = static_cast<double>((a + 1) / 2);
      d.col(a) = k * rows.col(a + 1);
      d.col(a + 1) = -k * rows.col(a);
    }
    return d;
  }

 private:
  int harmonics_;
  Eigen::MatrixXd basis_, projection_;
};

}  // namespace strandyn::solver
