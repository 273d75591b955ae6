#!/usr/bin/env bash
# tricontact run where the substrate relaxes, where the bodies are unlike, and on a layer: numbers
# beside their closed forms.
# usage: roll_relaxing.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# roll CASE ARGUMENTS...: its summary is summary.json.
roll() {
    local file=$source_dir/examples/cases/$1.toml
    shift
    "$program" run "$file" --points 0 --threads 1 --no-report --quiet --output out \
        --set output.vtk='"none"' "$@" >/dev/null || complain "failed: $file $*"
    cp out/summary.json .
}
# expect CONDITION: in Python, of the summary s, the first model's steady state m and its resistance
# over the normal force w; theory(list, name) is the entry of a theory.
expect() {
    "$python" -S -c "
import json
s = json.load(open('summary.json'))
m = s['models'][0]['steady']
w = m['resistance_N'] / m['normal_force_N']
theory = lambda entries, name: next(e for e in s[entries] if e['theory'] == name)
assert $1, m" || complain "$1"
}

# Hunter: the grid's error at 10 cells in the half length.
roll rolling_relaxing --set bem.cells_per_radius=10 --set tractive_rolling.distance=2
expect "abs(w / theory('resistances', 'hunter')['resistance_ratio'] - 1) < 0.01"
expect "m['material_dissipation_J_per_m'] > 0.9 * m['resistance_N'] and m['energy_error'] < 0.05"

# Springs: first order in their distance.
relaxing_sphere=(--set 'substrate.relaxation.G2="3.5 MPa"' --set 'substrate.relaxation.eta="0.35 MPa s"'
    --set 'tractive_rolling.speed="20 mm/s"' --set tractive_rolling.distance=2)
error="w / theory('resistances', 'mdr_closed_form')['resistance_ratio'] - 1"
roll rolling_sphere "${relaxing_sphere[@]}" --models mdr --set mdr.springs=1000
expect "-0.003 < $error < -0.002"
roll rolling_sphere "${relaxing_sphere[@]}" --models mdr --set mdr.springs=2000
expect "-0.0013 < $error < -0.0009"

# Aluminium on steel, between both limits of friction.
roll rolling_dissimilar --set bem.cells_per_radius=20 --set tractive_rolling.distance=1
bound="theory('free_creepages', 'bentall_johnson_%s')['longitudinal_creepage']"
expect "${bound/\%s/smooth} < m['longitudinal_creepage'] < ${bound/\%s/rough}"

# A bonded layer creeps by itself, an incompressible half-space does not.
free=(--set bem.cells_per_radius=6 --set load.tangential_ratio=0 --set tractive_rolling.distance=1
    --set 'substrate.thickness="8 mm"')
roll rolling_sphere "${free[@]}" --models bem-layer
expect "abs(m['longitudinal_creepage'] / s['creepage_unit']) > 0.01"
roll rolling_sphere "${free[@]}" --models bem
expect "abs(m['longitudinal_creepage'] / s['creepage_unit']) < 1e-6"

finish
