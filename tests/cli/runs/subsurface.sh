#!/usr/bin/env bash
# Fields inside, by boundary elements: files for ParaView, the largest stress in summary.json, figures.
# usage: subsurface.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

case_file=$source_dir/examples/cases/rig_sphere_inside.toml

# 1. Half-space and layer, nu = 0.3 and no friction.
"$program" run "$case_file" --models bem,bem-layer --quiet --no-studies --output inside \
    --set substrate.poisson=0.3 --set load.tangential_ratio=0 --set contact.coupling=false \
    --set 'bem.spacing="0.5 mm"' --set 'output.volume_depth="6 mm"' >inside.txt 2>&1 ||
    complain "$(cat inside.txt)"
for model in bem bem-layer; do
    grep -aq stress_Pa_zx "inside/$model/volume.ex2" || complain "$model: volume.ex2"
    [ -s "inside/plots/von_mises_$model.png" ] || complain "$model: no figure of the section"
done
[ -s inside/plots/axis_stress.svg ] || complain "no figure of the axis"
grep -q 'Inside the substrate' inside/report.html || complain "the report's table"
# Johnson (1985), section 4.2: 0.62 p0 below Hertz' contact, here on cells of a/9.
grep -m 1 peak_von_mises_ratio inside/summary.json | grep -qE ': 0\.6[12][0-9]*' ||
    complain "$(grep peak_von_mises_ratio inside/summary.json)"

# 2. Without volumes there is no inside to tell of.
"$program" run "$case_file" --models bem --quiet --no-studies --no-report --output none \
    --set 'output.volume="none"' --set 'bem.spacing="1 mm"' >none.txt 2>&1 || complain "$(cat none.txt)"
grep -q '"subsurface": null' none/summary.json || complain "an inside that was not asked for"
[ ! -e none/bem/volume.ex2 ] || complain "a volume that was not asked for"

refused 'output.volume_depth' run "$case_file" --models bem --set 'output.volume_depth="0 mm"'

finish
