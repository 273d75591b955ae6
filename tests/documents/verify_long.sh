#!/usr/bin/env bash
# tricontact verify: every row passes, and the table in docs is the command's, the digits of errors
# and orders aside, which differ with the processor.
# usage: verify_long.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/prepare.bash"
document=$source_dir/docs/reference/verification.md

"$program" verify --quiet --output written >long 2>err || complain "a row fails: $(grep FAIL long)"
cmp -s long written/verification.md || complain "verification.md is not what is printed"
[ -s err ] && complain "--quiet is not silent: $(cat err)"
without_errors() { awk -F'|' -v OFS='|' '/^\|/ { $7 = $9 = "" } { print }' "$1"; }
# A program without finite elements has no rows of theirs.
has_fem || {
    sed '/^|.*| `fem` |/d' "$document" >known
    document=known
}
diff <(without_errors long) <(without_errors "$document") ||
    complain "docs/reference/verification.md is not the output of tricontact verify"

finish
