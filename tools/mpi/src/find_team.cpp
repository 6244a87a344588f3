// SPDX-License-Identifier: MIT
// trophic::mpi_compiled: the code that needs MPI's headers.
#include <trophic/mpi/find_team.ipp>
