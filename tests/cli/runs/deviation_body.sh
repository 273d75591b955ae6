#!/usr/bin/env bash
# usage: deviation_body.sh PROGRAM SOURCE_DIR
# tricontact deviation --body: bodies over the size of their contact, beside Hertz and beside the numbers of another
# program; files, taking over what is there; what is refused leaves nothing behind.
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
hemisphere=$source_dir/examples/cases/hemisphere.toml
deviation=(deviation "$hemisphere" --body --set "load.indentation=1 mm")
if ! "$program" list | grep -q '^  fem-axisymmetric '; then
    refused "built without the model fem-axisymmetric" "${deviation[@]}"
    finish
fi

"$program" "${deviation[@]}" --jobs 2 >out 2>err || complain "runs: $(cat err)"
folder=results/hemisphere_body_size
for file in report.html body_size.csv body_size.json; do
    [ -s "$folder/$file" ] || complain "no $file"
done
grep -q 'Failed' out && complain "failed runs: $(cat out)"
grep -qE "^Normal force F_N at equal depth: [0-9.]+ ± [0-9.]+ % above a half-space's here, at a/R = 0.316" out ||
    complain "sentence: $(cat out)"

# Axisymmetric finite elements of another program, R = 10 mm: F over Hertz at d/R = .01 and .1, F over Hertz less 1 over a/R as d -> 0.
cat >check.py <<'PY'
import json, sys
bodies = json.load(open(sys.argv[1]))["bodies"]
problems = []
def points(body, poisson):
    for one in bodies:
        if one["body"] == body and abs(one["poisson"] - poisson) < 1e-9:
            return {round(p["size"], 9): p for p in one["quantities"]["normal_force_at_equal_depth"]["points"]}
    problems.append("no %s of nu = %g" % (body, poisson))
    return {}
def near(name, point, reference, allowed):
    if abs(point["ratio"] / reference - 1) > allowed:
        problems.append("%s: %.5f instead of %.5f" % (name, point["ratio"], reference))
    if not 0 < point["error"] < .003:
        problems.append("%s: error %g" % (name, point["error"]))
soft, other, ball = points("hemisphere", .495), points("hemisphere", .3), points("ball", .495)
near("hemisphere .495", soft[.1], 1.0795, 5e-4)
near("hemisphere .495 at d/R = .1", soft[round(.1 ** .5, 9)], 1.2871, 5e-4)
near("hemisphere .3", other[.1], 1.0760, 5e-4)
near("ball .495", ball[.1], 1.0386, 5e-4)
# .748, .754 and .764 at d = 1e-4, 1e-3, 1e-2 of 10; at a/R = .01 d is 1e-3.
slope = (soft[.01]["ratio"] - 1) / .01
if abs(slope - .754) > .01:
    problems.append("slope %.4f instead of .754" % slope)
print("\n".join(problems))
sys.exit(bool(problems))
PY
$python check.py "$folder/body_size.json" >problems || complain "$(cat problems)"

cp -r "$folder" before
"$program" "${deviation[@]}" >again 2>err
grep -qE '^([0-9]+) of \1 points are there already$' err || complain "computed again: $(cat err)"
for file in report.html body_size.csv body_size.json; do
    cmp -s "$folder/$file" "before/$file" || complain "$file differs the second time"
done

refused "--body: goes neither with --finite-strain nor with --no-runs" deviation "$hemisphere" --body --no-runs
refused "indenter.body is missing" deviation "$source_dir/examples/cases/rig_sphere_parallel.toml" --body
refused "substrate.rigid: the size of a body is judged on a rigid plane" deviation \
    "$source_dir/examples/cases/cylinder_on_hub.toml" --body
refused "substrate.relaxation: deviations are those of elastic bodies" deviation "$hemisphere" --body \
    --set "substrate.relaxation.G2=1 MPa" --set "substrate.relaxation.eta=40 Pa s" --set substrate.relaxation.body=indenter
refused "bodies are compared up to 0.35; reduce the load" deviation "$hemisphere" --body --set "load.indentation=2 mm"
finish
