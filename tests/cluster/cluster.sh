# shellcheck shell=bash
# A Slurm cluster of its own on this machine: munged, slurmctld and two slurmd, everything in one folder, free ports. To be
# sourced.

slurm_programs=(munged slurmctld slurmd sbatch squeue sinfo scancel)

# The first of the programs that is not installed; nothing when all are.
missing_slurm_program() {
  local program
  for program in "${slurm_programs[@]}"; do
    command -v "$program" >/dev/null || { echo "$program"; return; }
  done
}

# Ports that nobody listens on now, as many as asked for.
free_ports() {
  python3 - "$1" <<'PYTHON'
import socket, sys
held = [socket.socket() for _ in range(int(sys.argv[1]))]
for one in held:
    one.bind(("", 0))
print(*[one.getsockname()[1] for one in held])
PYTHON
}

# write_configuration FOLDER: slurm.conf of a controller and the nodes node1, node2 that are this machine, for the user
# who calls; no cgroups, no accounting.
write_configuration() {
  local folder=$1 ports user host
  read -ra ports <<<"$(free_ports 3)"
  user=$(id -un) host=$(hostname -s)
  mkdir -p "$folder"/{state,log}
  cat >"$folder/slurm.conf" <<CONF
ClusterName=sweeptest
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=${ports[0]}
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool_%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd_%n.pid
SlurmctldLogFile=$folder/log/slurmctld.log
SlurmdLogFile=$folder/log/slurmd_%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SwitchType=switch/none
MpiDefault=none
SchedulerType=sched/backfill
SchedulerParameters=batch_sched_delay=0,sched_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SlurmdParameters=config_overrides
NodeName=node1 NodeHostname=$host NodeAddr=127.0.0.1 Port=${ports[1]} CPUs=2 State=UNKNOWN
NodeName=node2 NodeHostname=$host NodeAddr=127.0.0.1 Port=${ports[2]} CPUs=2 State=UNKNOWN
PartitionName=quick Nodes=node1,node2 Default=YES MaxTime=10 State=UP
CONF
}

# start_cluster FOLDER: starts the daemons and waits until both nodes are idle, at most 60 s. Sets SLURM_CONF and
# cluster_pids; returns 1 when the cluster does not come up.
cluster_pids=()
start_cluster() {
  local folder=$1 node
  write_configuration "$folder"
  export SLURM_CONF=$folder/slurm.conf
  (umask 077 && head -c 1024 /dev/urandom >"$folder/munge.key")
  munged --foreground --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" --seed-file="$folder/munge.seed" \
         --pid-file="$folder/munge.pid" --log-file="$folder/log/munge.log" >"$folder/log/munged.out" 2>&1 &
  cluster_pids+=($!)
  wait_until 10 test -S "$folder/munge.socket" || return 1
  slurmctld -D >"$folder/log/slurmctld.out" 2>&1 &
  cluster_pids+=($!)
  for node in node1 node2; do
    slurmd -D -N "$node" >"$folder/log/$node.out" 2>&1 &
    cluster_pids+=($!)
  done
  wait_until 60 two_nodes_idle
}

two_nodes_idle() {
  [[ $(sinfo --noheader --Node --format=%t 2>/dev/null | grep -c '^idle$') == 2 ]]
}

# wait_until SECONDS COMMAND...: tries it twice a second; 1 when it never succeeded.
wait_until() {
  local end=$((SECONDS + $1))
  shift
  while ((SECONDS < end)); do
    "$@" && return 0
    sleep 0.5
  done
  return 1
}

# Ends what start_cluster started, the last first, and waits for it.
stop_cluster() {
  local i pid
  for ((i = ${#cluster_pids[@]} - 1; i >= 0; --i)); do
    pid=${cluster_pids[i]}
    kill "$pid" 2>/dev/null
    wait_until 10 process_gone "$pid" || kill -KILL "$pid" 2>/dev/null
    wait "$pid" 2>/dev/null
  done
  cluster_pids=()
}

# A zombie that nobody waited for yet is gone, too.
process_gone() {
  local state
  state=$(sed 's/.*) //' "/proc/$1/stat" 2>/dev/null)
  [[ -z $state || $state == Z* ]]
}
