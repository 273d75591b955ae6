#!/usr/bin/env bash
# The text of each formula that `rig` shows, evaluated with the numbers beside it, gives the number shown. More draws:
# rig_formulas.py PROGRAM RIGS SEED DRAWS.
# usage: rig_formulas.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

"$python" "$source_dir/tests/cli/rigs/rig_formulas.py" "$program" "$source_dir/examples/rigs" 20261128 1 >told.txt ||
    complain "$(cat told.txt)"
cat told.txt

finish
