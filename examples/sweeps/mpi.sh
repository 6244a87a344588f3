#!/bin/bash
# Every N-th run of a plan on each of N ranks: mpirun -n 16 mpi.sh trophic-predator-prey runs/study/plan.jsonl
# The same command again finishes what was cut off.
set -euo pipefail
rank=${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-${SLURM_PROCID:?"is not set: start this with mpirun or srun"}}}
ranks=${OMPI_COMM_WORLD_SIZE:-${PMI_SIZE:-${SLURM_NTASKS:?"is not set: start this with mpirun or srun"}}}
runs=$(seq "$rank" "$ranks" $(($(wc -l <"$2") - 1)))
[ -z "$runs" ] || exec "$1" --plan "$2" --jobs 1 --run $runs
