#include "vector_ops.hpp"

#include <nvector/nvector_serial.h>

// One body, compiled for two widths; which one runs is decided when the program starts.
#define STRANDYN_WIDE __attribute__((target_clones("avx2", "default")))

namespace strandyn::solver {
namespace {

// Where an output is one of the inputs, element i still depends on element i alone.

STRANDYN_WIDE void linear_sum(long n, double a, const double* x, double b, const double* y, double* z) {
#pragma GCC ivdep
  for (long i = 0; i < n; ++i) z[i] = a * x[i] + b * y[i];
}

STRANDYN_WIDE void scale(long n, double c, const double* x, double* z) {
#pragma GCC ivdep
  for (long i = 0; i < n; ++i) z[i] = c * x[i];
}

STRANDYN_WIDE void fill(long n, double c, double* z) {
#pragma GCC ivdep
  for (long i = 0; i < n; ++i) z[i] = c;
}

STRANDYN_WIDE void combine(long n, const double* c, const double* x, const double* y, const double* w, double* z) {
#pragma GCC ivdep
  for (long i = 0; i < n; ++i) z[i] = (c[0] * x[i] + c[1] * y[i]) + c[2] * w[i];
}

double* data(N_Vector v) {
  return N_VGetArrayPointer_Serial(v);
}

void wide_linear_sum(sunrealtype a, N_Vector x, sunrealtype b, N_Vector y, N_Vector z) {
  linear_sum(N_VGetLength_Serial(x), a, data(x), b, data(y), data(z));
}

void wide_scale(sunrealtype c, N_Vector x, N_Vector z) {
  scale(N_VGetLength_Serial(x), c, data(x), data(z));
}

void wide_fill(sunrealtype c, N_Vector z) {
  fill(N_VGetLength_Serial(z), c, data(z));
}

/// z = sum of c_k X_k: the predictor. A second-order formula has three terms.
int wide_combination(int count, sunrealtype* c, N_Vector* X, N_Vector z) {
  const long n = N_VGetLength_Serial(z);
  if (count == 1) {
    scale(n, c[0], data(X[0]), data(z));
  } else if (count == 2) {
    linear_sum(n, c[0], data(X[0]), c[1], data(X[1]), data(z));
  } else {
    combine(n, c, data(X[0]), data(X[1]), data(X[2]), data(z));
    for (int k = 3; k < count; ++k) linear_sum(n, 1, data(z), c[k], data(X[k]), data(z));
  }
  return 0;
}

/// Z_k = a_k x + Y_k: what a finished step does to the differences that IDA keeps.
int wide_scale_add(int count, sunrealtype* a, N_Vector x, N_Vector* Y, N_Vector* Z) {
  for (int k = 0; k < count; ++k) linear_sum(N_VGetLength_Serial(x), a[k], data(x), 1, data(Y[k]), data(Z[k]));
  return 0;
}

}  // namespace

void use_wide_operations(N_Vector v) {
  v->ops->nvlinearsum = wide_linear_sum;
  v->ops->nvscale = wide_scale;
  v->ops->nvconst = wide_fill;
  v->ops->nvlinearcombination = wide_combination;
  v->ops->nvscaleaddmulti = wide_scale_add;
}

}  // namespace strandyn::solver
