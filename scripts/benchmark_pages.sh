#!/usr/bin/env bash
# Writes the pages of the problems for contact codes, docs/reference/benchmarks/*.md, and the table of
# docs/reference/benchmarks.md again, by tricontact benchmark show and list; whoever changes a problem, or a number of a
# reference, runs it.
# usage: benchmark_pages.sh [PROGRAM] [FOLDER]   (build/release/app/tricontact, the root of the sources)
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
program=${1:-$root/build/release/app/tricontact}
pages=${2:-$root}/docs/reference/benchmarks
mkdir -p "$pages"
table=$(mktemp)
trap 'rm -f "$table"' EXIT

"$program" benchmark list --markdown >"$table"
rm -f "$pages"/*.md
sed -n 's/^| \[\([a-z_0-9]*\)\].*/\1/p' "$table" | while read -r name; do
    "$program" benchmark show "$name" --markdown >"$pages/$name.md"
done
awk -v table="$table" '
    /^<!-- end of problems/ { inside = 0 }
    !inside { print }
    /^<!-- problems:/ {
        inside = 1
        while ((getline line < table) > 0) print line
    }' "$pages.md" >"$pages.md.new"
mv "$pages.md.new" "$pages.md"
