#!/usr/bin/env bash
# Writes the tables of keys in docs/case-file.md and docs/walking.md anew, from the declarations of the
# keys; whoever adds a key runs it.
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
renew case "$root/docs/case-file.md"
renew walking "$root/docs/walking.md"
