#!/bin/sh
# Run an experiment as a Slurm job array, a range of trials in each job, and put the parts together.
#
#   sbatch --array=0-9 slurm_array.sh experiments/table2.toml table2 1000
#   slurm_array.sh merge table2        # when all jobs have ended
#
# The array must be numbered from 0. A job that was killed goes on where it was when it runs again (scontrol requeue).
#SBATCH --cpus-per-task=2
#SBATCH --time=01:00:00
set -eu

if [ "${1:?an experiment file, or merge}" = merge ]; then
    cdpr merge "${2:?the folder}"/part-* -o "$2/whole"
    exec cdpr report "$2/whole"
fi

experiment=$1 folder=${2:?a folder} trials=${3:?the number of trials}
first=$((SLURM_ARRAY_TASK_ID * trials / SLURM_ARRAY_TASK_COUNT))
end=$(((SLURM_ARRAY_TASK_ID + 1) * trials / SLURM_ARRAY_TASK_COUNT))
mkdir -p "$folder"
part=$(printf '%s/part-%04d' "$folder" "$SLURM_ARRAY_TASK_ID")
exec cdpr batch "$experiment" -o "$part" --resume --trials "$first..$end" --threads "${SLURM_CPUS_PER_TASK:-1}"
