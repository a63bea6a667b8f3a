// The linear equations of Newton's method for the balance of all harmonics.

#include "periodic_balance.hpp"
#include "strandyn/beam/planar_element.hpp"

namespace strandyn::solver {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using section::Component;
using section::Field;
using system::Matrix;

namespace {

/// Places of the extra unknowns: the swing of the control, frequency, drive; then those of updates of rank one.
enum Extra : Index { swing_cosine, swing_sine, at_frequency, at_drive, first_update };

}  // namespace

void HarmonicBalance::section_stiffness(const section::TangentField& tangents, Matrix& K) const {
  system_.stiffness_of(unstressed_, tangents, rest_.data(), K);
  if (springs_) K.add(-1, *springs_);
}

void HarmonicBalance::add_slip(const SectionModel& model, HarmonicMatrix& T) const {
  const Index m = fourier_.coefficients();
  const auto axes = static_cast<Index>(axes_.size());
  const std::size_t points = system_.committed_strains().points();
  Matrix K = system_.make_matrix();
  // Stiffness of one section for a tangent of one. Every other element shares no node with the next such one, so that
  // all of these are found at once.
  for (std::size_t first = 0; first < 2 * beam::gauss_points; ++first) {
    std::vector<std::size_t> those;  // of the slipping points
    for (std::size_t s = 0; s < model.slipping.size(); ++s) {
      if (model.slipping[s] % (2 * beam::gauss_points) == first) those.push_back(s);
    }
    if (those.empty()) continue;
    for (Index r = 0; r < axes; ++r) {
      for (Index c = 0; c < axes; ++c) {
        end_if_asked(options_.stop);
        section::TangentField tangents(axes == 1 ? section::Dimension::planar : section::Dimension::spatial, points);
        auto& one = tangents(axes_[static_cast<std::size_t>(r)], axes_[static_cast<std::size_t>(c)]);
        for (std::size_t s : those) one[model.slipping[s]] = 1;
        section_stiffness(tangents, K);
        for (std::size_t s : those) {
          const MatrixXd factors = model.extra[s].block(r * m, c * m, m, m);
          T.add_element(factors, K, model.slipping[s] / beam::gauss_points);
        }
      }
    }
  }
}

void HarmonicBalance::assemble(const PeriodicPoint& point, const BalanceEvaluation& at, const SectionModel& model,
                               HarmonicMatrix& T, std::vector<VectorXd>& columns, std::vector<VectorXd>& rows) const {
  const Index m = fourier_.coefficients();
  Matrix K = system_.make_matrix();
  const MatrixXd u = swing(point).u;
  CycleMatrix around(fourier_, K.block(), K.nodes());
  for (Index j = 0; j < u.cols(); ++j) {
    end_if_asked(options_.stop);
    system_.stiffness_of(at.loops.stresses[static_cast<std::size_t>(j)], model.mean, u.col(j).data(), K);
    system_.subtract_external_tangent({.time = 0}, u.col(j).data(), K);
    around.set(j, K);
    if (!K.update()) continue;
    columns.push_back(T.pack(K.update()->column * fourier_.projection().col(j).transpose()));
    rows.push_back(T.pack(K.update()->row * fourier_.basis().row(j)));
  }
  T.add(around);
  add_slip(model, T);
  MatrixXd square = MatrixXd::Zero(m, m);
  MatrixXd turn = MatrixXd::Zero(m, m);
  for (Index a = 1; a < m; a += 2) {
    const double rate = static_cast<double>((a + 1) / 2) * point.omega;
    square(a, a) = square(a + 1, a + 1) = -rate * rate;
    turn(a, a + 1) = rate;
    turn(a + 1, a) = -rate;
  }
  T.add(square, M_);
  T.add(turn, C_);
  add_air_and_metal(point, T);
  for (const system::ProportionalDamping::Mode& mode : system_.damping().modes) {
    for (Index a = 1; a < m; ++a) {
      const Index b = a % 2 == 1 ? a + 1 : a - 1;
      columns.push_back(T.pack(mode.factor * turn(a, b) * mode.momentum * VectorXd::Unit(m, a).transpose()));
      rows.push_back(T.pack(mode.momentum * VectorXd::Unit(m, b).transpose()));
    }
  }
}

void HarmonicBalance::add_air_and_metal(const PeriodicPoint& point, HarmonicMatrix& T) const {
  const Index m = fourier_.coefficients();
  if (A_) {
    MatrixXd turn = MatrixXd::Zero(m, m);
    for (Index a = 1; a < m; a += 2) {
      const int k = static_cast<int>(a + 1) / 2;
      turn(a, a + 1) = k * point.omega * linear_air(point, k).linear;
      turn(a + 1, a) = -turn(a, a + 1);
    }
    T.add(turn, *A_);
  }
  const air::AirForce other = other_air(point);
  if (!other.is_none()) {
    const MatrixXd v = swing(point).v;
    // Rates are basis * derivative * coefficients.
    const MatrixXd rates = point.omega * Fourier::derivative(MatrixXd(fourier_.basis())) * -1;
    Matrix D = system_.make_matrix();
    for (Index j = 0; j < v.cols(); ++j) {
      D.set_zero();
      system_.air_on_chain().add_tangent(other, v.col(j).data(), 1, D);
      T.add(fourier_.projection().col(j) * rates.row(j), D);
    }
  }
  const section::MaterialBranches& branches = system_.model().material;
  if (branches.empty()) return;
  section::TangentField tangents = tangents_;
  Matrix K = system_.make_matrix();
  for (const section::MaterialBranch& branch : branches) {
    for (std::size_t r = 0; r < section::component_count; ++r) {
      for (std::size_t c = 0; c < section::component_count; ++c) {
        auto& entries = tangents(Component{r}, Component{c});
        std::fill(entries.begin(), entries.end(), r == c ? branch.stiffness[c] : 0.0);
      }
    }
    section_stiffness(tangents, K);
    MatrixXd answer = MatrixXd::Zero(m, m);
    for (Index a = 1; a < m; a += 2) {
      const double x = static_cast<double>((a + 1) / 2) * point.omega * branch.relaxation_time;
      answer(a, a) = answer(a + 1, a + 1) = x * x / (1 + x * x);
      answer(a, a + 1) = x / (1 + x * x);
      answer(a + 1, a) = -answer(a, a + 1);
    }
    T.add(answer, K);
  }
}

bool HarmonicBalance::solve(const PeriodicPoint& point, const BalanceEvaluation& at, const SectionModel& model,
                            const Closings& closings, MatrixXd equations, MatrixXd closing_values,
                            PeriodicPoint& change) const {
  HarmonicMatrix T(M_.block(), M_.nodes(), fourier_.coefficients());
  std::vector<VectorXd> columns, rows;
  assemble(point, at, model, T, columns, rows);
  const auto updates = static_cast<Index>(columns.size());
  Border border(T.size(), first_update + updates);
  for (Index k = 0; k < updates; ++k) {
    border.columns.col(first_update + k) = columns[static_cast<std::size_t>(k)];
    border.rows.row(first_update + k) = rows[static_cast<std::size_t>(k)];
    border.corner(first_update + k, first_update + k) = -1;
  }
  // Inertia and drag are of second degree in the frequency: the central difference is exact.
  const double step = 1e-3 * point.omega;
  PeriodicPoint faster = point, slower = point;
  faster.omega += step;
  slower.omega -= step;
  border.columns.col(at_frequency) = T.pack((inertia(faster) - inertia(slower)) / (2 * step));
  for (std::size_t i = 0; i < system_.unknowns(); ++i) {
    if (!system_.is_held(i)) continue;
    for (Index a = 0; a < fourier_.coefficients(); ++a) {
      T.pin_row(T.place(i, a));
      border.columns.row(T.place(i, a)).setZero();
    }
  }
  border.columns(T.place(drive_, 1), at_drive) = -1;

  MatrixXd x = T.pack(equations);
  MatrixXd y = MatrixXd::Zero(border.corner.rows(), 1);
  for (Index e : {swing_cosine, swing_sine}) {
    const Index place = T.place(control_, 1 + e);
    border.rows.row(e) = T.row(place);
    border.corner.row(e) = border.columns.row(place);
    border.columns.row(place).setZero();
    border.columns(place, e) = -1;
    T.pin_row(place);
    y(e) = x(place);
    x(place) = 0;
  }
  for (Index e : {0, 1}) {
    const Closing& closing = closings[static_cast<std::size_t>(e)];
    for (const Closing::Term& term : closing.terms) {
      border.rows(at_frequency + e, T.place(term.unknown, term.coefficient)) += term.factor;
    }
    border.corner(at_frequency + e, at_frequency) = closing.by_omega;
    border.corner(at_frequency + e, at_drive) = closing.by_drive;
    y(at_frequency + e) = closing_values(e);
  }
  HarmonicFactors factors;
  if (!factors.factorize(T) || !solve_bordered(factors, border, x, y)) return false;
  change = {.x = T.unpack(x.col(0)), .omega = y(at_frequency), .drive = y(at_drive)};
  return true;
}

bool HarmonicBalance::correct(const PeriodicPoint& point, const BalanceEvaluation& at, const SectionModel& model,
                              const Closings& closings, PeriodicPoint& change) const {
  return solve(point, at, model, closings, -at.residual, Eigen::Vector2d(-closings[0].gap, -closings[1].gap), change);
}

bool HarmonicBalance::direction(const PeriodicPoint& point, const BalanceEvaluation& at, const SectionModel& model,
                                const Closings& closings, PeriodicPoint& change) const {
  return solve(point, at, model, closings, MatrixXd::Zero(at.residual.rows(), at.residual.cols()),
               Eigen::Vector2d(1, 0), change);
}

}  // namespace strandyn::solver
