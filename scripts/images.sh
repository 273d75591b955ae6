#!/usr/bin/env bash
# Makes the pictures of docs/images from a run of the demo; needs chromium besides.
# usage: images.sh
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)

"$root/scripts/demo.sh"
results=$root/results/rig_sphere_layer_all
cp "$results/plots/shift.png" "$results/plots/traction_x.png" "$results/plots/zones_fem.png" \
    "$root/docs/images/"
chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=1100,920 \
    --screenshot="$root/docs/images/report.png" "file://$results/report.html" 2>/dev/null
