#!/usr/bin/env bash
# The differences of models that the player of a report shows: by closed forms; the page offers them where there are two
# models.
# usage: player_difference.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
nodejs=$(command -v nodejs || command -v node) || complain "no node"
"$nodejs" "$source_dir/tests/cli/pages/player_difference.js" "$source_dir" || complain "differences"

coarse=(--set rolling.steps=turning-points --set rolling.periods=1 --set bem.cells_per_radius=4 --set mdr.springs=200
    --set output.vtk=none)
"$program" run "$source_dir/examples/cases/rig_sphere_parallel.toml" "${coarse[@]}" --no-studies --quiet --output two \
    >/dev/null || complain "run"
grep -qF 'globalThis.player_difference' two/report.html || complain "the page offers no difference"
finish
