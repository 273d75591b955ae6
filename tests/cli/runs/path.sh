#!/usr/bin/env bash
# Prescribed paths: a table in a file and in the case, what the report says and does not say, files for each row.
# usage: path.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

{
    sed '/^\[path\]/,$d; s/^models.*/models = ["mdr", "bem"]/; s/cells_per_radius.*/cells_per_radius = 8/' \
        "$source_dir/examples/cases/path_forces.toml"
    printf '[path]\nfile = "loads.csv"\nsteps = 4\n'
} >from_file.toml
printf 'normal_force [N], tangential_force_x [N]\n0, 0\n20, 4\n15, 6\n15, -3\n25, 2\n' >loads.csv
"$program" run from_file.toml --set output.vtk=quarters --output file --quiet
# 1. The same table in the case: the same numbers; the resolved case reproduces them.
"$program" run from_file.toml --set 'path.table="normal_force [N], tangential_force_x [N]\n0, 0\n20, 4\n15, 6\n15, -3\n25, 2"' \
    --output table --quiet --no-report
cmp file/bem/history.csv table/bem/history.csv || complain "a table in the case differs from one in a file"
"$program" run file/case.toml --output again --quiet --no-report
cmp file/mdr/history.csv again/mdr/history.csv || complain "the resolved case does not reproduce the run"
# 2. Surfaces of the rows that have a contact, and a report about the path alone.
[ "$(od -An -j4 -N4 -tu4 --endian=big file/bem/surface.ex2)" -eq 4 ] || complain "not one surface for each row"
grep -q "At the end of the path the shift is" file/report.html || complain "the report does not tell the end of the path"
for claim in "u_stat = " "The tangential force shifts" "pressed without a tangential force" "expected"; do
    ! sed 's/<script.*//' file/report.html | grep -q "$claim" || complain "the report says '$claim' of a path"
done
"$python" -S - <<'END' || complain "summary.json: static values of a path"
import json
models = json.load(open("file/summary.json"))["models"]
assert all(m["static_shift_m"] is None and m["final_shift_m"] > 0 for m in models.values())
END
# 3. refine follows the shift at its end: Cattaneo's 1 - (1 - f)^(2/3) over U_max, to the cells that cut the edge of the
# contact (1 % at this size).
cp from_file.toml pulled.toml
printf 'normal_force [N], tangential_force_x [N]\n20, 0\n20, 4\n' >loads.csv
"$program" refine pulled.toml --models bem --quiet --output refined >out 2>&1 || complain "refine: $(cat out)"
"$python" -S - <<'END' || complain "refine does not follow the end of a path: $(cat out)"
import json, re
mu = float(re.search(r"coefficient = ([0-9.]+)", open("pulled.toml").read())[1])
found = json.load(open("refined/refinement.json"))["quantities"]["final_shift_ratio"]
assert abs(found["values"][-1] / (1 - (1 - 4 / 20 / mu) ** (2 / 3)) - 1) < .01, found
END
# 4. Commands that need rolling say so.
for command in limit predict; do
    code=0
    "$program" "$command" from_file.toml >out 2>err || code=$?
    [ "$code" = 2 ] || complain "$command takes a path: exit $code, $(cat err)"
done
finish
