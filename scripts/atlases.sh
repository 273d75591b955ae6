#!/usr/bin/env bash
# Builds the shipped atlases again from their studies in atlas/studies, checks each by 300 random points and puts it
# into atlas/data: minutes for a half-space, an hour for a layer and for ratcheting, on two cores. What was computed before is found in
# results/atlases.
# usage: atlases.sh [NAME]...   (all)
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
cd "$root"
[ $# -gt 0 ] || set -- $(basename -s .toml atlas/studies/*.toml | grep -v '_case$')
for name in "$@"; do
    [ -r "atlas/studies/$name.toml" ] || { echo "error: no atlas/studies/$name.toml" >&2; exit 2; }
    printf '== %s\n' "$name"
    build/release/app/tricontact atlas "atlas/studies/$name.toml" --output "results/atlases/$name" --check 300 --quiet
    cp "results/atlases/$name/atlas.json" "atlas/data/$name.json"
done
