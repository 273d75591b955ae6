#!/usr/bin/env bash
# tricontact fit: MDR's kappa from a sweep, files and groups; a sweep that is missing or not finished,
# and cases without kappa, are refused and nothing is written.
# Under a shear strength likewise, with 4/pi.
# usage: fit.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# study FILE CASE LINES...: lines standing behind [vary].
study() {
    local file=$1 case=$2
    shift 2
    cat >"$file" <<END
case = "$case"
models = ["mdr"]
[set]
rolling.steps = "turning-points"
rolling.periods = 100
[vary]
END
    printf '%s\n' "$@" >>"$file"
}
# refused TEXT ARGUMENTS...: exit code 2, one line of error with the text.
refused() {
    local text=$1 code
    shift
    "$program" "$@" >out 2>err
    code=$?
    [ "$code" -eq 2 ] || complain "$*: exit code $code"
    [ "$(wc -l <err)" -eq 1 ] && grep -qF -- "$text" err || complain "$*: $(cat err)"
}
rig=$source_dir/examples/cases/rig_sphere_parallel.toml

# 1. MDR with 10000 springs: kappa is 3/2 to 1e-6, whatever the direction.
study a.toml "$rig" 'rolling.amplitude_ratio = [0.2, 0.4]' 'load.tangential_ratio = [0.1, 0.2, 0.3]' \
    'rolling.angle = ["0 deg", "90 deg"]'
refused "compute the study first: tricontact sweep a.toml --output a" fit a.toml --output a
[ ! -e a ] || complain "a folder for nothing"
"$program" sweep a.toml --output a --quiet || complain "the sweep"
"$program" fit a.toml --output a --quiet || complain "the fit"
[ "$(cut -d, -f1,2 a/fits.csv | sort -u | tr '\n' ' ')" = \
    "mdr,parallel mdr,perpendicular model,group " ] || complain "groups: $(cat a/fits.csv)"
awk -F, '$4 == "kappa" { n++; if (($5 - 1.5)^2 > 1e-12) bad = 1 } END { exit bad || n != 2 }' \
    a/fits.csv || complain "kappa: $(cat a/fits.csv)"
[ -s a/fit.json ] || complain "no fit.json"
grep -q figure_3_16 a/fit.html || complain "the report lacks a figure"

# 2. A study with more points than have been computed.
study b.toml "$rig" 'rolling.amplitude_ratio = [0.2, 0.5]' 'load.tangential_ratio = [0.1, 0.2, 0.3]'
refused "3 of 6 points of b.toml have not been computed" fit b.toml --output a

# 3. What has no kappa.
study c.toml "$rig" 'load.tangential_ratio = [0.1, 0.2]'
sed -i 's/rolling.steps = "turning-points"/load.normal_amplitude_ratio = 0.1/' c.toml
refused "under constant loads" fit c.toml --output a
refused "confidence" fit a.toml --output a --confidence 2

# 4. Under a shear strength MDR's kappa is 4/pi, whatever the direction, and nothing of the thesis is said.
silicone=$source_dir/examples/cases/shear_strength_rolled.toml
study d.toml "$silicone" 'rolling.amplitude_ratio = [0.2, 0.4]' 'load.tangential_ratio = [0.1, 0.2, 0.3]' \
    'rolling.angle = ["0 deg", "90 deg"]'
"$program" sweep d.toml --output d --quiet --no-report || complain "the sweep under a strength"
"$program" fit d.toml --output d --quiet || complain "the fit under a strength"
awk -F, '$4 == "kappa" { n++; if (($5 - 1.2732395447)^2 > 1e-10) bad = 1 } END { exit bad || n != 2 }' \
    d/fits.csv || complain "kappa of a strength: $(cat d/fits.csv)"
! grep -qE "figure_3_16|the thesis’ κ|Figures of the thesis" d/fit.html || complain "the thesis under a strength"
study e.toml "$silicone" 'load.tangential_ratio = [0.1, 0.2]'
sed -i 's/^rolling.steps = .*/friction.coefficient = 0.4/' e.toml
refused "kappa and eta presume Coulomb's law, tau = mu p, or a shear strength, tau = tau_0, and the case has" fit e.toml --output d

finish
