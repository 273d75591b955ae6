# Sourced by tests of the program from the shell, which are called with PROGRAM and SOURCE_DIR: both
# as full paths, an empty folder to work in that goes away with the test, complaints counted.
set -uo pipefail
program=$(realpath "$1")
source_dir=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

complain() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$*"
}

# The last line of a test: how often it complained, as text and exit code.
finish() {
    printf '%d failures\n' "$failures"
    exit $((failures > 0))
}
