#!/usr/bin/env bash
# The main job: builds the program, computes a sphere on a rubber layer, rolled back and forth, by
# all models, says which assumption of that rig fails, and lets a slider walk.
# usage: demo.sh
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
name=rig_sphere_layer_all

"$root/scripts/build.sh" tricontact
"$root/build/release/app/tricontact" run "$root/examples/cases/$name.toml" \
    --output "$root/results/$name"
"$root/build/release/app/tricontact" rig "$root/examples/rigs/sphere_parallel.toml" \
    --output "$root/results/rig" >/dev/null
"$root/build/release/app/tricontact" run "$root/examples/cases/walking_set_b.toml" \
    --output "$root/results/walking_set_b" --quiet
printf '\nThe report:   %s\n' "$root/results/$name/report.html"
printf 'The rig:      %s\n' "$root/results/rig/report.html"
printf 'The slider:   %s\n' "$root/results/walking_set_b/report.html"
printf 'The numbers:  %s\n' "$root/results/$name/summary.json"
printf 'For ParaView: %s\n' "$root/results/$name/fem/surface.ex2"
