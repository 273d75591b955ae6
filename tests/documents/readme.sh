#!/usr/bin/env bash
# README is at most 9000 bytes, and its case has the answer that stands below it.
# usage: readme.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/prepare.bash"
readme=$source_dir/README.md
[ "$(wc -c <"$readme")" -le 9000 ] || complain "README has $(wc -c <"$readme") bytes"

sed -n '/^```toml$/,/^```$/p' "$readme" | grep -v '^```' >case.toml
sed -n '/^The answer:$/,/^The rigid-body/p' "$readme" | grep -E '^[a-z-]+: .* U = ' | sed 's/;.*//' >answer
[ "$(wc -l <answer)" -eq 2 ] || complain "no answer in README"
"$program" run case.toml --no-studies --no-report 2>/dev/null | grep ' U = ' | sed 's/;.*//' | diff answer - ||
    complain "README has another answer"
finish
