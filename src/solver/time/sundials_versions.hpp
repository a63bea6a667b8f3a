#pragma once
/// \file What SUNDIALS 6 and 7 call by different names.

#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_nonlinearsolver.h>

namespace strandyn::solver::sundials {

#if SUNDIALS_VERSION_MAJOR < 7

inline constexpr int converged = SUN_NLS_SUCCESS;

inline int make_context(SUNContext& context) {
  return SUNContext_Create(nullptr, &context);
}
inline int silence(SUNContext, void* ida) {
  return IDASetErrFile(ida, nullptr);
}

#else

inline constexpr int converged = SUN_SUCCESS;

inline int make_context(SUNContext& context) {
  return SUNContext_Create(SUN_COMM_NULL, &context);
}
inline int silence(SUNContext context, void*) {
  return SUNContext_ClearErrHandlers(context);
}

#endif

}  // namespace strandyn::solver::sundials
