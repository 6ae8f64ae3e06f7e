#!/bin/sh
# slurm_test.sh CS550_GRADE ROOT SCRATCH: a class graded by the array script on a Slurm of one node, and by GNU
# parallel, has the marks of a class graded at once. Exit code 77: Slurm or parallel is not installed.
set -eu
program=$1 root=$2 scratch=$3
for needed in slurmctld slurmd sbatch parallel; do
  command -v "$needed" >/dev/null || { echo "skipped: $needed is missing (slurm-wlm, parallel)"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo 'skipped: Slurm is started as root'; exit 77; }
rm -rf "$scratch"
mkdir -p "$scratch/state" "$scratch/spool" "$scratch/class"
cd "$scratch"
for student in ada bob eve; do
  mkdir -p "class/$student/labs/lab3_hill_climbing"
  echo '// all right' >"class/$student/labs/lab3_hill_climbing/hill_climbing.cpp"
done
echo '// fake: fails FirstOfEqualVerticesWins' >class/bob/labs/lab3_hill_climbing/hill_climbing.cpp

node=$(hostname -s)
export SLURM_CONF="$scratch/slurm.conf"
cat >"$SLURM_CONF" <<END
ClusterName=test
SlurmctldHost=$node(127.0.0.1)
SlurmUser=root
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SlurmctldPort=27817
SlurmdPort=27818
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/spool
SlurmctldPidFile=$scratch/slurmctld.pid
SlurmdPidFile=$scratch/slurmd.pid
SlurmctldLogFile=$scratch/slurmctld.log
SlurmdLogFile=$scratch/slurmd.log
NodeName=$node NodeAddr=127.0.0.1 CPUs=2 RealMemory=500 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
slurmctld -i
slurmd
stop() { for daemon in slurmd slurmctld; do kill "$(cat "$scratch/$daemon.pid")"; done; }
trap stop EXIT

export CS550_ROOT="$root" CS550_GRADE="$program"
fake=$root/tests/gradebook/fake_grade_lab.sh
ls -d class/* >submissions.txt
timeout 120 sbatch --wait --array="1-$(wc -l <submissions.txt)" "$root/framework/gradebook/slurm/grade_array.sh" \
  submissions.txt parts --labs 3 --judge "$fake" || { cat slurm-*.out ./*.log; exit 1; }
"$program" --report parts/* --out by_slurm
parallel --jobs 2 -a submissions.txt "$program" '{}' --out 'in_parallel/{/.}' --labs 3 --judge "$fake"
"$program" --report in_parallel/* --out by_parallel
"$program" class --out at_once --labs 3 --judge "$fake"
grep -q '^bob' at_once/grades.csv
for folder in by_slurm by_parallel; do cmp "$folder/grades.csv" at_once/grades.csv; done
