// SPDX-License-Identifier: MIT
// The ranks of an MPI job, which share the runs of a plan.
#pragma once

#include <memory>
#include <trophic/support/linkage.hpp>

namespace trophic::sweep {
class Team;
}  // namespace trophic::sweep

namespace trophic::mpi {

/// The team of a program that mpirun or srun started as a rank of a job, by the environment variables of Open MPI, MPICH and
/// PMIx; null if it was started alone. Callers also include tools/sweep/team.hpp.
[[nodiscard]] std::unique_ptr<sweep::Team> find_team();

}  // namespace trophic::mpi

#if TROPHIC_HEADER_ONLY
#include <trophic/mpi/find_team.ipp>
#endif
