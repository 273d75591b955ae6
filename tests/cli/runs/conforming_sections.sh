#!/usr/bin/env bash
# fem-plane: pins in holes beside Persson's closed form and an independent program; refusals.
# usage: conforming_sections.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../summaries.bash"

# A clearance of R/10^4: the closed forms are those of a small one. The plate is as good as unbounded.
cat >pin.toml <<'TOML'
title = "pin"
models = ["fem-plane"]
[indenter]
shape = "cylinder"
radius = "10 mm"
length = "100 mm"
young = "2 MPa"
poisson = 0.3
body = "pin"
support = "hub"
hub_radius = "0.2 mm"
[substrate]
shape = "hole"
hole_radius = "10.001 mm"
outer_radius = "1 m"
young = "2 MPa"
poisson = 0.3
[friction]
coefficient = 0.2
[load]
normal_force = "1 N"
tangential_ratio = 0
[output]
vtk = "none"
TOML
run() { # OUTPUT ARGUMENTS...
    local output=$1
    shift
    "$program" run "$@" --quiet --no-studies --no-report --output "$output" || complain "$*: does not run"
}
# expect OUTPUT DEGREES [PEAK]: the half angle of Persson (1964) and of Ciavarella and Decuzzi (2001), a fifth of the
# distance of nodes, and R p0/Q, which hub and plate change by less than 1e-3.
expect() {
    local summary=$1/summary.json
    near "$(awk -v a="$(value fem-plane contact_half_angle_rad "$summary")" 'BEGIN { print a * 45 / atan2(1, 1) }')" "$2" \
        8e-3 "angle of $1"
    [ $# -lt 3 ] || near "$(value fem-plane conforming_peak_ratio "$summary")" "$3" 1e-3 "peak of $1"
}

# 1. F_N = E* DR L/(E* DR/Q). Equal materials.
run thirty pin.toml --set "load.normal_force = 0.0276677 N"
expect thirty 30 1.260289
near "$(value fem-plane clearance_ratio thirty/summary.json)" 7.94354 1e-5 "clearance of thirty"
run sixty pin.toml --set "load.normal_force = 0.205939 N"
expect sixty 60 .711721
# A rigid pin; a pin in a rigid hole; a pin of half the modulus of its plate.
grep -v -E '^(body|support|hub_radius)' pin.toml | awk '/^\[/ { section = $0 } !(section == "[indenter]" && /^(young|poisson)/)' >rigid_pin.toml
run rigid_pin rigid_pin.toml --set "load.normal_force = 0.411635 N"
expect rigid_pin 60 .705526
run unlike pin.toml --set indenter.poisson=0.495 --set substrate.poisson=0.495 --set "substrate.young=4 MPa" \
    --set "load.normal_force = 0.0439106 N"
expect unlike 30 1.26029

grep -v -E '^outer' pin.toml | awk '/^\[/ { section = $0 } !(section == "[substrate]" && /^(young|poisson)/)' |
    sed 's/^shape = "hole"/&\nrigid = true/' >rigid_hole.toml
run rigid_hole rigid_hole.toml --set "load.normal_force = 0.413194 N"
expect rigid_hole 60

# 2. A pin on a hub of R/5 in a plate of 10 R, both held: force and R p0/Q by the depth beyond the clearance of an
# independent program, in units of N, m.
finite=(--set "indenter.hub_radius=2 mm" --set "substrate.outer_radius=100.01 mm")
while read -r depth force peak; do
    run "depth_$depth" pin.toml "${finite[@]}" --set "load.indentation=$depth um"
    near "$(value fem-plane normal_force_N "depth_$depth/summary.json")" "$force" 1e-3 "force of $depth"
    near "$(value fem-plane conforming_peak_ratio "depth_$depth/summary.json")" "$peak" 2e-3 "peak of $depth"
done <<'END'
0.4 0.033034 1.1884
1 0.100006 0.8379
2 0.22243 0.7147
4 0.47538 0.6559
END

# 3. Refused by name, nothing written.
refuses() { refused "$1" run "$work/pin.toml" --output out "${@:2}"; }
refuses "substrate.hole_radius" --set "substrate.hole_radius=10 mm"
refuses "a clearance above 0.1" --set "substrate.hole_radius=11.5 mm"
refuses "substrate.outer_radius" --set "substrate.outer_radius=10 mm"
refuses "substrate.thickness" --set "substrate.thickness=8 mm"
refuses "has a flat substrate" --set 'models=["bem"]'
refuses "has a flat substrate" --set 'models=["fem-axisymmetric"]'
refuses "load.tangential_ratio" --set load.tangential_ratio=0.3
refuses "rolling.amplitude" --set "rolling.amplitude=0.1 mm"
refuses "Coulomb's friction alone in a hole" --set contact.coupling=true --set "friction.strength_limit=1 MPa"
refuses "load.tangential_ratio" --set contact.coupling=true --set load.tangential_ratio=0.3
refuses "a hole along y takes a cylinder" --set indenter.shape=roller
refuses "take body = \"pin\"" --set indenter.body=cylinder
refused "the formulas of rigs" rig "$work/rigid_pin.toml" --output out
refuses "the substrate has no hole" --set substrate.shape=layer --set "substrate.thickness=8 mm"
finish
