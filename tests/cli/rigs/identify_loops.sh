#!/usr/bin/env bash
# tricontact identify reads friction loops: E, mu, k_rig and the drift of made ones are in their intervals, regimes and energies are
# named; tables that hold no loops, and what loops cannot have beside them, are refused with one line.
# usage: identify_loops.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

number() { "$python" -c "import json; print(json.load(open('out/identify.json'))$1)"; }
holds() { awk "BEGIN { exit !($1) }" || complain "$1: $2"; }

# Half of the example: the cycles 1, 100 and 200. Its truth stands in make_loop_data.py.
awk '/^#/ || /^cycle/ || /^1,/ || /^100,/ || /^200,/' "$source_dir/examples/measurements/fretting_loops.csv" >fretting_loops.csv
cp "$source_dir/examples/measurements/fretting_loops.toml" .
"$program" identify fretting_loops.toml --output out --quiet >text || complain "identify"
for known in young_Pa:200e9 friction_coefficient:0.6 rig_tangential_stiffness_N_per_m:30e6 friction_drift:0.12; do
    low=$(number "['models']['half-space']['${known%:*}']['interval'][0]")
    high=$(number "['models']['half-space']['${known%:*}']['interval'][1]")
    # In each of twenty such statements one is outside: 1.5 half widths around the middle.
    holds "($low - ${known#*:}) < ($high - $low) / 4 && (${known#*:} - $high) < ($high - $low) / 4" "${known%:*}: $low to $high"
done
[ "$(number "['friction_loops']['series'][0]['regime']")" = partial-slip ] || complain "partial slip: $(cat text)"
[ "$(number "['friction_loops']['series'][1]['regime']")" = gross-slip ] || complain "gross slip: $(cat text)"
# What slides dissipates 4 mu F_N (U_a - U_slide) and more: between 80 and 100 % of 4 mu F_N U_a less the rig's share.
holds "$(number "['friction_loops']['series'][1]['energy_J']['value']") > 0.8 * 4 * 180 * (40e-6 - 180 / 30e6)" energy
holds "$(number "['friction_loops']['series'][1]['energy_J']['value']") < 4 * 180 * (40e-6 - 180 / 30e6)" energy
grep -q "^Regime (cycles 1 to 200, F_N = 300 N, amplitude 10.* partial slip, confidence 100 %" text || complain "regime: $(cat text)"
grep -q "^Friction rises over cycles 1 to 200: +1[0-4] %" text || complain "drift: $(cat text)"
[ "$(wc -l <out/loops.csv)" -eq 13 ] || complain "loops.csv"
grep -q "loop_series" out/report.html || complain "no table of series in the report"

# Loops that are none.
bad() {
    mv fretting_loops.csv whole.csv
    { printf '%s\n' "$2"; grep -v '^#\|^cycle' whole.csv | sed "$3"; } >fretting_loops.csv
    refused "$1" identify "$work/fretting_loops.toml"
    mv whole.csv fretting_loops.csv
}
header="cycle, shift [um], tangential_force [N], normal_force [N], amplitude [um]"
bad "the loop does not close: a cycle ends where it began" "$header" '20,48d'
bad "forces of a loop have both signs, and these have one" "$header" 's/, -\([0-9.]*, [36]00\)/, \1/'
bad "the forces do not resist the shift: around the loops they give work" "$header" \
    's/^\([^,]*, [^,]*, \)-/\1~/; s/^\([^,]*, [^,]*, \)\([0-9]\)/\1-\2/; s/~//'
bad "cycle numbers go back under the same load and amplitude" "$header" '49,96s/^100/0/'
bad "cycles have whole numbers from 0 on" "$header" 's/^100,/99.5,/'
bad "the cycle has fewer than 12 rows" "$header" '9,48d'
bad "the normal force changes by more than 10 % within a cycle" "$header" '10s/300/400/'
bad "tangential_force" "cycle, shift [um], tangential_force [um], normal_force [N], amplitude [um]" ''
bad "shift" "cycle, shift, tangential_force [N], normal_force [N], amplitude [um]" ''
bad "small deformations are assumed; check the units" "cycle, shift [mm], tangential_force [N], normal_force [N], amplitude [um]" ''
bad 'unknown column "cycles"' "cycles, shift [um], tangential_force [N], normal_force [N], amplitude [um]" ''

# What loops cannot have beside them.
beside() {
    sed "$2" fretting_loops.toml >beside.toml
    refused "$1" identify "$work/beside.toml"
}
beside "loops find friction beside whatever else; add friction.coefficient" 's/"friction.coefficient", //'
beside "friction_loop does not determine substrate.poisson" 's/"friction.coefficient"/&, "substrate.poisson"/'
beside "loops are evaluated on their own, and there is measurement.static_shift" 's/^friction_loop/static_shift = "shift.csv"\n&/'
beside "the rows of friction_loop state their own normal forces; omit it" 's/^\[measurement\]/[load]\nnormal_force = "300 N"\n&/'
beside "each of which finds its own numbers" 's/^find/laws = ["coulomb", "shear-strength"]\n&/'
beside "in loops, a rigid indenter is computed" 's/"half-space"/"layer"/; s/^\[substrate\].*/&\nthickness = "8 mm"/'
beside "loops are evaluated by half-space or layer, not by bem-layer" 's/"half-space"/"bem-layer"/; s/^\[substrate\].*/&\nthickness = "8 mm"/'
beside "loops are evaluated by one model" 's/"half-space"/&, "layer"/; s/^\[substrate\].*/&\nthickness = "8 mm"/'
sed 's/^friction_loop/static_shift/' fretting_loops.toml >beside.toml
refused "the rig's stiffness is in series with the contact in friction_loop alone" identify "$work/beside.toml"


# Loops of a cylinder, by the closed form of line contact (docs/explanation/cylinder.md) and Masing's rule, 0.3 % of noise.
"$python" - <<'PYTHON' >cylinder.csv
import math, random
random.seed(7)
radius, length, young, nu, mu, rig = 20e-3, 10e-3, 206e9, .3, .6, 50e6
plane = young / (2 * (1 - nu * nu))
print("cycle, shift [um], tangential_force [N], normal_force [N], amplitude [um]")
def curve(load):
    a = math.sqrt(4 * load / length * radius / (math.pi * plane))
    factor = .5 + math.log(2) + math.log(length / a) + nu / (1 - nu)
    def shift(f):
        rest = (1 - f) * (1 - math.log(1 - f) / (2 * factor)) if f < 1 else 0
        return mu * a * a / (2 * radius) * factor * (1 - rest) + f * mu * load / rig
    def force(way):
        if way >= shift(1): return mu * load
        low, high = 0., 1.
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if shift(middle) < way else (low, middle)
        return low * mu * load
    return force, shift(1)
for load in (1000, 4000):
    force, slide = curve(load)
    for way in (.6, 2):
        end = way * slide
        for i in range(96):
            u = end * math.cos(2 * math.pi * (i + .5) / 96)
            sign = -1 if i < 48 else 1
            f = sign * (2 * force((end + sign * u) / 2) - force(end))
            print(f"1, {1e6 * u:.5f}, {f + .003 * mu * load * random.gauss(0, 1):.4f}, {load}, {1e6 * end:.4f}")
PYTHON
sed 's/^radius.*/radius = "20 mm"\nlength = "10 mm"\nshape = "cylinder"/; s/fretting_loops.csv/cylinder.csv/; s/"mdr", "bem"/"bem"/' fretting_loops.toml >cylinder.toml
"$program" identify cylinder.toml --output out --quiet >text || complain "cylinder: $(cat text)"
for known in young_Pa:206e9 friction_coefficient:0.6 rig_tangential_stiffness_N_per_m:50e6; do
    low=$(number "['models']['half-space']['${known%:*}']['interval'][0]")
    high=$(number "['models']['half-space']['${known%:*}']['interval'][1]")
    holds "($low - ${known#*:}) < ($high - $low) / 4 && (${known#*:} - $high) < ($high - $low) / 4" "cylinder, ${known%:*}: $low to $high"
done
of_cylinder() {
    sed "$2" cylinder.toml >beside.toml
    refused "$1" identify "$work/beside.toml"
}
of_cylinder "the shift of a line contact goes with the size of its bodies" 's/, "rig.tangential_stiffness"//'
of_cylinder "loops of cylinders are evaluated under Coulomb's law" 's/^find.*/find = ["substrate.young", "rig.tangential_stiffness"]\nlaws = ["coulomb", "shear-strength"]/'
of_cylinder "loops of cylinders are evaluated on a half-space" 's/"half-space"/"layer"/; s/^\[substrate\].*/&\nthickness = "8 mm"/'
of_cylinder 'take "paraboloid" or "sphere"; friction loops also "cylinder"' 's/"cylinder"/"punch"/'
finish
