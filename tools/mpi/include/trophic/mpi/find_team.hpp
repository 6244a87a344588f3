// SPDX-License-Identifier: MIT
// The ranks of an MPI job, which share out the runs of a plan.
#pragma once

#include <memory>
#include <trophic/support/linkage.hpp>

namespace trophic::sweep {
class Team;
}  // namespace trophic::sweep

namespace trophic::mpi {

/// The team of a program that mpirun or srun started as a rank of a job, as Open MPI's, MPICH's and PMIx's variables of the
/// environment say; null where it was started alone. Who uses it includes trophic/run/sweep/team.hpp, too.
[[nodiscard]] std::unique_ptr<sweep::Team> find_team();

}  // namespace trophic::mpi

#if TROPHIC_HEADER_ONLY
#include <trophic/mpi/find_team.ipp>
#endif
