#!/usr/bin/env bash
# tricontact verify: every row of the short form passes; the table in docs is the long form's, the
# digits of errors and orders aside, which differ with the processor.
# usage: verify.sh PROGRAM SOURCE_DIR
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

"$program" verify --short --output short >out 2>err || complain "a row fails: $(grep FAIL out)"
[ "$(grep -c '| pass |$' out)" -eq 16 ] || complain "not sixteen rows pass: $(cat out)"
cmp -s out short/verification.md || complain "verification.md is not what is printed"
grep -q '"passed": true' short/verification.json || complain "verification.json does not pass"
grep -q '^bem, level 3$' err || complain "no progress: $(cat err)"

"$program" verify --quiet >long 2>err || complain "a row of the long form fails: $(grep FAIL long)"
[ -s err ] && complain "--quiet is not silent: $(cat err)"
without_errors() { awk -F'|' -v OFS='|' '/^\|/ { $7 = $9 = "" } { print }' "$1"; }
diff <(without_errors long) <(without_errors "$source_dir/docs/verification.md") ||
    complain "docs/verification.md is not the output of tricontact verify"

"$program" verify --briefly >out 2>err
[ $? -eq 2 ] || complain "an unknown option is taken"

[ "$failures" -eq 0 ] && echo "verify: passed"
exit $((failures > 0))
