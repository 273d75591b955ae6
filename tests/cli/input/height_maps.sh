#!/usr/bin/env bash
# One paraboloid in all the ways in which instruments and programs write a surface: the same history to the byte, and
# Hertz' depth; what a map was taken for, and contact at its border, are said.
# usage: height_maps.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# A paraboloid of R = 8 mm on 25 x 25 nodes, 0.1 mm apart, in micrometres: 90 at the middle of a side. Heights are
# multiples of 1/16, the digits of none are cut.
# surface FORMAT SIGN: FORMAT of awk's variables i, j, h.
surface() {
    awk -v sign="$2" "BEGIN { for (j = -12; j <= 12; j++) for (i = -12; i <= 12; i++) {
        h = sign * (i * i + j * j) * 0.625; last = i == 12; first = i == -12; $1 } }"
}
rows='printf "%.4f%s", h, last ? "\n" : ","'
surface "$rows" 1 >plain.csv
surface "$rows" 1 | tr ',.' ';,' >semicolons.csv
surface 'printf "%.4f%s", h, last ? "\n" : "\t"' 1 | tr . , | iconv -t UTF-16 >tabs_utf16.txt
surface 'printf "%.1f %.1f %.4f\n", i / 10, j / 10, h' 1 >xyz.txt
{
    printf 'x [mm], y [mm], z [um]\n'
    surface 'printf "%.1f, %.1f, %.4f\n", i / 10, j / 10, h' 1 | sort
} >sorted_xyz.csv
{
    printf 'y\\x'
    awk 'BEGIN { for (i = -12; i <= 12; i++) printf ",%.1f", i / 10; print "" }'
    surface 'printf "%s%.4f%s", first ? j / 10 "," : "", h, last ? "\n" : ","' 1
} >coordinates.csv
{
    awk 'BEGIN { for (i = 0; i < 25; i++) printf ",%d", i; print "" }'
    surface 'printf "%s%.4f%s", first ? j + 12 "," : "", h, last ? "\n" : ","' 1
} >pandas.csv
{
    printf '%s\n' '# Channel: Height' '# Width: 2.50 mm' '# Height: 2.50 mm' '# Value units: µm'
    surface 'printf "%.4f%s", h, last ? "\n" : "\t"' 1
} >gwyddion.txt
surface "$rows" -1 >summit_up.csv
# sdf MAGIC SIGN NUMBERS: in ISO 25178-71 heights point out of the material.
sdf() {
    printf '%s\n' "$1" 'ManufacID   = LAB' 'NumPoints   = 25' 'NumProfiles = 25' 'Xscale      = 1E-04' \
        'Yscale      = 1E-04' 'Zscale      = 1E-06' 'Zresolution = -1' 'Compression = 0' 'DataType    = 7' \
        'CheckType   = 0' '*'
    surface 'printf "%.4f%s", h, last ? "\n" : " "' "$2"
    echo '*'
}
sdf aISO-1.0 -1 >iso1.sdf
sdf aISO-2.0 -1 | sed '1!{/=/!s/\./,/g}' >iso2.sdf
sdf aISO-2.0 1 >gap.sdf

# case FILE [KEYS]
map_case() {
    local scale=$'spacing = "0.1 mm"\nunit = "1 um"'
    [[ $1 == *.sdf ]] && scale=
    cat <<TOML
models = ["bem"]
[indenter]
shape = "height-map"
file = "$1"
$scale
${2-}
[substrate]
young = "1000 MPa"
poisson = 0.3
[friction]
coefficient = 0.3
[load]
normal_force = "100 N"
tangential_ratio = 0
[contact]
coupling = false
[bem]
spacing = "0.05 mm"
TOML
}
# run NAME: of NAME.toml.
run() {
    "$program" run "$1.toml" --no-studies --no-report --output "out_$1" >"$1.out" 2>&1 ||
        complain "$1: $(cat "$1.out")"
}

map_case plain.csv >plain.toml
run plain
# Hertz: d = (9 F^2/(16 E*^2 R))^(1/3). The bilinear map is coarser than the paraboloid by at most h^2/(8 R) = 0.16 um
# in either direction, and cells cut the edge of the contact: 1 %.
depth=$(column indentation_m out_plain/bem/history.csv | tail -1)
awk -v d="$depth" 'BEGIN { e = 1e9 / (1 - 0.09); hertz = (9 * 100 ^ 2 / (16 * e * e * 8e-3)) ^ (1 / 3)
    exit !((d / hertz - 1) ^ 2 < 0.01 ^ 2) }' || complain "d = $depth is not Hertz'"
grep -q '25 x 25 nodes (x by y), 100.0 µm apart, 2.400 mm x 2.400 mm; heights differ by 180.0 µm' plain.out ||
    complain "the map is not said: $(cat plain.out)"
grep -q 'the lowest node of the file presses first, at x = 0 m, y = 0 m from the middle node' plain.out ||
    complain "the side is not said: $(cat plain.out)"
grep -q 'warning' plain.out && complain "a warning: $(cat plain.out)"
"$program" check plain.toml >plain.check || complain "check"
grep -q '^# Height map, read as rows of heights: 25 x 25 nodes' plain.check || complain "check: $(cat plain.check)"

for file in semicolons.csv tabs_utf16.txt xyz.txt sorted_xyz.csv coordinates.csv pandas.csv gwyddion.txt \
    iso1.sdf iso2.sdf; do
    map_case "$file" >"${file%.*}.toml"
    run "${file%.*}"
    cmp -s "out_plain/bem/history.csv" "out_${file%.*}/bem/history.csv" || complain "$file is another surface"
done
map_case summit_up.csv 'heights = "outward"' >summit_up.toml
map_case gap.sdf 'heights = "gap"' >gap.toml
for name in summit_up gap; do
    run $name
    cmp -s "out_plain/bem/history.csv" "out_$name/bem/history.csv" || complain "$name is another surface"
done
# The resolved case is the same case.
cp out_iso1/case.toml again.toml
run again
cmp -s out_plain/bem/history.csv out_again/bem/history.csv || complain "the resolved case turns the map over"

# Turned over it stands on its corners, most of the force on the cells of the border: said by check, terminal, summary and report.
map_case summit_up.csv >corners.toml
"$program" run corners.toml --no-studies --output out_corners >corners.out 2>&1 || complain "$(cat corners.out)"
grep -q 'warning: bem: cells at the border of the height map carry [5-9][0-9] % of F_N' corners.out ||
    complain "no warning: $(cat corners.out)"
grep -q 'the map is turned over; heights = "outward" turns it' corners.out || complain "no remedy: $(cat corners.out)"
"$program" check corners.toml | grep -q 'heights = "outward" turns it' || complain "check says nothing"
grep -q '"border_force_share": 0.[5-9]' out_corners/summary.json || complain "$(grep border out_corners/summary.json)"
grep -q 'The height map is larger than the contact: cells at the border' out_corners/report.html ||
    complain "the report says nothing"
grep -q '"border_force_share": 0' out_plain/summary.json || complain "$(grep border out_plain/summary.json)"

# So do commands that run it many times; of a map on which contact stays inside they do not.
for name in plain corners; do
    printf 'case = "%s.toml"\nmodels = ["bem"]\n[vary]\nload.normal_force = ["1 N", "2 N"]\n' $name >study_$name.toml
    "$program" sweep study_$name.toml --output sweep_$name >sweep_$name.out 2>&1 || complain "$(cat sweep_$name.out)"
    sed 's/tangential_ratio = 0/tangential_ratio = 0.4/' $name.toml >rolled_$name.toml
    printf '[rolling]\namplitude = "0.01 mm"\n' >>rolled_$name.toml
    "$program" limit rolled_$name.toml --set "bem.spacing=0.1 mm" --tolerance 0.1 --output limit_$name >limit_$name.out 2>&1 ||
        complain "$(cat limit_$name.out)"
    # Levels from twice the cells on: the finest has those of the runs above.
    "$program" refine $name.toml --models bem --set "bem.spacing=0.1 mm" --output refine_$name >refine_$name.out 2>&1 ||
        complain "$(cat refine_$name.out)"
    grep -q '25 x 25 nodes (x by y), 100.0 µm apart' sweep_$name.out || complain "sweep: $(cat sweep_$name.out)"
    grep -q '25 x 25 nodes (x by y), 100.0 µm apart' refine_$name.out || complain "refine: $(cat refine_$name.out)"
done
said='warning: .*cells at the border of the height map carry [0-9.]* % of F_N'
for command in sweep limit refine; do
    grep -q "$said" ${command}_corners.out || complain "$command: no warning: $(cat ${command}_corners.out)"
    grep -q 'The height map is larger than the contact: .*cells at the border' ${command}_corners/report.html ||
        complain "$command: the report says nothing"
    ! grep -q "$said" ${command}_plain.out || complain "$command: a warning: $(cat ${command}_plain.out)"
done
grep -q 'warning: bem: cells at the border' refine_corners.out || complain "whose border: $(cat refine_corners.out)"
grep -q '"border_force_share": 0.[0-9]' limit_corners/limit.json || complain "$(grep border limit_corners/limit.json)"
grep -q 'in 2 of 2 runs contact reaches the border' sweep_corners.out || complain "$(cat sweep_corners.out)"

# What is neither is refused.
head -n 24 xyz.txt >cut_xyz.txt
head -n 600 xyz.txt >>cut_xyz.txt
map_case "$work/cut_xyz.txt" >cut.toml
refused 'rows of three numbers are not x, y and height of each node of a regular lattice; interpolate' \
    check "$work/cut.toml"
sed 's/"0.1 mm"/"0.3 mm"/' xyz.toml | sed "s|xyz.txt|$work/xyz.txt|" >spacing.toml
refused 'its coordinates step by' check "$work/spacing.toml"
sed 's/"1 um"/"1 nm"/' gwyddion.toml | sed "s|gwyddion.txt|$work/gwyddion.txt|" >unit.toml
refused 'states heights in µm, but indenter.unit is 1e-09 m' check "$work/unit.toml"

finish
