#!/usr/bin/env bash
# Random histories of forces, shifts, twists and places, written for the program CONTACT and read back from their numbers
# alone, give the same forces to 1e-9. More of them: contact_histories.py PROGRAM SEED N.
# usage: contact_histories.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

"$python" "$source_dir/tests/cli/codes/contact_histories.py" "$program" 20261128 12 >told.txt || complain "$(cat told.txt)"
cat told.txt

finish
