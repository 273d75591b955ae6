#!/usr/bin/env bash
# MDR's creepage in steady rolling over that of boundary elements under the same force, for several
# Poisson's ratios and forces. Boundary elements err by the first order of a cell: three grids, each
# half as fine as the next; the value is the one to which the finer two lead, its error how far that
# of the coarser two is from it.
# usage: scripts/creep_ratio.sh [PROGRAM]   (build/release/app/tricontact)
set -euo pipefail
program=$(realpath "${1:-build/release/app/tricontact}")
case_file=$(realpath "$(dirname -- "$0")/../examples/cases/rolling_sphere.toml")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# ratio NU F CELLS: xi of MDR's closed form over that of BEM.
ratio() {
    "$program" run "$case_file" --models bem --points 0 --quiet --no-report --output run \
        --set substrate.poisson="$1" --set load.tangential_ratio="$2" \
        --set bem.cells_per_radius="$3" --set tractive_rolling.distance=0.01 \
        --set contact.coupling=false --set output.vtk='"none"' |
        awk '$1 == "bem" { bem = $2 } $1 == "mdr_closed_form" { print $2 / bem }'
}

printf '%4s %4s %7s %7s %7s %9s %7s %8s\n' nu f_T h=a/12 h=a/24 h=a/48 ratio error '(2.2.31)'
for nu in 0 0.25 0.3 0.5; do
    for f in 0.1 0.3 0.56 0.8; do
        coarse=$(ratio $nu $f 12)
        medium=$(ratio $nu $f 24)
        fine=$(ratio $nu $f 48)
        awk -v nu=$nu -v f=$f -v a="$coarse" -v b="$medium" -v c="$fine" 'BEGIN {
            value = 2 * c - b; error = value - (2 * b - a); if (error < 0) error = -error
            printf "%4s %4s %7.4f %7.4f %7.4f %9.4f %7.4f %8.4f\n", nu, f, a, b, c, value, error,
                4 * (2 - nu) / (4 - 3 * nu) }'
    done
done
