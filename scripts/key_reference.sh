#!/usr/bin/env bash
# Writes the tables of keys in docs/reference/case-file.md, docs/reference/walking.md and docs/reference/quantities.md again, from
# the declarations of keys and results, and the stubs of the module for Python; whoever adds one builds all and runs it.
# usage: key_reference.sh [PROGRAM]   (build/release/app/tricontact)
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
program=${1:-$root/build/release/app/tricontact}
tables=$(mktemp)
trap 'rm -f "$tables"' EXIT

# renew KIND DOCUMENT: between the heading "## Keys" and the next one of its level.
renew() {
    "$program" keys "$1" >"$tables"
    awk -v tables="$tables" '
        /^## / { inside = 0 }
        !inside { print }
        /^## Keys$/ {
            inside = 1
            while ((getline line < tables) > 0) print line
            print ""
        }' "$2" >"$2.new"
    mv "$2.new" "$2"
}
renew case "$root/docs/reference/case-file.md"
renew walking "$root/docs/reference/walking.md"
renew results "$root/docs/reference/quantities.md"

# between DOCUMENT BEGIN END: the lines between those that begin so.
between() {
    awk -v tables="$tables" -v begin="$2" -v end="$3" '
        index($0, end) == 1 { inside = 0 }
        !inside { print }
        index($0, begin) == 1 {
            inside = 1
            while ((getline line < tables) > 0) print line
        }' "$1" >"$1.new"
    mv "$1.new" "$1"
}
"$program" keys summary >"$tables"
between "$root/docs/reference/quantities.md" '<!-- results:' '<!-- end of results'
# Results are properties in Python, too.
for module in "$(dirname -- "$program")"/../python/_core*.so; do
    if [ -e "$module" ]; then
        /usr/bin/python3 "$root/scripts/python_stubs.py" "$module"
    else
        echo "the module for Python is not built: python/tricontact/_core.pyi is left as it is"
    fi
done
