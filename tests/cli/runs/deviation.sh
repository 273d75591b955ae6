#!/usr/bin/env bash
# tricontact deviation: exact part and its numbers in the documents, runs, taking over what is
# there; what is refused leaves nothing behind.
# usage: deviation.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
rig=$source_dir/examples/cases/rig_layer_parallel.toml

# 1. Exact theory alone: the rig's layer, and the thicknesses of docs/explanation/half-space-deviation.md.
"$program" deviation "$rig" --no-runs --quiet >out 2>err || complain "exact part: $(cat err)"
folder=results/rig_layer_parallel_deviation
for file in report.html deviation.csv deviation.json; do
    [ -s "$folder/$file" ] || complain "no $file"
done
[ ! -e "$folder/results.sqlite" ] || complain "runs in spite of --no-runs"
[ ! -s err ] || complain "not quiet: $(cat err)"
grep -q '36\.3 % below that of a half-space under the same force' out || complain "verdict: $(cat out)"
# documented SYMBOL [OURS]: the column nu = 0.5 of the table, of which the terminal has another symbol.
documented() {
    local found
    found=$(awk -F '   *' -v symbol="${2:-$1}" '$2 == symbol { print $5 ", " $6 ", " $7 }' out)
    grep -F "| $1 |" "$source_dir/docs/explanation/half-space-deviation.md" | cut -d'|' -f6 | grep -qF "${found:-none}" ||
        complain "docs: $1 at nu = 0.5 is $found"
}
documented a
documented d
documented p0 p_0
documented U_max
documented dF_N/dd k_n
documented dF_T/dU k_t
documented f_T,lim
documented w_lim

# 2. Runs: of a case that is loaded and not rolled, the quickest. Called again nothing is computed.
sed '/^\[rolling\]/,/^$/d; /^\[fem\]/,$d' "$rig" >static.toml
"$program" deviation static.toml --set load.press=frictionless --output static >out 2>err ||
    complain "runs: $(cat err)"
grep -qE '^static shift +u_stat ' out || complain "no static shift: $(cat out)"
! grep -q settled out || complain "a settled shift without rolling"
cp -r static before
"$program" deviation static.toml --set load.press=frictionless --output static --json >again 2>err
grep -qE '^([0-9]+) of \1 points are there already$' err || complain "computed again: $(cat err)"
"$python" -S - <<'PYTHON' || complain "--json: not the numbers of deviation.json: $(head -c 300 again)"
import json
answer, kept = (json.load(open(name)) for name in ("again", "static/deviation.json"))
answer["notes"] = kept["notes"] = None
assert answer == kept
PYTHON
for file in report.html deviation.csv deviation.json; do
    cmp -s "static/$file" "before/$file" || complain "$file differs the second time"
done

# Old results go at the start, not when the exact theory is done; of a case that is refused they stay.
refused "w = W/a is at least 1" deviation "$rig" --set rolling.amplitude_ratio=1.5 --output "$PWD/static"
[ -s static/report.html ] || complain "results removed by a call that is refused"
# Killed after one of the seconds that the theory takes.
(ulimit -t 1; exec "$program" deviation "$rig" --no-runs --quiet --output static) >out 2>err &&
    complain "was over within a second"
[ -z "$(ls static/*.html static/*.csv static/*.json 2>/dev/null)" ] || complain "old results stayed until the end"

refused "rig_sphere_parallel.toml: substrate.thickness is missing: without it" deviation \
    "$source_dir/examples/cases/rig_sphere_parallel.toml"
refused "the exact theory covers one layer" deviation "$source_dir/examples/cases/rig_layer_on_glue.toml"
refused "substrate.relaxation: deviations are those of an elastic layer" deviation \
    "$source_dir/examples/cases/rig_sphere_layer_relaxing.toml"
refused "w = W/a is at least 1" deviation "$rig" --set rolling.amplitude_ratio=1.5
refused "path_twist.toml: [path] or an amplitude in [load]: layer and half-space are compared under constant loads" deviation \
    "$source_dir/examples/cases/path_twist.toml"
refused "the file cannot be read" deviation missing.toml

finish
