#!/usr/bin/env bash
# fem-plane and fem-axisymmetric: two bodies that deform beside closed forms, numbers of an independent program and
# fem; refusals.
# usage: fem_sections.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../summaries.bash"

cat >hemisphere.toml <<'TOML'
title = "hemisphere"
models = ["fem-axisymmetric"]
[indenter]
shape = "sphere"
radius = "10 mm"
young = "2 MPa"
poisson = 0.3
body = "hemisphere"
support = "holder"
[substrate]
rigid = true
[friction]
coefficient = 0.5
[contact]
coupling = false
[load]
indentation = "1 mm"
tangential_ratio = 0
[output]
vtk = "none"
TOML
run() { # OUTPUT ARGUMENTS...
    local output=$1
    shift
    "$program" run "$@" --quiet --no-studies --no-report --output "$output" || complain "$*: does not run"
}

# 1. By default the force errs by less than 5e-4, radius and peak pressure by less than 3e-3. Numbers of an
# independent program, four digits: N, m, Pa.
expect() { # MODEL OUTPUT FORCE RADIUS PEAK
    near "$(value "$1" normal_force_N "$2/summary.json")" "$3" 5e-4 "force of $2"
    near "$(value "$1" contact_radius_m "$2/summary.json")" "$4" 3e-3 "radius of $2"
    near "$(value "$1" peak_pressure_Pa "$2/summary.json")" "$5" 3e-3 "peak of $2"
}
run holder hemisphere.toml
expect fem-axisymmetric holder 12.0063 3.3867e-3 489000
on_layer=(--set substrate.rigid=false --set "substrate.young=4 MPa" --set substrate.poisson=0.3
    --set "substrate.thickness=5 mm")
run layer hemisphere.toml "${on_layer[@]}"
expect fem-axisymmetric layer 8.9953 3.4774e-3 348730
run plates hemisphere.toml --set indenter.body=ball --set indenter.support=plates
expect fem-axisymmetric plates 11.2588 3.3257e-3 475910

# 2. A cylinder between plates: Johnson (1985), 5.57, the approach of one plate, P (2 ln(4 R/a) - 1)/(pi E*) with
# a = R/20; within (a/R)^2/10.
cat >cylinder.toml <<'TOML'
title = "cylinder"
models = ["fem-plane"]
[indenter]
shape = "cylinder"
radius = "10 mm"
length = "80 mm"
young = "2 MPa"
poisson = 0.3
body = "cylinder"
support = "plates"
[substrate]
rigid = true
[friction]
coefficient = 0.5
[load]
normal_force = "3.4523 N"
tangential_ratio = 0
[output]
vtk = "none"
TOML
run between cylinder.toml
near "$(value fem-plane contact_radius_m between/summary.json)" 5e-4 3e-3 "half width between plates"
near "$(value fem-plane indentation_m between/summary.json)" 4.852533e-5 4e-4 "approach of a plate"

# 3. A rigid cylinder on a layer, pulled and rolled: as by boundary elements of the exact layer.
cat >rolled.toml <<'TOML'
title = "rolled"
models = ["fem-plane", "bem-layer"]
[indenter]
shape = "cylinder"
radius = "40 mm"
length = "100 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.45
thickness = "8 mm"
[friction]
coefficient = 0.57
[load]
normal_force = "50 N"
tangential_ratio = 0.3
[rolling]
amplitude_ratio = 0.3
periods = 2
[bem]
cells_per_radius = 30
[output]
vtk = "none"
TOML
run rolled rolled.toml
for key in indentation_m unit_shift_m static_shift_m final_shift_m limit_tangential_ratio; do
    near "$(value fem-plane $key rolled/summary.json)" "$(value bem-layer $key rolled/summary.json)" 2e-3 "$key of fem-plane"
done

# 4. A cover on its hub rolls on a layer of its own material: half-spaces that do not couple have the same limit, and
# settle as far beyond the static shift as finite bodies do within a tenth; fem has the numbers of its section.
cover=(--set "indenter.young=5.2 MPa" --set indenter.poisson=0.45 --set indenter.body=cylinder --set indenter.support=hub
    --set "indenter.hub_radius=12 mm" --set "substrate.thickness=28 mm" --set "fem.size=0.35 mm")
run cover rolled.toml "${cover[@]}" --set 'models=["fem-plane", "bem-layer", "fem"]' --set fem.cache=none
of_cover() { value "$1" "$2" cover/summary.json; }
settling() { $python -c "print($(of_cover "$1" final_shift_m) - $(of_cover "$1" static_shift_m))"; }
near "$(of_cover fem-plane limit_tangential_ratio)" "$(of_cover bem-layer limit_tangential_ratio)" 3e-3 "limit of a cover"
near "$(settling fem-plane)" "$(settling bem-layer)" .1 "settling of a cover"
near "$(of_cover fem limit_tangential_ratio)" "$(of_cover fem-plane limit_tangential_ratio)" 1e-3 "limit of fem"
near "$(of_cover fem final_shift_m)" "$(of_cover fem-plane final_shift_m)" 1e-2 "shift of fem"
near "$(settling fem)" "$(settling fem-plane)" 1e-2 "settling of fem"
# On a layer that relaxes too: twice as stiff at once.
relaxing=(--set 'substrate.relaxation.relative_moduli=[0.5]' --set 'substrate.relaxation.times=["20 ms"]' --set "rolling.speed=10 mm/s")
run relaxing rolled.toml "${cover[@]}" "${relaxing[@]}"
near "$(value fem-plane limit_tangential_ratio relaxing/summary.json)" "$(value bem-layer limit_tangential_ratio relaxing/summary.json)" \
    3e-3 "limit on a layer that relaxes"

# 5. Refused by name, nothing written.
refuses() { refused "$1" run "$work/$2" --output out "${@:3}"; }
refuses "load.tangential_ratio" hemisphere.toml --set load.tangential_ratio=0.3
refuses "substrate.thickness" hemisphere.toml --set substrate.rigid=false --set "substrate.young=4 MPa" \
    --set substrate.poisson=0.3
refuses "is about bodies of revolution" cylinder.toml --set 'models=["fem-axisymmetric"]'
refuses "is about cylinders" hemisphere.toml --set 'models=["fem-plane"]'
refuses "load.tangential_ratio" cylinder.toml --set load.tangential_ratio=0.3
refuses "too large for the indenter's body" hemisphere.toml --set indenter.shape=rounded-punch --set "indenter.radius=1 mm" \
    --set "indenter.flat_radius=2 mm" --set indenter.body=punch --set "indenter.height=10 mm" --set "load.indentation=4 mm"
refuses "fewer than 2 elements" hemisphere.toml --set "fem.size=3 mm"
refuses "about its hub by no more than 115 degrees" rolled.toml "${cover[@]}" --set "rolling.amplitude=85 mm"
refuses "takes no [rolling]" cylinder.toml --set rolling.amplitude_ratio=0.3
refuses "fem.mesh" hemisphere.toml --set fem.mesh=none.msh
refused "fem.size" refine "$work/hemisphere.toml" --models fem-axisymmetric --output out
finish
