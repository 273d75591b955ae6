#!/usr/bin/env bash
# Springs between the surfaces: models beside each other, what a penalty is, refusals, pages.
# usage: elastic_interface.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../summaries.bash"
foreign=$source_dir/tests/benchmarks/foreign

cat >springs.toml <<'TOML'
title = "springs"
models = ["bem-layer", "fem"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.5
thickness = "4 mm"
[friction]
coefficient = 0.4
[interface]
normal_stiffness = "5 MPa/mm"
tangential_stiffness = "3 MPa/mm"
[load]
normal_force = "20 N"
tangential_ratio = 0.3
[rolling]
amplitude_ratio = 0.15
periods = 4
steps = "turning-points"
[fem]
size = "0.5 mm"
TOML

has_fem || sed -i 's/, "fem"//' springs.toml

# 1. Two models of a layer: both have 1e-3 of their own meshes.
"$program" run springs.toml --quiet --no-studies --output run || complain "the case does not run"
for key in indentation_m contact_radius_m static_shift_m settled_shift_m limit_tangential_ratio; do
    ! has_fem || near "$(value fem $key run/summary.json)" "$(value bem-layer $key run/summary.json)" 2e-3 "$key of fem"
done
# Springs on a line: exact for the pressing of bodies of revolution, elements of a/100; shifts are
# those of the mean over the circle, uncoupled.
"$program" run springs.toml --models mdr-layer --quiet --no-studies --no-report --output line || complain "mdr-layer does not run"
for key in indentation_m:5e-3 peak_pressure_Pa:5e-3 limit_tangential_ratio:5e-3 static_shift_m:1e-2; do
    near "$(value mdr-layer "${key%:*}" line/summary.json)" "$(value bem-layer "${key%:*}" run/summary.json)" "${key#*:}" \
        "${key%:*} of mdr-layer"
done
# So they are on a half-space.
"$program" run springs.toml --set 'models=["mdr","bem"]' --quiet --no-studies --no-report --output half || complain "mdr does not run"
for key in indentation_m:3e-3 peak_pressure_Pa:3e-3 limit_tangential_ratio:5e-3 static_shift_m:1e-2; do
    near "$(value mdr "${key%:*}" half/summary.json)" "$(value bem "${key%:*}" half/summary.json)" "${key#*:}" \
        "${key%:*} of mdr"
done
# The springs matter: without them the same shift is less.
"$program" run springs.toml --models bem-layer --set "interface.normal_stiffness=5000 MPa/mm" \
    --set "interface.tangential_stiffness=5000 MPa/mm" --quiet --no-studies --no-report --output stiff
awk -v a="$(value bem-layer static_shift_m run/summary.json)" \
    -v b="$(value bem-layer static_shift_m stiff/summary.json)" 'BEGIN { exit !(a > 1.05 * b) }' ||
    complain "springs of 3 MPa/mm change no shift"
grep -q "tangential stiffness" run/report.html || complain "the page does not say the springs"
for rigid in "Cattaneo" "1 − 3/2 w" "a rigid interface,"; do
    grep -qF -- "$rigid" run/report.html && complain "the page speaks of $rigid"
done
[ "$(value bem-layer kappa run/summary.json)" = None ] || complain "a kappa of an elastic interface"

# 2. A penalty is the problem's own: FreeFem++ with 260 MPa/mm is -0.40 % off a rigid interface and
# within 0.1 % of these springs. 26 and 2600 MPa/mm: its -4.03 and -0.031 % of the exact 16.48962 N.
cat >pressed.toml <<'TOML'
title = "a rigid paraboloid pressed on a bonded layer, frictionless"
models = ["bem-layer"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.3
thickness = "8 mm"
[friction]
coefficient = 0.57
[contact]
coupling = false
[interface]
normal_stiffness = "260 MPa/mm"
[load]
indentation = "0.35 mm"
tangential_ratio = 0.0
[bem]
cells_per_radius = 40
TOML
"$program" benchmark compare --case pressed.toml "$foreign"/freefem_p2_{1,0.5,0.25}.csv --tolerance 0.01 \
    --output compared --quiet >compared.txt || complain "the comparison fails"
"$python" -S - <<'PYTHON' || complain "a penalty is not the problem's own"
import json
force = json.load(open("compared/comparison.json"))["quantities"]["normal_force"]
assert force["verdict"] == "pass" and abs(force["difference"]) < 1e-3, force
PYTHON
for pair in 26:-0.0403 2600:-0.00031; do
    "$program" run pressed.toml --set "interface.normal_stiffness=${pair%:*} MPa/mm" --quiet --no-studies --no-report \
        --output "k${pair%:*}"
    near "$(value bem-layer normal_force_N "k${pair%:*}/summary.json")" \
        "$(awk -v x="${pair#*:}" 'BEGIN { print 16.48962 * (1 + x) }')" 1e-3 "penalty of ${pair%:*} MPa/mm"
done

# 3. Rolling on over springs much softer than the body: the brush model of tyres, 1 - (1 - theta)^3 with
# theta = k_t xi a/(2 mu k_n d) = 0.621447. The body's own compliance is 5e-3 of that of the springs.
cat >brush.toml <<'TOML'
title = "brush"
models = ["bem"]
[indenter]
shape = "cylinder"
radius = "300 mm"
length = "200 mm"
[substrate]
young = "1 GPa"
poisson = 0.5
[friction]
coefficient = 0.8
[interface]
normal_stiffness = "1 GPa/m"
tangential_stiffness = "2 GPa/m"
[load]
normal_force = "400 N"
[tractive_rolling]
longitudinal_creepage = 0.008
[bem]
cells_per_radius = 20
TOML
"$program" run brush.toml --points 0 --quiet --output brush || complain "the brush does not roll"
near "$("$python" -S -c "import json; print(json.load(open('brush/summary.json'))['models'][0]['steady']['force_ratio'])")" \
    0.945752 5e-3 "force of the brush"
grep -q "2 GPa/m" brush/report.html || complain "the page of rolling does not say the springs"

# 4. Refused by name, before anything is computed.
refuses() { # WORDS COMMAND...
    local words=$1
    shift
    "$program" "$@" >said.txt 2>&1
    [ $? = 2 ] || complain "$*: not refused"
    grep -q "interface" said.txt && grep -q -- "$words" said.txt || complain "$*: $(cat said.txt)"
}
sed -e '/^\[rolling\]/,/^steps/d' -e '/^thickness/d' -e 's/^models.*/models = ["mdr"]/' springs.toml >on.toml
echo "[tractive_rolling]" >>on.toml
refuses "rolls on over independent ones" roll on.toml --output no
refuses "finite strains" run springs.toml --models fem --set substrate.material=neo-hookean --output no
refuses "deviations" deviation springs.toml --output no
refuses "rigs" rig springs.toml --output no
refuses "CONTACT" contact export springs.toml --models bem-layer --output no
refuses "no atlas" predict springs.toml
refuses "greater than 0" check springs.toml --set "interface.normal_stiffness=0 Pa/m"
[ -e no ] && complain "a refused command has written"
finish
