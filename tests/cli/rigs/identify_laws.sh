#!/usr/bin/env bash
# tricontact identify compares laws of friction: the lens is one of constant strength, Coulomb's law alone is held against one; what
# laws and loads cannot have beside them is refused with one line and leaves nothing behind.
# usage: identify_laws.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# number PATH: of the result in out, by python's notation of keys.
number() { "$python" -c "import json; print(json.load(open('out/identify.json'))$1)"; }
# holds EXPRESSION: in awk.
holds() { awk "BEGIN { exit !($1) }" || complain "$1: $2"; }

# Laws of friction: the lens is one of constant strength, whose modulus Coulomb's law would miss.
"$program" identify "$source_dir/examples/measurements/lens_laws.toml" --output out --quiet >text || complain "laws"
grep -q "The data support the law of friction shear-strength" text || complain "law: $(cat text)"
grep -q "^Excluded: coulomb (mu p) (likelihood ratio " text || complain "Coulomb's law: $(cat text)"
for number in young_Pa:1.8e6 shear_strength_Pa:0.35e6; do
    low=$(number "['models']['half-space']['${number%:*}']['interval'][0]")
    high=$(number "['models']['half-space']['${number%:*}']['interval'][1]")
    holds "$low < ${number#*:} && ${number#*:} < $high && $high < 1.05 * $low" "${number%:*} of the lens"
done
holds "$(number "['laws_of_friction']['compared']['coulomb']['aicc_above_least']") > 100" "AICc"
grep -q "shear-strength" out/report.html || complain "no laws in the report"

# Two laws alone, a known one, and the old question: E and mu of the shifts under the largest load.
sed 's/^laws = .*/laws = ["coulomb", "shear-strength"]/' "$source_dir/examples/measurements/lens_laws.toml" >lens.toml
cp "$source_dir"/examples/measurements/lens_*.csv .
"$program" identify lens.toml --output out --quiet >text || complain "two laws"
grep -q "^Excluded: coulomb (mu p) (AICc 1[0-9][0-9] above that of shear-strength)" text || complain "two laws: $(cat text)"
sed '/^laws/d; s/^\[measurement\]/[friction]\nshear_strength = "0.35 MPa"\n&/' lens.toml >known.toml
"$program" identify known.toml --output out --quiet >text || complain "a known law"
holds "1.78e6 < $(number "['models']['half-space']['young_Pa']['value']") && $(number \
    "['models']['half-space']['young_Pa']['value']") < 1.82e6" "E under a known strength"
grep -v '^0.1,\|^0.3,' lens_static_shift.csv | sed 's/^normal_force \[N\], //; s/^1.0, //' >one_load.csv
sed '/^laws\|^sliding/d; s/^find = .*/find = ["substrate.young", "friction.coefficient"]/; s/lens_static_shift/one_load/
    s/^\[measurement\]/[load]\nnormal_force = "1 N"\n&/' lens.toml >old.toml
"$program" identify old.toml --output out --quiet >text || complain "E and mu"
grep -q "^Coulomb's law .*shear strength" text || complain "Coulomb's law without a word: $(cat text)"

# A law that [friction] states: its numbers are found, one or all, and three are more than a strength tells.
stated() { sed '/^laws/d; s/^find = .*/find = ["substrate.young", '"$2"']/; s/^\[measurement\]/[friction]\n'"$1"'\n&/' lens.toml >stated.toml; }
stated '' '"friction.shear_strength"'
"$program" identify stated.toml --output out --quiet >text || complain "a stated strength: $(cat text)"
holds "347e3 < $(number "['models']['half-space']['shear_strength_Pa']['value']") && $(number \
    "['models']['half-space']['shear_strength_Pa']['value']") < 353e3" "tau_0 of a stated strength"
stated 'coefficient = 20' '"friction.strength_limit"'
"$program" identify stated.toml --output out --quiet >text || complain "a cap: $(cat text)"
holds "345e3 < $(number "['models']['half-space']['strength_limit_Pa']['value']") && $(number \
    "['models']['half-space']['strength_limit_Pa']['value']") < 357e3" "tau_cap of mu = 20"
stated 'coefficient = 1\npressure_exponent = 0.8\nreference_pressure = "0.1 MPa"' \
    '"friction.shear_strength", "friction.coefficient", "friction.pressure_exponent"'
"$program" identify stated.toml --output out --quiet >text || complain "three numbers: $(cat text)"
grep -q "n is not identifiable: no value from 0 to 2.00 is excluded" text || complain "three numbers: $(cat text)"
grep -q "^One law of friction, tau = tau_0 + mu p_r (p/p_r)^n, p_r = 100 kPa, was stated: it was not compared" text ||
    complain "the law as stated: $(cat text)"

# Coulomb's law alone, no errors stated: the pattern of its residuals calls it wrong.
sed 's/^laws = .*/laws = ["coulomb"]/' lens.toml >alone.toml
"$program" identify alone.toml --output out --quiet >text || complain "Coulomb's law alone"
grep -q "^None of the laws of friction compared explains the tables" text || complain "alone: $(cat text)"
grep -q "^Excluded: coulomb (mu p) (its residuals show a pattern)" text || complain "alone: $(cat text)"
sed '/^laws/d; s/^find = .*/find = ["substrate.young", "friction.coefficient"]/' lens.toml >assumed.toml
"$program" identify assumed.toml --output out --quiet >text || complain "Coulomb's law assumed"
grep -q "^Coulomb's law was assumed, and a half-space with a shear strength excludes it (AICc" text || complain "assumed: $(cat text)"
grep -q "^The values of half-space are not to be used before the reason is known: its residuals" text || complain "assumed: $(cat text)"

sed 's/, "bem-layer"//' "$source_dir/examples/measurements/rig_static_shift.toml" >shift.toml
cp "$source_dir/examples/measurements/rig_static_shift.csv" .
# refused EXPECTED SED [TABLE]: the rig's file changed, TABLE in place of its table.
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
laws='laws = ["coulomb", "shear-strength"]'
header='tangential_force [N], shift [um], shift_error [um]\n'
rows='1, 20, 1\n2, 45, 1\n3, 70, 1\n'
refused 'laws of friction are compared by half-space and layer, not by bem-layer' \
    's/^find = .*/find = ["substrate.young"]\n'"$laws"'/; s/"layer"/"bem-layer"/'
refused 'has friction.coefficient beside measurement.laws' 's/^models.*/models = ["half-space"]\n'"$laws"'/'
only_half_space='s/^find = .*/find = ["substrate.young"]/; s/^models.*/models = ["half-space"]\n'"$laws"'/'
refused 'measurement.laws names the laws whose numbers are found; omit it' \
    "$only_half_space"'; s/^\[load\]/[friction]\ncoefficient = 0.5\n[load]/'
refused 'no table has friction; add static_shift, sliding_force or friction_loop' "$only_half_space; s/^static_shift/force_indentation/" \
    'indentation [um], normal_force [N]\n100, 2\n200, 7\n300, 13\n'
refused '3 rows do not determine 3 values' \
    's/^find = .*/find = ["substrate.young"]/; s/^models.*/models = ["half-space"]\nlaws = ["power"]/' \
    "$header$rows"
refused 'sliding_force does not determine the modulus' "$only_half_space; s/^static_shift/sliding_force/" \
    'normal_force [N], sliding_force [N]\n1, 2\n2, 3\n3, 4\n'
refused 'load.normal_force = "21.1 ± 0.1 N": the rows of static_shift state their own normal forces' '' \
    'normal_force [N], tangential_force [N], shift [um]\n5, 1, 20\n10, 2, 45\n20, 3, 70\n'
refused 'bem-layer identifies under Coulomb' \
    's/^find = .*/find = ["substrate.young"]/; s/^\[load\]/[friction]\nshear_strength = "1 MPa"\n[load]/; s/"layer"/"bem-layer"/'
refused 'has friction.strength_limit of a law without mu' 's/"friction.coefficient"/"friction.strength_limit"/'
refused 'has n of mu p_r (p/p_r)^n, which [friction] does not state' 's/"friction.coefficient"/&, "friction.pressure_exponent"/'
refused 'without tangential force nothing determines friction.shear_strength' \
    's/"friction.coefficient"/"friction.shear_strength"/; s/^static_shift/force_indentation/' \
    'indentation [um], normal_force [N]\n100, 2\n200, 7\n300, 13\n'
refused 'has friction.shear_strength beside measurement.laws' \
    's/"friction.coefficient"/"friction.shear_strength"/; s/^models.*/models = ["half-space"]\n'"$laws"'/'
refused 'bem-layer identifies under Coulomb' 's/"friction.coefficient"/"friction.shear_strength"/; s/"layer"/"bem-layer"/'
printf '%d files refused\n' "$n"
finish
