#!/usr/bin/env bash
# friction.map: friction that varies over the substrate. Refusals, tables, a run beside its mirror image.
# usage: friction_map.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../summaries.bash"

cat >case.toml <<'TOML'
title = "stripes"
models = ["bem-layer"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.5
thickness = "8 mm"
[friction]
coefficient = 0.5
map = "stripes.csv"
[load]
normal_force = "20 N"
tangential_ratio = 0.3
[rolling]
amplitude_ratio = 0.15
periods = 4
steps = "turning-points"
[bem]
cells_per_radius = 12
TOML
printf 'x [mm], factor\n-20, 0.4\n-0.5, 0.4\n0.5, 1.2\n20, 1.2\n' >stripes.csv
printf 'x [mm], factor\n-20, 1.2\n-0.5, 1.2\n0.5, 0.4\n20, 0.4\n' >mirrored.csv
printf 'x [mm], factor\n-20, 1\n20, 1\n' >same.csv
{ echo 'y [mm], x [mm], factor'; for y in 20 -20; do for x in 20 -20; do echo "$y, $x, 1"; done; done; } >same_in_plane.csv

# 1. Without coupling the limit does not ask on which side the rougher half lies: the path is
# symmetric. A map of ones is no map: both solve to 1e-7.
"$program" run case.toml --set "friction.map=stripes.csv" --quiet --no-studies --output stripes || complain "stripes does not run"
for name in same same_in_plane; do
    "$program" run case.toml --set "friction.map=$name.csv" --quiet --no-studies --no-report --output "$name" ||
        complain "$name does not run"
done
grep -v '^map' case.toml >plain.toml
"$program" run plain.toml --quiet --no-studies --no-report --output plain || complain "the plain case does not run"
for name in stripes mirrored; do
    "$program" run case.toml --set "friction.map=$name.csv" --set contact.coupling=false --quiet --no-studies --no-report \
        --output "$name-uncoupled"
done
near "$(value bem-layer limit_tangential_ratio stripes-uncoupled/summary.json)" \
    "$(value bem-layer limit_tangential_ratio mirrored-uncoupled/summary.json)" 1e-9 "limit of the mirror image"
for name in same same_in_plane; do
    near "$(value bem-layer settled_shift_m $name/summary.json)" "$(value bem-layer settled_shift_m plain/summary.json)" \
        1e-5 "$name"
done
awk -v a="$(value bem-layer static_shift_m stripes/summary.json)" -v b="$(value bem-layer static_shift_m plain/summary.json)" \
    'BEGIN { exit !(a > 1.005 * b || a < 0.995 * b) }' || complain "stripes change no shift"
grep -q "times a map" stripes/report.html || complain "the page does not say the map"
if has_fem; then
    "$program" run case.toml --models fem --set "fem.size=1.5 mm" --quiet --no-studies --no-report --output fem || complain "fem does not run"
    near "$(value fem static_shift_m fem/summary.json)" "$(value bem-layer static_shift_m stripes/summary.json)" 0.03 \
        "fem, three elements in the radius"
fi

# 2. Refused by name.
refuses() { # WORDS COMMAND...
    local words=$1
    shift
    "$program" "$@" >said.txt 2>&1
    [ $? = 2 ] || complain "$*: not refused"
    grep -q -- "$words" said.txt || complain "$*: $(cat said.txt)"
}
refuses "friction.map.*springs of mdr stand" run case.toml --models mdr --output no
refuses "friction.map.*springs of mdr-layer" run case.toml --models mdr-layer --output no
refuses "friction.map.*finite strains" run case.toml --models fem --set substrate.material=neo-hookean --output no
refuses "presumes Coulomb" deviation case.toml --output no
printf 'x [mm], factor\n-1, 1\n1, 1\n' >short.csv
refuses "friction.map: the contact reaches x" run case.toml --set friction.map=short.csv --output no
printf 'x [mm], factor\n-9, 1\n9, -1\n' >negative.csv
refuses "nothing less than zero" check case.toml --set friction.map=negative.csv
printf 'x [mm], y [mm], factor\n-9, 0, 1\n9, 1, 1\n' >holes.csv
refuses "form no grid" check case.toml --set friction.map=holes.csv
printf 'x [mm], factor\n-9, 1\n-9, 1\n9, 1\n' >twice.csv
refuses "stands above" check case.toml --set friction.map=twice.csv
refuses "friction.map.*none.csv" check case.toml --set friction.map=none.csv
[ -e no ] && complain "a refused command has written"
finish
