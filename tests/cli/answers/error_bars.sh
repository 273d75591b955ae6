#!/usr/bin/env bash
# What ± covers: closed forms, finer steps; it is 0 of nothing but what the case prescribes.
# usage: error_bars.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
export OPENBLAS_NUM_THREADS=1

cat >oblique.toml <<'END'
models = ["bem"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.5
[friction]
coefficient = 0.57
[bem]
cells_per_radius = 15
[path]
table = "normal_force [N], tangential_force_x [N]\n0, 0\n20, 4"
END

# run OUTPUT CASE ARGUMENTS...: ends with 0.
run() {
    local output=$1
    shift
    "$program" run "$@" --output "$output" --quiet --set output.vtk=none 2>err || complain "$*: $(cat err)"
}

# 1. Nothing slips: U = F_T/F_N E*/G* d exactly (Mindlin and Deresiewicz 1953), with one step as with many.
for steps in 1 3 10; do
    run "oblique_$steps" oblique.toml --no-report --set "path.steps=$steps"
    "$python" -S - "oblique_$steps" <<'END' || complain "the shift of a path of $steps steps is not what its ± says"
import json, sys
summary = json.load(open(sys.argv[1] + "/summary.json"))
contact = 5.2e6 / .75  # E* of a rigid body on nu = 1/2; G* is 4 G/(2 - nu), E*/G* = 1.5
depth = (.75 * 20 / contact) ** (2 / 3) / .04 ** (1 / 3)
exact = .2 * 1.5 * depth
shift = summary["models"]["bem"]["final_shift_m"]
width = summary["numerical_error"]["half_widths"]["final_shift_m"]
assert abs(shift - exact) < .01 * exact, (shift, exact)
assert abs(shift - exact) < width < .1 * exact, (shift, exact, width)
END
done

# 2. Runs whose steps cannot be longer: turning points, one per quarter. Finer ones lie within the ±.
rolling=("$source_dir/examples/cases/rig_sphere_parallel.toml" --set models='["mdr"]' --set mdr.springs=1000 --set rolling.periods=2
    --set load.tangential_ratio=0.7 --set rolling.amplitude_ratio=0.3)
run fine "${rolling[@]}" --set rolling.steps_per_quarter=64 --no-studies --no-report
run turning "${rolling[@]}" --no-report --set rolling.steps=turning-points
run quarter "${rolling[@]}" --no-report --set rolling.steps_per_quarter=1
"$python" -S - <<'END' || complain "± of turning points or one step per quarter"
import json
def of(run):
    return json.load(open(run + "/summary.json"))
fine = of("fine")["models"]["mdr"]["final_shift_m"]
for run in "turning", "quarter":
    summary = of(run)
    off = abs(summary["models"]["mdr"]["final_shift_m"] - fine)
    assert 1e-3 * fine < off < summary["numerical_error"]["half_widths"]["final_shift_m"], (run, off)
END

# 3. A prescribed value is exact and says so; no other has no error.
run depth oblique.toml --set 'path.table="indentation [um], shift_x [um]\n0, 0\n400, 50"'
grep -q "The shift is prescribed" depth/report.html || complain "the page does not say what is prescribed"
run layer oblique.toml --no-report --set 'models=["mdr-layer"]' --set 'substrate.thickness=8 mm'
models=(depth layer)
if has_fem; then
    sed '/^size/d; /^increment/d' "$source_dir/examples/cases/rig_cylinder.toml" >cylinder.toml
    run fem cylinder.toml --models fem --no-report --set fem.cache=none --set rolling.periods=1 \
        --set rolling.steps=turning-points --set load.press_steps=2
    grep -q '^size = ' fem/case.toml && complain "the case gives the size of its elements"
    models+=(fem)
fi
"$python" -S - "${models[@]}" <<'END' || complain "a ± of 0"
import json, sys
for run in sys.argv[1:]:
    error = json.load(open(run + "/summary.json"))["numerical_error"]
    assert error["half_widths"], run
    for key, width in error["half_widths"].items():
        assert (width > 0) != (key in error["exact"]), (run, key, width)
exact = json.load(open("depth/summary.json"))["numerical_error"]["exact"]
assert exact == ["indentation_m", "final_shift_m", "end_indentation_m"], exact
END
finish
