#!/usr/bin/env bash
# Tables as programs and instruments write them give the same result; force curves begin where the contact does;
# relaxation tests and DMA tables say how well they are fitted.
# usage: tables.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# Hertz: F = 4/3 E* sqrt(R) d^(3/2), E* = E/(1 - nu^2), R = 10 um, in nN and nm, with errors of
# 5 pN that repeat themselves.
awk 'BEGIN { for (k = 0; k <= 10; k++) { d = 50 + 10 * k
    f = 4 / 3 * 2000 / 0.75 * sqrt(10e-6) * (d * 1e-9) ^ 1.5 * 1e9
    printf "%d, %.6f\n", d, f + 0.005 * ((k * 7) % 5 - 2) } }' >rows
# with FILE: the case.
with() {
    cat <<TOML
[indenter]
radius = "10 um"
[substrate]
poisson = 0.5
[measurement]
force_indentation = "$1"
find = ["substrate.young"]
models = ["half-space"]
TOML
}
young() { "$python" -S -c "import json; print(json.load(open('$1/identify.json'))['models']['half-space']['young_Pa']['$2'])"; }

header='indentation [nm], normal_force [nN]'
{ echo "$header"; cat rows; } >plain.csv
{ echo '"","indentation [nm]","normal_force [nN]"'; awk -F', ' '{ printf "\"%d\",%s,%s\n", NR, $1, $2 }' rows; } >r.csv
{ echo '"";"indentation [nm]";"normal_force [nN]"'
    awk -F', ' '{ printf "\"%d\";%s;%s\n", NR, $1, $2 }' rows | tr . ,; } >r_german.csv
{ echo ',indentation [nm],normal_force [nN]'; awk -F', ' '{ printf "%d,%s,%s\n", NR - 1, $1, $2 }' rows; } >pandas.csv
{ echo '"indentation [nm]","normal_force [nN]"'; sed 's/, /","/; s/^/"/; s/$/"/' rows; } >quoted.csv
{ echo 'indentation, normal_force'; echo 'nm, nN'; cat rows; } >units.csv
{ printf 'Sample,gel 3\nDate,2026-01-01\n'; cat plain.csv; } >preamble.csv
iconv -t UTF-16 plain.csv >utf16.csv
{ echo '# an instrument'; echo "# ${header//,/}"; tr -d , <rows; } >savetxt.csv
for name in plain r r_german pandas quoted units preamble utf16 savetxt; do
    with $name.csv >$name.toml
    "$program" identify $name.toml --output out_$name --quiet >$name.out 2>&1 ||
        complain "$name: $(cat $name.out)"
    [ "$(young out_$name value)" = "$(young out_plain value)" ] || complain "$name: E = $(young out_$name value)"
done
awk -v e="$(young out_plain value)" 'BEGIN { exit !((e / 2000 - 1) ^ 2 < 0.01 ^ 2) }' ||
    complain "E = $(young out_plain value), not 2 kPa"

# A force curve that begins 300 nm before the contact, whose depths count from anywhere, with noise about zero.
awk 'BEGIN { print "indentation [nm], normal_force [nN]"
    for (k = 0; k <= 80; k++) { d = -700 + 10 * k; c = d + 400
        f = c > 0 ? 4 / 3 * 2000 / 0.75 * sqrt(10e-6) * (c * 1e-9) ^ 1.5 * 1e9 : 0
        printf "%d, %.6f\n", d, f + 0.02 * (((k * 7) % 11 - 5) / 5) } }' >curve.csv
with "$work/curve.csv" >curve.toml
refused 'indentation = -700: there is no contact at this depth, counted from where it begins; add "zero_depth" to measurement.find, or leave out the rows before contact' \
    identify "$work/curve.toml" --output out
sed 's/find = .*/find = ["substrate.young", "zero_depth"]/' curve.toml >zero.toml
"$program" identify zero.toml --output out_zero --quiet >zero.out 2>&1 || complain "zero: $(cat zero.out)"
"$python" -S - <<'PYTHON' || complain "E or the depth of contact: $(cat zero.out)"
import json
m = json.load(open("out_zero/identify.json"))["models"]["half-space"]
low, high = m["young_Pa"]["likelihood_interval"]
assert low < 2000 < high and high - low < 200, (low, high)
low, high = m["zero_depth_m"]["likelihood_interval"]
assert low < -400e-9 < high and high - low < 2e-8, (low, high)
PYTHON
sed 's/find = .*/find = ["zero_depth"]/' curve.toml >alone.toml
refused 'force_indentation determines zero_depth only together with the modulus; add "substrate.young"' \
    identify "$work/alone.toml" --output out

# A force curve as JPK's programs export it, E = 2 kPa, first touch 3.2 um below the zero of the tip: an approach, a pause and
# a retraction that is no Hertz' (forces at 0.9 of the depth). Of the tip, and of the height with the bending in it,
# k = 0.05 N/m; the piezo's own height is 1 % off.
jpk() { # COLUMNS UNITS
    awk -v columns="$1" -v units="$2" 'function row(d, k,    f, i, n, c, v) {
            f = (d > 0 ? 4 / 3 * 2000 / 0.75 * sqrt(10e-6) * d ^ 1.5 : 0) + 2e-11 * (((k * 7) % 11 - 5) / 5)
            v["verticalTipPosition"] = 3.2e-6 - d; v["vDeflection"] = f; v["measuredHeight"] = 3.2e-6 - d - f / 0.05
            v["height"] = 1.01 * v["measuredHeight"]; v["seriesTime"] = k / 1000
            n = split(columns, c, " ")
            for (i = 1; i <= n; i++) printf "%.10e%s", v[c[i]], i < n ? " " : "\n" }
        function head(index_, name) { printf "\n# segmentIndex: %d\n# segment: %s\n# springConstant: 0.05\n#\n", index_, name
            printf "# columns: %s\n# units: %s\n", columns, units }
        BEGIN { print "# xPosition: 0.0"
            head(0, "extend"); for (k = 0; k <= 80; k++) row((-300 + 10 * k) * 1e-9, k)
            head(1, "pause"); for (k = 0; k <= 20; k++) row(500e-9, k)
            head(2, "retract"); for (k = 80; k >= 0; k--) row((-300 + 10 * k) * 0.9e-9, k) }'
}
jpk "height vDeflection verticalTipPosition seriesTime" "m N m s" >tip.txt
jpk "height vDeflection measuredHeight" "m N m" >height.txt
for name in tip height; do
    sed "s|$work/curve.csv|$work/$name.txt|" zero.toml >$name.toml
    "$program" identify $name.toml --output out_$name --quiet >$name.out 2>&1 || complain "$name: $(cat $name.out)"
    "$python" -S - $name <<'PYTHON' || complain "E or the first touch of JPK's text: $(cat $name.out)"
import json, sys
m = json.load(open(f"out_{sys.argv[1]}/identify.json"))["models"]["half-space"]
low, high = m["young_Pa"]["likelihood_interval"]
assert low < 2000 < high and high - low < 100, (low, high)
low, high = m["zero_depth_m"]["likelihood_interval"]
assert low < -3.2e-6 < high and high - low < 2e-8, (low, high)
PYTHON
done
grep -q '^tip.txt: segment extend of 3, depth = -verticalTipPosition$' tip.out || complain "not said: $(cat tip.out)"
grep -q 'depth = -(measuredHeight + vDeflection/k), k = 0.05 N/m' out_height/identify.json || complain "the settings say nothing"
# jpk_refused FILE EXPECTED: instead of tip.txt.
jpk_refused() {
    sed "s|$work/curve.csv|$work/$1|" zero.toml >refused.toml
    refused "$2" identify "$work/refused.toml" --output out
}
sed 's/# units: m N/# units: m V/' tip.txt >volts.txt
jpk_refused volts.txt 'vDeflection in "V": "V" is not a unit of force; export it in N'
grep -v springConstant height.txt >loose.txt
jpk_refused loose.txt 'measuredHeight, which the bending of the cantilever is part of, and the file no line # springConstant'
sed 's/# segment: retract/# segment: extend/' tip.txt >twice.txt
jpk_refused twice.txt 'a second segment "extend" begins here; keep the one that is to be evaluated'
sed 's/# segment: extend/# segment: approach/' tip.txt >other.txt
jpk_refused other.txt 'has no segment "extend", which goes towards the sample; it has approach, pause, retract'
sed 's/\(e-0[0-9]\) \(-\{0,1\}[0-9]\)/\1 -\2/; s/--//' tip.txt >flipped.txt
jpk_refused flipped.txt 'has its largest force far from the sample'
sed "s|$work/curve.csv|$work/tip.txt|" curve.toml >no_zero.toml
refused 'the heights of a force curve count from anywhere; add "zero_depth" to measurement.find' \
    identify "$work/no_zero.toml" --output out
sed 's/force_indentation/contact_radius/; s/, "zero_depth"//' tip.toml >radius.toml
refused 'this is a force curve, which is read for measurement.force_indentation alone' identify "$work/radius.toml" --output out

# On a layer, too: depths counted from elsewhere change nothing but the depth of first touch, and the stated 4.22 MPa lie
# in the interval.
sed 's/find = .*/find = ["substrate.young", "zero_depth"]/; s/, *"half-space"//; s/"half-space", *//' \
    "$source_dir/examples/measurements/rig_indentation.toml" >layer.toml
cp "$source_dir/examples/measurements/rig_indentation.csv" .
"$program" identify layer.toml --output out_layer --quiet >layer.out 2>&1 || complain "layer: $(cat layer.out)"
awk -F, -v OFS=, '/^#|indentation/ { print; next } NF { $1 = $1 - 1000; print }' rig_indentation.csv >moved.csv
sed 's/rig_indentation.csv/moved.csv/' layer.toml >moved.toml
"$program" identify moved.toml --output out_moved --quiet >moved.out 2>&1 || complain "moved: $(cat moved.out)"
"$python" -S - <<'PYTHON' || complain "zero_depth on a layer: $(cat layer.out moved.out)"
import json
here, there = (json.load(open(f"out_{name}/identify.json"))["models"]["layer"] for name in ("layer", "moved"))
low, high = here["young_Pa"]["likelihood_interval"]
assert low < 4.22e6 < high, (low, high)
low, high = here["zero_depth_m"]["likelihood_interval"]
assert low < 0 < high, (low, high)
# As far as the search goes, 1e-6 of the values.
assert abs(here["young_Pa"]["value"] / there["young_Pa"]["value"] - 1) < 1e-5
moved = here["zero_depth_m"]["value"] - there["zero_depth_m"]["value"]
assert abs(moved / 1e-3 - 1) < 1e-5, moved
PYTHON

# A relaxation test of a standard solid: G_0/G_inf = 3, tau = 2 s, said with its misfit.
awk 'BEGIN { print "time [s], E [MPa]"
    for (k = 0; k < 25; k++) { t = 0.05 * 10 ^ (k / 8); printf "%.8g, %.10g\n", t, 1 + 2 * exp(-t / 2) } }' >test.csv
relaxing() {
    cat <<TOML
models = ["mdr"]
[indenter]
radius = "40 mm"
[substrate]
young = "1 MPa"
poisson = 0.5
[substrate.relaxation]
$1
[friction]
coefficient = 0.5
[load]
normal_force = "5 N"
tangential_ratio = 0.3
press_time = "1 s"
TOML
}
relaxing 'test = "test.csv"' >test.toml
"$program" check test.toml >test.check || complain "check: $(cat test.check)"
grep -q '# test.csv: Prony series of 1 term fitted to 25 times; residuals (root mean square) of E(t)' test.check ||
    complain "no misfit: $(cat test.check)"
# The table's digits bound what is found: 1e-6. G_1 = 2 G_inf = 2/3 MPa.
sed -n '/substrate.relaxation/,/^$/p' test.check | tr -d '[]"' | awk '/^moduli/ { m = $3 / 666666.67 - 1 }
    /^times/ { t = $3 / 2 - 1 } END { exit !(m * m < 1e-10 && t * t < 1e-10 && m != 0) }' ||
    complain "the solid is not found: $(cat test.check)"
"$program" run test.toml --no-studies --output out_test >test.out 2>&1 || complain "run: $(cat test.out)"
grep -q 'Prony series of 1 term fitted to 25 times' test.out || complain "no misfit in the terminal: $(cat test.out)"
grep -q 'Relaxation test' out_test/report.html || complain "no figure"
sed 's|"test.csv"|"'"$work"'/test.csv"|; s/poisson = 0.5/poisson = 0.3/; s/^test = /bulk = "elastic"\ntest = /' test.toml >bulk.toml
refused 'E(t) of test.csv relaxes otherwise than G(t) where the bulk modulus does not relax' check "$work/bulk.toml"

# A DMA table says its misfit in check and terminal, too; sets at several temperatures are not to be sorted.
awk 'BEGIN { print "frequency [Hz], G'\'' [MPa], G'\'''\'' [MPa]"
    for (k = 0; k < 12; k++) { w = 0.1 * 10 ^ (k / 4); x = w * 6.283185307 * 0.05
        printf "%.6g, %.6g, %.6g\n", w, 1 + x * x / (1 + x * x), x / (1 + x * x) } }' >dma.csv
relaxing 'dma = "dma.csv"' >dma.toml
"$program" check dma.toml | grep -q "# dma.csv: Prony series of 1 term fitted to 12 frequencies" || complain "check says no misfit"
"$program" run dma.toml --no-studies --no-report --output out_dma >dma.out 2>&1 || complain "dma: $(cat dma.out)"
grep -q 'Prony series of 1 term fitted to 12 frequencies' dma.out || complain "the terminal says no misfit: $(cat dma.out)"
{ cat dma.csv; sed 1d dma.csv; } >two.csv
relaxing "dma = \"$work/two.csv\"" >two.toml
refused 'the frequencies begin again, as in sets at several temperatures; keep the rows of one temperature, or shift all to a master curve' \
    check "$work/two.toml"

finish
