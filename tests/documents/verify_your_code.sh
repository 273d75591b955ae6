#!/usr/bin/env bash
# Each block of docs/tutorials/verify-your-code.md works, with the codes that are installed: CalculiX, FreeFem++, GetFEM
# (packages of Debian, see scripts/packages.txt). Blocks of a code that is not there are left out, and named.
# usage: verify_your_code.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/prepare.bash"
source "$source_dir/tests/documents/document_blocks.bash"
export TRICONTACT_CACHE=$work/cache OMP_NUM_THREADS=1

has_calculix=$(command -v ccx || true)
has_freefem=$(command -v FreeFem++ || true)
has_getfem=$("$python" -c 'import getfem' 2>/dev/null && echo yes || true)

# The document without the blocks of codes that are missing.
mkdir -p docs/tutorials
awk -v calculix="$has_calculix" -v freefem="$has_freefem" -v getfem="$has_getfem" '
    /^```/ && !inside { inside = 1; block = $0 ORS; next }
    inside { block = block $0 ORS }
    inside && /^```$/ {
        inside = 0
        if (block ~ /code freefem/ && !freefem) next
        if (block ~ /code getfem/ && !getfem) next
        if (block ~ /(ccx|code calculix|try\/submission)/ && !calculix) next
        printf "%s", block
        next
    }
    !inside { print }' "$source_dir/docs/tutorials/verify-your-code.md" >docs/tutorials/verify-your-code.md
for code in calculix freefem getfem; do
    has=has_$code
    [ -n "${!has}" ] || echo "no $code: its blocks are left out"
done
whole=$source_dir
source_dir=$work run_blocks tutorials/verify-your-code.md
source_dir=$whole
[ "$blocks" -ge 4 ] || complain "only $blocks blocks"

# verdict FOLDER: of the force, and of all.
verdict() {
    "$python" - "$1/comparison.json" <<'END'
import json
import sys

found = json.load(open(sys.argv[1]))
print(found["quantities"]["normal_force"]["verdict"], *sorted(one["id"] for one in found["diagnoses"]))
END
}
expect() {
    local folder=$1 due=$2 found
    [ -e "$folder/comparison.json" ] || { complain "no $folder/comparison.json"; return; }
    found=$(verdict "$folder")
    [[ $found == $due ]] || complain "$folder: $found instead of $due"
    [ -s "$folder/report.html" ] && [ -s "$folder/junit.xml" ] || complain "$folder lacks files"
}
expect comparison_mine 'pass*'
[ -z "$has_calculix" ] || expect comparison 'pass *displaced_surface*penalty*'
[ -z "$has_calculix" ] || expect comparison_locking 'fail *locking*'
[ -z "$has_freefem" ] || expect comparison_freefem 'pass *penalty*'
[ -z "$has_getfem" ] || expect comparison_getfem 'pass*'
finish
