#!/usr/bin/env bash
# tricontact verify --short: every row passes.
# usage: verify.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

"$program" verify --short --output short >out 2>err || complain "a row fails: $(grep FAIL out)"
[ "$(grep -c '| pass |$' out)" -eq 60 ] || complain "not 60 rows pass: $(cat out)"
cmp -s out short/verification.md || complain "verification.md is not what is printed"
grep -q '"passed": true' short/verification.json || complain "verification.json does not pass"
grep -q '^bem, level 3$' err || complain "no progress: $(cat err)"

"$program" verify --briefly >out 2>err
[ $? -eq 2 ] || complain "an unknown option is taken"

finish
