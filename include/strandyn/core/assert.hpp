#pragma once
/// \file Assumptions of the developer, armed by the audit preset (STRANDYN_AUDIT); user input is checked elsewhere,
/// always.

#ifdef STRANDYN_AUDIT
#include <cstdio>
#include <cstdlib>
/// Stops the program when `condition` is false and prints `value`, the number that says why.
#define STRANDYN_ASSERT(condition, value)                                                                         \
  do {                                                                                                            \
    if (!(condition)) {                                                                                           \
      std::fprintf(stderr, "%s:%d: assumption broken: %s (%s = %.17g)\n", __FILE__, __LINE__, #condition, #value, \
                   static_cast<double>(value));                                                                   \
      std::abort();                                                                                               \
    }                                                                                                             \
  } while (false)
#else
#define STRANDYN_ASSERT(condition, value) \
  do {                                    \
  } while (false)
#endif
