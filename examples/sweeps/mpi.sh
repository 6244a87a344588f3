#!/bin/bash
# Every N-th run of a sweep on each of N ranks: mpirun -n 16 mpi.sh trophic-predator-prey sweep.toml OUT
# The same command again finishes what was cut off.
set -euo pipefail
rank=${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-${SLURM_PROCID:?"is not set: start this with mpirun or srun"}}}
ranks=${OMPI_COMM_WORLD_SIZE:-${PMI_SIZE:-${SLURM_NTASKS:?"is not set: start this with mpirun or srun"}}}
"$1" --sweep "$2" --out "$3" --plan >/dev/null
runs=$(seq "$rank" "$ranks" $(($(wc -l <"$3/plan.jsonl") - 1)))
[ -z "$runs" ] || exec "$1" --sweep "$2" --out "$3" --jobs 1 --run $runs
