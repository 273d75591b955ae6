#!/usr/bin/env bash
# Makes the pictures of docs/images from a run of the demo, one of stresses inside and a map of
# walking machines; needs chromium besides.
# usage: images.sh
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)

"$root/scripts/demo.sh"
results=$root/results/rig_sphere_layer_all
cp "$results/plots/shift.png" "$results/plots/traction_x.png" "$results/plots/zones_fem.png" \
    "$root/docs/images/"
"$root/build/release/app/tricontact" run "$root/examples/cases/rig_sphere_inside.toml" --models bem-layer \
    --output "$root/results/rig_sphere_inside" --quiet
cp "$root/results/rig_sphere_inside/plots/von_mises_bem-layer.png" "$root/docs/images/von_mises_bem_layer.png"
"$root/build/release/app/tricontact" sweep "$root/examples/studies/walking_map.toml" \
    --output "$root/results/walking_map_full" --quiet
# picture NAME SIZE FILE: of the upper end of a page.
picture() {
    chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size="$2" \
        --virtual-time-budget=8000 --screenshot="$root/docs/images/$1" "file://$3" 2>/dev/null
}
"$root/build/release/app/tricontact" predict "$root/examples/cases/rig_sphere_parallel.toml" \
    --output "$root/results/predict_half_space" >/dev/null
"$root/build/release/app/tricontact" predict "$root/examples/cases/rig_layer_parallel.toml" \
    --output "$root/results/predict_layer" >/dev/null
picture atlas_half_space.png 1200,1560 "$root/results/predict_half_space/atlas.html"
picture atlas_layer.png 1200,1560 "$root/results/predict_layer/atlas.html"
picture report.png 1100,920 "$results/report.html"
picture walking_map.png 1200,940 "$root/results/walking_map_full/map.html"
