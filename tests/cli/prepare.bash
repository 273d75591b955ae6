# Sourced by tests of the program from the shell, which are called with PROGRAM and SOURCE_DIR: both
# as full paths, an empty folder to work in that goes away with the test, complaints counted.
set -uo pipefail
program=$(realpath "$1")
source_dir=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0
# Debian's, which has the packages of packages.txt; another python3 may come first in PATH.
# What needs no package takes -S, which starts it in half the time.
python=/usr/bin/python3
[ -x $python ] || python=python3

complain() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$*"
}

# refused EXPECTED ARGUMENTS...: exit code 2, an error of one line that holds EXPECTED, nothing written.
refused() {
    local expected=$1 code
    shift
    mkdir "$work/empty"
    message=$(cd "$work/empty" && "$program" "$@" 2>&1)
    code=$?
    [ "$code" -eq 2 ] || complain "exit code $code instead of 2: $*"
    [[ $message == "error: "*"$expected"* && $message != *$'\n'* ]] ||
        complain "$*: expected $expected, got $message"
    rmdir "$work/empty" || { complain "files left behind: $*"; rm -rf "$work/empty"; }
}

# Whether the program was built with finite elements.
has_fem() { "$program" list | grep -q '^  fem '; }

# rows FOLDER: how many points the table of a sweep has.
rows() { echo $(($(wc -l <"$1/results.csv") - 1)); }
# column NAME FILE: its values.
column() {
    awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) k = i; next }
        { print $k }' "$2"
}

# The last line of a test: how often it complained, as text and exit code.
finish() {
    printf '%d failures\n' "$failures"
    exit $((failures > 0))
}
