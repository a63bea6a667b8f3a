#pragma once
/// \file The endings of a run that a user can meet, one type each. The application turns them into exit codes.

#include <stdexcept>
#include <string>
#include <utility>

namespace strandyn {

/// What the program returns to the shell.
enum class ExitCode : int {
  done = 0,
  wrong_input = 2,
  not_converged = 3,  ///< the computation did not converge, or broke a bound that the case asked for
  no_file = 4,        ///< a file could not be read or written
  interrupted = 130
};

/// The input is wrong. The text is complete: file, line, column, key, what is wrong, what would be right.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file could not be read or written. The text names the path and the cause.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The computation did not converge or broke a bound; the text says where, when and what to change.
struct ComputationError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The user stopped the run. What was computed so far is kept by whoever catches this.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace strandyn
