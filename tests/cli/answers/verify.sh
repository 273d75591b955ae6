#!/usr/bin/env bash
# tricontact verify --short: every row passes; --json gives the numbers of its file. What is printed without it:
# tests/documents/verify_long.sh.
# usage: verify.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

table=short/verification.md
"$program" verify --short --json --output short >out 2>err || complain "a row fails: $(grep FAIL $table)"
[ "$(grep -c '| pass |$' $table)" -eq 60 ] || complain "not 60 rows pass: $(cat $table)"
"$python" -S - <<'PYTHON' || complain "--json: not the numbers of verification.json: $(head -c 300 out)"
import json
answer, kept = (json.load(open(name)) for name in ("out", "short/verification.json"))
answer["notes"] = kept["notes"] = None
assert answer == kept
PYTHON
grep -q '"passed": true' short/verification.json || complain "verification.json does not pass"
grep -q '^bem, level 3$' err || complain "no progress: $(cat err)"

"$program" verify --briefly >out 2>err
[ $? -eq 2 ] || complain "an unknown option is taken"

finish
