#!/usr/bin/env bash
# Rig checks of bodies that are neither sphere nor cylinder: a power law of exponent 2 is the paraboloid, whose theories
# are exact; a cone on a half-space has d = pi/2 a tan(angle) (Love 1939, Sneddon 1948).
# usage: rig_bodies.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# rig NAME INDENTER...: a check of the body, in the folder NAME.
rig() {
    local name=$1
    shift
    {
        printf 'models = ["bem-layer"]\n[indenter]\n'
        printf '%s\n' "$@"
        cat <<'END'
[substrate]
young = "3 MPa"
poisson = 0.5
thickness = "7 mm"
[friction]
coefficient = 0.6
[load]
normal_force = "8 N"
tangential_ratio = 0.4
[rolling]
amplitude_ratio = 0.2
speed = "1 mm/s"
[rig]
eigenfrequency = "22 Hz"
density = "1100 kg/m^3"
work_of_adhesion = "1 J/m2"
END
    } >"$name.toml"
    "$program" rig "$name.toml" --output "$name" >"$name.txt" 2>err || complain "$name: $(cat err)"
}
rig paraboloid 'shape = "paraboloid"' 'radius = "30 mm"'
rig power_law 'shape = "power-law"' 'radius = "30 mm"' 'exponent = 2'
rig cone 'shape = "cone"' 'angle = "8 deg"'
rig ellipsoid 'shape = "ellipsoid"' 'radius = "40 mm"' 'radius_y = "20 mm"'
"$python" - <<'END' || complain "the numbers of bodies"
import json, math
def numbers(name):
    found = {}
    for assumption in json.load(open(name + "/rig.json"))["assumptions"]:
        for one in assumption["criteria"] + assumption["background"]:
            found[one["name"]] = one["result"]
    return found
exact, body = numbers("paraboloid"), numbers("power_law")
# Boundary elements on the default cells: to their own error bars of two standard errors, and 1e-4 for those of the theory.
for name in ("indentation", "layer_indentation", "contact_radius", "layer_contact_radius", "coupling_effect"):
    reach = 2 * body[name]["standard_error"] + 1e-4 * exact[name]["value"]
    if name == "coupling_effect": reach = 1e-3
    assert abs(body[name]["value"] - exact[name]["value"]) < reach, (name, body[name], exact[name])
cone = numbers("cone")
a, d = cone["contact_radius"], cone["indentation"]
expected = math.pi / 2 * a["value"] * math.tan(math.radians(8))
reach = 2 * (d["standard_error"] + a["standard_error"] * math.pi / 2 * math.tan(math.radians(8)))
assert abs(d["value"] - expected) < reach, (d, expected, reach)
# Adhesion: runs of springs beside the closed forms of a paraboloid, and a cone's pull-off (Maugis and Barquins 1981).
for name in ("pull_off_ratio", "adhesive_radius_change", "layer_pull_off_ratio", "layer_adhesive_radius_change"):
    assert abs(body[name]["value"] / exact[name]["value"] - 1) < 1e-3, (name, body[name], exact[name])
expected = 54 / (math.pi * math.tan(math.radians(8)) ** 3 * 4e6) / 8
assert abs(cone["pull_off_ratio"]["value"] / expected - 1) < 1e-4, (cone["pull_off_ratio"], expected)
assert "pull_off_ratio" not in numbers("ellipsoid")
assert "peak_pressure" not in cone and "peak_pressure" in body    # infinite under the tip
effects = {(e["assumption"], e["measured"]): e["relative"] for e in json.load(open("ellipsoid/rig.json"))["effects"]}
assert effects[("half_space", "indentation")] > .05, effects
END
# What is said of spheres alone is not said of others.
for claim in "Hertz" "pivot"; do
    ! grep -q "$claim" cone.txt || complain "'$claim' of a cone: $(grep "$claim" cone.txt)"
done
grep -A 3 '^not testable: The surfaces do not attract' ellipsoid.txt | grep -q 'not computed: .*body of revolution' ||
    complain "adhesion of an ellipsoid: $(grep -A 3 'do not attract' ellipsoid.txt)"

# A soft ball is judged by the body that it is; one whose body is not stated by the names of what is missing; a rigid one not.
if "$program" list | grep -q '^  fem-axisymmetric '; then
    cat >soft.toml <<'END'
models = ["bem-layer"]
indenter = {shape = "sphere", radius = "25 mm", young = "2 MPa", poisson = 0.495, body = "hemisphere", support = "holder"}
substrate = {thickness = "8 mm", young = "4 MPa", poisson = 0.495}
friction.coefficient = 0.7
load = {normal_force = "8 N", tangential_ratio = 0.4}
bem.cells_per_radius = 12
rig.work_of_adhesion = "50 mJ/m2"
END
    "$program" rig soft.toml -o soft >soft.txt 2>&1 || complain "a soft ball: $(cat soft.txt)"
    grep -A 1 '^violated: The indenter is as large as a half-space' soft.txt | grep -q '|d half-space/d body - 1| = 0.068' ||
        complain "the indenter's body: $(grep -A 3 'as large as' soft.txt)"
    grep -A 9 'surfaces do not attract' soft.txt | grep -q 'On the layer adhesion widens the contact by' ||
        complain "adhesion of a soft ball: $(grep -A 9 'not attract' soft.txt)"
    ! grep -q 'leaves out indenter.body' soft.txt || complain "said to be left out"
    sed 's/, body = "hemisphere", support = "holder"//' soft.toml >silent.toml
    "$program" rig silent.toml -o silent >silent.txt 2>&1 || complain "without a body: $(cat silent.txt)"
    grep -A 2 '^not testable: The indenter is as large as a half-space' silent.txt | grep -q 'not given: indenter.body' ||
        complain "missing keys: $(grep -A 3 'as large as' silent.txt)"
    sed 's/young = "2 MPa", poisson = 0.495, body = "hemisphere", support = "holder"/young = "200 GPa", poisson = 0.3/' \
        soft.toml >steel.toml
    "$program" rig steel.toml -o steel >steel.txt 2>&1 || complain "steel: $(cat steel.txt)"
    ! grep -q 'as large as a half-space' steel.txt || complain "the size of a rigid ball"
fi
finish
