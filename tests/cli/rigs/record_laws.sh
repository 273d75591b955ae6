#!/usr/bin/env bash
# Laws of friction in experiment and design: a record decides what tables under one load leave open, [friction] may have any law,
# loads that tell laws apart are proposed, and what has no meaning is refused.
# usage: record_laws.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# number FILE PATH: of a result, by python's notation of keys.
number() { "$python" -S -c "import json; print(json.load(open('$1'))$2)"; }
# holds EXPRESSION WHAT: in awk.
holds() { awk "BEGIN { exit !($1) }" || complain "$2: $1"; }

cp -r "$source_dir/examples" .
file=examples/records/lens_laws.toml
"$program" identify $file --output tables --quiet >text || complain "tables: $(cat text)"
grep -q '^These data cannot tell the laws of friction coulomb (mu p), shear-strength (tau_0) apart' text ||
    complain "the tables decide: $(cat text)"
"$program" experiment $file --output out --set bem.cells_per_radius=6 --quiet >text 2>err || complain "experiment: $(cat err)"
grep -q '^Tables and record support the law of friction shear-strength (tau_0)\.' text || complain "law: $(cat text)"
grep -q '^coulomb (mu p), E = .*: the record disagrees\.$' text || complain "Coulomb's law: $(cat text)"
grep -q '^shear-strength (tau_0), E = .*: the record agrees\.$' text || complain "strength: $(cat text)"
[ "$(number out/experiment.json "['laws']['named']")" = shear-strength ] || complain "named"
[ "$(number out/experiment.json "['laws']['record']['coulomb']['is_excluded']")" = True ] || complain "coulomb stays"
[ "$(number out/experiment.json "['laws']['tables']['named']")" = None ] || complain "the tables name one"
grep -q 'id="friction_laws"' out/report.html || complain "no section in the report"

# A limit run: under F_T = .65 F_lim Coulomb's law has w_lim = .238, a strength .28, the record .26 to .29.
"$python" "$source_dir/tests/cli/rigs/limit_record.py" examples/records/limit.csv
sed 's/^kind = .*/kind = "limit"/; s/^runs = .*/runs = ["limit.csv"]/; s/^tangential_force.*/tangential_force = "0.9624 N"/
    s/^models = \["mdr", "bem"\]/models = ["mdr"]/; /^resolution/d' $file >examples/records/limit.toml
"$program" experiment examples/records/limit.toml --output limit --quiet >text 2>err || complain "a limit run: $(cat err)"
grep -q '^Tables and record support the law of friction shear-strength (tau_0)\.' text || complain "law of a limit run: $(cat text)"
grep -q "^coulomb .*: W_lim = 0.276 .* by the law's closed form, measured from 0.302 to 0.337 mm: the record disagrees" text ||
    complain "Coulomb's limit: $(cat text)"
grep -q "^shear-strength .*: W_lim = 0.33.*: the record agrees" text || complain "the strength's limit: $(cat text)"

# The law that was found stands in [friction]: w_lim of f_T is its own, f = 2/pi [arccos w - w sqrt(1 - w^2)].
sed '/^\[measurement\]/,$d; s/^models.*/models = ["mdr"]/
    s/^poisson = 0.5/&\nyoung = "1.8 ± 0.03 MPa"\n[friction]\nshear_strength = "0.35 ± 0.007 MPa"/' $file >examples/records/known.toml
"$program" experiment examples/records/known.toml --output known --quiet >text 2>err || complain "a known law: $(cat err)"
grep -q '^MDR: U_stat = .*: agrees; .*friction.shear_strength' text || complain "U_stat under a law: $(cat text)"
f=$(number known/experiment.json "['normalised']['tangential_ratio']['value']")
w=$(number known/experiment.json "['normalised']['exact_amplitude_limit']['value']")
# tau_0 pi a^2 with a^3 = 3 F_N R/(4 E*), E* = 2.4 MPa.
holds "(q = $f*3.14159265*0.35e6*(3*0.5*0.01/(4*2.4e6))^(2/3)/1.07) > 0.9999 && q < 1.0001" "f_T"
holds "(x = 2/3.14159265*(atan2(sqrt(1 - $w*$w), $w) - $w*sqrt(1 - $w*$w)) - $f) < 1e-4 && x > -1e-4" "w_lim"
grep -q '"laws": null' known/experiment.json || complain "laws that nobody asked for"
grep -q 'F_T/(μ F_N)' known/report.html && complain "mu of a law without one"

# Of the example one axis, for speed.
design=examples/measurements/one_axis.toml
sed '/^load.tangential_ratio/d; s/^tangential_ratio.*/tangential_ratio = 0.65/' examples/measurements/design_laws.toml >$design
"$program" design $design --output plan >text || complain "design: $(cat text)"
grep -q '^All requirements can be met\.' text || complain "not met: $(cat text)"
grep -q '^separation from coulomb: D = ' text || complain "no separation: $(cat text)"
grep -q '^To be measured there, with what 350 kPa gives: sliding force (standard error 6.0 %): 1.48 N under F_N = 500 mN' text ||
    complain "no tables: $(cat text)"
grep -q '^look closer: tricontact run ' text || complain "a check that rig refuses: $(cat text)"
least=$(number plan/design.json "['varied']['design.load_ratio']['least']['value']")
holds "$least > 2 && $least < 5" "the least range of loads"
# Sliding alone, at loads 1, r^(1/2), r: x ~ r^(1/3) of the two slopes, D^2 = (n - (sum x)^2/sum x^2)/s^2.
sed 's/^sliding_error.*/sliding_error = 0.05/; s/^shift_error.*/shift_error = 0.9/; s/^tangential_ratio.*/tangential_ratio = 0.05/
    /^resolution/,/^repeats/d' $design >slopes.toml
"$program" design slopes.toml --output slopes >text || complain "slopes: $(cat text)"
ratio=$(number slopes/design.json "['varied']['design.load_ratio']['best']")
found=$(number slopes/design.json "['separation']['distances']['coulomb']")
holds "(r = $ratio ^ (-1/6)) > 0 && (s = 1 + r + r*r) > 0 && (d = sqrt(3 - s*s/(1 + r*r + r^4))/0.05) > 0 && (q = $found/d) > 0.97 && q < 1.03" "D"
"$program" design $design --set 'friction.shear_strength="0.35 ± 0.02 MPa"' --set friction.coefficient=0.3 \
    --set 'design.laws=["coulomb","shear-strength"]' --output two --json >two.json || complain "two rivals"
[ "$(number two.json "['separation']['distances']['shear-strength'] > 0")" = True ] || complain "two distances"

# refuses MESSAGE OPTIONS...: of the design.
refuses() { refused "$1" design "$work/$design" "${@:2}"; }
refuses 'power contains the law of [friction], shear-strength: no table tells them apart' --set 'design.laws=["power"]'
refuses 'shear-strength is the law of [friction] itself' --set 'design.laws=["shear-strength"]'
refuses 'the check of rigs presumes Coulomb' --set 'design.assumptions=["small_strains"]'
refuses 'designs have closed forms of the half-space' --set 'substrate.thickness="5 mm"'
sed 's/^tangential_ratio.*/tangential_ratio = 0/' $design >without.toml
refused 'static shifts need a force between 0 and what friction carries' design "$work/without.toml"
sed 's/^coefficient = .*/shear_strength = "0.1 MPa"/' examples/rigs/sphere_parallel.toml >examples/rigs/strength.toml
# tau_0 pi a^2/F_N, a^3 = 3 F_N R/(4 E*), E* = 6.93 MPa, the steel making it .1 % more: .302.
refused 'the case has tau = 100 kPa; give friction.coefficient alone, or take F_lim/F_N = 0.302 of the half-space in its place' \
    rig "$work/examples/rigs/strength.toml"
refused 'laws of friction are compared by closed forms of the half-space' experiment "$work/$file" --set 'substrate.thickness="5 mm"'
refused 'measurement.laws names the laws whose numbers are found' experiment "$work/$file" --set friction.coefficient=1
sed '/^models = \["mdr"/d' $file >examples/records/without.toml
refused 'records are held against models under each law, and the file names none' experiment "$work/examples/records/without.toml"
sed 's/^find = .*/find = ["substrate.young", "zero_depth"]\nforce_indentation = "pressed.csv"/' $file >examples/records/zero.toml
printf 'indentation [um], normal_force [N]\n100, 0.3\n120, 0.42\n150, 0.6\n160, 0.65\n' >examples/records/pressed.csv
refused 'zero_depth is found by tricontact identify' experiment "$work/examples/records/zero.toml"
finish
