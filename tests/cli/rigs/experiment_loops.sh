#!/usr/bin/env bash
# tricontact experiment lays models beside recorded friction loops, with the values that identify finds of them: made loops agree with
# the law that made them, and not with another; work, stiffnesses and regimes in terminal, JSON and report.
# usage: experiment_loops.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# Cycles 1 and 200 of the example, whose truth stands in make_loop_data.py; two cycles tell no drift.
awk '/^#/ || /^cycle/ || (/^1,/ && /, 300, 10$/) || (/^1,/ && /, 600, 40$/)' "$source_dir/examples/measurements/fretting_loops.csv" >loops.csv
sed 's/fretting_loops.csv/loops.csv/; s/"mdr", "bem"/"mdr"/; s/^find.*/find = ["substrate.young", "rig.tangential_stiffness"]\nlaws = ["coulomb", "shear-strength"]/' \
    "$source_dir/examples/measurements/fretting_loops.toml" >loops.toml
"$program" experiment loops.toml --output out --quiet >text || complain "experiment"
grep -q "^mdr under coulomb agrees with the measured loops: furthest off is .* (95 % of 6 numbers together)" text || complain "agrees: $(cat text)"
grep -q "^mdr under shear-strength does not agree with the measured loops" text || complain "another law: $(cat text)"
grep -q "^Regime (cycle 1, F_N = 600 N, amplitude 40.* gross slip" text || complain "regime: $(cat text)"
"$python" - <<'PYTHON' || complain "experiment.json"
import json
answer = json.load(open("out/experiment.json"))
coulomb, strength = answer["predicted_loops"]
assert (coulomb["law"], strength["law"]) == ("coulomb", "shear-strength")
stuck, slid = coulomb["models"]["mdr"]
assert (stuck["regime"], slid["regime"]) == ("partial-slip", "gross-slip")
# By hand, of gross slip: 4 mu F_N (U_a - U_slide) and what partial slip adds, between 70 and 100 % of the whole.
work = slid["energy_J"]["predicted"]
assert .7 < work / (4 * .6 * .94 * 600 * (40e-6 - .6 * 600 / 30e6)) < 1, work
for number in ("energy_J", "secant_stiffness_N_per_m", "initial_stiffness_N_per_m"):
    for one in (stuck, slid):
        assert abs(one[number]["difference"]) < 1.5 * one[number]["half_width"], (number, one[number])
# The shift at which all slides: mdr's own loop against Mindlin's closed form, to its steps.
assert abs(slid["sliding_shift_m"]["difference"]) < 1e-3 * slid["sliding_shift_m"]["measured"]
assert stuck["sliding_shift_m"]["predicted"] is None
assert answer["laws_of_friction"] and len(answer["friction_loops"]["series"]) == 2
PYTHON
[ "$(wc -l <out/loops.csv)" -eq 3 ] || complain "loops.csv"
grep -q "loop_predictions" out/report.html || complain "no table of computed loops in the report"

# What loops cannot have beside them.
beside() {
    sed "$2" loops.toml >beside.toml
    refused "$1" experiment "$work/beside.toml"
}
beside "is of a rig that rolls, and measurement.friction_loop of one that does not" 's/^\[contact\].*/[record]\nkind = "shakedown"\nruns = ["r.csv"]\n&/'
beside "loops are compared with contacts that do not wear" 's/^\[contact\].*/[wear]\ncoefficient = "1e-5 mm3\/(N m)"\ncycles = 10\n&/'
sed 's/^models = \["mdr"\].*//' loops.toml >alone.toml
"$program" experiment alone.toml --output alone --quiet | grep -q "The file names no models" || complain "without models"
beside "fem models a layer, but the case has no substrate.thickness" 's/^models = \["mdr"\].*/models = ["fem"]/'
cp "$source_dir"/examples/records/synthetic_shakedown.toml record.toml
sed -i 's/^runs = .*/runs = ["loops.csv"]/' record.toml
refused "has a column cycle, as friction loops have" experiment "$work/record.toml"
sed 's/friction_loop/static_shift/; s/, "rig.tangential_stiffness"//' loops.toml >shifts.toml
refused "or friction loops as measurement.friction_loop" experiment "$work/shifts.toml"
finish
