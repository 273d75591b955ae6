#!/usr/bin/env bash
# tricontact sweep and merge: rows of a study, the same numbers as runs one by one, points that a
# changed study shares with the old one, shards, samples, levels, failures; what is refused leaves
# nothing behind.
# usage: sweep.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# study FILE LINES...: a small one, lines standing behind [vary].
study() {
    local file=$1
    shift
    cat >"$file" <<EOF
case = "$source_dir/examples/cases/rig_sphere_parallel.toml"
models = ["mdr", "bem"]
[set]
rolling.steps = "turning-points"
rolling.periods = 3
mdr.springs = 300
bem.cells_per_radius = 6
[vary]
EOF
    printf '%s\n' "$@" >>"$file"
}

# 1. All combinations in their order; the numbers of `run`.
study a.toml 'load.tangential_ratio = [0.1, 0.3]' \
    'rolling.amplitude = {from = "0.5 mm", to = "1.5 mm", points = 3}'
"$program" sweep a.toml --output a --jobs 2 2>log || complain "the sweep failed: $(cat log)"
[ "$(rows a)" -eq 12 ] || complain "not twelve rows"
[ "$(cut -d, -f1-4 a/results.csv | sed -n '1p;2p;3p;4p;8p' | tr '\n' ' ')" = \
    "load.tangential_ratio,rolling.amplitude_m,model,level 0.1,5e-04,mdr,0 0.1,5e-04,bem,0 \
0.1,0.001,mdr,0 0.3,5e-04,mdr,0 " ] || complain "order: $(cut -d, -f1-4 a/results.csv)"
grep -q '^sweep: 12 points in ' log || complain "progress: $(cat log)"
"$program" run "$source_dir/examples/cases/rig_sphere_parallel.toml" --output alone --quiet --no-report \
    --no-studies --models bem --set rolling.steps=turning-points --set rolling.periods=3 \
    --set bem.cells_per_radius=6 --set load.tangential_ratio=0.3 --set "rolling.amplitude=1 mm"
for name in final_shift_ratio contact_radius_m limit_tangential_ratio; do
    alone=$(grep -m1 "\"$name\"" alone/summary.json | sed 's/.*: //; s/,$//')
    [ "$(column "$name" a/results.csv | sed -n 10p)" = "$alone" ] ||
        complain "$name differs from that of a run alone: $alone"
done

grep -q '12 points computed, none failed' a/report.html || complain "the report's verdict"
[ "$(grep -c '<figure id="figure_static_shift_ratio_[12]"' a/report.html)" -eq 2 ] || complain "figures of the report"

# Files for ParaView: of points that have results too, which stay as they are; the report names them.
before=$(md5sum <a/results.csv)
"$program" sweep a.toml --output a --vtk --quiet 2>log || complain "--vtk failed: $(cat log)"
[ "$(md5sum <a/results.csv)" = "$before" ] || complain "--vtk changed results"
[ "$(find a/points -name surface.ex2 | wc -l)" -eq 12 ] || complain "not twelve series"
link=$(grep -o 'href="points/[0-9a-f]*/bem/surface.ex2"' a/report.html | head -1)
[ -n "$link" ] && [ -f "a/$(cut -d'"' -f2 <<<"$link")" ] || complain "the report's link: $link"
folder=$(dirname "$(dirname "a/$(cut -d'"' -f2 <<<"$link")")")
"$program" run "$folder/case.toml" --output rerun --quiet --no-report --no-studies
cmp -s rerun/bem/history.csv "$folder/bem/history.csv" || complain "a point's case is another"
study none.toml 'load.tangential_ratio = [0.1]'
sed -i 's/^\[set\]/&\noutput.vtk = "none"/' none.toml
"$program" sweep none.toml --output none --vtk 2>log && complain "--vtk without files"
grep -q 'output.vtk = "none" leaves nothing to write' log || complain "no reason: $(cat log)"
[ ! -e none ] || complain "a folder without results"

# 2. Called again nothing is computed; a study with more points takes over what is there.
"$program" sweep a.toml --output a 2>log || complain "the second call"
grep -q '^12 of 12 points are there already$' log || complain "computed again: $(cat log)"
study b.toml 'load.tangential_ratio = [0.3, 0.1, 0.2]' \
    'rolling.amplitude = ["1 mm", "0.15 cm"]'
cp -r a b
"$program" sweep b.toml --output b 2>log || complain "the changed study"
grep -q '^8 of 12 points are there already$' log || complain "shared points: $(cat log)"
"$program" sweep b.toml --output b_alone --quiet --no-report
[ -e b/report.html ] && [ ! -e b_alone/report.html ] || complain "--no-report"
cmp -s b/results.csv b_alone/results.csv || complain "the changed study differs from a new one"

# 3. Shards are disjoint and complete; merged they are the whole, twice merged too.
for i in 1 2 3; do
    "$program" sweep a.toml --shard $i/3 --quiet || complain "shard $i"
    [ -e results/a_shard_${i}_of_3/results.csv ] || complain "no folder of shard $i"
done
[ "$(cat results/a_shard_*/results.csv | grep -vc '^load')" -eq 12 ] || complain "rows of the shards"
"$program" sweep merge whole results/a_shard_* >log || complain "merge"
"$program" sweep merge whole results/a_shard_* a >again || complain "merging again"
[ "$(sed 's/.*: \([0-9]*\) points, 0 failures/\1/' log | paste -sd+ | tr -d '\n' | tee sum |
    awk -F+ '{ print $1 + $2 + $3 }')" -eq 12 ] || complain "merged: $(cat log)"
[ "$(grep -c ': 0 points, 0 failures$' again)" -eq 4 ] || complain "merged again: $(cat again)"
"$program" sweep a.toml --output whole 2>log
grep -q '^12 of 12 points are there already$' log || complain "points of the merge: $(cat log)"
cmp -s a/results.csv whole/results.csv || complain "the merged table is another one"

# 4. A sample: so many points, within its range, one in each part.
study sample.toml 'rolling.amplitude_ratio = {from = 0.1, to = 0.4}' \
    'load.tangential_force = {from = "0.1 N", to = "1 N", scale = "log"}' \
    '[latin_hypercube]' 'points = 6'
"$program" sweep sample.toml --output sample --quiet || complain "the sample"
[ "$(rows sample)" -eq 12 ] || complain "rows of the sample"
[ "$(column rolling.amplitude_ratio sample/results.csv | awk 'NR % 2 { print int(($1 - .1)/.05) }' |
    sort | tr -d '\n')" = 012345 ] || complain "parts of the sample"
[ "$(column load.tangential_force_N sample/results.csv |
    awk 'NR % 2 { print int(6*log($1/.1)/log(10)) }' | sort | tr -d '\n')" = 012345 ] ||
    complain "parts of the sample, log"

# 5. Levels: 2^(k/2) finer, so that the settled area of a press is closer to Hertz'.
study levels.toml 'load.tangential_ratio = [0.3]'
sed -i 's/^models/levels = 3\nmodels/' levels.toml
"$program" sweep levels.toml --output levels --quiet || complain "levels"
[ "$(column level levels/results.csv | tr -d '\n')" = 012012 ] || complain "levels of the rows"
[ "$(column static_shift_ratio levels/results.csv | sort -u | wc -l)" -eq 6 ] ||
    complain "levels do not differ"

# 6. Points that fail are told; the others stand.
study failing.toml 'load.tangential_force = ["1 N", "4000 N"]'
sed -i 's/^\[set\]/[set]\nload.indentation = "0.5 mm"/' failing.toml
message=$("$program" sweep failing.toml --output failing --quiet 2>&1)
[ $? -eq 1 ] || complain "exit code of failed points"
[[ $message == "error: 2 of 4 points failed"*"--retry-failed"* ]] || complain "failed: $message"
[ "$(column state failing/results.csv | sed -n 1p)" != "" ] || complain "the other points"
[ "$(tail -n 1 failing/results.csv | grep -c 'reaches the friction limit')" -eq 1 ] || complain "no error in the table"
grep -q '2 of 4 points failed' failing/report.html || complain "failures in the report"

study bad.toml 'rolling.amplitude_ratio = [0.1]' 'load.tangential_force = ["1 N", "4000 N"]'
refused "bad.toml: point rolling.amplitude_ratio = 0.1, load.tangential_force_N = 4000, mdr, level 0: ../bad.toml:10" \
    sweep ../bad.toml
study bad.toml 'load.tangential_ratio = [0.1, 1.2]'
refused "../bad.toml:9:25: load.tangential_ratio = 1.2: must be" sweep ../bad.toml
study bad.toml 'load.tangential_ratio = {from = 0.1, to = 0.2, points = 400}' \
    'rolling.amplitude_ratio = {from = 0.1, to = 0.2, points = 400}'
refused "the study has 320000 points, more than 100000" sweep ../bad.toml
refused "the file cannot be read" sweep missing.toml
refused "--shard 4/3: must be i/n" sweep ../a.toml --shard 4/3
refused "--shard 0/3: must be i/n" sweep ../a.toml --shard 0/3
refused "--shard 1of3: must be i/n" sweep ../a.toml --shard 1of3
refused "this is a contact case, not a study" sweep "$source_dir/examples/cases/rig_sphere_parallel.toml"
refused "missing: holds no results.sqlite" sweep merge out missing
refused "is the output folder too" sweep merge ../whole ../whole
echo "no database at all, but long enough to be taken for one" >results/results.sqlite
refused "is no file of results" sweep merge ../whole ../results
refused "results.sqlite: is there already, and tricontact did not write it" sweep ../a.toml --output ../results

# 7. The example of docs/how-to/sweeps.md is refused by nothing but its size.
"$program" sweep "$source_dir/examples/studies/rig_layer.toml" --output example --shard 1/100000 --quiet ||
    complain "the example"

finish
