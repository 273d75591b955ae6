#!/usr/bin/env bash
# tricontact identify and rig read several tables of one kind: with stated errors the files say what one file of all their rows
# says, each force curve has a depth of first touch of its own, a list of one is its file, archives hold all of them; what is wrong
# is refused with one line that names file and row.
# usage: identify_tables.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# number FOLDER PATH: of the result there, by python's notation of keys.
number() { "$python" -c "import json; print(json.load(open('$1/identify.json'))$2)"; }
# holds EXPRESSION WHAT: in awk.
holds() { awk "BEGIN { exit !($1) }" || complain "$2: $1"; }
# same A B TOLERANCE WHAT: relative.
same() { holds "($1 - $2)^2 <= ($3 * $2)^2" "$4"; }

cp "$source_dir"/examples/measurements/lens_*.csv .
grep -v '^#' lens_static_shift.csv | awk 'NR == 1 { print $0 ", shift_error [um]" } NR > 1 { print $0 ", 2" }' >all.csv
for load in 0.1 0.3 1.0; do awk -v load="$load," 'NR == 1 || index($0, load) == 1' all.csv >"at_$load.csv"; done
# write FILE: the lens with the tables `$shifts`.
write() {
    cat >"$1" <<EOF
title = "lens"
[indenter]
radius = "10 mm"
[substrate]
poisson = 0.5
[measurement]
static_shift = $shifts
sliding_force = "lens_sliding.csv"
find = ["substrate.young"]
laws = ["coulomb", "shear-strength"]
models = ["half-space"]
EOF
}
mkdir bare list
cp all.csv lens_sliding.csv bare && cp all.csv lens_sliding.csv list
shifts='"all.csv"' write bare/lens.toml
shifts='["all.csv"]' write list/lens.toml
shifts='["at_0.1.csv", "at_0.3.csv", "at_1.0.csv"]' write three.toml
for folder in bare list; do (cd "$folder" && "$program" identify lens.toml --output ../"out_$folder" --quiet) >"$folder.txt" || complain "$folder"; done
cmp -s out_bare/identify.json out_list/identify.json || complain "a list of one has other bytes than its file"
cmp -s bare.txt list.txt || complain "a list of one prints other bytes than its file"

# Rows with stated errors are the same whatever file they stand in.
"$program" identify three.toml --output three --quiet >text || complain "three tables: $(cat text)"
for path in "['models']['half-space']['young_Pa']['value']" "['models']['half-space']['young_Pa']['interval'][0]" \
    "['models']['half-space']['shear_strength_Pa']['value']" "['laws_of_friction']['compared']['coulomb']['aicc']"; do
    same "$(number three "$path")" "$(number out_bare "$path")" 1e-6 "$path of three tables"
done
holds "$(number three "['models']['half-space']['tables']['static-shift (at_0.3.csv)']['sum_of_squares']") > 0" "tables by their files"
for figure in fit_static_shift fit_static_shift_2 fit_static_shift_3; do
    grep -q "id=\"figure_$figure\"" three/report.html || complain "no $figure"
done

# Force curves that count their depths from different places: each finds its own.
grep -v '^#' "$source_dir/examples/measurements/soft_indentation.csv" >first.csv
awk -F', ' 'NR == 1 { print } NR > 1 { print $1 + 37 ", " $2 ", " $3 }' first.csv >second.csv
printf '[indenter]\nradius = "12 mm"\n[substrate]\npoisson = 0.5\n[measurement]
force_indentation = ["first.csv", "second.csv"]\nfind = ["substrate.young", "zero_depth"]\nmodels = ["half-space"]\n' >curves.toml
"$program" identify curves.toml --output curves --quiet >text || complain "two curves: $(cat text)"
found="['models']['half-space']"
apart=$("$python" -c "print($(number curves "$found['zero_depth_2_m']['value']") - $(number curves "$found['zero_depth_1_m']['value']"))")
same "$apart" 37e-6 1e-4 "depths of first touch"
sed 's/\["first.csv", "second.csv"\]/"first.csv"/' curves.toml >curve.toml
"$program" identify curve.toml --output curve --quiet >text || complain "one curve: $(cat text)"
for name in young_Pa zero_depth_m; do number curve "$found['$name']['value']" >value_$name; done
same "$(number curves "$found['young_Pa']['value']")" "$(cat value_young_Pa)" 1e-5 "E of a curve that stands there twice"
same "$(number curves "$found['zero_depth_1_m']['value']")" "$(cat value_zero_depth_m)" 1e-3 "its depth of first touch"

# An archive runs again.
"$program" identify three.toml --output three --export paper --quiet >text || complain "export: $(cat text)"
archive=$(find paper -name '*.zip' | head -n 1)
"$program" reproduce "$archive" --output again --quiet >text 2>&1 || complain "reproduce: $(cat text)"

# rig: the slope of sliding forces by all tables.
cp "$source_dir/examples/rigs/sphere_parallel.toml" whole.toml
sed '/^\[measurement\]/,/^$/d' whole.toml >parts.toml
cp parts.toml whole.toml
printf '[measurement]\nsliding_force = "lens_sliding.csv"\n' >>whole.toml
printf '[measurement]\nsliding_force = ["some.csv", "others.csv"]\n' >>parts.toml
grep -v '^#' lens_sliding.csv | awk 'NR == 1 || NR % 2 == 0' >some.csv
grep -v '^#' lens_sliding.csv | awk 'NR == 1 || NR % 2 == 1' >others.csv
for file in whole parts; do "$program" rig $file.toml --output "rig_$file" >$file.txt || complain "rig $file"; done
grep 'F_N^' whole.txt | sort >slope_whole
grep 'F_N^' parts.txt | sort >slope_parts
[ -s slope_whole ] && cmp -s slope_whole slope_parts || complain "the slope of two tables: $(cat slope_parts)"

# refused EXPECTED COMMAND FILE
n=0
refused() {
    local message code
    n=$((n + 1))
    message=$("$program" "$2" "$3" --output refused 2>&1 >stdout)
    code=$?
    [ "$code" -eq 2 ] || complain "exit code $code instead of 2: $1"
    case $message in
        *$'\n'*) complain "more than one line: $message" ;;
        "error: "*"$1"*) ;;
        *) complain "expected: $1"$'\n'"       got: $message" ;;
    esac
    [ ! -e refused ] || complain "output in spite of the error: $1"
}
shifts='["at_0.1.csv", "at_0.1.csv"]' write bad.toml
refused '"at_0.1.csv" stands twice; name each once' identify bad.toml
shifts='["at_0.1.csv", "./at_0.1.csv"]' write bad.toml
refused './at_0.1.csv stands twice; name each table once' identify bad.toml
shifts='[]' write bad.toml
refused 'the list is empty' identify bad.toml
shifts='3' write bad.toml
refused 'must be a text in quotes, or a list of such' identify bad.toml
shifts='[3, 4]' write bad.toml
refused 'must be a list of texts' identify bad.toml
shifts='["at_0.1.csv", "none.csv"]' write bad.toml
refused 'none.csv' identify bad.toml
awk 'NR == 3 { sub(/^0.3, [0-9.]*/, "0.3, -1") } { print }' at_0.3.csv >negative.csv
shifts='["at_0.1.csv", "negative.csv"]' write bad.toml
refused 'negative.csv:3' identify bad.toml
sed 's/^normal_force \[N\], //; s/^0.3, //' at_0.3.csv >unloaded.csv
shifts='["at_0.1.csv", "unloaded.csv"]' write bad.toml
refused 'all have a column normal_force or none, and unloaded.csv has none' identify bad.toml
sed 's/\["some/["stated.csv", "some/' parts.toml >bad.toml
awk 'NR == 1 { print $0 ", sliding_force_error [N]" } NR > 1 { print $0 ", 0.1" }' some.csv >stated.csv
refused 'some.csv: of several tables all state errors or none' rig bad.toml
printf '%d files refused\n' "$n"
finish
