#!/usr/bin/env bash
# Cases of bodies other than the sphere: what check says of them, and that they run.
# usage: bodies.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# derived CASE NAME VALUE: check derives the value (SI), to five digits.
derived() {
    "$program" check "$source_dir/examples/cases/$1.toml" --json | "$python" -S -c '
import json, sys
value = json.load(sys.stdin)["derived"][sys.argv[1]]["value"]
sys.exit(abs(value / float(sys.argv[2]) - 1) > 2e-5)' "$2" "$3" || complain "$1: $2 is not $3"
}
# 1. The cone by hand: E* = 5.2/0.75 MPa, a^2 = 2 F_N/(pi E* tan 8 deg), d = pi/2 a tan 8 deg,
#    U_max = 3/2 mu d, f_T,lim = (1 - 0.24)^2.
derived body_cone a 3.71286e-3
derived body_cone d 0.819656e-3
derived body_cone U_max 0.700806e-3
derived body_cone f_T,lim 0.5776

# 2. An ellipse is a stretched circle: w = 0.24 over the mean half axis, more over the short one.
limit=$("$program" check "$source_dir/examples/cases/body_ellipsoid.toml" | awk '$2 == "f_T,lim" { print $4 }')
awk -v f="$limit" 'BEGIN { exit !(f > 0.3 && f < 0.646) }' || complain "limit $limit of the ellipse"

# 3. Every case runs, its report names the body.
# Of two, reports take longer than the run: numbers alone.
body() { # NAME MODEL OPTIONS...
    local name=$1 model=$2
    shift 2
    "$program" run "$source_dir/examples/cases/body_$name.toml" --models "$model" --set mdr.springs=1000 \
        --set bem.cells_per_radius=4 --set rolling.steps=turning-points --set rolling.periods=2 \
        --no-studies --quiet --output "$name" "$@" >/dev/null || complain "$name does not run"
}
body power_law mdr --no-report
body profile mdr --no-report
body cone mdr
body rounded_punch mdr
body ellipsoid bem
grep -q "flat punch with rounded edge" rounded_punch/report.html || complain "no punch in its report"
grep -q "half axes" ellipsoid/report.html || complain "no half axes in the ellipse's report"
grep -q "mean pressure" cone/report.html || complain "no mean pressure in the cone's report"

# 4. What is about spheres only refuses.
code=0
"$program" deviation "$source_dir/examples/cases/body_cone.toml" --set "substrate.thickness=8 mm" \
    2>message >/dev/null || code=$?
[ "$code" -eq 2 ] && grep -q "indenter.shape: deviations are those from Hertz" message ||
    complain "deviation of a cone: $code $(cat message)"

# 5. A point of a sweep is found again, unless the table of its profile has changed.
cp "$source_dir"/examples/cases/body_profile.* .
cat >study.toml <<EOF
case = "body_profile.toml"
models = ["mdr"]
[set]
mdr.springs = 1000
rolling.periods = 2
[vary]
load.tangential_ratio = [0.1]
EOF
swept() { "$program" sweep study.toml --output swept --no-report 2>&1; }
swept >/dev/null
[[ $(swept) == *"1 of 1 points are there already"* ]] || complain "a point is computed again"
before=$(column indentation_m swept/results.csv)
sed -i 's/^10, 1200, 0$/10, 1300, 0/; s/^3, 62.5, 0$/3, 70, 0/' body_profile.csv
[[ $(swept) != *"are there already"* ]] || complain "a changed profile is not noticed"
[ "$(column indentation_m swept/results.csv)" != "$before" ] || complain "results of the old profile"

finish
