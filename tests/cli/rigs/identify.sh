#!/usr/bin/env bash
# tricontact identify: the examples give their truth back, the half-space does not; every bad file
# is refused with one line and leaves nothing behind.
# usage: identify.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# number PATH: of the result in out, by python's notation of keys.
number() { "$python" -c "import json; print(json.load(open('out/identify.json'))$1)"; }
# holds EXPRESSION: in awk.
holds() { awk "BEGIN { exit !($1) }" || complain "$1: $2"; }

# 1. Depths: the layer finds the stated 4.22 MPa, the half-space twice as much.
"$program" identify "$source_dir/examples/measurements/rig_indentation.toml" --output out --quiet >text ||
    complain "indentation"
low=$(number "['models']['layer']['young_Pa']['likelihood_interval'][0]")
high=$(number "['models']['layer']['young_Pa']['likelihood_interval'][1]")
holds "$low < 4.22e6 && 4.22e6 < $high" "layer's interval holds the truth"
ratio=$(number "['models']['half-space']['young_over_reference']")
holds "1.9 < $ratio && $ratio < 2.1" "the half-space's E"
grep -q "The half-space finds E = .* too high" text || complain "no sentence: $(cat text)"
grep -q "<html" out/report.html || complain "no report"

# 2. Shifts: E and mu. 1 % for the coupling that the layer's springs leave out.
sed 's/, "bem-layer"//' "$source_dir/examples/measurements/rig_static_shift.toml" >shift.toml
cp "$source_dir/examples/measurements/rig_static_shift.csv" .
"$program" identify shift.toml --output out --quiet >text || complain "shift"
young=$(number "['models']['layer']['young_Pa']['value']")
friction=$(number "['models']['layer']['friction_coefficient']['value']")
holds "4.18e6 < $young && $young < 4.26e6" "E of the layer"
holds "0.564 < $friction && $friction < 0.576" "mu of the layer"
holds "$(number "['models']['half-space']['young_over_reference']") > 1.2" "the half-space's E"
holds "$(number "['models']['layer']['young_Pa']['change_by_standard_errors_of_inputs']['load.normal_force']") < 0" \
    "more force at the same shift is a stiffer hold, so a softer substrate"

# The posterior is that of the likelihood where all is nearly linear: medians within a fifth, widths within a quarter of
# the interval.
"$program" identify shift.toml --output out --quiet --posterior >text || complain "posterior: $(cat text)"
grep -q "^layer: posterior E = 4.2" text || complain "no posterior: $(cat text)"
for property in young_Pa friction_coefficient; do
    low=$(number "['models']['layer']['$property']['interval'][0]")
    high=$(number "['models']['layer']['$property']['interval'][1]")
    value=$(number "['models']['layer']['$property']['value']")
    from=$(number "['models']['layer']['posterior']['$property']['interval'][0]")
    to=$(number "['models']['layer']['posterior']['$property']['interval'][1]")
    median=$(number "['models']['layer']['posterior']['$property']['median']")
    holds "(($to - $from) / ($high - $low) - 1)^2 < 0.25^2" "width of the posterior of $property: $from to $to, not $low to $high"
    holds "(($median - $value) / ($high - $low))^2 < 0.2^2" "median of the posterior of $property: $median, not $value"
done
[ "$(wc -l <out/posterior.csv)" -gt 1000 ] || complain "no points of the posterior"

# By the maps: what the coupled runs of the data came from, within the maps' errors, in a second; the smallest force lies
# below their least load.
sed 's/^models = .*/models = ["half-space", "atlas"]/' shift.toml >mapped.toml
"$program" identify mapped.toml --output out --quiet >text || complain "by the maps: $(cat text)"
young=$(number "['models']['atlas']['young_Pa']['value']")
friction=$(number "['models']['atlas']['friction_coefficient']['value']")
holds "4.18e6 < $young && $young < 4.29e6" "E of the maps: $young"
holds "0.558 < $friction && $friction < 0.578" "mu of the maps: $friction"

# No map is about an indenter that gives way: refused, not read as a rigid one's.
sed 's/206 GPa/30 MPa/' mapped.toml >soft.toml
refused "no atlas is about indenters on a layer that are not rigid" identify ../soft.toml --quiet

# 3. Small forces tell no friction, and the report says so.
{
    echo "tangential_force [N], shift [um], shift_error [um]"
    for i in 1 2 3 4 5; do
        awk -v i="$i" 'BEGIN { printf "%g, %g, 0.3\n", i * 0.1, i * 2.23 + (i % 2) * 0.1 }'
    done
} >small.csv
sed 's/rig_static_shift.csv/small.csv/; s/"layer"/"half-space"/; s/"half-space", "half-space"/"half-space"/' \
    shift.toml >small.toml
"$program" identify small.toml --output out --quiet >text || complain "small forces"
grep -q "mu is not identifiable" text || complain "mu of small forces: $(cat text)"
grep -q "mu above 0\." text || complain "what small forces tell of mu: $(cat text)"
[ "$(number "['models']['half-space']['friction_coefficient']['likelihood_interval'][1]")" = None ] ||
    complain "the interval of mu is open"

# 4. Without errors in the table they are estimated from the residuals.
sed 's/, 0\.5$//; s/, shift_error \[um\]//' rig_static_shift.csv >plain.csv
sed 's/rig_static_shift.csv/plain.csv/' shift.toml >plain.toml
"$program" identify plain.toml --output out --quiet >text || complain "without errors"
[ "$(number "['models']['layer']['goodness']")" = None ] || complain "goodness without errors"

# 5. The thesis' curve belongs to a softer rubber with more friction.
"$program" identify "$source_dir/examples/rigs/sphere_parallel.toml" --output out --quiet \
    >text || complain "thesis"
young=$(number "['models']['half-space']['young_Pa']['value']")
holds "5.199e6 < $young && $young < 5.201e6" "the curve is that of the half-space: $young"
young=$(number "['models']['layer']['young_Pa']['value']")
holds "3.7e6 < $young && $young < 3.85e6" "E of the layer by the thesis' curve: $young"

# 6. The coupled layer, on a coarse grid: 0.5 % of E and mu by 8 cells in the radius.
sed 's/models = .*/models = ["bem-layer"]/; s/cells_per_radius = 12/cells_per_radius = 8/' \
    "$source_dir/examples/measurements/rig_static_shift.toml" | sed 's/ ± 0.1//' >coupled.toml
"$program" identify coupled.toml --output out --quiet >text || complain "bem-layer"
young=$(number "['models']['bem-layer']['young_Pa']['value']")
friction=$(number "['models']['bem-layer']['friction_coefficient']['value']")
holds "4.20e6 < $young && $young < 4.24e6" "E of bem-layer: $young"
holds "0.567 < $friction && $friction < 0.573" "mu of bem-layer: $friction"

# 7. Radii: the rig's exact one at 5.2 MPa (docs/explanation/models/mdr-layer.md), to its five digits; Hertz finds
#    (4.5028/4.3638)^3 of it.
cat >radius.toml <<'END'
[indenter]
radius = "40 mm"
[substrate]
poisson = 0.5
thickness = "8 mm"
[measurement]
contact_radius = "radius.csv"
find = ["substrate.young"]
models = ["half-space", "layer"]
END
printf 'normal_force [N], contact_radius [mm]\n21.1, 4.3637\n21.1, 4.3638\n21.1, 4.3639\n' >radius.csv
"$program" identify radius.toml --output out --quiet >text || complain "radii"
young=$(number "['models']['layer']['young_Pa']['value']")
holds "5.199e6 < $young && $young < 5.201e6" "E by the layer's radius: $young"
young=$(number "['models']['half-space']['young_Pa']['value']")
holds "5.711e6 < $young && $young < 5.715e6" "E by Hertz' radius: $young"

# 8. Coupled materials: the half-space's closed forms need no model that couples, a refusal names the
#    file's models, and no remedy asks for another material.
sed 's/models = .*/models = ["half-space", "bem-layer"]/; s/^poisson = .*/poisson = 0.48/' \
    coupled.toml >compressible.toml
"$program" identify compressible.toml --output out --quiet >text 2>err || complain "coupled: $(cat err)"
[ "$(number "['reference']")" = bem-layer ] || complain "no bem-layer at nu = 0.48"
sed 's/models = .*/models = ["half-space"]/' compressible.toml >alone.toml
"$program" identify alone.toml --output out --quiet >text 2>err || complain "alone: $(cat err)"

# 9. What stands behind ± is in the printed interval, of E by half of those of R: E ~ R^(-1/2).
sed 's/models = .*/models = ["half-space"]/' \
    "$source_dir/examples/measurements/rig_indentation.toml" >depth.toml
cp "$source_dir/examples/measurements/rig_indentation.csv" .
"$program" identify depth.toml --output out --quiet >plain_text || complain "depths"
grep -q "the rig's data taken as exact" plain_text || complain "exact inputs: $(cat plain_text)"
sed -i 's/^radius = .*/radius = "40 ± 2 mm"/' depth.toml
"$program" identify depth.toml --output out --quiet >text || complain "depths with errors"
found=$(number "['models']['half-space']['young_Pa']['value']")
low=$(number "['models']['half-space']['young_Pa']['interval'][0]")
holds "($found - $low) / $found > .045 && ($found - $low) / $found < .055" \
    "2.5 % of E, 1.96 times: $low below $found"
grep -q "and the errors of the rig's data" text || complain "uncertain inputs: $(cat text)"
grep -qE '·10|e-[0-9]' text && complain "a power of ten: $(cat text)"
grep -q "p < 0.001" text || complain "chance: $(cat text)"

# layer_finds SHARE NAME:TRUTH...: intervals of the layer that hold the truth and are narrower than this share of it.
layer_finds() {
    local share=$1 truth low high
    shift
    for truth in "$@"; do
        low=$(number "['models']['layer']['${truth%:*}']['interval'][0]")
        high=$(number "['models']['layer']['${truth%:*}']['interval'][1]")
        holds "$low < ${truth#*:} && ${truth#*:} < $high && $high - $low < $share * ${truth#*:}" \
            "${truth%:*} is $low to $high"
    done
}

# 10. Several tables together: shifts and depths tell E, mu and b of the layer, and no product of them alone; the
#     half-space explains neither.
sed 's/, "atlas"//' "$source_dir/examples/measurements/rig_joint.toml" >joint.toml
cp "$source_dir/examples/measurements/rig_indentation.csv" .
"$program" identify joint.toml --output out --quiet >text || complain "joint: $(cat text)"
layer_finds 0.05 young_Pa:4.22e6 friction_coefficient:0.57 thickness_m:0.008
grep -q "only in the combination" text && complain "a product where all is told: $(cat text)"
grep -q "^Use the values of layer: chi^2 rejects the half-space." text || complain "no choice: $(cat text)"
[ "$(number "['models']['layer']['told_combinations']")" = "[]" ] || complain "told combinations"
[ "$(number "['models']['half-space'].get('thickness_m')")" = None ] || complain "the half-space's thickness"
[ "$(number "['models']['layer']['tables']['force-indentation']['degrees_of_freedom'] < 7")" = True ] ||
    complain "rows less the share of the parameters"
# Forces at depths of a half-space tell E sqrt(R) alone.
sed 's/^find = .*/find = ["substrate.young", "indenter.radius"]/; s/"half-space", "layer"/"half-space"/' \
    "$source_dir/examples/measurements/rig_indentation.toml" >product.toml
"$program" identify product.toml --output out --quiet >text || complain "a product: $(cat text)"
grep -q "E and R are identifiable only in the combination E R^0.50 (standard error" text || complain "no product: $(cat text)"
grep -q "E not identifiable, R not identifiable" text || complain "each alone: $(cat text)"

# 11. A history tells modulus, share and time of a Prony term; its table was made with 4.22 MPa, 0.3, 10 s.
cp "$source_dir/examples/measurements/rig_relaxation.csv" .
"$program" identify "$source_dir/examples/measurements/rig_relaxation.toml" --output out --quiet >text || complain "relaxation"
layer_finds 0.1 young_Pa:4.22e6 relative_modulus_1:0.3 relaxation_time_1_s:10

# 12. Creep of a standard solid under a constant force, closed form: d^(3/2) ~ J(t) = 1 - g exp(-(1 - g) t/tau).
cat >creep.toml <<'END'
[indenter]
radius = "40 mm"
[substrate]
poisson = 0.5
[substrate.relaxation]
relative_moduli = [0.2]
times = ["5 s"]
[measurement]
indentation_creep = "creep.csv"
held_force = "5 N"
find = ["substrate.young", "substrate.relaxation.relative_moduli", "substrate.relaxation.times"]
models = ["half-space"]
END
awk 'BEGIN { print "time [s], indentation [um]"
    for (t = 1; t <= 100; t *= 1.6) {
        J = 1 - 0.4 * exp(-t * 0.6 / 10)
        printf "%.10g, %.10g\n", t, 1e6 * (3 * 5 * J / (4 * 4e6 / 0.75 * sqrt(0.04)))^(2 / 3) } }' >creep.csv
"$program" identify creep.toml --output out --quiet >text || complain "creep: $(cat text)"
for truth in young_Pa:4e6 relative_modulus_1:0.4 relaxation_time_1_s:10; do
    value=$(number "['models']['half-space']['${truth%:*}']['value']")
    holds "($value / ${truth#*:} - 1)^2 < 1e-12" "${truth%:*} of creep is $value" # digits of the table
done

# 13. Poisson's ratio follows from depths on a layer, not on a half-space.
sed 's/^find = .*/find = ["substrate.young", "substrate.poisson"]/' \
    "$source_dir/examples/measurements/rig_indentation.toml" >poisson.toml
"$program" identify poisson.toml --output out --quiet >text || complain "nu: $(cat text)"
grep -q "^layer .* 0.49. (0.48. to 0.500)" text || complain "nu by the layer: $(cat text)"
grep -q "^half-space .* not identifiable" text || complain "nu by the half-space: $(cat text)"
grep -q "told only in" text && complain "E is told by the bounds of nu: $(cat text)"

# 14. Shifts that follow the drive tell the pivot, 60 um too high, beside the own wobble of the coupled layer, which the
#     half-space has not; without the radius Dh/R alone.
cp "$source_dir/examples/measurements/rig_rolling_shift.csv" .
sed '/^static_shift/d; s/^find = .*/find = ["rig.pivot_height"]/; s/= 12$/= 8/
    s/^poisson = 0.5/young = "4.22 MPa"\n&/; s/^\[load\]/[friction]\ncoefficient = 0.57\n&/' \
    "$source_dir/examples/measurements/rig_pivot.toml" >pivot.toml
"$program" identify pivot.toml --output out --quiet >text || complain "pivot: $(cat text)"
low=$(number "['models']['bem-layer']['pivot_height_m']['interval'][0]")
high=$(number "['models']['bem-layer']['pivot_height_m']['interval'][1]")
holds "$low < 60e-6 && 60e-6 < $high && $high - $low < 25e-6" "the pivot's height: $low to $high"
holds "$(number "['models']['half-space']['pivot_height_m']['interval'][1]") < 0" "the half-space's pivot"
sed 's/^find = .*/find = ["rig.pivot_height", "indenter.radius"]/; s/, "bem-layer"//' pivot.toml >ratio.toml
"$program" identify ratio.toml --output out --quiet >text || complain "Dh and R: $(cat text)"
grep -q "Dh and R are identifiable only in the combination Dh R^−1.0 (" text || complain "no ratio: $(cat text)"

# 15. Close to sliding the coupled contact moves aside, off the grid that pressing needs: the grid grows. Shifts made with
#     E = 4.22 MPa, mu = 0.8 by bem-layer at nearly the largest force; chi^2 alone has one degree of freedom per row.
# shifts_under FORCE: edge.csv, three readings of that shift.
shifts_under() {
    "$program" run "$source_dir/examples/cases/rig_layer_parallel.toml" --no-studies --set 'models=["bem-layer"]' \
        --set friction.coefficient=0.8 --set load.tangential_force="$1 N" --set rolling.periods=1 \
        --set bem.cells_per_radius=12 --output edge --quiet >/dev/null 2>err || complain "a run under $1 N: $(cat err)"
    largest=$("$python" -c "import json; m = json.load(open('edge/summary.json'))['models']
print(1e6 * (m['bem-layer'] if isinstance(m, dict) else m[0])['static_shift_m'])" 2>err) || complain "$(cat err)"
    {
        echo "tangential_force [N], shift [um], shift_error [um]"
        printf '%s, %s, 0.5\n' "$1" "$largest" "$1" "$largest" "$1" "$largest"
    } >edge.csv
}
shifts_under 16.7
sed 's/rig_static_shift.csv/edge.csv/; s/^find = .*/find = ["friction.coefficient"]/
    s/^models = .*/models = ["bem-layer"]/; s/^poisson = 0.5/young = "5.2 MPa"\n&/; s/ ± [0-9.]*//' \
    "$source_dir/examples/measurements/rig_static_shift.toml" >edge.toml
"$program" identify edge.toml --output out --quiet >text 2>err || complain "close to sliding: $(cat err)"
friction=$(number "['models']['bem-layer']['friction_coefficient']['value']")
holds "0.795 < $friction && $friction < 0.805" "mu close to sliding: $friction"
# The maps end at mu = 2, below three times the largest F_T/F_N, up to which tables of shifts reach: no reason to refuse 0.8.
# Their error of 0.2 % of the shift is 0.6 um, a hundredth of mu.
shifts_under 14.5
sed -i 's/^models = .*/models = ["atlas"]/' edge.toml
"$program" identify edge.toml --output out --quiet >text 2>err || complain "maps beside large forces: $(cat err)"
friction=$(number "['models']['atlas']['friction_coefficient']['value']")
holds "0.785 < $friction && $friction < 0.815" "mu by the maps: $friction"
# Their bars are part of the interval, which says so; those of bem-layer above were none.
grep -q "from the likelihood and the errors of the maps, the rig's data taken as exact" text || complain "no maps: $(cat text)"
own=$(number "['models']['atlas']['friction_coefficient']['standard_error']")
all=$(number "['models']['atlas']['friction_coefficient']['combined_standard_error']")
holds "$all > 1.1 * $own" "mu by the maps: $own, with their bars $all"

# 16. The terminal, the report's sentence and the file count the same degrees of freedom: of mu at its bound none is taken.
"$program" identify small.toml --output out --quiet >text || complain "degrees of freedom"
printed=$(sed -n 's/^half-space .*, \([0-9]*\) degrees of freedom$/\1/p' text)
said=$(sed -n 's/.*chi^2 = .* with \([0-9]*\) degrees of freedom.*/\1/p' text)
[ -n "$printed" ] && [ "$printed" = "$said" ] &&
    [ "$printed" = "$(number "['models']['half-space']['degrees_of_freedom']")" ] ||
    complain "degrees of freedom: $printed, $said, $(number "['models']['half-space']['degrees_of_freedom']")"

# 17. Neither a term without effect nor a time without end: within seconds, with what is not identifiable.
cat >relaxing.toml <<'END'
[indenter]
radius = "40 mm"
[substrate]
poisson = 0.5
thickness = "11 ± 0.1 mm"
base = "bonded"
[substrate.relaxation]
relative_moduli = [0.3]
times = ["8 s"]
[measurement]
force_relaxation = "relaxing.csv"
held_indentation = "155 um"
find = ["substrate.young", "substrate.relaxation.relative_moduli", "substrate.relaxation.times"]
models = ["half-space", "layer"]
END
{
    echo "time [s], normal_force [N], normal_force_error [N]"
    printf '%s, 0.12\n' "0.5, 4.08" "1, 3.89" "2, 4.13" "3, 4.03" "5, 3.84" "7, 4.16" "10, 4.02" "14, 3.88" \
        "20, 3.99" "28, 4.10" "40, 4.04" "60, 3.93" "90, 4.00" "130, 3.92"
} >relaxing.csv
(ulimit -t 30; exec "$program" identify relaxing.toml --output out --quiet) >text 2>err ||
    complain "a substrate that does not relax: $(cat err)"
grep -q "^layer: tau_1 is not identifiable: no value from" text || complain "tau without its term: $(cat text)"

# 18. Without stated errors: a curve of another law is not recommended, and a misprint of one reading is named.
{
    echo "tangential_force [N], shift [um]"
    awk 'BEGIN { for (i = 1; i <= 12; ++i) printf "%g, %.4f\n", i * 0.9, 30 * i / (1 - i / 16) }'
} >law.csv
sed 's/rig_static_shift.csv/law.csv/' shift.toml >law.toml
"$program" identify law.toml --output out --quiet >text || complain "another law: $(cat text)"
grep -q "^layer: the residuals of static-shift show a pattern" text || complain "no pattern: $(cat text)"
grep -q "^Use the values" text && complain "recommended in spite of a pattern: $(cat text)"
awk -F, -v OFS=, 'NR == 6 { $2 += 12 } { print }' plain.csv >misprint.csv
sed 's/plain.csv/misprint.csv/' plain.toml >misprint.toml
"$program" identify misprint.toml --output out --quiet >text || complain "a misprint: $(cat text)"
grep -q "^layer: one row is an outlier: row 3 of static-shift (tangential force F_T = 3 N), " text ||
    complain "no outlier: $(cat text)"
"$program" identify plain.toml --output out --quiet >text
grep -qE "outlier|show a pattern" text && complain "an outlier or pattern in white noise: $(cat text)"

# 19. Adhesion that the rig states and no model has.
sed 's/^\[measurement\]/[rig]\nwork_of_adhesion = "2 J\/m2"\n&/' radius.toml >adhesive.toml
"$program" identify adhesive.toml --output out --quiet >text || complain "adhesion: $(cat text)"
grep -q "rig.work_of_adhesion = 2 J/m2 is left out.*from which radii alone give E .* % too low" text ||
    complain "adhesion left out in silence: $(cat text)"

# refused EXPECTED SED [TABLE]: the file of 2 changed, TABLE in place of its table.
n=0
refused() {
    local expected=$1 message code
    n=$((n + 1))
    mkdir refused && cp rig_static_shift.csv refused
    sed "$2" shift.toml >refused/bad.toml
    [ $# -lt 3 ] || printf "$3" >refused/rig_static_shift.csv
    message=$("$program" identify refused/bad.toml --output refused/out 2>&1 >stdout)
    code=$?
    [ "$code" -eq 2 ] || complain "exit code $code instead of 2: $expected"
    case $message in
        *$'\n'*) complain "more than one line: $message" ;;
        "error: "*"$expected"*) ;;
        *) complain "expected: $expected"$'\n'"       got: $message" ;;
    esac
    [ ! -e refused/out ] || complain "output in spite of the error: $expected"
    [ ! -s stdout ] || complain "text in spite of the error: $expected"
    rm -r refused
}
header='tangential_force [N], shift [um], shift_error [um]\n'
rows='1, 20, 1\n2, 45, 1\n3, 70, 1\n'
refused 'the table is empty' '' ''
refused 'rig_static_shift.csv:1: the table has 2 rows' '' "${header}1, 20, 1\n2, 45, 1\n"
refused 'the column "shift" has no unit in brackets' '' "tangential_force [N], shift\n1, 20\n2, 45\n3, 70\n"
refused 'tangential_force = -2: must be positive' '' "${header}1, 20, 1\n-2, 45, 1\n3, 70, 1\n4, 90, 1\n"
refused 'shift_error = 0: must be positive' '' "${header}${rows}4, 90, 0\n"
refused 'shift = nan: must be a finite number' '' "${header}${rows}4, nan, 1\n"
refused 'no value is positive' '' "${header}1, -20, 1\n2, -45, 1\n3, -70, 1\n"
refused 'unknown column "shift_eror"' '' "tangential_force [N], shift [um], shift_eror [um]\n${rows}"
refused 'unknown column "force"; known are tangential_force, shift, shift_error, normal_force' '' \
    "force [N], shift [um]\n1, 20\n2, 45\n3, 70\n"
refused 'the column shift is missing' '' "tangential_force [N]\n1\n2\n3\n"
refused 'shift reaches 340 m' '' 'tangential_force [N], shift [m]\n1, 20\n5, 120\n11, 340\n'
refused 'the contact would slide: F_T of the table reaches 11 N, mu F_N is 10.55 N' \
    's/^find = .*/find = ["substrate.young"]/; s/^\[load\]/[friction]\ncoefficient = 0.5\n[load]/'
refused 'unknown section [mesurement]; did you mean measurement?' 's/^\[measurement/[mesurement/'
refused 'missing section [measurement]: nothing was measured' '/^\[measurement/,$d'
refused 'nothing was measured; name a table: static_shift' '/^static_shift/d'
refused 'no history determines substrate.relaxation.times' 's/^find = .*/find = ["substrate.relaxation.times"]/'
refused 'has no effect without measurement.held_indentation' 's/^find/force_relaxation = "r.csv"\nfind/'
refused 'with shifts, nu is found by half-space and atlas, not by layer' 's/^find = .*/find = ["substrate.poisson"]/'
refused 'lengths of a layer under a sphere are not in proportion' \
    's/^find = .*/find = ["indenter.radius"]/; s/^radius/shape = "sphere"\nradius/'
refused 'finds radius and thickness only of a rigid paraboloid' \
    's/^find = .*/find = ["substrate.young", "indenter.radius"]/; s/"layer"/"bem-layer"/; s/206 GPa/30 MPa/; s/^\[load\]/[friction]\ncoefficient = 0.57\n[load]/'
refused 'measurement.find has substrate.young, which is found as the relaxed modulus; omit it' \
    's/^\[load\]/[substrate.relaxation]\nmodulus = "unrelaxed"\nrelative_moduli = [0.5]\ntimes = ["1 s"]\n&/'
refused 'missing.csv: ' 's/rig_static_shift.csv/missing.csv/'
refused 'missing key measurement.find' '/^find/d'
refused '"substrate.yung" is not one of' 's/"substrate.young"/"substrate.yung"/'
refused 'missing key load.normal_force; add the force under which' '/^normal_force/d'
refused 'missing key friction.coefficient' 's/^find = .*/find = ["substrate.young"]/'
refused 'layer is a model of a layer, but substrate.thickness is missing' '/thickness/d; /^base/d'
refused 'unknown key substrate.poison' 's/^poisson = 0.5/poison = 0.5/'
refused 'normal_force = "21.1 ± 0.1 mm"' 's/21.1 ± 0.1 N/21.1 ± 0.1 mm/'
refused 'is a setting of the computation' 's/= 12$/= "12 ± 1"/'
refused "leave out layer (bem and bem-layer do)" 's/^poisson = 0.5/poisson = 0.48/'
refused 'confidence = 1.5: must be' 's/^models/confidence = 1.5\nmodels/'
refused 'nothing determines rig.pivot_height; add rolling_shift' 's/^find = .*/find = ["rig.pivot_height"]/'
refused "rolling_shift determines the pivot's height; add rig.pivot_height" \
    's/^find/rolling_shift = "rig_static_shift.csv"\nfind/'
rolled='offset [mm], shift [um]\n-1, 5\n0, 4.2\n1, 3.1\n'
refused "rolling_shift alone determines the pivot's height" \
    's/^static/rolling/; s/^find = .*/find = ["substrate.young", "rig.pivot_height"]/' "$rolled"
refused 'the maps do not contain the shift of free rolling' \
    's/^static/rolling/; s/^find = .*/find = ["rig.pivot_height"]/; s/"layer"/"atlas"/' "$rolled"
pivot_alone='s/^static/rolling/; s/^find = .*/find = ["rig.pivot_height"]/; s/^poisson = 0.5/young = "4 MPa"\n&/
    s/^\[load\]/[friction]\ncoefficient = 0.5\n&/'
refused 'the offset is the same everywhere' "$pivot_alone" 'offset [mm], shift [um]\n1, 5\n1, 4.2\n1, 3.1\n'
refused 'the table has 2 rows' "$pivot_alone" 'offset [mm], shift [um]\n-1, 5\n1, 4.2\n'
refused 'without tangential force nothing determines the coefficient of friction' \
    's/^static_shift/force_indentation/' 'indentation [um], normal_force [N]\n100, 2\n200, 7\n'
printf '%d files refused\n' "$n"
finish
