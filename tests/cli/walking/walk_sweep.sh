#!/usr/bin/env bash
# tricontact sweep of walking machines: the same table whatever jobs, lots, kills and shards; the numbers
# of a run alone; machines that fit no lane; the reports that axes ask for; what is refused leaves
# nothing behind.
# usage: walk_sweep.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# study FILE LINES...: lines behind [vary].
study() {
    local file=$1
    shift
    cat >"$file" <<EOF
case = "$source_dir/examples/cases/walking_set_b.toml"
[set]
time.end = 60
[vary]
EOF
    printf '%s\n' "$@" >>"$file"
}

# 1. A map of more machines than a lot holds; its reports.
study map.toml 'machine.kappa8 = {from = 0, to = 2, points = 17}' \
    'machine.kappa5 = {from = 0.1, to = 2, points = 9}'
"$program" sweep map.toml --output whole --jobs 2 2>log || complain "the sweep failed: $(cat log)"
[ "$(rows whole)" -eq 153 ] || complain "not 153 rows"
[ "$(head -n 3 whole/results.csv | cut -d, -f1-3 | tr '\n' ' ')" = \
    "machine.kappa8,machine.kappa5,regime 0,0.1,steady 0,0.3375,steady " ] ||
    complain "order: $(head -n 3 whole/results.csv | cut -d, -f1-3)"
grep -q 'id="figure_map_friction"' whole/report.html || complain "no map in the report"
[ -s whole/map.html ] || complain "no page of the map"
grep -q 'href="map.html"' whole/report.html || complain "no link to the page of the map"

# 2. Whatever the jobs, and after kill -9, the same bytes; a lot that ended is kept.
"$program" sweep map.toml --output alone --jobs 1 --quiet || complain "one job"
cmp -s whole/results.csv alone/results.csv || complain "one job, another table"
for _ in 1 2 3 4 5; do  # one that ends before it can be killed is begun again
    rm -rf killed
    "$program" sweep map.toml --output killed --jobs 1 --quiet &
    child=$!
    for _ in $(seq 1 400); do  # until the first lot is committed
        [ -s killed/results.sqlite ] && [ ! -e killed/results.sqlite-journal ] &&
            [ "$(stat -c %s killed/results.sqlite)" -gt 100000 ] && break
        sleep 0.01
    done
    kill -9 "$child" 2>/dev/null
    wait "$child" 2>/dev/null
    [ -e killed/results.csv ] || break
done
"$program" sweep map.toml --output killed --jobs 2 2>log || complain "after kill -9: $(cat log)"
grep -qE '^(128|153) of 153 points are there already' log || complain "nothing kept: $(cat log)"
cmp -s whole/results.csv killed/results.csv || complain "killed, another table"

# 3. Shards: other company, the same numbers.
for i in 1 2 3; do "$program" sweep map.toml --shard "$i/3" --quiet || complain "shard $i"; done
"$program" sweep merge merged results/map_shard_*_of_3 >log || complain "merge: $(cat log)"
"$program" sweep map.toml --output merged 2>log
grep -q '^153 of 153 points are there already' log || complain "merged: $(cat log)"
cmp -s whole/results.csv merged/results.csv || complain "shards, another table"

# 4. Machines that fit no lane run by themselves: without coupling, with a load from outside.
study single.toml 'mechanisms.coupling = [true, false]' 'machine.kappa5 = [0.4, 0.5]'
"$program" sweep single.toml --output single --jobs 2 --quiet || complain "machines by themselves"
[ "$(column regime single/results.csv | sort -u | wc -l)" -ge 1 ] && [ "$(rows single)" -eq 4 ] ||
    complain "rows of machines by themselves"

# 5. Lists of few numbers are an experiment, starts alone a study of starts.
study effects.toml 'machine.kappa2 = [1, 1.2, 1.4]' 'machine.kappa3 = [0.5, 1]' \
    'machine.kappa5 = [0.2, 0.4]'
"$program" sweep effects.toml --output effects --quiet || complain "effects"
grep -q 'id="figure_main_effects_friction"' effects/report.html || complain "no main effects"
grep -q 'id="table_interactions_friction"\|interactions_friction' effects/report.html ||
    complain "no effects of pairs"
study starts.toml 'start.x = [-1, 0, 1]' 'start.phi_velocity = [-1, 0, 1]'
"$program" sweep starts.toml --output starts --quiet || complain "starts"
grep -q 'id="figure_effects_on_kinetic_energy"' starts/report.html || complain "no energies"

study bad.toml 'machine.kappa5 = [0.5, -0.1]'
refused "../bad.toml:5:18: machine.kappa5 = -0.1: must be" sweep ../bad.toml
study bad.toml 'machine.kapa5 = [0.5]'
refused "unknown key vary.machine.kapa5: the case has no key machine.kapa5; did you mean" \
    sweep ../bad.toml
study bad.toml 'time.step = [0.001, 3]'
refused "../bad.toml: point time.step = 3: " sweep ../bad.toml
study bad.toml 'machine.kappa5 = [0.5]'
sed -i '1s/^/models = ["mdr"]\n/' bad.toml
refused "../bad.toml:1:1: a walking case has no models; omit the key" sweep ../bad.toml
study bad.toml 'machine.kappa5 = [0.5]'
refused "--vtk: studies of walking machines write no files for ParaView" sweep ../bad.toml --vtk
refused "is a study of walking machines" fit ../bad.toml

# 6. A machine on rounded tips shakes down, or ratchets, as it is rocked: its limit is m = 0.5.
cat >rocking.toml <<END
case = "$source_dir/examples/cases/walking_rocking.toml"
[set]
bed.springs = 24
time.end = 2513.3
[vary]
excitation.moment = [3e-5, 7e-5]
END
"$program" sweep rocking.toml --output rocking --quiet >/dev/null || complain "rocking"
grep -q '^3e-05,shakedown,' rocking/results.csv || complain "0.3 does not shake down"
grep -q '^7e-05,ratcheting,' rocking/results.csv || complain "0.7 does not ratchet"
grep -q 'Quasi-static, it shakes down up to' rocking/report.html || complain "no limit in the report"

# 7. The studies of the thesis are refused by nothing but their size.
for file in "$source_dir"/examples/studies/walking_*.toml; do
    "$program" sweep "$file" --output example --shard 1/100000 --quiet || complain "$file"
    rm -rf example
done

finish
