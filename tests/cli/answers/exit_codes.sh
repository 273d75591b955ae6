#!/usr/bin/env bash
# Exit codes and what stands on standard output and standard error: 0 done, 1 did not converge,
# 2 bad input (in full: bad_input.sh).
# usage: exit_codes.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
case_file=$source_dir/examples/cases/rig_sphere_parallel.toml
coarse=(--set rolling.periods=1 --set rolling.steps=turning-points --set "bem.spacing=0.5 mm"
    --no-report)

# expect CODE ARGUMENTS...: output goes to the files out and err.
expect() {
    local code=$1 got
    shift
    "$program" "$@" >out 2>err
    got=$?
    [ "$got" -eq "$code" ] || complain "exit code $got instead of $code: $*: $(cat err)"
}

# 1. Done: results on disk, progress on standard error, a line per model and the folder on standard output.
expect 0 run "$case_file" "${coarse[@]}"
[ "$(wc -l <out)" -eq 3 ] || complain "run writes to standard output: $(cat out)"
grep -qx "results: results/rig_sphere_parallel" out || complain "no closing line: $(cat out)"
grep -q "^mdr: .* steps in .* s, " err || complain "no line for mdr: $(cat err)"
grep -q "^bem: .* steps in .* s, " err || complain "no line for bem: $(cat err)"
grep -q $'\r' err && complain "a progress bar where there is no terminal"
[ -s results/rig_sphere_parallel/summary.json ] || complain "no summary.json"
[ -e results/rig_sphere_parallel/report.html ] && complain "a report in spite of --no-report"

expect 0 run "$case_file" "${coarse[@]}" --quiet --models mdr --output quiet
[ -s out ] || [ -s err ] && complain "--quiet is not silent: $(cat out err)"
[ -d quiet/bem ] && complain "--models mdr ran bem"

# 2. Not converged: rounding forbids a residual of 1.1e-14. One line says so; no numbers are left.
# Nor those of an earlier run into the same folder.
expect 0 run "$case_file" "${coarse[@]}" --quiet --models bem --output impossible
expect 1 run "$case_file" "${coarse[@]}" --quiet --models bem --set bem.tolerance=1.1e-14 \
    --output impossible
[ "$(wc -l <err)" -eq 1 ] || complain "not one line: $(cat err)"
grep -q "^error: .*residual .* after .* iterations" err || complain "message: $(cat err)"
[ -z "$(find impossible -name summary.json -o -name history.csv -o -name report.html)" ] ||
    complain "results of a run that did not converge: $(find impossible)"

# 3. Without gnuplot everything is there but its pictures, which is said: the page draws its figures itself, and names no files
# that are missing.
PATH=/nowhere expect 0 run "$case_file" "${coarse[@]:0:6}" --quiet --models mdr --output undrawn
grep -q "^warning: undrawn/plots is left out, since gnuplot is not there .*gnuplot-nox" err || complain "message without gnuplot: $(cat err)"
[ "$(wc -l <err)" -eq 1 ] && [ ! -s out ] || complain "without gnuplot: $(cat out err)"
for file in summary.json report.html mdr/history.csv; do [ -s "undrawn/$file" ] || complain "no $file without gnuplot"; done
[ ! -e undrawn/plots ] || complain "plots without gnuplot: $(ls undrawn/plots)"
grep -q 'plots/' undrawn/report.html && complain "the report names plots that are not there"

# 4. Bad input.
expect 2 run "$case_file" --set substrate.poisson=0.6 --output bad
grep -q "substrate.poisson = 0.6" err || complain "message: $(cat err)"
[ -e bad ] && complain "a folder in spite of bad input"
expect 2 run
expect 2
for number in nan NaN; do
    expect 2 limit "$case_file" --models mdr --tolerance $number --output bad
    grep -q -- "--tolerance: Value $number is no number" err || complain "message: $(cat err)"
done
[ -e bad ] && complain "a folder in spite of a tolerance that is no number"

# 5. Two runs into one folder at once: the second is told, the first is whole.
"$program" run "$case_file" --models mdr --set rolling.periods=2000 --set rolling.run_all=true --set output.vtk=none \
    --no-report --no-studies --quiet --output twice &
child=$!
for _ in $(seq 1 500); do
    [ -e twice/.tricontact ] && break
    sleep 0.01
done
kill -STOP $child
expect 2 run "$case_file" "${coarse[@]}" --quiet --models mdr --output twice
grep -qx "error: twice: is being filled by another run; wait until that has ended, or choose another output folder" err ||
    complain "two runs at once: $(cat err)"
kill -CONT $child
kill -KILL $child
wait $child 2>/dev/null
expect 0 run "$case_file" "${coarse[@]}" --quiet --models mdr --output twice

# 6. Little memory: an error of one line, of the program's own words, whatever library asks first.
cat >layer.toml <<'TOML'
models = ["fem"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.45
thickness = "8 mm"
[friction]
coefficient = 0.57
[load]
normal_force = "21.1 N"
tangential_ratio = 0.5
[fem]
size = "1.2 mm"
cache = "none"
TOML
if "$program" run --help >/dev/null && ls "$(dirname "$program")"/tricontact_fem_module* >/dev/null 2>&1; then
    for kilobytes in 200000 350000 450000 500000 600000 800000; do
        code=$(ulimit -v $kilobytes; env -u OPENBLAS_NUM_THREADS "$program" run layer.toml --quiet --no-report --no-studies \
            --output little >out 2>err; echo $?)
        [ "$code" -eq 1 ] || [ "$code" -eq 2 ] || complain "exit code $code with $kilobytes kB: $(cat err)"
        [ "$(wc -l <err)" -eq 1 ] && grep -q "^error: " err || complain "words of others with $kilobytes kB: $(cat err)"
    done
fi

finish
