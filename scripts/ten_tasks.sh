#!/usr/bin/env bash
# What a stranger does first, from a bare Debian 12 in a folder and by the commands of the documents as the package
# has them: ten tasks, the time of each, and what it left. Root installs, an ordinary user does the rest. Writes a table
# to FOLDER/ten_tasks.md; docs/explanation/first-hour.md has one. As root.
# usage: [WHEEL=FILE.whl] ten_tasks.sh PACKAGE.deb FOLDER [TASK]...   FOLDER/debian is kept: another call begins with it
#   TASK: install run rig code data queue paraview notebook cite fault (all), wheel: into another bare Debian
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/bare_debian.bash"
[ $# -ge 2 ] || { sed -n '/^# usage/s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
package=$(realpath "$1")
folder=$(realpath -m "$2")
shift 2
mkdir -p "$folder"
root=$folder/stranger
docs=$root/usr/share/doc/tricontact/docs

# blocks DOCUMENT FROM TO: from the heading FROM up to the heading TO (its end) the blocks of sh, and those that are a file, as one script.
blocks() {
    awk -v from="$2" -v to="$3" '
        $0 == from { on = 1 }
        to != "" && $0 == to { on = 0 }
        on && /^```/ && !inside {
            inside = 1; kind = ""
            if (match($0, / file=.*/)) { kind = "file"; print "cat >" substr($0, RSTART + 6) " <<\47END OF BLOCK\47" }
            else if (/^```sh$/) kind = "sh"
            next
        }
        /^```$/ && inside { if (kind == "file") print "END OF BLOCK"; inside = 0; next }
        inside && kind != "" { print }' "$docs/$1"
}

# as_root SCRIPT, as_user SCRIPT
as_root() { inside "$root" bash -euo pipefail -c "cd /root; $1"; }
as_user() { inside "$root" runuser -u stranger -- bash -euo pipefail -c "export HOME=/home/stranger; cd; $1"; }
fetch() { as_root "apt-get -q -y install $*"; }

# Each task, then what has to be there.
task_install() {
    as_root "apt-get update; apt-get -y install ./tricontact_0.2.0_amd64.deb" # the block for root, which asks
    as_user "$(blocks how-to/install.md '## The package' '## From a clone' | sed '/^apt-get/d')"
    as_user "test -s results/rig_sphere_parallel/report.html; man -w tricontact >man 2>&1 || ls /usr/share/man/man1/tricontact.1.gz"
}
task_run() {
    as_user "$(awk '/^```toml/ { on = 1; print "cat >case.toml <<\47END\47"; next } on && /^```/ { print "END"; exit } on' \
        "$docs/../README.md")
        tricontact check case.toml
        tricontact run case.toml
        test -s results/case/report.html -a -s results/case/plots/shift.png"
}
task_rig() {
    as_user "$(blocks how-to/own-rig.md '## 1. Ask the drawing' '')
        test -s results/my_rig/report.html"
}
task_code() {
    as_user "$(blocks tutorials/verify-your-code.md '## A code that writes a table' '## When it fails')
        test -s comparison_mine/report.html"
}
task_data() {
    # The block of the page, with a modulus and a friction that the numbers of somebody else's rig have.
    as_user "$(awk '/^```toml/ { on = 1; print "cat >my_data.toml <<\47END\47"; next } on && /^```/ { print "END"; exit } on' \
        "$docs/how-to/identify.md")
        cp examples/measurements/rig_static_shift.csv examples/measurements/rig_indentation.csv .
        tricontact identify my_data.toml
        test -s results/my_data/report.html"
}
# Of Debian's SLURM one machine that is all of a cluster.
start_queue() {
    fetch --no-install-recommends slurmctld slurmd slurm-client munge
    cat >"$root/etc/slurm/slurm.conf" <<CONF
ClusterName=stranger
SlurmctldHost=$(hostname)
SlurmUser=root
StateSaveLocation=/var/lib/slurm/slurmctld
SlurmdSpoolDir=/var/lib/slurm/slurmd
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
ReturnToService=2
NodeName=$(hostname) CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
CONF
    printf '127.0.0.1 localhost %s\n' "$(hostname)" >"$root/etc/hosts"
}
task_queue() {
    start_queue
    as_user "cat >study.toml <<'END'
case = \"examples/cases/rig_sphere_parallel.toml\"
models = [\"mdr\"]
[set]
rolling.steps = \"turning-points\"
[vary]
load.tangential_ratio = [0.1, 0.2, 0.3, 0.4]
rolling.amplitude_ratio = [0.1, 0.2, 0.3, 0.4]
END
$(awk '/^## On a cluster/ { there = 1 } there && /^```sh/ { on = 1; print "cat >job.sh <<\47END\47"; next } on && /^```/ { print "END"; exit } on' \
        "$docs/how-to/sweeps.md" | sed "s/--cpus-per-task=4/--cpus-per-task=1/")" # a machine of two cores
    # The daemons end with the space of processes of this command; slurmd asks /sys for cores.
    unshare --pid --fork --mount bash -c 'mount -t proc proc "$0/proc" && mount --rbind /sys "$0/sys" && exec chroot "$0" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin \
        bash -euo pipefail -c "
        mkdir -p /run/munge /var/lib/slurm/slurmctld /var/lib/slurm/slurmd; chown munge: /run/munge
        runuser -u munge -- munged --force
        slurmctld; slurmd; sleep 2
        cd /home/stranger
        timeout 300 runuser -u stranger -- sbatch --wait job.sh
        cat slurm-*.out"' "$root"
    as_user "$(awk '/^## On a cluster/ { there = 1 } there && /^```sh/ { n++; on = (n == 2); next } /^```/ { on = 0 } on' "$docs/how-to/sweeps.md")
        test \$(wc -l <results/study/results.csv) -eq 17"
}
task_paraview() {
    fetch paraview xvfb xauth
    as_user "tricontact run examples/cases/rig_sphere_layer_all.toml --models mdr-layer,bem-layer
        $(blocks how-to/paraview.md '## Pictures' '## Models over each other' | grep '^xvfb-run')
        ls pictures/*.png"
}
task_notebook() {
    fetch jupyter-notebook jupyter-nbconvert python3-matplotlib python3-xarray
    as_user "$(blocks how-to/python.md '## Labels, plots, notebooks' '## Studies')
        grep -c 'data:image/png' my_notebook.html"
}
task_cite() {
    as_user "grep -A3 -i 'cite' /usr/share/doc/tricontact/README.md
        cat /usr/share/doc/tricontact/CITATION.cff
        tricontact rig my_rig.toml --export paper >rig.txt
        grep -A12 -i tricontact paper/references.bib"
}
task_fault() {
    as_user "$(blocks how-to/report-a-fault.md '# Report a fault' '')
        grep -q tricontact fault.txt; dpkg --status tricontact; cat /etc/debian_version"
}
task_wheel() {
    root=$folder/wheel
    bare_copy "$folder/debian" "$root"
    cp "$WHEEL" "$root/root"
    awk '/^```toml/ { on = 1; next } on && /^```/ { exit } on' "$docs/../README.md" >"$root/root/case.toml"
    as_root "apt-get update
        $(blocks how-to/python.md '# Python' '## A case' | sed '1,/wheel$/d; s/apt-get install/apt-get -y install/')
        my_env/bin/tricontact run case.toml --quiet
        my_env/bin/python -c 'import tricontact; print(tricontact.run(\"case.toml\", models=[\"mdr\"], studies=False))'"
}

all=(install run rig code data queue paraview notebook cite fault)
[ -z "${WHEEL:-}" ] || all+=(wheel)
[ $# -gt 0 ] || set -- "${all[@]}"
if [[ " $* " == *" install "* ]]; then
    bare_debian "$folder/debian"
    bare_copy "$folder/debian" "$root"
    cp "$package" "$root/root/tricontact_0.2.0_amd64.deb"
    inside "$root" useradd --create-home --shell /bin/bash stranger
fi

failed=0
printf '| Task | Time | Result |\n|---|---|---|\n' >"$folder/ten_tasks.md"
for name in "$@"; do
    begun=$EPOCHREALTIME
    result=done
    # As a process of its own: of a function before || the shell would ignore commands that fail.
    (set -e; "task_$name") >"$folder/$name.log" 2>&1 &
    wait $! || { result=failed; failed=$((failed + 1)); tail -n 5 "$folder/$name.log"; }
    printf '| %s | %.1f min | %s |\n' "$name" "$(awk "BEGIN { print ($EPOCHREALTIME - $begun) / 60 }")" "$result" |
        tee -a "$folder/ten_tasks.md"
done
printf '%d of %d tasks failed\n' "$failed" $#
exit $((failed > 0))
