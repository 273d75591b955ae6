#!/usr/bin/env bash
# Makes the pictures of docs/images from a run of the demo, one of stresses inside and a map of
# walking machines, and those of docs/tutorials/gallery.md and other pages from their commands; needs chromium besides.
# usage: images.sh
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)

"$root/scripts/demo.sh"
results=$root/results/rig_sphere_layer_all
cp "$results/plots/shift.png" "$results/plots/traction_x.png" "$results/plots/zones_fem.png" \
    "$root/docs/images/"
"$root/scripts/paraview.sh" pvpython --force-offscreen-rendering "$results/open_run.py" "$root/results/paraview_pictures"
cp "$root/results/paraview_pictures/models.png" "$root/docs/images/paraview_models.png"
"$root/build/release/app/tricontact" run "$root/examples/cases/rig_sphere_inside.toml" --models bem-layer \
    --output "$root/results/rig_sphere_inside" --quiet
cp "$root/results/rig_sphere_inside/plots/von_mises_bem-layer.png" "$root/docs/images/von_mises_bem_layer.png"
"$root/build/release/app/tricontact" sweep "$root/examples/studies/walking_map.toml" \
    --output "$root/results/walking_map_full" --quiet
# picture NAME SIZE FILE: of the upper end of a page.
picture() {
    # A page that never gets idle would wait for ever.
    timeout 120 chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size="$2" \
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

# The gallery's pictures, docs/images/gallery: small copies of these, figures of runs, figures of reports.
"$root/scripts/setup.sh" docs report
gallery=$root/docs/images/gallery
mkdir -p "$gallery"
# computed NAME COMMAND...: into results/gallery/NAME.
computed() {
    local name=$1
    shift
    (cd "$root" && build/release/app/tricontact "$@" --output "results/gallery/$name" </dev/null >/dev/null)
}
# small FROM NAME [HEIGHT]
small() { /usr/bin/python3 "$root/scripts/small_picture.py" "$1" "$gallery/$2.png" ${3:+"$3"}; }
# figure NAME ID [PAGE]: the figure ID of the report of results/gallery/NAME by itself. What plotly measures text with stays, too.
figure() {
    local run=$root/results/gallery/$1 kept="#figure_$2, #figure_$2 *, #js-plotly-tester, #js-plotly-tester *"
    sed "s|<details>|<details open>|
        s|</head>|<style>body :not(:has(#figure_$2)):not($kept), #figure_$2 figcaption { display: none } .figures { display: block }</style></head>|" \
        "$run/${3:-report.html}" >"$run/figure.html"
    picture "gallery/$1.png" 900,440 "$run/figure.html"
    small "$gallery/$1.png" "$1"
}
small "$root/docs/images/shift.png" sphere_layer
small "$root/docs/images/von_mises_bem_layer.png" inside
small "$root/docs/images/atlas_layer.png" atlas 1000
small "$root/docs/images/walking_map.png" walking_map
small "$root/docs/images/zones_fem.png" zones_fem
small "$root/docs/images/traction_x.png" traction_x
small "$root/docs/images/report.png" report
# Name, figure among the plots of the run, arguments of the run.
while read -r -a words; do
    computed "${words[0]}" run "${words[@]:2}"
    small "$root/results/gallery/${words[0]}/plots/${words[1]}.png" "${words[0]}"
done <<'END'
cone shift examples/cases/body_cone.toml
rough_sphere traction_surface_bem examples/cases/rough_sphere.toml
cylinder traction_x examples/cases/rig_cylinder.toml --models bem,bem-layer
path path_loop examples/cases/path_forces.toml
twist path_twist examples/cases/path_twist.toml
finite_strain shift examples/cases/rig_layer_finite_strain.toml --set fem.size=1.5mm
relaxation shift examples/cases/rig_sphere_layer_relaxing.toml --models mdr-layer
END
computed rolling_on run examples/cases/rolling_sphere.toml
figure rolling_on creep
computed spin run examples/cases/rolling_spin.toml
figure spin zones_bem
computed deviation deviation examples/cases/rig_layer_parallel.toml --no-runs
figure deviation deviations
computed walking run examples/cases/walking_set_b.toml
figure walking motion
computed identification identify examples/measurements/rig_indentation.toml
figure identification fit
computed rig rig examples/rigs/sphere_parallel.toml
figure rig indentation
computed design design examples/rigs/design_resolution.toml
picture gallery/design.png 900,830 "$root/results/gallery/design/report.html"
small "$gallery/design.png" design
computed thesis sweep examples/studies/cylinder_shakedown.toml
computed thesis fit examples/studies/cylinder_shakedown.toml
figure thesis figure_3_43 fit.html
computed shear_strength sweep examples/studies/shear_strength_shakedown.toml
computed shear_strength fit examples/studies/shear_strength_shakedown.toml
figure shear_strength kappa_4 fit.html
# Surfaces that attract each other, for docs/explanation/adhesion.md: lambda = .5; ranges; layers.
computed adhesion run examples/cases/adhesive_sphere.toml --models bem --set contact.coupling=false --set 'bem.spacing="6 um"' \
    --set 'adhesion.peak_stress="16 kPa"'
figure adhesion force_curve
computed adhesion_range sweep examples/studies/adhesive_range.toml
figure adhesion_range pull_off_force_N_1
computed adhesion_layer sweep examples/studies/adhesive_layer.toml
figure adhesion_layer pull_off_force_N_1
