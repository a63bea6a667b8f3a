#!/usr/bin/env bash
# tools/slurm/submit under a real Slurm of one node: munged, slurmctld and slurmd of its own in a scratch folder, as root,
# without control groups. A study of four shards must merge to the bytes of the undivided one. Where Slurm is missing, it is
# installed from Debian; exit code 77 where that or its start fails, with the words of what has failed.
. "$(dirname "$0")/support.sh"
program=$(readlink -f "$program")
submit=$(readlink -f "$(dirname "$0")/../../tools/slurm/submit")
skip() { echo "skipped: $*"; exit 77; }

[ "$(id -u)" -eq 0 ] || skip "only root starts the daemons"
if ! command -v slurmctld > /dev/null || ! command -v slurmd > /dev/null || ! command -v munged > /dev/null; then
  command -v apt-get > /dev/null || skip "there is no Slurm and no apt-get"
  # Installed, the daemons would start with a configuration that is not there.
  [ -e /usr/sbin/policy-rc.d ] || { printf '#!/bin/sh\nexit 101\n' > /usr/sbin/policy-rc.d; chmod +x /usr/sbin/policy-rc.d; made_policy=yes; }
  { apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends -o DPkg::Lock::Timeout=600 slurm-wlm munge; } \
    > "$scratch/apt.log" 2>&1 < /dev/null
  installed=$?
  [ -z "${made_policy-}" ] || rm -f /usr/sbin/policy-rc.d
  [ "$installed" -eq 0 ] || { tail -5 "$scratch/apt.log"; skip "slurm-wlm and munge cannot be installed (above: apt-get)"; }
fi

etc=$scratch/slurm
mkdir -p "$etc/state" "$etc/spool" "$etc/munge"
chmod 755 "$scratch"
chmod 700 "$etc/munge"
host=$(hostname -s)
# Ports of this run's own, so that a Slurm of the machine is left alone.
port=$((20000 + $$ % 20000 * 2))
dd if=/dev/urandom of="$etc/munge/key" bs=128 count=1 2> /dev/null
chmod 400 "$etc/munge/key"
cat > "$etc/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$etc/munge/socket
CredType=cred/munge
StateSaveLocation=$etc/state
SlurmdSpoolDir=$etc/spool
SlurmctldPidFile=$etc/slurmctld.pid
SlurmdPidFile=$etc/slurmd.pid
SlurmctldLogFile=$etc/slurmctld.log
SlurmdLogFile=$etc/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
ReturnToService=2
SchedulerParameters=sched_interval=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$etc/slurm.conf

daemons=()
end_daemons() {
  local i
  for ((i = ${#daemons[@]} - 1; i >= 0; --i)); do kill "${daemons[i]}" 2> /dev/null; done
  for i in "${daemons[@]}"; do wait "$i" 2> /dev/null; done
  rm -rf "$scratch"
}
trap end_daemons EXIT
# start NAME LOG COMMAND...: in the foreground of a job of this shell, so that its number is known.
start() {
  local name=$1 log=$2
  shift 2
  "$@" >> "$log" 2>&1 < /dev/null &
  daemons+=($!)
}
# wait_for SECONDS WHAT LOG COMMAND...
wait_for() {
  local end=$((SECONDS + $1)) what=$2 log=$3
  shift 3
  until "$@" > /dev/null 2>&1; do
    ((SECONDS < end)) || { tail -15 "$log"; skip "$what (above: the daemon's own words)"; }
    sleep 0.2
  done
}

start munged "$etc/munge.log" munged --foreground --force --key-file="$etc/munge/key" --socket="$etc/munge/socket" \
  --pid-file="$etc/munge/pid" --log-file="$etc/munge/log" --seed-file="$etc/munge/seed"
wait_for 20 "munged does not answer" "$etc/munge.log" munge -S "$etc/munge/socket" -n
start slurmctld "$etc/slurmctld.log" slurmctld -D -c -f "$SLURM_CONF"
wait_for 40 "slurmctld does not answer" "$etc/slurmctld.log" scontrol ping
start slurmd "$etc/slurmd.log" slurmd -D -N "$host" -f "$SLURM_CONF"
node_is_up() { sinfo -h -o %t | grep -qx 'idle'; }
wait_for 60 "slurmd does not come up" "$etc/slurmd.log" node_is_up
sinfo

small_study "1, 2, 3" > "$scratch/study.toml"
export STRANDYN=$program
"$program" run "$scratch/study.toml" --quiet --out "$scratch/whole" || fail "the undivided study"
"$submit" "$scratch/study.toml" 4 --out "$scratch/out" > "$scratch/said" 2>&1 || { fail "submit"; cat "$scratch/said"; }
cat "$scratch/said"
squeue
nothing_left() { [ -z "$(squeue -h)" ]; }
end=$((SECONDS + 300))
until nothing_left || ((SECONDS > end)); do sleep 1; done
nothing_left || { fail "the jobs have not ended"; squeue; }
squeue
# A file system may show the last file a moment after the job has gone.
for ((i = 0; i < 50; ++i)); do [ -e "$scratch/out/summary.json" ] && break; sleep 0.2; done
for ((i = 1; i <= 4; ++i)); do
  [ -e "$scratch/out.shards/$i-of-4/shard.json" ] || { fail "shard $i has left nothing"; cat "$scratch/out.shards/shard-$i.log"; }
done
without_times() { sed '/"wall_s"\|"cpu_s"/d' "$1"; }
files=$(cd "$scratch/whole" && ls)
[ "$files" = "$(cd "$scratch/out" && ls)" ] || { fail "other files"; cat "$scratch/out.shards"/*.log; }
for file in $files; do
  cmp -s <(without_times "$scratch/whole/$file") <(without_times "$scratch/out/$file") || fail "merged by Slurm: other $file"
done
[ "$failures" -ne 0 ] || echo "4 shards and their merge under $(slurmctld -V): the $(wc -w <<< "$files") files of the undivided study"
finish
