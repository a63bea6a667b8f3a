#pragma once
/// \file What the headers of Debian's SUNDIALS 7 want of MPI: a type and the name of "no communicator", as Open MPI,
/// with which that package was compiled, lays them out. No process is ever asked to talk to another one.

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ompi_communicator_t* MPI_Comm;
extern struct ompi_communicator_t ompi_mpi_comm_null;
#define MPI_COMM_NULL (&ompi_mpi_comm_null)

#ifdef __cplusplus
}
#endif
