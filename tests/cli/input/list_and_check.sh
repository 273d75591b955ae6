#!/usr/bin/env bash
# What the program tells without computing: list, check, --help, --version.
# usage: list_and_check.sh PROGRAM SOURCE_DIR
set -euo pipefail
program=$(realpath "$1")
source_dir=$(realpath "$2")
python=/usr/bin/python3
[ -x $python ] || python=python3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

complain() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$*"
}

# holds TEXT PATTERN: a line of the text matches.
holds() {
    grep -qE -- "$2" <<<"$1" || complain "no line matches '$2' in: $1"
}

# 1. list: the models and every case with its title.
cd "$source_dir"
text=$("$program" list)
holds "$text" '^models$'
for model in mdr mdr-layer bem bem-layer; do
    holds "$text" "^  $model +[a-z]"
done
n=0
for file in examples/cases/*.toml; do
    holds "$text" "^  $file: [A-Z]"
    n=$((n + 1))
done
[ "$n" -ge 6 ] || complain "only $n cases"
[ "$(grep -c '\.toml: ' <<<"$text")" -eq "$n" ] || complain "list names other cases: $text"
[ "$(cd "$work" && "$program" list "$source_dir/examples/cases" | grep -c '\.toml: ')" -eq "$n" ] ||
    complain "list FOLDER differs from list"

mkdir "$work/empty"
[ "$(cd "$work/empty" && "$program" list | tail -n +2)" = "$(grep '^  [a-z-]* \+[a-z]' <<<"$text")" ] ||
    complain "list without a folder of cases"
code=0
message=$("$program" list "$work/missing" 2>&1 >/dev/null) || code=$?
[ "$code" -eq 2 ] || complain "exit code $code for a folder that is missing"
holds "$message" "^error: $work/missing: is not a folder; "

# 2. check: values that follow from the case (Hertz; Cattaneo and Mindlin), by hand:
#    E* = 5.2 MPa/(1 - 1/4) = 6.9333 MPa (steel adds 3e-5), a^3 = 3 F_N R/(4 E*) -> 4.5029 mm,
#    d = a^2/R, p0 = 3 F_N/(2 pi a^2), U_max = mu 3/2 d, F_T = 0.56 mu F_N, W = 0.24 a,
#    limit 1 - 3/2 w + 1/2 w^3; beta = -(1 - 2 nu_1) (1 + nu_1)/(2 E_1) E*.
text=$("$program" check examples/cases/rig_sphere_parallel.toml)
"$program" check examples/cases/rig_sphere_parallel.toml --json >"$work/check.json"
# derived NAME VALUE UNIT: the values here have five digits, the text has four (half a unit of the last: 5e-4), the JSON all (SI).
derived() {
    awk -v name="$1" -v due="$2" -v unit="$3" '
        $1 == "#" && $2 == name && $3 == "=" {
            error = $4/due - 1
            found = error < 5e-4 && error > -5e-4 && $5 == unit
        }
        END { exit !found }' <<<"${text//−/-}" || complain "$1 = $2 $3 is due in: $text"
    "$python" -S - "$work/check.json" "$@" <<'PYTHON' || complain "$1 = $2 $3 is due in check --json"
import json, sys
factor = {"mm": 1e-3, "µm": 1e-6, "MPa": 1e6, "kPa": 1e3}.get(sys.argv[4], 1)
value = json.load(open(sys.argv[1]))["derived"][sys.argv[2]]["value"]
sys.exit(abs(value / (float(sys.argv[3]) * factor) - 1) > 2e-5)
PYTHON
}
derived a 4.5029 mm
derived d 506.90 µm
derived F_N 21.1 N
derived p0 496.87 kPa
derived U_max 433.40 µm
derived 'E*' 6.9331 MPa
derived 'G*' 4.6221 MPa
grep -q '^# beta  *=  *−8.751·10⁻⁶ ' <<<"$text" || complain "beta in $text"
derived F_T 6.7351 N
derived f_T 0.56 -
derived W 1.0807 mm
derived w 0.24 -
derived f_T,lim 0.64691 -
# Names and texts stand in columns.
"$program" list | awk '/^cases/ { done = 1 } !done && NR > 1 { print index($0, $2) }' >"$work/columns"
[ "$(sort -u "$work/columns" | wc -l)" -eq 1 ] || complain "list: $("$program" list | head -8)"

# 3. check prints a case that reads back to the same text, and writes nothing.
for file in examples/cases/*.toml; do
    "$program" check "$file" >"$work/once.toml" || complain "check $file"
    "$program" check "$work/once.toml" >"$work/twice.toml" || complain "check of $file's check"
    cmp "$work/once.toml" "$work/twice.toml" || complain "$file: does not read back the same"
done
(cd "$work/empty" && "$program" check "$source_dir/examples/cases/rig_sphere_parallel.toml" >/dev/null)
[ -z "$(ls -A "$work/empty")" ] || complain "check writes files"

# 4. Overrides, one of a pair included.
text=$("$program" check examples/cases/rig_sphere_parallel.toml --set "load.tangential_force=6 N" \
    --set rolling.angle="90 deg")
holds "$text" '^tangential_force = "6 N"$'
grep -q '^tangential_ratio' <<<"$text" && complain "both force and ratio are set"
holds "$text" '^angle = "1\.5707963267948966 rad"$'
holds "$text" '^# f_T += +0\.4989'

# 5. Help for everything, and the version of CMakeLists.txt.
text=$("$program" --help)
for command in run check list; do
    holds "$text" "^  $command  +[A-Z]"
    "$program" "$command" --help | grep -q -- --help || complain "$command --help"
done
text=$("$program" run --help)
for option in --set --output --models --threads --quiet --no-report --no-studies; do
    holds "$text" "^  (-[a-z],)?$option"
done
version=$(sed -n 's/^project(Tricontact VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
[ "$("$program" --version)" = "tricontact ${version:?}" ] ||
    complain "version: $("$program" --version) is not $version"

# What acts on a terminal does not get there out of a title, nor out of a name or a key in an error.
cd "$work"
mkdir -p hostile
printf 'title = "a\\u009B31mb\\u001B]0;x\\u0007c\\u202Ed\\u2066e"\n' >hostile/a.toml
sed 1d "$source_dir/examples/cases/rig_sphere_parallel.toml" >>hostile/a.toml
cp hostile/a.toml hostile/$'b\xc2\x9b31m.toml'
sed 's/^periods = /"p\\u009B31m" = /' hostile/a.toml >hostile/wrong.toml.txt
"$program" list hostile >listed || complain "a folder with hostile titles"
grep -q "a 31mb ]0;x c d e" listed || complain "title: $(grep 31mb listed)"
"$program" check hostile/$'b\xc2\x9b31m.toml' >checked || complain "check of a hostile name"
"$program" check hostile/wrong.toml.txt >>checked 2>&1 && complain "a wrong key"
LC_ALL=C grep -qP '\x1b|\x07|\xc2[\x80-\x9f]|\xe2\x80[\xa8-\xae]|\xe2\x81[\xa6-\xa9]' listed checked &&
    complain "control characters reach the terminal: $(cat -v listed checked)"

printf '%d failures\n' "$failures"
[ "$failures" -eq 0 ]
