#!/usr/bin/env bash
# Kinds of faults that users of other programs reported in public: each of public_reports.txt has a test, those that have
# none elsewhere have it here.
# usage: public_reports.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
table=$source_dir/tests/cli/answers/public_reports.txt

# run CASE OPTIONS...: into out_CASE.
run() {
    "$program" run "$1.toml" --no-studies --no-report --quiet --set output.vtk=none --output "out_$1" "${@:2}" \
        >"$1.out" 2>&1 || complain "$1: $(cat "$1.out")"
}
# close A B TOLERANCE WHAT
close() {
    awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { e = a / b - 1; exit !(a != "" && e < t && e > -t) }' ||
        complain "$4: $1 for $2"
}
# last COLUMN FOLDER [ROW]: of a history, the last value, or that of a row from 1.
last() { column "$1" "$2/history.csv" | sed -n "${3:-\$}p"; }
identify() {
    "$program" identify "$1.toml" --output "out_$1" --quiet >"$1.out" 2>&1 || complain "$1: $(cat "$1.out")"
}

# An indenter of 10 um on a gel of 2 kPa.
hertz_case() { # INDENTER SUBSTRATE LOAD
    cat <<TOML
models = ["mdr", "bem"]
[indenter]
$1
[substrate]
$2
[friction]
coefficient = 0.5
[load]
$3
[contact]
coupling = false
TOML
}

missing_points() {
    printf '1 2 3\n4 Bad 6\n7 8 9\n' >bad.txt
    cat >bad.toml <<'TOML'
models = ["bem"]
[indenter]
shape = "height-map"
file = "bad.txt"
spacing = "1 um"
unit = "1 um"
[substrate]
young = "1 MPa"
poisson = 0.3
[friction]
coefficient = 0.3
[load]
normal_force = "1 mN"
tangential_ratio = 0
TOML
    refused 'bad.txt:2: "Bad": is no finite number: missing values are not filled in; interpolate them first' \
        check "$work/bad.toml"
}

units_change_nothing() {
    hertz_case 'radius = "10 um"' $'young = "2 kPa"\npoisson = 0.5' \
        $'normal_force = "0.5 nN"\ntangential_ratio = 0.4' >small.toml
    hertz_case 'radius = "1e-5 m"' $'young = "2000 Pa"\npoisson = 0.5' \
        $'normal_force = "5e-10 N"\ntangential_ratio = 0.4' >si.toml
    run small
    run si
    for model in mdr bem; do
        cmp -s "out_small/$model/history.csv" "out_si/$model/history.csv" || complain "$model: units change the history"
    done
}

# Force curve of Hertz, E = 2 kPa, R = 10 um, first touch at 1 um; forces in nN with a zero of OFFSET + SLOPE (d + 300 nm).
# force_curve OFFSET SLOPE FROM
force_curve() {
    awk -v offset="$1" -v slope="$2" -v from="$3" 'BEGIN { print "indentation [nm], normal_force [nN]"
        for (k = 0; k <= 80; k++) { d = -300 + 10 * k; if (d < from) continue
            f = d > 0 ? 4 / 3 * 2000 / 0.75 * sqrt(10e-6) * (d * 1e-9) ^ 1.5 * 1e9 : 0
            printf "%d, %.6f\n", d + 1000, f + offset + slope * (d + 300) + 0.02 * (((k * 7) % 11 - 5) / 5) } }'
}
curve_case() {
    force_curve "${@:2}" >"$1.csv"
    cat >"$1.toml" <<TOML
[indenter]
radius = "10 um"
[substrate]
poisson = 0.5
[measurement]
force_indentation = "$1.csv"
find = ["substrate.young", "zero_depth"]
models = ["half-space"]
TOML
    identify "$1"
}
# holds NAME WIDTH: 2 kPa lies in the interval, which is narrower than WIDTH of it, and 1 um where nothing is left out.
holds() {
    "$python" -S - "$@" <<'PYTHON' || complain "$1: $(cat "$1.out")"
import json, sys
m = json.load(open(f"out_{sys.argv[1]}/identify.json"))["models"]["half-space"]
low, high = m["young_Pa"]["likelihood_interval"]
assert low < 2000 < high and high - low < float(sys.argv[2]) * 2000, (low, high)
low, high = m["zero_depth_m"]["likelihood_interval"]
assert low < 1e-6 < high or sys.argv[3:] == ["biased"], (low, high)
PYTHON
}
late_contact() {
    curve_case late 0 0 150
    holds late 0.05
    grep -q pattern late.out && complain "a pattern where there is none: $(cat late.out)"
}
tilted_zero() {
    curve_case tilted 0 0.0003 -300
    holds tilted 0.2 biased
    curve_case shifted 0.3 0 -300
    holds shifted 1 biased
    for name in tilted shifted; do
        grep -q 'residuals of force-indentation show a pattern' $name.out || complain "$name: $(cat $name.out)"
    done
}

# pi a^2 = pi R d; squares cut the edge of the contact: 2 % at 22.5 of them in its radius.
contact_area() {
    hertz_case 'radius = "40 mm"' $'young = "5.2 MPa"\npoisson = 0.5' \
        $'indentation = "0.5 mm"\ntangential_ratio = 0' >area.toml
    run area
    close "$(last contact_area_m2 out_area/mdr)" 6.283185307e-5 3e-4 "contact area of mdr, of 10^4 springs"
    close "$(last contact_area_m2 out_area/bem)" 6.283185307e-5 0.02 "contact area of bem"
}

# Two bodies of E* = E/(2 (1 - nu^2)), one of E/(1 - nu^2).
elastic_indenter() {
    local load=$'normal_force = "100 N"\ntangential_ratio = 0' steel=$'young = "210 GPa"\npoisson = 0.3' model
    hertz_case $'radius = "10 mm"\n'"$steel" "$steel" "$load" >both.toml
    hertz_case 'radius = "10 mm"' "$steel" "$load" >rigid.toml
    run both
    run rigid
    # d = (9 F^2/(16 E*^2 R))^(1/3)
    close "$(last indentation_m out_both/mdr)" 3.4829099e-6 1e-6 "depth of two bodies"
    for model in mdr bem; do
        close "$(last indentation_m out_both/$model)" \
            "$(awk -v d="$(last indentation_m out_rigid/$model)" 'BEGIN { printf "%.12g", d * 2 ^ (2 / 3) }')" 1e-6 \
            "$model: depth of two bodies over that of one"
    done
}

# theta = 20 deg from the surface, d = 0.1 mm, E* = 4/3 MPa: F = 2 E* d^2/(pi tan theta). Its shift under f mu F is that of
# the normal contacts superposed: mu (E*/G*) d (1 - sqrt(1 - f)), E*/G* = 3/2.
cone() {
    hertz_case $'shape = "cone"\nangle = "20 deg"' $'young = "1 MPa"\npoisson = 0.5' \
        $'indentation = "0.1 mm"\ntangential_ratio = 0.3' >cone.toml
    run cone
    close "$(last normal_force_N out_cone/mdr)" 0.02332138 2e-4 "force of mdr on a cone"
    close "$(last normal_force_N out_cone/bem)" 0.02332138 0.01 "force of bem on a cone"
    close "$(last shift_x_m out_cone/mdr)" 1.225049e-5 2e-3 "shift of mdr under a cone"
    close "$(last shift_x_m out_cone/bem)" 1.225049e-5 0.01 "shift of bem under a cone"
    [ "$(grep -c '"peak_pressure_Pa": null' out_cone/summary.json)" -eq 2 ] ||
        complain "a peak of an infinite pressure: $(grep peak_pressure_Pa out_cone/summary.json)"
    grep -q '"peak_pressure_Pa": "it is infinite under a conical tip"' out_cone/summary.json ||
        complain "the reason is not said: $(grep -A5 undefined out_cone/summary.json)"
}

# F_N 1 N, F_T 0.3 N, F_N 2 N, F_T 0: no spring slips while F_N grows. mu = 0.5, E*/G* = 3/2, E* = 4/3 MPa, R = 10 mm, d(F)
# Hertz' depth: U = mu (E*/G*) (d(1) - d(0.4)), then less by mu (E*/G*) (d(2) - d(1.4)), since nothing of the new ring was
# loaded before (Mindlin and Deresiewicz 1953).
force_grows_under_shear() {
    cat >grows.toml <<'TOML'
models = ["mdr", "bem"]
[indenter]
radius = "10 mm"
[substrate]
young = "1 MPa"
poisson = 0.5
[friction]
coefficient = 0.5
[contact]
coupling = false
[bem]
cells_per_radius = 20
[path]
steps = 10
table = """
normal_force [N], tangential_force_x [N]
0, 0
1, 0
1, 0.3
2, 0.3
2, 0
"""
TOML
    run grows
    local model rows
    for model in mdr bem; do
        rows=$(column step out_grows/$model/history.csv | wc -l)
        # 1 %: edges of contact and stick area cut by cells; of mdr the digits given.
        tolerance=$([ $model = mdr ] && echo 1e-4 || echo 0.01)
        close "$(last shift_x_m out_grows/$model)" 2.87459e-5 $tolerance "$model: shift left"
        close "$(last shift_x_m out_grows/$model $((rows - 10)))" 1.084351e-4 $tolerance "$model: shift under 2 N"
        close "$(last shift_x_m out_grows/$model $((rows - 10)))" "$(last shift_x_m out_grows/$model $((rows - 20)))" \
            1e-9 "$model: shift while F_N grows"
    done
}

# Each row of the table has its test.
kinds=0
here=()
while IFS='|' read -r of wrong right test; do
    [[ -z $of || $of == \#* ]] && continue
    kinds=$((kinds + 1))
    [ -n "${wrong// /}" ] && [ -n "${right// /}" ] || complain "a row without fault or value: $of"
    read -r kind name <<<"$test"
    case $kind in
    unit)
        grep -rqE "(TEST|TEST_F|TEST_P|RC_GTEST_PROP)\(${name%.*}, ${name#*.}[,)]" "$source_dir/tests/unit" \
            "$source_dir/tests/verification" || complain "no test $name"
        ;;
    script)
        file=${name%%: *}
        [[ $file == *.txt ]] || file+=.sh
        grep -qF -- "${name#*: }" "$source_dir/tests/$file" || complain "tests/$file has nothing of: ${name#*: }"
        ;;
    here)
        declare -F "$name" >/dev/null || complain "no function $name"
        here+=("$name")
        ;;
    *) complain "a row without a test: $of" ;;
    esac
done <"$table"
# As many kinds were reported when the table was begun.
[ "$kinds" -ge 29 ] || complain "$kinds kinds in the table"
for name in "${here[@]}"; do "$name"; done

finish
