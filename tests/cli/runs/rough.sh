#!/usr/bin/env bash
# Rough surfaces: a periodic plane, whose force balances and whose limit of shakedown is told; a height
# map of Westergaard's wave from two formats, which agree.
# usage: rough.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# 1. The plane of the cases, coarser.
"$program" run "$source_dir/examples/cases/rough_plane.toml" --quiet --no-studies --output plane \
    --set rolling.periods=1 --set rolling.steps_per_quarter=2 --set load.press_steps=3 \
    --set 'indenter.roughness.short_wavelength="125 um"' --set 'bem.spacing="31.25 um"' \
    >plane.txt 2>&1 || complain "$(cat plane.txt)"
[ -s plane/summary.json ] && [ -s plane/report.html ] || complain "the plane's files"
grep -q '"audit_passed": *true\|"passed": *true' plane/summary.json || complain "audit of the plane"

# 2. A wave of 1 um over 0.1 mm as text, and as ISO 25178-71 says it: the same numbers.
awk 'BEGIN { pi = atan2(0, -1)
    for (j = 0; j < 20; j++) for (i = 0; i < 20; i++)
        printf "%.15g%s", 1 - cos(2 * pi * i / 20), i < 19 ? "," : "\n" }' >wave.csv
{
    printf '%s\n' aISO-1.0 'NumPoints = 20' 'NumProfiles = 20' 'Xscale = 5E-6' 'Yscale = 5E-6' \
        'Zscale = 1E-6' 'Compression = 0' 'DataType = 7' '*'
    tr ',' ' ' <wave.csv
    echo '*'
} >wave.sdf
# wave FILE KEYS: a case.
wave() {
    cat <<TOML
models = ["bem"]
[indenter]
shape = "height-map"
file = "$1"
$2
[substrate]
young = "3 MPa"
poisson = 0.5
[friction]
coefficient = 0.5
[load]
normal_force = "0.6283185 mN"
tangential_ratio = 0.3
press = "frictionless"
[bem]
period = "0.1 mm"
spacing = "5 um"
TOML
}
wave wave.csv $'spacing = "5 um"\nunit = "1 um"' >csv.toml
wave wave.sdf 'heights = "gap"' >sdf.toml
for kind in csv sdf; do
    "$program" run "$kind.toml" --quiet --no-studies --no-report --output "$kind" >"$kind.txt" 2>&1 ||
        complain "$kind: $(cat "$kind.txt")"
done
cmp -s csv/bem/history.csv sdf/bem/history.csv || complain "the same wave from .csv and .sdf differs"
# Westergaard: at half of p* = pi E* A/lambda = 4 pi 10^4 Pa strips of half the wavelength, but for a
# row of cells on either side.
column contact_area_m2 csv/bem/history.csv | awk '{ if ($1 < 0.39e-8 || $1 > 0.61e-8) exit 1 }' ||
    complain "contact area $(column contact_area_m2 csv/bem/history.csv)"

finish
