#!/usr/bin/env bash
# The scripts of examples/cluster on a real queue, two nodes of one core on this machine: tasks that are stopped by their limit of time, that
# are killed and requeued, and parts of a study that are merged give the same bytes as one process. Ranks of MPI, too.
# usage: array_job.sh PROGRAM SOURCE_DIR
# Exit codes: 77 where SLURM is not installed (packages slurm-wlm, munge).
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
for tool in munged slurmctld slurmd sbatch; do
    [ -n "$(PATH=$PATH:/usr/sbin command -v $tool)" ] || { echo "no $tool: not tried"; exit 77; }
done
PATH=$(dirname "$program"):$PATH:/usr/sbin
cluster=$source_dir/examples/cluster

# A queue of its own, with its own keys, ports and folders, that ends with this test.
host=$(hostname -s) port=$((20000 + $$ % 20000)) me=$(id -un)
mkdir queue queue/state
head -c 128 /dev/urandom >queue/key
chmod 400 queue/key
cat >queue/slurm.conf <<END
ClusterName=tricontact
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$me
SlurmdUser=$me
AuthInfo=socket=$work/queue/munge
SlurmctldPort=$port
StateSaveLocation=$work/queue/state
SlurmdSpoolDir=$work/queue/spool_%n
SlurmctldPidFile=$work/queue/slurmctld.pid
SlurmdPidFile=$work/queue/slurmd_%n.pid
SlurmctldLogFile=$work/queue/slurmctld.log
SlurmdLogFile=$work/queue/slurmd_%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,bf_interval=1,batch_sched_delay=0
MpiDefault=none
KillWait=1
NodeName=node1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=1
NodeName=node2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=1
PartitionName=all Nodes=node1,node2 Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$work/queue/slurm.conf
end_queue() {
    local file
    for file in "$work"/queue/*.pid; do kill "$(cat "$file")" 2>/dev/null; done
    sleep 0.5
    rm -rf "$work"
}
trap end_queue EXIT
munged --force --key-file="$work/queue/key" --socket="$work/queue/munge" --pid-file="$work/queue/munge.pid" \
    --log-file="$work/queue/munge.log" --seed-file="$work/queue/seed" &&
    slurmctld -i && slurmd -N node1 && slurmd -N node2 || { complain "the queue does not start"; finish; }

# within SECONDS COMMAND...: waits until it succeeds.
within() {
    local end=$((SECONDS + $1))
    shift
    until "$@"; do
        [ $SECONDS -lt $end ] || return 1
        sleep 0.2
    done
}
idle_nodes() { [ "$(sinfo --noheader --format=%D --states=idle)" = 2 ]; }
is_merged() { [ -e "$1/results.csv" ] && [ ! -L "$1/merging" ]; }
has_failed() { scontrol show job "${array}_3" | grep -q JobState=FAILED && [ -e "$1/part_1.done" ] && [ -e "$1/part_2.done" ]; }
state_is() { [ "$(squeue --noheader --array --format=%T --jobs="$1")" = "$2" ]; }
within 30 idle_nodes || complain "no nodes: $(sinfo)"

cat >study.toml <<END
case = "$source_dir/examples/cases/rig_sphere_parallel.toml"
models = ["mdr", "bem"]
[set]
rolling.periods = 3
bem.cells_per_radius = 28
[vary]
load.tangential_ratio = {from = 0.1, to = 0.4, points = 12}
END
"$program" sweep study.toml --output one --jobs 2 --quiet --no-report || complain "one process"

# submit FOLDER: the number of the array job in $array.
submit() { array=$("$cluster/submit_sweep.sh" study.toml 3 "$1" --time=10) || complain "submit $1"; }
same() { cmp -s one/results.csv "$1/results.csv" || complain "$1 differs from one process: $(tail -n 3 "$1"/*.log)"; }

# 1. A task is killed and requeued by its user, another is told that its time is over: both go on, each is started twice.
submit requeued
within 30 state_is "${array}_1" RUNNING && scontrol requeue "${array}_1" || complain "the first part is not requeued"
within 60 state_is "${array}_2" RUNNING && scancel --batch --signal=TERM "${array}_2" || complain "the second part is not told"
for part in 1 2; do  # who requeues waits for two minutes otherwise
    within 30 state_is "${array}_$part" PENDING && scontrol update "jobid=${array}_$part" starttime=now
done
within 90 is_merged requeued || complain "never merged: $(squeue)"
for part in 1 2; do
    scontrol show job "${array}_$part" | grep -q ' Restarts=1 ' || complain "part $part: $(scontrol show job "${array}_$part")"
done
same requeued

# 2. A program that is killed fails its task: nothing is merged. Submitted again, what is missing is computed.
submit killed
is_at_work() { pgrep -f "sweep study.toml --shard 3/3" >pids; }
within 60 is_at_work && kill -9 $(cat pids) 2>/dev/null || complain "the third part is not killed"
within 90 has_failed killed || complain "the killed study's queue: $(squeue)"
[ ! -e killed/results.csv ] || complain "merged without a part"
submit killed
within 90 is_merged killed || complain "never merged again: $(squeue)"
same killed

# 3. Ranks of MPI.
if command -v mpirun >/dev/null; then
    mpirun --allow-run-as-root --oversubscribe -n 2 "$cluster/sweep_part.sh" study.toml 2 ranks >ranks.log 2>&1 ||
        complain "ranks of MPI: $(cat ranks.log)"
    cp ranks.log ranks
    same ranks
fi
finish
