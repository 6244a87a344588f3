#!/bin/bash
# One array task for each shard of a sweep: sbatch --array=1-8 slurm.sh trophic-predator-prey sweep.toml OUT
# The same command again completes interrupted runs.
#SBATCH --array=1-8
#SBATCH --cpus-per-task=1
exec "$1" --sweep "$2" --out "$3" --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --jobs "$SLURM_CPUS_PER_TASK"
