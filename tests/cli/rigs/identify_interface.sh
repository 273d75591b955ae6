#!/usr/bin/env bash
# tricontact identify finds springs of the interface beside E and mu, holds them against a rigid one, and states where tables do not tell
# them; who does not know them is refused with one line.
# usage: identify_interface.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# number PATH: of the result in out, by python's notation of keys.
number() { "$python" -c "import json; print(json.load(open('out/identify.json'))$1)"; }
# holds EXPRESSION: in awk.
holds() { awk "BEGIN { exit !($1) }" || complain "$1: $2"; }
# within KEY VALUE PART: an interval holds the value, and is not wider than a part of it.
within() {
    local low high
    low=$(number "['models']['half-space']['$1']['interval'][0]")
    high=$(number "['models']['half-space']['$1']['interval'][1]")
    holds "$low < $2 && $2 < $high && $high - $low < $3 * $2" "$1"
}

# Springs of a rough lens, of tables that rings made.
"$program" identify "$source_dir/examples/measurements/rough_lens.toml" --output out --quiet >text || complain "rough lens"
within young_Pa 1.8e6 .03
within friction_coefficient .8 .03
within normal_stiffness_Pa_per_m 20e9 .4
within tangential_stiffness_Pa_per_m 10e9 .4
grep -q "^A rigid interface is excluded (likelihood ratio .*it would give E = 1.7" text || complain "rigid: $(cat text)"
grep -q "Of the springs, k_n alone is excluded" text || complain "k_n alone: $(cat text)"
holds "$(number "['interfaces']['rigid']['aicc_above_least']") > 50" "AICc"
grep -q "Springs of the interface" out/report.html || complain "no springs in the report"

# Known ones, in [interface], give the same E.
cp "$source_dir"/examples/measurements/{rough,lens}_*.csv .
sed '/^\[measurement\]/i [interface]\nnormal_stiffness = "20 MPa/mm"\ntangential_stiffness = "10 MPa/mm"
    s/, "interface[^]]*//' "$source_dir/examples/measurements/rough_lens.toml" >known.toml
"$program" identify known.toml --output out --quiet >text || complain "known springs"
within young_Pa 1.8e6 .02

# The smooth lens has none: open intervals, and a rigid interface is not excluded.
sed '/^force_indentation/d; s/rough_static/lens_static/; s/^find.*/find = ["substrate.young", "interface.tangential_stiffness"]\nlaws = ["shear-strength"]/' \
    "$source_dir/examples/measurements/rough_lens.toml" >smooth.toml
"$program" identify smooth.toml --output out --quiet >text || complain "smooth lens"
grep -q "^These data do not tell springs of the interface from a rigid one" text || complain "smooth: $(cat text)"
grep -q "k_t is not identifiable: all values above .* and a rigid interface are as likely" text || complain "open: $(cat text)"
within young_Pa 1.8e6 .05

# refused EXPECTED SED: the rough lens' file changed.
n=0
refused() {
    local expected=$1 message code
    n=$((n + 1))
    mkdir refused && cp rough_*.csv refused
    sed "$2" "$source_dir/examples/measurements/rough_lens.toml" >refused/bad.toml
    message=$("$program" identify refused/bad.toml --output refused/out 2>&1 >stdout)
    code=$?
    [ "$code" -eq 2 ] || complain "exit code $code instead of 2: $expected"
    case $message in
        *$'\n'*) complain "more than one line: $message" ;;
        "error: "*"$expected"*) ;;
        *) complain "expected: $expected"$'\n'"       got: $message" ;;
    esac
    [ ! -e refused/out ] || complain "output in spite of the error: $expected"
    rm -r refused
}
layer='s/^poisson.*/&\nthickness = "8 mm"/'
refused 'springs of the interface are identified by half-space and layer, not by bem-layer; leave out bem-layer' \
    "$layer"'; s/"half-space"/"bem-layer"/'
refused 'without static_shift nothing determines interface.tangential_stiffness' '/^static_shift/d; s/"friction.coefficient", //'
refused 'springs of the interface do not relax' 's/^poisson.*/&\n[substrate.relaxation]\nrelative_moduli = [0.2]\ntimes = ["1 s"]/
    s/^force_ind.*/force_relaxation = "rough_indentation.csv"\nheld_indentation = "0.1 mm"/'
refused 'substrate.base' "$layer"'; s/^thickness.*/&/; s/8 mm"/&\nbase = "frictionless"/; s/"half-space"/"layer"/'
refused 'friction.map' 's/^\[measurement\]/[friction]\ncoefficient = 0.8\nmap = "rough_indentation.csv"\n&/; s/"friction.coefficient", //'
printf '%d files refused\n' "$n"
finish
