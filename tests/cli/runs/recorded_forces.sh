#!/usr/bin/env bash
# Records that hold forces: the models get them. A record made along a path whose F_N falls by a fifth is what the
# same model says where it follows the forces, and is not where it takes them as constant.
# usage: recorded_forces.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

cat >rig.toml <<'END'
models = ["mdr"]
[indenter]
shape = "paraboloid"
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.5
[friction]
coefficient = "0.57 ± 0.01"
[load]
normal_force = "21 ± 0.1 N"
tangential_force = "6 N"
[rolling]
amplitude = "1 mm"
periods = 8
[mdr]
springs = 2000
END
cat >make.py <<'END'
import csv, sys
periods, quarter, rest, speed, amplitude = 8, 6, 40.0, 1.0, 1.0   # s, mm/s, mm
end = rest + periods * 4 * amplitude / speed
def normal(t): return 21 - 4 * t / end
def offset(t):
    p = max(0.0, t - rest) * speed / (4 * amplitude) % 1
    return amplitude * (4 * p if p <= .25 else 2 - 4 * p if p <= .75 else 4 * p - 4)
if sys.argv[1] == "path":
    n = periods * 4 * quarter
    times = [0, 1e-3] + [rest + (end - rest) * k / n for k in range(n + 1)]
    print("time [s], normal_force [N], tangential_force_x [N], offset_x [mm], steps")
    for i, t in enumerate(times):
        print(f"{t!r}, {normal(t)!r}, {6.0 if i else 0.0}, {offset(t)!r}, 1")
else:
    steps = [r for r in csv.DictReader(open("truth/mdr/history.csv"))]
    time = [0, 1e-3] + [rest + (end - rest) * k / (periods * 4 * quarter) for k in range(periods * 4 * quarter + 1)]
    shift = {round(float(r["phase"])): float(r["shift_x_m"]) for r in steps if float(r["phase"]) == round(float(r["phase"]))}
    forces = sys.argv[1] == "forces"
    print("time [s], shift [um], drive [mm]" + (", normal_force [N], tangential_force [N]" if forces else ""))
    k, t = 1, 0.05
    while t < end + 10:
        while k + 2 < len(time) and time[k + 1] < t: k += 1
        part = min(1, max(0, (t - time[k]) / (time[k + 1] - time[k])))
        u = shift[k] + part * (shift[k + 1] - shift[k])
        row = f"{t:.2f}, {1e6 * u:.4f}, {offset(min(t, end)):.4f}"
        print(row + (f", {normal(min(t, end)):.5f}, 6.0" if forces else ""))
        t += 0.05
END
"$python" make.py path >path.csv
{
    sed '/^\[load\]/,/^periods/d; s/ ± 0.01//; s/"0.57"/0.57/' rig.toml
    printf '[path]\nfile = "path.csv"\n[output]\nvtk = "none"\n'
} >truth.toml
"$program" run truth.toml --output truth --quiet --no-report || complain "the path does not run"
"$python" make.py forces >with.csv
"$python" make.py none >without.csv
for kind in with without; do
    { cat rig.toml; printf '[record]\nkind = "shakedown"\nruns = ["%s.csv"]\n' "$kind"; } >$kind.toml
    "$program" experiment $kind.toml --output $kind --quiet >$kind.txt || complain "$kind: $(cat $kind.txt)"
done
grep -q "The models get what was recorded: F_N from .* (the case states 21.0 N); F_T from 6.00 to 6.00 N" with.txt ||
    complain "the answer does not tell the forces: $(cat with.txt)"
! grep -q "what was recorded" without.txt || complain "it tells forces that nobody recorded"
grep -q 'Loads that the models follow' with/report.html || complain "the report does not show the loads"
"$python" -S - <<'END' || complain "the models do not get what was recorded"
import json
def differences(name):
    document = json.load(open(name + "/experiment.json"))
    model = document["models"][0]
    return {d["quantity"]: d["comparison"]["difference_m"] / d["predicted_m"]["value"] for d in model["deviations"]}
followed, constant = differences("with"), differences("without")
# The record is sampled, and read by parabolas: 0.3 % of the shift.
assert all(abs(d) < .003 for d in followed.values()), followed
assert abs(constant["U_sd"]) > .05, constant
recorded = json.load(open("with/experiment.json"))["rolled_as"]["recorded_forces"]
assert abs(recorded["normal_force_N"]["low"] - 17) < .01, recorded
END
# Columns that only some runs have, and forces that nobody can carry.
sed 's/runs = .*/runs = ["with.csv", "without.csv"]/' with.toml >mixed.toml
code=0
"$program" experiment mixed.toml --output none 2>err || code=$?
[ $code = 2 ] && grep -q "some runs have a column of forces that others have not" err || complain "mixed columns: $code, $(cat err)"
code=0
"$program" experiment with.toml --set friction.coefficient=0.3 --output none 2>err || code=$?
[ $code = 2 ] && grep -q "reaches mu F_N" err || complain "a contact that slides: $code, $(cat err)"
[ ! -e none ] || complain "something was written"
finish
