#!/usr/bin/env bash
# A Slurm of one machine, of its own: one_box_slurm.sh start FOLDER | stop FOLDER. Private keys, ports, sockets and
# logs in FOLDER; SLURM_CONF=FOLDER/slurm.conf reaches it. Exits 77 with a sentence where it cannot be started.
set -uo pipefail
what=$1 folder=$2

cannot() { echo "Slurm cannot run here: $1" >&2; exit 77; }

free_port() { python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])'; }

stop() {
  for daemon in slurmd slurmctld munged; do
    [ -s "$folder/$daemon.pid" ] || continue
    process=$(cat "$folder/$daemon.pid")
    kill "$process" 2>/dev/null
    for _ in $(seq 50); do
      kill -0 "$process" 2>/dev/null || break
      sleep 0.1
    done
  done
  return 0
}

start() {
  [ "$(id -u)" -eq 0 ] || cannot "it needs root"
  for program in munged slurmctld slurmd sbatch; do
    command -v $program >/dev/null || cannot "$program is not installed"
  done
  mkdir -p "$folder/state" "$folder/spool" && chmod 755 "$folder"
  head -c 128 /dev/urandom >"$folder/munge.key" && chmod 400 "$folder/munge.key"
  munged --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" --pid-file="$folder/munged.pid" \
    --log-file="$folder/munged.log" --seed-file="$folder/munge.seed" || cannot "munged does not start"
  host=$(hostname -s)
  cat >"$folder/slurm.conf" <<CONF
ClusterName=onebox
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket,cred_expire=5
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/backfill
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0
ReturnToService=2
SwitchType=switch/none
MpiDefault=none
KillWait=5
MinJobAge=300
NodeName=$host NodeAddr=127.0.0.1 CPUs=4 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
SlurmdParameters=config_overrides
CONF
  export SLURM_CONF=$folder/slurm.conf
  slurmctld -c -f "$SLURM_CONF" || cannot "slurmctld does not start"
  slurmd -c -f "$SLURM_CONF" || cannot "slurmd does not start"
  for _ in $(seq 100); do
    [ "$(sinfo -h -o %t 2>/dev/null)" = idle ] && exit 0
    sleep 0.2
  done
  tail -3 "$folder"/*.log >&2
  stop
  cannot "its node does not become idle in 20 s"
}

case $what in
  start) start ;;
  stop) stop ;;
esac
