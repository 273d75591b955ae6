#!/usr/bin/env bash
# Steady rolling under friction that falls with the speed of slip: what the run tells, and where a force has no state.
# usage: falling_friction.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
case_file=$source_dir/examples/cases/rolling_falling_friction.toml

# value FOLDER KEY: of the steady state; KEY may be "from_fast_slip".
value() { "$python" -S -c "import json, sys; m = json.load(open('$1/summary.json'))['models'][0]; print(m['steady'].get('$2', m.get('$2')))"; }

# 1. One state, of which both searches tell; without a way from rest.
"$program" run "$case_file" --points 3 --quiet --output one >told.txt 2>&1 || complain "the example: $(cat told.txt)"
grep -q "from slow and from fast slip the same steady state is found" one/report.html || complain "one state is not told"
grep -q "From rest to steady rolling" one/report.html && complain "a way from rest is shown"
grep -q "falling by 0.12 p" one/report.html || complain "the law is not told"
value one from_fast_slip | grep -q "'force_ratio': -0.5940" || complain "from fast slip: $(value one from_fast_slip)"
"$program" run one/case.toml --points 0 --no-report --quiet --output again >told.txt 2>&1 || complain "again: $(cat told.txt)"
[ "$(value one force_ratio)" = "$(value again force_ratio)" ] || complain "the resolved case is another one"

# 2. Two of them, by a law whose second part is lost at 0.3 mm/s.
sed 's/^law.*/law = "rational"/; s/^drops.*/drops = [0.06, 0.06]/; s|^speeds.*|speeds = ["100 mm/s", "0.3162 mm/s"]|' \
    "$case_file" >two.toml
"$program" run two.toml --points 0 --quiet --output two >told.txt 2>&1 || complain "two states: $(cat told.txt)"
grep -q "leaves more than one steady state" two/report.html || complain "two states are not told"

# 3. Under a force the state of the creepage that has it, up to the peak of the creep curve, 0.8083 at 0.0021.
sed 's/^longitudinal_creepage.*//; s/^normal_force.*/&\ntangential_ratio = -0.7464/' "$case_file" >force.toml
"$program" run force.toml --points 0 --no-report --quiet --output force >told.txt 2>&1 || complain "a force: $(cat told.txt)"
awk -v xi="$(value force longitudinal_creepage)" 'BEGIN { exit (xi / -0.0015 - 1) ^ 2 > 1e-7 }' ||
    complain "the creepage of 0.7464 is 0.0015, not $(value force longitudinal_creepage)"
[ "$(value force from_fast_slip)" = None ] || complain "under a force there is no other state"
"$program" run force.toml --set load.tangential_ratio=-0.808 --points 0 --no-report --quiet --output peak >told.txt 2>&1 ||
    complain "just below the peak: $(cat told.txt)"
"$program" run force.toml --set load.tangential_ratio=-0.81 --points 0 --no-report --quiet --output none >told.txt 2>&1
[ $? = 2 ] || complain "a force beyond the peak: $(cat told.txt)"
grep -q "N is more than friction carries that falls with the speed of slip (186665 N at rest)" told.txt || complain "$(cat told.txt)"
[ ! -e none/summary.json ] || complain "a summary of no state"

finish
