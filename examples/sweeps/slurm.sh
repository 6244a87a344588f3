#!/bin/bash
# One array task for each shard of a sweep: sbatch --array=1-8 slurm.sh trophic-predator-prey sweep.toml OUT
# Any first index and step will do: --array=0-7, --array=10-80:10. Indices with gaps are refused, as a task cannot know which shard is
# its own. Without --array one task makes all runs. The same command again finishes interrupted runs.
#SBATCH --array=1-8
#SBATCH --cpus-per-task=1
#SBATCH --signal=B:TERM@60
set -euo pipefail

refuse() {
  echo "slurm.sh: $1" >&2
  exit 2
}
[ $# -eq 3 ] || refuse "needs three arguments: PROGRAM SWEEP.TOML OUT"

shard=()
if [ -n "${SLURM_ARRAY_TASK_ID:-}" ]; then
  id=$SLURM_ARRAY_TASK_ID
  count=${SLURM_ARRAY_TASK_COUNT:?"is not set by this Slurm"}
  first=${SLURM_ARRAY_TASK_MIN:?"is not set by this Slurm"}
  step=${SLURM_ARRAY_TASK_STEP:-1}
  last=${SLURM_ARRAY_TASK_MAX:-$((first + (count - 1) * step))}
  if [ "$last" -ne $((first + (count - 1) * step)) ] || [ $(((id - first) % step)) -ne 0 ] || [ "$id" -gt "$last" ]; then
    refuse "array index $id of $count from $first to $last in steps of $step: must be an array without gaps, such as --array=1-$count"
  fi
  shard=(--shard "$(((id - first) / step + 1))/$count")
fi

# Slurm signals this shell a minute before the time limit (B:TERM) and the program itself at scancel: either way it keeps a checkpoint.
"$1" --sweep "$2" --out "$3" ${shard[@]+"${shard[@]}"} --jobs "${SLURM_CPUS_PER_TASK:-1}" &
program=$!
trap 'kill -TERM "$program"' TERM
code=0
wait "$program" || code=$?
# A signal ends the wait, not the program.
while kill -0 "$program" 2>/dev/null; do
  code=0
  wait "$program" || code=$?
done
exit "$code"
