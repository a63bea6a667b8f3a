// The block elimination of the implicit step against KLU, on the matrix of the reference beam.
//   bench_linear_solver                                            do the solutions agree?
//   bench_linear_solver SOLVER PART DIMENSION ELEMENTS REPEATS     one part, for a script that counts instructions
// SOLVER: ours, klu (2n unknowns, as IDA hands them), klu-reduced (n unknowns, K + c G). PART: setup, solve.
// Set-up is what a new matrix costs once K and M of the elements are summed per node: to fill it and to factor it.
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include <cstdlib>
#include <memory>
#include <string_view>

#include "measured.hpp"
#include "reference_beam.hpp"

using namespace strandyn;
using system::Matrix;
using system::Vector;

namespace {

constexpr double rate = 1.5 * 1200;  // [1/s] c of a step of 1/1200 s with the second-order BDF formula

/// The implicit step of a beam in motion: (K + c^2 M) du = b2 + c M b1, dv = c du - b1.
struct Step {
  Step(const std::string& dimension, int elements)
      : span("beam/elastic_benchmark_" + dimension + ".toml", {fmt::format("span.elements={}", elements)}),
        K(span.system.make_matrix()),
        M(K) {
    Vector u = span.u + 1e-3 * bench::sine_velocity(span, 12, 0.8);
    Vector f = u;
    span.system.internal_force(u.data(), f.data(), K);
    span.system.mass_matrix(u.data(), M);
    b = Vector::Random(2 * u.size());
    for (Eigen::Index i = 0; i < u.size(); ++i) {
      if (span.system.is_held(static_cast<std::size_t>(i))) b(i) = b(u.size() + i) = 0;
    }
  }
  std::size_t unknowns() const { return span.system.unknowns(); }

  bench::Span span;
  Matrix K, M;
  Vector b;  // both right-hand sides, b1 first
};

class Solver {
 public:
  virtual ~Solver() = default;
  virtual void set_up() = 0;
  virtual Vector solve() = 0;
};

class Ours final : public Solver {
 public:
  explicit Ours(const Step& step) : step_(step), A_(step.K), G_(step.M), product_(step.span.system.make_vector()) {}
  void set_up() override {
    A_ = step_.K;
    A_.add(rate * rate, step_.M);
    G_.set_zero();
    G_.add(rate, step_.M);
    step_.span.system.hold(A_);
    if (!factors_.factorize(A_)) std::abort();
  }
  Vector solve() override {
    const Eigen::Index n = product_.size();
    Vector x(2 * n);
    G_.multiply(step_.b.data(), product_.data());
    for (Eigen::Index i = 0; i < n; ++i) {
      x(i) = step_.b(n + i) + (step_.span.system.is_held(static_cast<std::size_t>(i)) ? 0 : product_(i));
    }
    factors_.solve(x.data());
    for (Eigen::Index i = 0; i < n; ++i) x(n + i) = rate * x(i) - step_.b(i);
    return x;
  }

 private:
  const Step& step_;
  Matrix A_, G_;
  math::ChainFactors factors_;
  Vector product_;
};

/// Column by column: where the entries of a block-tridiagonal matrix stand, rows and columns shifted.
template <class F>
void visit_columns(const Matrix& A, F&& visit) {
  math::with_block_size(A.block(), [&](auto B) {
    const auto& t = A.as<B()>();
    for (std::size_t node = 0; node < t.nodes(); ++node) {
      for (int c = 0; c < B(); ++c) {
        const std::size_t column = node * B() + static_cast<std::size_t>(c);
        const auto entries = [&](std::size_t row_node, const auto& block) {
          for (int r = 0; r < B(); ++r) visit(row_node * B() + static_cast<std::size_t>(r), column, block(r, c));
        };
        if (node > 0) entries(node - 1, t.upper(node - 1));
        entries(node, t.diagonal(node));
        if (node + 1 < t.nodes()) entries(node + 1, t.lower(node));
      }
    }
  });
}

class Klu final : public Solver {
 public:
  Klu(const Step& step, bool reduced) : step_(step), reduced_(reduced), M_(step.M), A_(step.K) {
    const std::size_t n = step.unknowns();
    size_ = reduced ? n : 2 * n;
    std::size_t entries = 0;
    visit_columns(A_, [&](std::size_t, std::size_t, double) { ++entries; });
    entries = reduced ? entries : 2 * entries + 2 * n;
    SUNContext_Create(nullptr, &context_);
    const auto size = static_cast<sunindextype>(size_);
    matrix_ = SUNSparseMatrix(size, size, static_cast<sunindextype>(entries), CSC_MAT, context_);
    x_ = N_VNew_Serial(size, context_);
    b_ = N_VNew_Serial(size, context_);
    fill();
    solver_ = SUNLinSol_KLU(x_, matrix_, context_);
    SUNLinSolInitialize(solver_);
    SUNLinSolSetup(solver_, matrix_);  // the first one orders the unknowns; later ones keep the order
  }
  ~Klu() override {
    SUNLinSolFree(solver_);
    N_VDestroy(x_);
    N_VDestroy(b_);
    SUNMatDestroy(matrix_);
    SUNContext_Free(&context_);
  }
  void set_up() override {
    fill();
    if (SUNLinSolSetup(solver_, matrix_) != 0) std::abort();
  }
  Vector solve() override {
    double* b = N_VGetArrayPointer(b_);
    const auto n = static_cast<Eigen::Index>(step_.unknowns());
    if (reduced_) {
      Eigen::Map<Vector> right(b, n);
      Vector product(n);
      M_.multiply(step_.b.data(), product.data());
      right = step_.b.tail(n) + rate * product;
      for (Eigen::Index i = 0; i < n; ++i) {
        if (step_.span.system.is_held(static_cast<std::size_t>(i))) right(i) = 0;
      }
    } else {
      Eigen::Map<Vector>(b, 2 * n) = step_.b;
    }
    SUNLinSolSolve(solver_, matrix_, x_, b_, 0);
    const Eigen::Map<const Vector> x(N_VGetArrayPointer(x_), static_cast<Eigen::Index>(size_));
    if (!reduced_) return x;
    Vector both(2 * n);
    both.head(n) = x;
    both.tail(n) = rate * x - step_.b.head(n);
    return both;
  }

 private:
  /// [c I, -I; K, c M] or K + c^2 M; a held unknown has u = b2, v = c u - b1.
  void fill() {
    A_ = step_.K;
    if (reduced_) A_.add(rate * rate, step_.M);
    step_.span.system.hold(A_);
    const auto n = static_cast<sunindextype>(step_.unknowns());
    sunindextype* starts = SM_INDEXPTRS_S(matrix_);
    sunindextype* rows = SM_INDEXVALS_S(matrix_);
    double* values = SM_DATA_S(matrix_);
    sunindextype k = 0;
    sunindextype open = -1;
    const auto put = [&](sunindextype row, double value) {
      rows[k] = row;
      values[k++] = value;
    };
    visit_columns(A_, [&](std::size_t row, std::size_t column, double value) {
      const auto c = static_cast<sunindextype>(column);
      if (c != open) {
        starts[open = c] = k;
        if (!reduced_) put(c, rate);
      }
      put(static_cast<sunindextype>(row) + (reduced_ ? 0 : n), value);
    });
    if (!reduced_) {
      visit_columns(step_.M, [&](std::size_t row, std::size_t column, double value) {
        const auto c = static_cast<sunindextype>(column) + n;
        if (c != open) {
          starts[open = c] = k;
          put(c - n, -1);
        }
        put(static_cast<sunindextype>(row) + n, step_.span.system.is_held(row) ? 0 : rate * value);
      });
    }
    starts[size_] = k;
  }

  const Step& step_;
  bool reduced_;
  const Matrix& M_;
  Matrix A_;
  std::size_t size_ = 0;
  SUNContext context_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver solver_ = nullptr;
  N_Vector x_ = nullptr, b_ = nullptr;
};

std::unique_ptr<Solver> make_solver(std::string_view name, const Step& step) {
  if (name == "ours") return std::make_unique<Ours>(step);
  return std::make_unique<Klu>(step, name == "klu-reduced");
}

void print_agreement() {
  fmt::print("| case | elements | KLU, 2n unknowns | KLU, n unknowns |\n| --- | --- | --- | --- |\n");
  for (const char* dimension : {"planar", "spatial"}) {
    for (int elements : {100, 400}) {
      const Step step(dimension, elements);
      std::vector<Vector> x;
      for (const char* name : {"ours", "klu", "klu-reduced"}) {
        const std::unique_ptr<Solver> solver = make_solver(name, step);
        solver->set_up();
        x.push_back(solver->solve().head(static_cast<Eigen::Index>(step.unknowns())));
      }
      fmt::print("| {} | {} | {:.1e} | {:.1e} |\n", dimension, elements, (x[1] - x[0]).norm() / x[0].norm(),
                 (x[2] - x[0]).norm() / x[0].norm());
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 1) {
    print_agreement();
    return 0;
  }
  if (count != 6) {
    fmt::print(stderr, "usage: bench_linear_solver [SOLVER PART DIMENSION ELEMENTS REPEATS]\n");
    return 2;
  }
  const Step step(arguments[3], std::atoi(arguments[4]));
  const std::unique_ptr<Solver> solver = make_solver(arguments[1], step);
  const std::string_view part = arguments[2];
  const int repeats = std::atoi(arguments[5]);
  solver->set_up();
  measured([&] {
    for (int i = 0; i < repeats; ++i) {
      if (part == "setup") {
        solver->set_up();
      } else {
        solver->solve();
      }
    }
  });
}
