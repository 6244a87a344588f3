// SPDX-License-Identifier: MIT
// trophic::mpi_compiled: what MPI's headers are needed for.
#include <trophic/mpi/find_team.ipp>
