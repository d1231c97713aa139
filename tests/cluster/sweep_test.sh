#!/usr/bin/env bash
# sweep_test.sh PROGRAM: a sweep of four quick runs as an array job on two nodes of a Slurm that is started here and stopped
# at the end. Exit 77 where Slurm is not installed.
set -uo pipefail
program=$1
# shellcheck source=tests/cluster/cluster.sh
source "$(dirname "$0")/cluster.sh"

missing=$(missing_slurm_program)
if [[ -n $missing ]]; then
  echo "skipped: $missing is not installed (apt install slurmctld slurmd slurm-client munge)"
  exit 77
fi

folder=$(mktemp -d)
failures=0
finish() {
  stop_cluster
  ((failures == 0)) || tail -n 20 "$folder"/cluster/log/*.log
  rm -rf "$folder"
}
trap finish EXIT
trap 'failures=1; exit 1' INT TERM

# check TEXT COMMAND...: the command has to succeed.
check() {
  local what=$1
  shift
  if "$@"; then echo "ok: $what"; else
    echo "FAILED: $what"
    failures=$((failures + 1))
  fi
}

# exits CODE COMMAND...
exits() {
  local expected=$1 code
  shift
  "$@" >"$folder/said" 2>&1
  code=$?
  cat "$folder/said"
  ((code == expected))
}

all_done() { "$program" sweep --collect --quiet --out "$folder/out"; }
rows_with() { [[ $(grep -c "$1" "$folder/out/table.csv") == "$2" ]]; }

start_cluster "$folder/cluster" || {
  echo "FAILED: the cluster did not come up"
  failures=1
  exit 1
}

cat >"$folder/grid.toml" <<'GRID'
scene = "doublebubble"
steps = 5
[options]
effects = ["surface_tension", "burst"]
[sweep]
n = [8, 9]
burst_region = [[1], [7]]
GRID
sweep=("$program" sweep "$folder/grid.toml" --out "$folder/out" --slurm)

check "a partition that is not there is refused" exits 2 "${sweep[@]}" --partition nowhere
check "nothing was written then" test ! -e "$folder/out"
check "an option that sbatch does not take is refused" exits 2 "${sweep[@]}" --sbatch=--mem=much
check "one array job is submitted" exits 0 "${sweep[@]}" --partition quick
check "its number is recorded" grep -q '"job": "[0-9][0-9]*"' "$folder/out/sweep.json"

none_to_come() {
  all_done
  [[ $? != 5 ]]
}
check "all tasks end" wait_until 120 none_to_come
check "two runs failed, which the exit code says" exits 3 "$program" sweep --collect --out "$folder/out"
check "two runs finished" rows_with ',finished,0,' 2
check "two failed with their message" rows_with ',failed,2,burst_region names region 7' 2
nodes_with_tasks() { [[ $(grep -l -i 'launching batch job' "$folder"/cluster/log/slurmd_node*.log | wc -l) == 2 ]]; }
check "both nodes took part" nodes_with_tasks
check "nothing is submitted twice" exits 3 "${sweep[@]}"
check "no second job is recorded" test "$(grep -c '"job":' "$folder/out/sweep.json")" == 1
# As after some minutes, when the queue has forgotten the job.
sed -i 's/"job": "[0-9]*"/"job": "99999"/' "$folder/out/sweep.json"
check "a job that the queue does not know any more is over" exits 3 "${sweep[@]}"

# Runs that would take hours: the job is cancelled, and they save.
sed 's/^steps = 5/steps = 10000000/; s/^burst_region.*//; s/^effects.*//' "$folder/grid.toml" >"$folder/long.toml"
long=("$program" sweep "$folder/long.toml" --out "$folder/long" --slurm)
check "a long job is submitted" exits 0 "${long[@]}"
job=$(sed -n 's/.*"job": "\([0-9]*\)".*/\1/p' "$folder/long/sweep.json")
under_way() { grep -q '^3,' "$folder/long/runs/$1/metrics.csv" 2>/dev/null; }
check "its first task is under way" wait_until 60 under_way n=8
check "its second task is under way" wait_until 60 under_way n=9
check "what is in the queue is not submitted again" exits 5 "${long[@]}"
# As where the program ended before it had the number.
sed -i "s/\"job\": \"$job\"/\"job\": \"\"/" "$folder/long/sweep.json"
check "a job whose number was lost is not submitted again" exits 5 "${long[@]}"
check "its number is found by its name" grep -q "\"job\": \"$job\"" "$folder/long/sweep.json"
scancel "$job"
queue_is_empty() { [[ -z $(squeue --noheader) ]]; }
check "the queue becomes empty" wait_until 90 queue_is_empty
"$program" sweep --collect --out "$folder/long"
check "both runs saved" test -f "$folder/long/runs/n=8/checkpoint.cbor" -a -f "$folder/long/runs/n=9/checkpoint.cbor"
check "both are interrupted" test "$(grep -c ',interrupted,' "$folder/long/table.csv")" == 2
check "they are submitted again" exits 0 "${long[@]}"
goes_on() { grep -q '"first_step": [1-9]' "$folder/long/runs/n=8/run.json" 2>/dev/null; }
check "they go on from their checkpoints" wait_until 60 goes_on
scancel --user "$(id -un)"
check "the queue becomes empty again" wait_until 90 queue_is_empty

echo "$failures failures"
((failures == 0))
