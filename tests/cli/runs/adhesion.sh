#!/usr/bin/env bash
# Surfaces that attract each other: force curves, pull-off, what check and predict say, refusals.
# usage: adhesion.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../summaries.bash"

# 1. The example: JKR's pull-off, -3/2 pi w R at a^3 = 9 pi w R^2/(8 E*) (E* = 2 MPa), to 1e-6; energy
# lost in two jumps; force curve first.
case=$source_dir/examples/cases/adhesive_sphere.toml
"$program" run "$case" --output out --quiet >text 2>&1 || complain "no run: $(cat text)"
"$python" -S - <<'PYTHON' || complain "numbers of JKR"
import csv, json, math
w, R, E = 60e-3, 5e-3, 2e6
model = json.load(open("out/summary.json"))["models"]["mdr"]
assert abs(model["pull_off_force_N"] / (1.5 * math.pi * w * R) - 1) < 1e-6
assert abs(model["pull_off_radius_m"] / (9 * math.pi * w * R * R / 8 / E) ** (1 / 3) - 1) < 1e-6
assert model["audit"]["energy_balance"]["passed"]
steps = [{k: float(v) for k, v in row.items() if v} for row in csv.DictReader(open("out/mdr/history.csv"))]
jumps = [s for s in steps if s["released_energy_J"] > 0]
assert len(jumps) == 2 and jumps[0]["indentation_m"] == 0, jumps
# There and back again the same force at the same depth, where nothing jumps: 1e-9 of the largest.
there = {round(s["indentation_m"], 12): s["normal_force_N"] for s in steps if 1 < s["phase"] <= 2}
back = [s for s in steps if 2 < s["phase"] <= 3 and round(s["indentation_m"], 12) in there]
assert len(back) > 15
assert all(abs(s["normal_force_N"] - there[round(s["indentation_m"], 12)]) < 1e-9 * 5e-3 for s in back)
assert min(s["normal_force_N"] for s in steps) > -model["pull_off_force_N"]
PYTHON
[[ $(grep -o 'force_curve\|traction_x' out/report.html | head -1) == force_curve ]] || complain "the force curve is not first"

# 2. The same without a run.
"$program" predict "$case" --json >prediction.json || complain "no prediction"
"$python" -S - <<'PYTHON' || complain "prediction: $(head -c 600 prediction.json)"
import json
run = json.load(open("out/summary.json"))["models"]["mdr"]
said = json.dumps(json.load(open("prediction.json"))["models"]["mdr"])
assert "pull_off_force_N" in said and "Johnson, Kendall and Roberts" in said
PYTHON
"$program" check "$case" >text || complain "check: $(cat text)"
grep -q "F_off .*1.414 mN" text || complain "check knows no pull-off: $(cat text)"

# 3. On a layer it holds more; bars by other elements.
"$program" run "$case" --models mdr-layer --set 'substrate.thickness="0.1 mm"' --output layer --quiet >text 2>&1 ||
    complain "no layer: $(cat text)"
"$python" -S - <<'PYTHON' || complain "layer"
import json
summary = json.load(open("layer/summary.json"))
model = summary["models"]["mdr-layer"]
assert 1.5 < model["pull_off_force_N"] / (3.14159265 * 60e-3 * 5e-3) < 3
assert 0 < summary["numerical_error"]["half_widths"]["pull_off_force_N"] < 1e-3 * model["pull_off_force_N"]
PYTHON

grep -q "surfaces that do not attract each other, those of the case do" layer/report.html || complain "compared with a layer without adhesion"
"$program" refine "$case" --models mdr --output refined --quiet >text 2>&1 || complain "not refined: $(cat text)"
grep -q "Theory (Hertz)" text && complain "refined against Hertz: $(cat text)"

# 4. A force beyond pull-off ends the run, with what the contact holds.
"$program" run "$case" --set 'path.table="normal_force [mN]\n0\n2\n-1.5"' --output lost --quiet >text 2>&1 &&
    complain "-1.5 mN holds"
grep -q "holds 0.00141372 N at most" text || complain "$(cat text)"

# 5. By cells: JKR within the bars, on a short way in and out.
"$program" run "$case" --models bem --set contact.coupling=false --set 'bem.spacing="16 um"' \
    --set 'path.table="indentation [um]\n0\n4\n-6"' --set path.steps=5 --output cells --no-report --quiet >text 2>&1 ||
    complain "no cells: $(cat text)"
"$python" -S - <<'PYTHON' || complain "cells"
import json, math
w, R, E = 60e-3, 5e-3, 2e6
summary = json.load(open("cells/summary.json"))
model, width = summary["models"]["bem"], summary["numerical_error"]["half_widths"]
exact = {"pull_off_force_N": 1.5 * math.pi * w * R, "pull_off_radius_m": (9 * math.pi * w * R * R / 8 / E) ** (1 / 3)}
for key, value in exact.items():
    assert abs(model[key] - value) <= width[key], (key, model[key], value)
assert width["pull_off_force_N"] < .05 * exact["pull_off_force_N"]
assert model["steps_of_other_states"] > 0
PYTHON

# 6. Rolled with a shear strength: tau_0 over JKR's area, its limit and shift over its radius, which a run, predict
# and limit share.
rolling=$source_dir/examples/cases/adhesive_rolling.toml
"$program" run "$rolling" --output rolled --no-studies --no-report --quiet >text 2>&1 || complain "not rolled: $(cat text)"
"$program" predict "$rolling" --json >prediction.json || complain "rolling not predicted"
"$program" limit "$rolling" --tolerance 1e-4 --output limit --quiet >text 2>&1 || complain "no limit: $(cat text)"
"$python" -S - <<'PYTHON' || complain "rolling"
import json, math
w, R, E, G, F, tau, x = 60e-3, 5e-3, 2e6, 4 / 3 * 1e6, .5e-3, 40e3, .25
t = math.pi * w * R
a = (3 * R / 4 / E * (F + 3 * t + math.sqrt(6 * t * F + 9 * t * t))) ** (1 / 3)
limit = 2 / math.pi * (math.acos(x) - x * math.sqrt(1 - x * x))
model = json.load(open("rolled/summary.json"))["models"]["mdr"]
predicted = json.load(open("prediction.json"))["models"]["mdr"]
value = lambda p, key: p[key]["value"] if isinstance(p.get(key), dict) else p[key]
assert abs(model["contact_radius_m"] / a - 1) < 1e-6
assert abs(model["unit_shift_m"] / (2 * tau * a / G) - 1) < 1e-4
assert model["state"] == "shakedown" and abs(model["limit_tangential_ratio"] - limit) < 1e-4
for key in ("static_shift_m", "settled_shift_m", "kappa", "limit_amplitude_ratio"):
    assert abs(model[key] / value(predicted, key) - 1) < 2e-3, key
assert abs(model["kappa"] - 4 / math.pi) < 2e-3
found = json.load(open("limit/limit.json"))["models"]["mdr"]
assert abs(found["limit"] - limit) < 2e-4, found
PYTHON

# 7. Separation that takes more than the approach gains: a loop loses more than its jumps, off at the same force.
"$program" run "$case" --set 'adhesion.approach_work="20 mJ/m2"' --output hysteresis --no-studies --no-report --quiet >text 2>&1 || complain "no hysteresis: $(cat text)"
"$python" -S - <<'PYTHON' || complain "hysteresis"
import csv, json, math
model = json.load(open("hysteresis/summary.json"))["models"]["mdr"]
assert abs(model["pull_off_force_N"] / (1.5 * math.pi * 60e-3 * 5e-3) - 1) < 1e-6
def lost(folder):
    return sum(float(r["released_energy_J"]) for r in csv.DictReader(open(folder + "/mdr/history.csv")))
# (w - w_a) over the widest contact, of the radius of w_a at 10 um, less what the larger jump in of w loses.
assert lost("hysteresis") > lost("out") * 1.2, (lost("hysteresis"), lost("out"))
PYTHON

# 8. With a range, lambda = 3, springs are Maugis' contact, which predict has in closed form; bodies jump together before they touch.
range=(--set 'adhesion.peak_stress="96 kPa"')
"$program" run "$case" "${range[@]}" --output range --no-studies --no-report --quiet >text 2>&1 || complain "no range: $(cat text)"
"$program" predict "$case" "${range[@]}" --json >prediction.json || complain "range not predicted"
"$python" -S - <<'PYTHON' || complain "range"
import csv, json
model = json.load(open("range/summary.json"))["models"]["mdr"]
predicted = json.load(open("prediction.json"))["models"]["mdr"]
value = lambda p, key: p[key]["value"] if isinstance(p.get(key), dict) else p[key]
assert abs(model["pull_off_force_N"] / value(predicted, "pull_off_force_N") - 1) < 1e-6
steps = [{k: float(v) for k, v in row.items() if v} for row in csv.DictReader(open("range/mdr/history.csv"))]
jumps = [s for s in steps if s["released_energy_J"] > 0]
assert len(jumps) == 2 and jumps[0]["indentation_m"] < 0, jumps
PYTHON

# 9. What does not know it says so.
for command in "deviation" "contact export --output x" "experiment" "rig" "benchmark deck --for calculix"; do
    "$program" $command "$case" >text 2>&1 && complain "$command takes adhesion"
done
finish
