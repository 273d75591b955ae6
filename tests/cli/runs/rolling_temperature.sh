#!/usr/bin/env bash
# Temperatures of both surfaces in steady rolling: what a run tells, in files, report and terminal, and what comes back from CONTACT's form.
# usage: rolling_temperature.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
case_file=$source_dir/examples/cases/rolling_temperature.toml

# value FOLDER KEY: of the steady state, or of what its temperatures rest on.
value() { "$python" -S -c "import json, sys; m = json.load(open('$1/summary.json'))['models'][0]; print(m['steady'].get('$2', (m['heat'] or {}).get('$2')))"; }
# near VALUE EXPECTED TOLERANCE
near() { awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { exit !((a - b) ^ 2 <= t ^ 2) }'; }

# 1. The steady state alone has them: summary, history, report, fields.
"$program" run "$case_file" --set bem.spacing="0.6 mm" --points 0 --quiet --output out >told.txt 2>&1 || complain "the example: $(cat told.txt)"
near "$(value out highest_temperature_degC)" 86.2 0.7 || complain "highest: $(value out highest_temperature_degC)"
near "$(value out peclet_substrate)" 6200 200 || complain "Pe: $(value out peclet_substrate)"
[ "$(value out substrate_share)" = 0.5 ] || complain "two bodies of one steel: $(value out substrate_share)"
grep -q "friction heats it by at most" out/report.html || complain "the report says no temperature"
[ "$(column highest_temperature_degC out/bem/history.csv | grep -c .)" = 1 ] || complain "rows of history.csv that have a temperature"
for field in temperature_indenter_degC temperature_substrate_degC; do
    grep -aq "$field" out/bem/steady.ex2 || complain "steady.ex2 has no $field"
    grep -aq "$field" out/bem/surface.ex2 && complain "on the way there is $field"
done
"$program" run out/case.toml --points 0 --no-report --quiet --output again >told.txt 2>&1 || complain "again: $(cat told.txt)"
[ "$(value out friction_rise_K)" = "$(value again friction_rise_K)" ] || complain "the resolved case is another one"

# 2. Without slip both surfaces are as warm as bodies of one steel that touch.
"$program" run "$case_file" --set bem.spacing="0.6 mm" --set tractive_rolling.longitudinal_creepage=0 --set tractive_rolling.lateral_creepage=0 \
    --points 0 --no-report --quiet --output cold >told.txt 2>&1 || complain "without slip: $(cat told.txt)"
near "$(value cold highest_temperature_degC)" 75 1e-9 || complain "without slip: $(value cold highest_temperature_degC)"

# 3. Of a case without heat nothing is said.
"$program" run "$source_dir/examples/cases/rolling_falling_friction.toml" --set "bem.spacing=0.3 mm" --points 0 --quiet --output other \
    >told.txt 2>&1 || complain "without heat: $(cat told.txt)"
[ "$(value other highest_temperature_degC)" = None ] || complain "a temperature of a case without heat"
grep -q "Surface temperatures" other/report.html && complain "temperatures in the report of a case without heat"
head -n 1 other/bem/history.csv | grep -q temperature && complain "a column of a case without heat"

# 4. Friction that falls as it heats: one state, from cold and from hot surfaces, without a way from rest; CONTACT ends at 0.881 on
# small cells.
"$program" run "$source_dir/examples/cases/rolling_hot_friction.toml" --set bem.spacing="0.6 mm" --points 2 --quiet --output hot >told.txt 2>&1 ||
    complain "hot friction: $(cat told.txt)"
near "$(value hot force_ratio)" 0.881 0.004 || complain "hot friction: $(value hot force_ratio)"
grep -q "from cold and from hot surfaces the same steady state is found" hot/report.html || complain "one state is not told"
grep -q "From rest to steady rolling" hot/report.html && complain "a way from rest is shown"
grep -q "Carter" hot/report.html && complain "theories of Coulomb's law are shown"

# 5. Written for CONTACT with H = 3 and read again, also without the case that stands behind.
"$program" contact export "$case_file" --models bem --output there >told.txt 2>&1 || complain "export: $(cat told.txt)"
grep -q "BKTEMP, HEATCP" there/rolling_temperature.inp || complain "no heat is written"
sed '/^%/d' there/rolling_temperature.inp >back.inp
"$program" contact import back.inp --output back >told.txt 2>&1 || complain "import: $(cat told.txt)"
cat back/*.toml | grep -q '^temperature = "150 degC"' || complain "heat does not come back: $(cat told.txt)"

finish
