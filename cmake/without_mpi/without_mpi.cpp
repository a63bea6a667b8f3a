// The four names of MPI that SUNDIALS' context links to. It calls none of the functions while its communicator is
// MPI_COMM_NULL; would it ever, then to stop at once is better than to go on with a rank that nobody gave.
#include <cstdlib>

#include "mpi.h"

struct ompi_communicator_t {
  int nothing;
};

extern "C" {

ompi_communicator_t ompi_mpi_comm_null = {.nothing = 0};

[[noreturn]] int MPI_Comm_dup(MPI_Comm, MPI_Comm*) {
  std::abort();
}
[[noreturn]] int MPI_Comm_free(MPI_Comm*) {
  std::abort();
}
[[noreturn]] int MPI_Comm_rank(MPI_Comm, int*) {
  std::abort();
}

}  // extern "C"
