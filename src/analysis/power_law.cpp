#include "strandyn/analysis/power_law.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace strandyn::analysis {
namespace {

constexpr double newtons_per_kN = 1000;
constexpr double smallest_spread = 0.01;    // of ln x: below, x counts as constant
constexpr double smallest_singular = 1e-3;  // of unit columns: below, their combination counts as constant
constexpr double largest_share = 0.1;       // of an exponent in a combination that the points cannot see

/// ln A, ln f, -ln T: the factors of the exponents, in the order l, m, n.
std::array<double, 3> regressors(const TestCondition& at) {
  return {std::log(at.antinode_amplitude), std::log(at.frequency), -std::log(at.tension / newtons_per_kN)};
}

/// The points that can be fitted, their logarithms in rows.
struct Logarithms {
  std::vector<std::array<double, 3>> x;
  std::vector<double> ln_P;
};

bool usable(const SelfDampingPoint& point) {
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  return positive(point.at.antinode_amplitude) && positive(point.at.frequency) && positive(point.at.tension) &&
         std::isfinite(point.power);
}

/// Fills the counts of `fit` and returns what is left to fit.
Logarithms sort_out(std::span<const SelfDampingPoint> points, const AmplitudeBand& band, PowerLawFit& fit) {
  constexpr double slack = 1e-9;  // an amplitude computed as (A/D) D still belongs to the end of its band
  Logarithms logs;
  double first_loss = std::numeric_limits<double>::infinity();
  for (const SelfDampingPoint& point : points) {
    const double A = point.at.antinode_amplitude;
    if (A < band.lowest * (1 - slack) || A > band.highest * (1 + slack)) continue;
    if (!usable(point)) {
      ++fit.unusable;
    } else if (point.power <= 0) {
      ++fit.without_loss;
    } else {
      logs.x.push_back(regressors(point.at));
      logs.ln_P.push_back(std::log(point.power));
      first_loss = std::min(first_loss, A);
    }
  }
  fit.points = logs.ln_P.size();
  for (const SelfDampingPoint& point : points) {
    const double A = point.at.antinode_amplitude;
    if (A < band.lowest * (1 - slack) || A > band.highest * (1 + slack) || A >= first_loss) continue;
    if (usable(point) && point.power <= 0) fit.no_slip_below = std::max(fit.no_slip_below.value_or(0), A);
  }
  return logs;
}

Estimate estimate(double value, double variance, int degrees) {
  Estimate e{.value = value};
  if (degrees > 0) {
    const double error = std::sqrt(variance);
    const double reach = student_t(degrees, 0.95) * error;
    e.standard_error = error;
    e.interval_95 = Interval{.low = value - reach, .high = value + reach};
  }
  return e;
}

}  // namespace

double power(const PowerLaw& law, const TestCondition& at) {
  return law.factor * std::pow(at.antinode_amplitude, law.amplitude) * std::pow(at.frequency, law.frequency) /
         std::pow(at.tension / newtons_per_kN, law.tension);
}

std::optional<PowerLaw> PowerLawFit::law() const {
  if (!log_factor) return {};
  const double factor = std::exp(log_factor->value);
  if (!std::isnormal(factor)) return {};  // exponents of hundreds, from frequencies a per cent apart
  const auto value = [](const std::optional<Estimate>& e) { return e ? e->value : 0.0; };
  return PowerLaw{
      .factor = factor, .amplitude = value(amplitude), .frequency = value(frequency), .tension = value(tension)};
}

PowerLawFit fit_power_law(std::span<const SelfDampingPoint> points, const AmplitudeBand& band) {
  PowerLawFit fit;
  const Logarithms logs = sort_out(points, band, fit);
  const auto n = static_cast<Eigen::Index>(fit.points);
  if (n == 0) return fit;

  Eigen::MatrixXd x(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) x.row(i) = Eigen::Map<const Eigen::RowVector3d>(logs.x[i].data());
  const Eigen::Map<const Eigen::VectorXd> ln_P(logs.ln_P.data(), n);
  const Eigen::RowVector3d x_mean = x.colwise().mean();
  const double y_mean = ln_P.mean();
  const Eigen::VectorXd y = ln_P.array() - y_mean;

  // The variables that vary, centred and of unit length each.
  std::vector<int> varying;
  for (int j = 0; j < 3; ++j) {
    if (x.col(j).maxCoeff() - x.col(j).minCoeff() > smallest_spread) varying.push_back(j);
  }
  const auto q = static_cast<Eigen::Index>(varying.size());
  Eigen::MatrixXd z(n, q);
  Eigen::VectorXd length(q), mean(q);
  for (Eigen::Index c = 0; c < q; ++c) {
    mean(c) = x_mean(varying[c]);
    z.col(c) = x.col(varying[c]).array() - mean(c);
    length(c) = z.col(c).norm();
    z.col(c) /= length(c);
  }

  // Least squares in the combinations that the points see; the others are left alone.
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(q);
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(q, q);  // over the variance of a residual
  Eigen::VectorXd unseen = Eigen::VectorXd::Zero(q);         // share of each exponent in what is not seen
  Eigen::Index rank = 0;
  if (q > 0) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(z, Eigen::ComputeThinU | Eigen::ComputeFullV);
    const Eigen::VectorXd singular = svd.singularValues();
    for (Eigen::Index i = 0; i < q; ++i) {
      const Eigen::VectorXd direction = svd.matrixV().col(i);
      if (i < singular.size() && singular(i) > smallest_singular) {
        ++rank;
        slope += direction * (svd.matrixU().col(i).dot(y) / singular(i));
        covariance += direction * direction.transpose() / (singular(i) * singular(i));
      } else {
        unseen = unseen.cwiseMax(direction.cwiseAbs());
      }
    }
  }
  const Eigen::VectorXd residual = y - z * slope;
  slope = slope.cwiseQuotient(length);
  covariance = length.cwiseInverse().asDiagonal() * covariance * length.cwiseInverse().asDiagonal();

  const int degrees = static_cast<int>(n - 1 - rank);
  const double variance = degrees > 0 ? residual.squaredNorm() / degrees : 0;
  fit.scatter = residual.norm() / std::sqrt(static_cast<double>(n));
  if (y.norm() > 1e-14 * std::sqrt(static_cast<double>(n)))
    fit.r_squared = 1 - residual.squaredNorm() / y.squaredNorm();

  const std::array<std::optional<Estimate>*, 3> exponents{&fit.amplitude, &fit.frequency, &fit.tension};
  for (Eigen::Index c = 0; c < q; ++c) {
    if (unseen(c) < largest_share) *exponents[varying[c]] = estimate(slope(c), variance * covariance(c, c), degrees);
  }
  if (rank == q) {
    const double of_mean = 1 / static_cast<double>(n) + mean.dot(covariance * mean);
    fit.log_factor = estimate(y_mean - slope.dot(mean), variance * of_mean, degrees);
  }
  return fit;
}

double student_t(int degrees, double confidence) {
  // The probability in t = sqrt(degrees) tan(angle) is a finite sum in the cosine of the angle.
  const auto probability = [&](double angle) {
    const double square = std::cos(angle) * std::cos(angle);
    const bool odd = degrees % 2 == 1;
    double term = odd ? std::cos(angle) : 1;
    double sum = degrees == 1 ? 0 : term;
    for (int j = odd ? 3 : 2; j < degrees - 1; j += 2) {
      term *= square * (j - 1) / j;
      sum += term;
    }
    sum *= std::sin(angle);
    return odd ? (angle + sum) * 2 / std::numbers::pi : sum;
  };
  double low = 0, high = std::numbers::pi / 2;
  while (true) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) return std::sqrt(static_cast<double>(degrees)) * std::tan(middle);
    (probability(middle) < confidence ? low : high) = middle;
  }
}

}  // namespace strandyn::analysis
