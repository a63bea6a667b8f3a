#pragma once
/// \file What differs between SUNDIALS 6 and 7: here once, so that the rest is written for both.
///
/// Version 7 has no `realtype` (6 has `sunrealtype` too), names its communicator, and hands errors to handlers of the
/// context where 6 writes to a file of IDA's.

#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>
#include <sundials/sundials_version.h>

namespace strandyn::solver::sundials {

#if SUNDIALS_VERSION_MAJOR >= 7

inline int create_context(SUNContext* context) {
  return SUNContext_Create(SUN_COMM_NULL, context);
}
/// Our own messages say it better.
inline int be_silent(SUNContext context, void*) {
  return SUNContext_ClearErrHandlers(context);
}
inline constexpr int converged = SUN_SUCCESS;

#else

inline int create_context(SUNContext* context) {
  return SUNContext_Create(nullptr, context);
}
/// Our own messages say it better.
inline int be_silent(SUNContext, void* ida) {
  return IDASetErrFile(ida, nullptr);
}
inline constexpr int converged = SUN_NLS_SUCCESS;

#endif

}  // namespace strandyn::solver::sundials
