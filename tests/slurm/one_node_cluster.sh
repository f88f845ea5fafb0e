#!/usr/bin/env bash
# A Slurm cluster of one node with two processors in a folder of its own, for tests of `--engine slurm`. Needs root and the packages
# slurm-wlm and munge; nothing outside the folder is touched, no service of the machine is used.
#
#   one_node_cluster.sh start FOLDER [LINE ...]   lines for slurm.conf; prints what to set: export SLURM_CONF=...
#   one_node_cluster.sh stop FOLDER
#   one_node_cluster.sh stop-node FOLDER, start-node FOLDER   slurmd alone
#
# Exit 77 with a sentence where it cannot run: to be skipped.
set -euo pipefail

command=${1:?start, stop, stop-node or start-node} folder=${2:?folder}
skip() { echo "skipped: $1" >&2; exit 77; }
export PATH=$PATH:/usr/sbin:/sbin

[ "$(id -u)" -eq 0 ] || skip "the one-node Slurm cluster needs root"
for program in slurmctld slurmd munged sbatch; do
  command -v "$program" >/dev/null || skip "$program is not installed (packages slurm-wlm, munge)"
done
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)

end_of() {  # the process of a pid file, by its id
  [ -f "$1" ] || return 0
  local pid; pid=$(cat "$1")
  kill "$pid" 2>/dev/null || true
  for _ in $(seq 100); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
  kill -9 "$pid" 2>/dev/null || true
  rm -f "$1"
}

start_node() { SLURM_CONF=$folder/slurm.conf slurmd -N "$(hostname -s)"; }

case $command in
  start)
    mkdir -p "$folder"/{state,spool,munge}
    chmod 0700 "$folder/munge"
    [ -f "$folder/munge/key" ] || head -c 1024 /dev/urandom >"$folder/munge/key"
    chmod 0400 "$folder/munge/key"
    # The folder above must not be writable for others, or munged wants --force.
    munged --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" --pid-file="$folder/munge/pid" \
      --log-file="$folder/munge/log" --seed-file="$folder/munge/seed"
    port=$((20000 + RANDOM % 20000))
    cat >"$folder/slurm.conf" <<CONF
ClusterName=adore-test
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CryptoType=crypto/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerType=sched/backfill
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=1000000
JobRequeue=1
ReturnToService=2
SlurmdTimeout=15
SlurmctldTimeout=30
MinJobAge=600
MaxArraySize=10001
MpiDefault=none
SwitchType=switch/none
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=2 RealMemory=2000 State=UNKNOWN
PartitionName=test Nodes=$(hostname -s) Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
CONF
    for line in "${@:3}"; do echo "$line" >>"$folder/slurm.conf"; done
    export SLURM_CONF=$folder/slurm.conf
    slurmctld -i
    start_node
    for _ in $(seq 300); do
      [ "$(sinfo --noheader --format=%t 2>/dev/null)" = idle ] && break
      sleep 0.2
    done
    if [ "$(sinfo --noheader --format=%t 2>/dev/null)" != idle ]; then
      tail -5 "$folder"/slurm*.log >&2
      skip "the node of the one-node Slurm cluster does not come up"
    fi
    echo "export SLURM_CONF=$folder/slurm.conf"
    ;;
  stop-node) end_of "$folder/slurmd.pid" ;;
  start-node) start_node ;;
  stop)
    export SLURM_CONF=$folder/slurm.conf
    scancel --user=root 2>/dev/null || true
    end_of "$folder/slurmd.pid"
    end_of "$folder/slurmctld.pid"
    end_of "$folder/munge/pid"
    ;;
  *) echo "unknown command $command" >&2; exit 2 ;;
esac
