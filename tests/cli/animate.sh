#!/usr/bin/env bash
# tricontact animate: the pictures of a run's last period, the same each time, without display; what it refuses.
# usage: animate.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/prepare.bash"
unset DISPLAY WAYLAND_DISPLAY

cat >case.toml <<'END'
title = "A sphere that rolls"
models = ["mdr", "bem"]
indenter.radius = "40 mm"
substrate = {young = "5 MPa", poisson = 0.5}
friction.coefficient = 0.6
load = {normal_force = "20 N", tangential_ratio = 0.5}
rolling = {amplitude_ratio = 0.25, periods = 2, run_all = true, steps_per_quarter = 2}
bem.cells_per_radius = 8
mdr.springs = 60
END
"$program" run case.toml --output out --quiet --no-report --set output.vtk=all || complain "the run fails"

# A period of eight steps, four quarters of two: a PNG each (its first bytes: RFC 2083, section 3.1).
"$program" animate out --format png --output bem.png --quiet || complain "no pictures"
[ "$(ls bem_*.png | wc -l)" -eq 8 ] || complain "not 8 pictures: $(ls bem_*.png)"
for picture in bem_*.png; do
    [ "$(head -c 8 "$picture" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ] || complain "$picture is no PNG"
done
[ "$(cat bem_*.png | sha1sum)" != "$(cat bem_000.png{,,,,,,,} | sha1sum)" ] || complain "nothing moves"
cp bem_003.png before.png
for field in traction_x pressure state gap; do
    "$program" animate out --format png --field $field --output $field.png --quiet || complain "no $field"
    ! cmp -s ${field}_003.png before.png || complain "$field is the traction"
done
"$program" animate out --format png --output bem.png --quiet
cmp bem_003.png before.png || complain "the same run, other bytes"
"$program" animate out --model mdr --format png --output mdr.png --quiet || complain "no pictures of springs"

# Movies, with ffmpeg or a word on it.
if command -v ffmpeg >/dev/null; then
    "$program" animate out --quiet || complain "no GIF"
    [ "$(head -c 4 out/bem_traction.gif)" = GIF8 ] || complain "no GIF"
    "$program" animate out --format mp4 --quiet || complain "no MP4"
    [ "$(head -c 8 out/bem_traction.mp4 | tail -c 4)" = ftyp ] || complain "no MP4"
fi
mkdir empty_path
out=$work/out
message=$(PATH=$work/empty_path "$program" animate out 2>&1)
[ $? -eq 2 ] && [[ $message == "error: cannot start 'ffmpeg'"*"--format png" ]] || complain "without ffmpeg: $message"

refused "has no model \"fem\", but mdr, bem" animate "$out" --model fem
refused "is no folder of a run" animate "$work/nowhere"
refused "has no case.toml" animate "$work/empty_path"
cp -r out spoilt
head -c 2000 out/bem/surface_000003.vti >spoilt/bem/surface_000003.vti
refused "surface_000003.vti" animate "$work/spoilt" --format png
rm spoilt/bem/surface.pvd
refused "has no surface.pvd: run the case with output.vtk" animate "$work/spoilt"
printf 'mine\n' >mine_000.png
message=$("$program" animate out --format png --output mine.png 2>&1)
[ $? -eq 2 ] && [ "$(cat mine_000.png)" = mine ] || complain "a file that is no picture is replaced: $message"

# Other commands do not load what draws.
! ldd "$program" | grep -qi freetype || complain "the program loads what draws letters"

[ $failures -eq 0 ]
