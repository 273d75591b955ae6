#!/usr/bin/env bash
# Yield and bulk stress of a run: what summary.json and the report say, beside closed forms put in by hand.
# usage: strength.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

case_file=$source_dir/examples/cases/fretting_cylinder.toml
"$program" run "$case_file" --quiet --no-studies --output out --set bem.cells_per_radius=30 >out.txt 2>&1 ||
    complain "$(cat out.txt)"

# Johnson (1985), eq. 4.43 and 4.45; Nowell and Hills (1987).
"$python" -S - out/summary.json <<'PYTHON' || complain "$(cat out/summary.json)"
import json, math, sys

found = json.load(open(sys.argv[1]))["models"]["bem"]["strength"]
line, e_star, mu, bulk = 2000 / .01, 206e9 / (2 * .91), .6, 80e6
a = math.sqrt(4 * line * .02 / (math.pi * e_star))
p0 = 2 * line / (math.pi * a)
e, c = bulk * a / (4 * mu * p0), a * math.sqrt(.5)
edge = bulk + 2 * mu * p0 * (math.sqrt((a + e)**2 - c**2) - e) / a
for name, value in {"stick_centre_m": e, "trailing_stress_Pa": edge, "pressure_over_k": p0 * math.sqrt(3) / 700e6,
                    "normal_force_N": 2000, "tangential_force_N": 600}.items():
    if not abs(found[name] / value - 1) < 1e-6:
        sys.exit(f"{name}: {found[name]}, not {value}")
if not 0 < found["yield_factor"] < 5:
    sys.exit(f"yield_factor: {found['yield_factor']}")
PYTHON
# What check says of it before the run: the same of the same loads, by an oscillation too; nothing where F_T is unknown.
sed -e 's/^tangential_ratio.*/tangential_amplitude = "600 N"/' "$case_file" >oscillating.toml
sed -e 's/^tangential_ratio.*/shift_amplitude = "1 um"/' "$case_file" >shifted.toml
for one in "$case_file" oscillating.toml shifted.toml; do
    "$program" check "$one" --json >"$(basename "$one").json" || complain "check $one"
done
"$python" -S - out/summary.json "$(basename "$case_file").json" oscillating.toml.json shifted.toml.json <<'PYTHON' || complain "check"
import json, sys

run, *checked = [json.load(open(name)) for name in sys.argv[1:]]
found = run["models"]["bem"]["strength"]
static, oscillating, shifted = [{name: one["value"] for name, one in answer["derived"].items()} for answer in checked]
for values in static, oscillating:
    if not abs(values["Y/sigma_M"] / found["yield_factor"] - 1) < 1e-9 or \
            not abs(values["sigma_xx"] / found["trailing_stress_Pa"] - 1) < 1e-9:
        sys.exit(f"{values}, the run: {found}")
if "Y/sigma_M" in shifted or "sigma_xx" in shifted:
    sys.exit(f"strength before F_T is known: {shifted}")
PYTHON

grep -q 'Strength at .*2.000 kN' out/report.html || complain "no finding on strength"
grep -q 'at the trailing edge' out/report.html || complain "no finding on the edge"

# A sphere without friction force: p0 = 1.613 Y (Johnson 1985, section 3.4: 1.60), F_N ~ p0^3.
"$program" run "$source_dir/examples/cases/rig_sphere_parallel.toml" --models mdr --quiet --no-studies --no-report \
    --output ball --set contact.coupling=false --set substrate.poisson=0.3 --set load.tangential_ratio=0 --set 'substrate.yield_stress="1 MPa"' \
    >ball.txt 2>&1 || complain "$(cat ball.txt)"
"$python" -S - ball/summary.json <<'PYTHON' || complain "$(cat ball/summary.json)"
import json, sys

model = json.load(open(sys.argv[1]))["models"]["mdr"]
found = model["strength"]
factor = 1.6128e6 / (found["pressure_over_k"] * 1e6 / 3**.5)
if not (abs(found["yield_factor"] / factor - 1) < 1e-3 and
        abs(found["first_yield_force_N"] / found["normal_force_N"] / factor**3 - 1) < 4e-3):
    sys.exit(f"{found}, not {factor}")
PYTHON

# Another law, or a layer: refused by name.
refused 'substrate.yield_stress = "1 MPa": strength is judged' run "$source_dir/examples/cases/rig_sphere_parallel.toml" \
    --models bem-layer --set 'substrate.thickness="8 mm"' --set 'substrate.yield_stress="1 MPa"'
refused 'load.bulk_stress' contact export "$case_file" --models bem

finish
