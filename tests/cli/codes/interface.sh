#!/usr/bin/env bash
# What benchmark compare explains by a penalty and by elastic slip, beside the exact solutions of such contacts: boundary
# elements whose cells yield by 1/K and 1/K_T, which is one number of a file of influence coefficients.
# usage: interface.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
export OPENBLAS_NUM_THREADS=1

cat >sphere.toml <<'END'
title = "rigid paraboloid on a half-space, nu = 0, F_T = 0.5 mu F_N"
models = ["bem"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.0
[friction]
coefficient = 0.57
[contact]
coupling = false
[load]
press = "frictionless"
normal_force = "20 N"
tangential_ratio = 0.5
[bem]
cells_per_radius = 20
END

# yielding FROM TO TANGENTIAL NORMAL: the cell at the load yields by so much more [m/Pa].
yielding() {
    "$python" -S - "$@" <<'END'
import sys
source, target, tangential, normal = sys.argv[1:]
with open(source) as lines, open(target, "w") as out:
    for line in lines:
        numbers = line.split()
        if numbers[:2] == ["0", "0"]:
            for place, more in (2, tangential), (6, tangential), (10, normal):  # xx, yy, zz
                numbers[place] = repr(float(numbers[place]) + float(more))
            line = " ".join(numbers) + "\n"
        out.write(line)
END
}

# family NAME TANGENTIAL NORMAL CONTACT...: three runs with that interface, compared with the contact without.
family() {
    local name=$1 tangential=$2 normal=$3 cells
    shift 3
    {
        printf '%s\n' 'case = "sphere.toml"' 'code = "bem with an interface"' '[contact]' "$@"
        for cells in 10 20 40; do
            "$program" influence sphere.toml --models bem --set bem.cells_per_radius=$cells --output plain.txt >/dev/null
            yielding plain.txt "$name$cells.txt" "$tangential" "$normal"
            "$program" run sphere.toml --quiet --no-studies --no-report --output "$name$cells" --set bem.cells_per_radius=$cells \
                --set "bem.influence=$name$cells.txt" >/dev/null || complain "no run $name$cells"
            printf '[[mesh]]\nsize = "%s mm"\nfield = "%s"\n' "$("$python" -S -c "print(4.87 / $cells)")" \
                "$name$cells/bem/surface.ex2"
            "$python" -S -c 'import json, sys
found = json.load(open(sys.argv[1] + "/summary.json"))["models"]["bem"]
print("indentation = \"%.9g m\"\nshift = \"%.9g m\"" % (found["end_indentation_m"], found["static_shift_m"]))' "$name$cells"
        done
    } >"$name.toml"
    "$program" benchmark compare "$name.toml" --output "$name" >out 2>err || [ $? -lt 5 ] || complain "$name: $(cat err)"
}

# Elastic slip: 26 MPa/mm, penalty: 100 MPa/mm, both.
family slip 3.846153846e-11 0 'stick_slope = "26 MPa/mm"'
family penalty 0 1e-11 'stiffness = "100 MPa/mm"' 'kinematics = "undeformed"'
"$python" -S - <<'END' || complain "what is explained"
import json
def numbers(name):
    return json.load(open(name + "/comparison.json"))["quantities"]
slip, penalty = numbers("slip"), numbers("penalty")
def left(one):
    return one["difference"] - one["explained"]
shift, traction, load = (slip[key] for key in ("shift", "traction_l2", "traction_load_within"))
assert shift["difference"] > .02 and abs(left(shift)) < .001, shift
assert traction["difference"] > .04 and abs(left(traction)) < .3 * traction["difference"], traction
assert load["difference"] > .01 and abs(left(load)) < .3 * load["difference"], load
assert slip["pressure_l2_inside"]["explained"] == 0 and slip["peak_pressure"]["explained"] == 0, slip
depth, peak, inside = (penalty[key] for key in ("indentation", "peak_pressure", "pressure_l2_inside"))
assert depth["difference"] > .003 and abs(left(depth)) < .001, depth
assert abs(peak["difference"]) > .003 and abs(left(peak)) < .1 * abs(peak["difference"]), peak
assert abs(left(inside)) < .2 * inside["difference"], inside
assert penalty["traction_l2"]["explained"] == 0, penalty["traction_l2"]
END

finish
