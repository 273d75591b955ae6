#!/usr/bin/env bash
# What tricontact rig estimates of finite strains beside runs of the model, on a rig of the thesis and on
# one that the fit has not seen; beyond its range it gives none.
# usage: rig_finite_strain.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
rig=$source_dir/examples/rigs/sphere_parallel.toml

# layer R [mm] b [mm] E [MPa] F_N [N] MU SIZE [mm]: writes rig.toml, case.toml
layer() {
    sed -e "s/radius = \"40 mm\"/radius = \"$1 mm\"/; s/thickness = .*/thickness = \"$2 mm\"/" \
        -e "s/young = \"5.2 MPa\"/young = \"$3 MPa\"/; s/normal_force = .*/normal_force = \"$4 N\"/" \
        -e "s/coefficient = .*/coefficient = $5/; /^\[printed\]/,\$d" "$rig" >rig.toml
    cat >case.toml <<END
models = ["fem"]
[indenter]
radius = "$1 mm"
[substrate]
young = "$3 MPa"
poisson = 0.5
thickness = "$2 mm"
[friction]
coefficient = $5
[load]
normal_force = "$4 N"
tangential_ratio = 0.56
press_steps = 10
[fem]
size = "$6 mm"
growth = 3
cache = "none"
[output]
vtk = "none"
END
}

# run LAW: the case by it.
run() {
    "$program" run case.toml --no-studies --no-report --quiet --set "substrate.material=$1" --output "$1" >out 2>&1 ||
        complain "$1: $(cat out)"
}

# compare: estimates of rig.toml and runs of case.toml within three standard errors and what the mesh leaves.
compare() {
    "$program" rig rig.toml --output rig >rig.txt || complain "rig: $(cat rig.txt)"
    run linear
    run neo-hookean
    "$python" - <<'END' || complain "estimate and runs differ"
import json
import sys

def model(law):
    with open(law + "/summary.json", encoding="utf-8") as file:
        models = json.load(file)["models"]
    return models[0] if isinstance(models, list) else models["fem"]

with open("rig/rig.json", encoding="utf-8") as file:
    small = [one for one in json.load(file)["assumptions"] if one["name"] == "small_strains"][0]
linear, finite = model("linear"), model("neo-hookean")
good = True
for criterion, key, mesh in zip(small["criteria"], ("static_shift_m", "indentation_m"), (1.5e-3, 3e-4)):
    run = abs(linear[key] / finite[key] - 1)
    estimate = criterion["result"]
    off = abs(estimate["value"] - run)
    if off > 2 * estimate["standard_error"] + mesh:
        print(f"{criterion['name']}: {estimate['value']:.5f}, the model {run:.5f}")
        good = False
sys.exit(not good or len(small["criteria"]) != 2)
END
}

layer 40 8 5.2 21.1 0.57 0.87
compare
grep -q '^holds: The substrate.s strains are small' rig.txt || complain "thesis: $(grep -A4 small rig.txt)"
grep -qE 'linear elasticity puts the static shift at F_T = 0\.56 mu F_N \(?1\.7[0-9]? ± 0\.[0-9]+\)? % too high' rig.txt ||
    complain "thesis: $(grep neo-Hookean rig.txt)"

layer 25 12 3 10 0.4 0.72
compare

# Thinner than what was computed: no number, no sentence.
layer 40 3 5.2 21.1 0.57 0.87
"$program" rig rig.toml --output thin >thin.txt || complain "thin: $(cat thin.txt)"
grep -q 'linear elasticity puts' thin.txt && complain "a sentence beyond the fit: $(cat thin.txt)"
grep -q '^not testable: The substrate.s strains are small' thin.txt || complain "thin: $(cat thin.txt)"
grep -q 'not given: an estimate for a/b = 1\.' thin.txt || complain "thin: $(cat thin.txt)"

finish
