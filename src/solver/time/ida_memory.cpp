#include "ida_memory.hpp"

#include <cstddef>
#include <span>

#include "strandyn/core/error.hpp"
#include "strandyn/solver/time/ida.hpp"
#include "sundials_compat.hpp"

#ifdef STRANDYN_IDA_CHECKPOINTS
#include <ida/ida_impl.h>

// `ida_impl.h` describes IDA's memory as the library of this version lays it out.
static_assert(SUNDIALS_VERSION_MAJOR == 6 && SUNDIALS_VERSION_MINOR == 4,
              "checkpoints know the memory of IDA in SUNDIALS 6.4: compare ida_impl.h and the use of its fields in "
              "ida.c before this file is used with another version");
#endif

namespace strandyn::solver {

bool has_stepped(void* ida) {
  long steps = 0;
  IDAGetNumSteps(ida, &steps);
  return steps > 0;
}

#ifdef STRANDYN_IDA_CHECKPOINTS

bool ida_has_checkpoints() {
  return true;
}

namespace {

/// The library is loaded when the program starts: it may be another than the headers were of.
void require_version_of_headers() {
  int major = 0;
  int minor = 0;
  int patch = 0;
  char label[32] = {};
  SUNDIALSGetVersionNumber(&major, &minor, &patch, label, sizeof label);
  if (major == SUNDIALS_VERSION_MAJOR && minor == SUNDIALS_VERSION_MINOR) return;
  throw ComputationError("checkpoints of IDA need SUNDIALS " SUNDIALS_VERSION ", for which this program was built");
}

}  // namespace

void archive_ida(Archive& a, void* ida) {
  require_version_of_headers();
  IDAMem m = static_cast<IDAMem>(ida);
  // The next step.
  a(m->ida_kk, m->ida_kused, m->ida_knew, m->ida_phase, m->ida_ns, m->ida_hh, m->ida_hused, m->ida_h0u, m->ida_eta,
    m->ida_tn, m->ida_tretlast, m->ida_cj, m->ida_cjlast, m->ida_cjold, m->ida_cjratio, m->ida_ss, m->ida_tolsf);
  for (auto* coefficients : {&m->ida_psi, &m->ida_alpha, &m->ida_beta, &m->ida_sigma, &m->ida_gamma}) a(*coefficients);
  // Differences up to the highest order: the last one is kept for a step of higher order.
  for (int k = 0; k <= m->ida_maxord; ++k) {
    const std::span<double> difference(N_VGetArrayPointer(m->ida_phi[k]),
                                       static_cast<std::size_t>(N_VGetLength(m->ida_phi[k])));
    for (double& x : difference) a(x);
  }
  // Error weights and work vectors are made anew in each step; the memory of its Newton test is not used here.
  a(m->ida_nst, m->ida_nre, m->ida_ncfn, m->ida_netf, m->ida_nni, m->ida_nnf, m->ida_nsetups);
}

#else

bool ida_has_checkpoints() {
  return false;
}

void archive_ida(Archive&, void*) {
  throw ComputationError("this program cannot keep the state of IDA");
}

#endif

}  // namespace strandyn::solver
