#include "plain_beam.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "strandyn/math/block_tridiagonal.hpp"

namespace strandyn::bench {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double unstressed = 30, stretched = 30.0225, EA = 40e6, mass = 1.98;  // [m], [m], [N], [kg/m]
constexpr double residual_EI = 100, spring = 90;                                // [N m^2]
constexpr int springs = 10;                                                     // yield at 0.001, 0.002, ... 1/m

struct Point {
  double curvature = 0, moment = 0;
  std::array<double, springs> plastic{};
};

struct Bent {
  double moment = 0, stiffness = residual_EI, friction = 0;
  std::array<double, springs> plastic{};
};

Bent bend(const Point& at, double curvature) {
  Bent b{.moment = residual_EI * curvature};
  for (std::size_t i = 0; i < springs; ++i) {
    const double limit = spring * 1e-3 * static_cast<double>(i + 1);
    const double trial = spring * (curvature - at.plastic[i]);
    const double carried = std::clamp(trial, -limit, limit);
    b.moment += carried;
    if (std::abs(trial) < limit) b.stiffness += spring;
    b.plastic[i] = curvature - carried / spring;
    b.friction += carried * (b.plastic[i] - at.plastic[i]);
  }
  return b;
}

class Chain {
 public:
  explicit Chain(const PlainBeam& beam)
      : count_(static_cast<std::size_t>(beam.elements)),
        length_(unstressed / beam.elements),
        inside_(beam.tension_on_deflection ? 1.0 / 30 : 0.0) {
    const double side = beam.sections == 3 ? std::sqrt(0.15) : std::sqrt(1.0 / 12);
    place_ = {0.5 - side, 0.5 + side};
    weight_ = {0.5, 0.5};
    if (beam.sections == 3) {
      place_ = {0.5 - side, 0.5, 0.5 + side};
      weight_ = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    }
    points_.resize(count_ * place_.size());
    const double l = length_;
    Eigen::Matrix4d across;
    across << 156, 22 * l, 54, -13 * l, 22 * l, 4 * l * l, 13 * l, -3 * l * l, 54, 13 * l, 156, -22 * l, -13 * l,
        -3 * l * l, -22 * l, 4 * l * l;
    mass_.setZero();
    constexpr std::array bends = {1, 2, 4, 5};
    constexpr std::array stretches = {0, 3};
    mass_(bends, bends) = mass * l / 420 * across;
    mass_(stretches, stretches) = mass * l / 6 * (Eigen::Matrix2d() << 2, 1, 1, 2).finished();
  }

  std::size_t nodes() const { return count_ + 1; }
  const Matrix6& element_mass() const { return mass_; }

  /// f += internal force; K += its tangent.
  void add(const Eigen::VectorXd& q, Eigen::VectorXd& f, math::BlockTridiagonal<3>* K) const {
    for (std::size_t e = 0; e < count_; ++e) {
      const Eigen::Vector2d d = q.segment<2>(at(e + 1)) - q.segment<2>(at(e));
      const double l = d.norm(), angle = std::atan2(d.y(), d.x());
      const std::array t = {q(at(e) + 2) - angle, q(at(e + 1) + 2) - angle};
      const double N = EA * ((l - length_) / length_ + inside_ * (2 * t[0] * t[0] - t[0] * t[1] + 2 * t[1] * t[1]));
      const std::array s = {inside_ * (4 * t[0] - t[1]), inside_ * (4 * t[1] - t[0])};
      Eigen::Vector3d force(N, N * length_ * s[0], N * length_ * s[1]);
      const Eigen::Vector3d strain_row(1 / length_, s[0], s[1]);
      Eigen::Matrix3d local = EA * length_ * strain_row * strain_row.transpose();
      for (std::size_t g = 0; g < place_.size(); ++g) {
        const Eigen::Vector3d row = curvature_row(g);
        const Bent b = bend(points_[e * place_.size() + g], row(1) * t[0] + row(2) * t[1]);
        force += weight_[g] * length_ * b.moment * row;
        local += weight_[g] * length_ * b.stiffness * row * row.transpose();
      }
      local.bottomRightCorner<2, 2>() += N * length_ * inside_ * (Eigen::Matrix2d() << 4, -1, -1, 4).finished();
      Vector6 along, across;
      along << -d / l, 0, d / l, 0;
      across << d.y() / l, -d.x() / l, 0, -d.y() / l, d.x() / l, 0;
      across = -across;
      Eigen::Matrix<double, 3, 6> B;
      B << along.transpose(), across.transpose() / l, across.transpose() / l;
      B(1, 2) += 1;
      B(2, 5) += 1;
      f.segment<6>(at(e)) += B.transpose() * force;
      if (!K) continue;
      const double turn = (force(1) + force(2)) / (l * l);
      K->add_element(e, Matrix6(B.transpose() * local * B + N / l * across * across.transpose() -
                                turn * (along * across.transpose() + across * along.transpose())));
    }
  }

  void add_inertia(const Eigen::VectorXd& a, Eigen::VectorXd& f) const {
    for (std::size_t e = 0; e < count_; ++e) f.segment<6>(at(e)) += mass_ * a.segment<6>(at(e));
  }

  void accept(const Eigen::VectorXd& q, PlainWork& work) {
    for (std::size_t e = 0; e < count_; ++e) {
      const Eigen::Vector2d d = q.segment<2>(at(e + 1)) - q.segment<2>(at(e));
      const double angle = std::atan2(d.y(), d.x());
      for (std::size_t g = 0; g < place_.size(); ++g) {
        Point& point = points_[e * place_.size() + g];
        const Eigen::Vector3d row = curvature_row(g);
        const double curvature = row(1) * (q(at(e) + 2) - angle) + row(2) * (q(at(e + 1) + 2) - angle);
        const Bent b = bend(point, curvature);
        const double part = weight_[g] * length_;
        work.bending += part * (point.moment + b.moment) / 2 * (curvature - point.curvature);
        work.friction += part * b.friction;
        point = {.curvature = curvature, .moment = b.moment, .plastic = b.plastic};
      }
    }
  }

  static Eigen::Index at(std::size_t node) { return 3 * static_cast<Eigen::Index>(node); }

 private:
  Eigen::Vector3d curvature_row(std::size_t g) const {
    return {0, (6 * place_[g] - 4) / length_, (6 * place_[g] - 2) / length_};
  }

  std::size_t count_;
  double length_, inside_;
  std::vector<double> place_, weight_;
  std::vector<Point> points_;
  Matrix6 mass_;
};

}  // namespace

PlainWork plain_work(const PlainBeam& beam) {
  Chain chain(beam);
  const std::size_t last = chain.nodes() - 1;
  const auto size = static_cast<Eigen::Index>(3 * chain.nodes());
  Eigen::VectorXd q = Eigen::VectorXd::Zero(size), v = q, a = q;
  for (std::size_t node = 0; node <= last; ++node) {
    const double part = static_cast<double>(node) / beam.elements, wave = 12 * std::numbers::pi;
    q(Chain::at(node)) = part * stretched;
    if (node == 0 || node == last) continue;
    v(Chain::at(node) + 1) = 0.8 * std::sin(wave * part);
    v(Chain::at(node) + 2) = 0.8 * wave / stretched * std::cos(wave * part);
  }
  const auto hold = [&](Eigen::VectorXd& x) {
    x.head<3>().setZero();
    x.tail<3>().setZero();
  };
  const auto solve = [&](math::BlockTridiagonal<3>& K, Eigen::VectorXd& x) {
    for (int i = 0; i < 3; ++i) {
      K.pin(0, i);
      K.pin(last, i);
    }
    hold(x);
    math::BlockTridiagonalLU<3> factors;
    if (!factors.factorize(K)) throw std::runtime_error("the matrix of the plain beam is singular");
    factors.solve(x.data());
  };

  const double h = beam.step, c = 4 / (h * h);  // at rest straight, so the first acceleration is zero
  Eigen::VectorXd before = q - h * v;
  PlainWork work;
  for (std::size_t step = 0; step < beam.steps; ++step) {
    Eigen::VectorXd next = 2 * q - before, w = a;
    bool arrived = false;
    for (int iteration = 0; iteration < 25 && !arrived; ++iteration) {
      w = c * (next - q - h * v) - a;
      hold(w);
      Eigen::VectorXd r = Eigen::VectorXd::Zero(size);
      math::BlockTridiagonal<3> K(chain.nodes());
      chain.add(next, r, &K);
      chain.add_inertia(w, r);
      for (std::size_t e = 0; e < last; ++e) K.add_element(e, Matrix6(c * chain.element_mass()));
      r = -r;
      solve(K, r);
      next += r;
      arrived = r.norm() < 1e-9;
    }
    if (!arrived) throw std::runtime_error("Newton's method did not arrive on the plain beam");
    w = c * (next - q - h * v) - a;
    hold(w);
    v += h / 2 * (a + w);
    a = w;
    before = q;
    q = next;
    chain.accept(q, work);
  }
  return work;
}

}  // namespace strandyn::bench
