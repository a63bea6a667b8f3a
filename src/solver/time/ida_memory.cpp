#include "ida_memory.hpp"

#include "strandyn/core/error.hpp"
#include "strandyn/solver/time/ida.hpp"

#ifdef STRANDYN_IDA_CHECKPOINTS

#include <ida/ida_impl.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_version.h>

#include <cstddef>
#include <span>

// `ida_impl.h` describes IDA's memory as the library of this version lays it out.
static_assert(SUNDIALS_VERSION_MAJOR == 6 && SUNDIALS_VERSION_MINOR == 4,
              "checkpoints know the memory of IDA in SUNDIALS 6.4: compare ida_impl.h and the use of its fields in "
              "ida.c before this file is used with another version");

namespace strandyn::solver {
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

/// Orders and counts that IDA takes as places in its rows: those that it can have left itself.
void check_places(const IDAMem m) {
  const auto within = [](int x, int least, int most) { return x >= least && x <= most; };
  if (within(m->ida_kk, 1, m->ida_maxord) && within(m->ida_kused, 0, m->ida_maxord) &&
      within(m->ida_knew, 0, m->ida_maxord) && within(m->ida_phase, 0, 1) && within(m->ida_ns, 0, m->ida_maxord + 2)) {
    return;
  }
  throw FileError("it holds an order or a phase that IDA does not have");
}

}  // namespace

bool ida_has_checkpoints() {
  return true;
}

void archive_ida(Archive& a, void* ida) {
  require_version_of_headers();
  IDAMem m = static_cast<IDAMem>(ida);
  // The next step.
  a(m->ida_kk, m->ida_kused, m->ida_knew, m->ida_phase, m->ida_ns, m->ida_hh, m->ida_hused, m->ida_h0u, m->ida_eta,
    m->ida_tn, m->ida_tretlast, m->ida_cj, m->ida_cjlast, m->ida_cjold, m->ida_cjratio, m->ida_ss, m->ida_tolsf);
  for (auto* coefficients : {&m->ida_psi, &m->ida_alpha, &m->ida_beta, &m->ida_sigma, &m->ida_gamma}) a(*coefficients);
  if (a.reads()) check_places(m);
  // Differences up to the highest order: the last one is kept for a step of higher order.
  for (int k = 0; k <= m->ida_maxord; ++k) {
    const std::span<double> difference(N_VGetArrayPointer(m->ida_phi[k]),
                                       static_cast<std::size_t>(N_VGetLength(m->ida_phi[k])));
    for (double& x : difference) a(x);
  }
  // Error weights and work vectors are made anew in each step; the memory of its Newton test is not used here.
  a(m->ida_nst, m->ida_nre, m->ida_ncfn, m->ida_netf, m->ida_nni, m->ida_nnf, m->ida_nsetups);
}

}  // namespace strandyn::solver

#else

namespace strandyn::solver {

bool ida_has_checkpoints() {
  return false;
}

void archive_ida(Archive&, void*) {
  throw ComputationError("the memory of IDA is not known in this version of SUNDIALS");
}

}  // namespace strandyn::solver

#endif
