#!/bin/sh
#SBATCH --job-name=cs550
#SBATCH --cpus-per-task=2
#SBATCH --time=01:00:00
# sbatch --array=1-N grade_array.sh LIST PARTS [OPTION...]: task i grades the submission in line i of LIST into
# PARTS/i. The options are those of ./cs550 grade. A task that is run again reuses what it has graded.
set -eu
list=$1 parts=$2
shift 2
submission=$(sed -n "${SLURM_ARRAY_TASK_ID}p" "$list")
# shellcheck disable=SC2086  # two words
exec ${CS550_GRADE:-./cs550 grade} "$submission" --out "$parts/$SLURM_ARRAY_TASK_ID" --resume "$@"
