#!/usr/bin/env bash
# tricontact rig: the rigs of the thesis' chapter 5, what they flag, their files; what is refused
# leaves nothing behind.
# usage: rig.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# tells FILE PATTERN: a line of it matches.
tells() {
    grep -qE -- "$2" "$1" || complain "$1: no line matches $2"
}

# 1. All rig files; assumptions that fail are no error.
n=0
for file in "$source_dir"/examples/rigs/*.toml; do
    name=$(basename "$file" .toml)
    "$program" rig "$file" >"$name.txt" 2>&1 || complain "$name: $(cat "$name.txt")"
    [ -s "results/$name/rig.json" ] && [ -s "results/$name/report.html" ] || complain "$name: files"
    n=$((n + 1))
done
[ "$n" -ge 8 ] || complain "only $n rig files"

# 2. What is wrong in print, with the number that it would follow from.
tells sphere_parallel.txt '^differs +contact_radius = 4\.56 mm table 5\.1\.1$'
tells sphere_parallel.txt 'E_2 = 5\.007 MPa instead of 5\.200 MPa'
tells sphere_parallel.txt '^differs +drive_speed = 1 m/s'
tells sphere_parallel.txt '^differs +pivot_height_error = 62\.17 ± 5\.38 um'
tells sphere_parallel.txt 'W = 997\.[0-9] µm instead of 3\.420 mm'
tells sphere_parallel.txt '^agrees +viscous_ratio'
# The layer's coupling, by boundary elements: 0.3 % of the shift.
tells sphere_parallel.txt 'U_stat uncoupled - 1\| = 0\.003[0-9]*, at most 0\.05: holds'
tells sphere_parallel.txt '^violated: The substrate is a half-space'
tells cylinder_parallel.txt '^differs +edge_exponent = -0\.23'
tells micro_walking_set_5.txt '^differs +hertz_diameter = 0\.4 mm'
tells micro_walking_set_5.txt 'the printed error is 1\.06 times the propagated one'
tells micro_walking_set_5.txt 'Omega_exp = 240 ± 62 Hz'
tells results/sphere_parallel/rig.json '"standing": "violated"'
tells results/sphere_parallel/report.html 'does not follow'

tells sphere_parallel.txt '\(5\.1\.16\) has a square too many'
tells results/sphere_parallel/report.html 'printed numbers do not follow from the others'

# Of another rig no remark on the thesis; what nobody can compute does not follow from anything.
sed -e 's/"8 ± 0.1 mm"/"7 mm"/; /^maxwell_ratio/d' -e '/^\[printed\]/,$d' "$source_dir/examples/rigs/sphere_parallel.toml" >other.toml
cat >>other.toml <<'END'
[printed]
thickness_ratio = {value = "0.78", source = "a note"}
length_ratio = {value = "20", source = "a note"}
END
"$program" rig other.toml >other.txt
if grep -qE '5\.1\.16|suffices|loss_modulus' other.txt results/other/rig.json; then
    complain "another rig is told of the thesis"
fi
tells results/other/report.html '1 of 2 printed numbers can be computed from the others\. All that can be computed \(1\) follow'

# 3. The same file, the same bytes.
"$program" rig "$source_dir/examples/rigs/sphere_parallel.toml" --output again >/dev/null
cmp -s again/rig.json results/sphere_parallel/rig.json || complain "rig.json differs"
cmp -s again/report.html results/sphere_parallel/report.html || complain "report.html differs"

# The chance of a violation: b/D_c = (8 ± 0.1)/(9 ± 0.5) is below 1 in Phi(1/0.51) = 97.5 % of the cases.
"$program" rig "$source_dir/examples/rigs/sphere_parallel.toml" --samples 100 --output drawn >drawn.txt
tells drawn.txt 'b/D_c = .* violated; violated in (9[5-9]|100)[.0]* % of the samples'
tells drawn/rig.json '"probability_violated"'

# The layer's sides and the tilt of its surface: not testable without their data, one criterion each with them.
tells sphere_parallel.txt '^not testable: The layer is unbounded'
tells sphere_parallel.txt '^    not given: substrate\.depth$'
tells sphere_parallel.txt '^    not given: rig\.tilt$'
tells cylinder_parallel.txt '^    not given: rig\.axis_tilt$'
sed -e 's/^thickness = .*/&\nwidth = "60 ± 1 mm"\ndepth = "18 mm"/' -e 's/^\[rig\]/&\ntilt = "0 ± 0.2 deg"/' \
    "$source_dir/examples/rigs/sphere_parallel.toml" >small.toml
"$program" rig small.toml >small.txt || complain "$(cat small.txt)"
tells small.txt '^not testable: The layer is unbounded'
tells small.txt 'Delta d/d = 0\.04[0-9]* ± 0\.01[0-9]*, at most 0\.05: not testable'
tells small.txt 'free sides add 2\.[5-9] to 5\.[0-9] % to the indentation'
tells small.txt '^holds: The surface of the substrate is level'
tells small.txt 'changes F_T by up to 1\.2 %'

# The law of friction, by forces of full sliding: F_N^(2/3) of a constant shear strength, F_N of Coulomb's law.
sed '/^\[printed\]/,$d; /^\[measurement\]/,/^$/d' "$source_dir/examples/rigs/sphere_parallel.toml" >slides.toml
printf '[measurement]\nsliding_force = "sliding.csv"\n' >>slides.toml
cp "$source_dir/examples/measurements/lens_sliding.csv" sliding.csv
"$program" rig slides.toml >slides.txt || complain "$(cat slides.txt)"
tells slides.txt '^violated: Friction grows in proportion to the pressure'
tells slides.txt 'grow with F_N\^m, m = 0\.6[0-9]* \(95 %: 0\.6'
printf 'normal_force [N], sliding_force [N]\n1, 0.51\n3, 1.49\n10, 5.02\n30, 14.9\n' >sliding.csv
"$program" rig slides.toml >slides.txt || complain "$(cat slides.txt)"
tells slides.txt '^holds: Friction grows in proportion to the pressure'
printf 'normal_force [N], sliding_force [N]\n1, 0.5\n1.2, 0.66\n1.4, 0.65\n' >sliding.csv
"$program" rig slides.toml >slides.txt || complain "$(cat slides.txt)"
tells slides.txt '^not testable: Friction grows in proportion to the pressure'
tells slides.txt '^    not given: measurement\.sliding_force over a wider range of loads$'
printf 'normal_force [N], sliding_force [N]\n1, 0.5\n1, 0.6\n2, 1\n' >sliding.csv
refused 'sliding.csv:1: a slope and its error need three different loads at least' rig "$PWD/slides.toml"

# Without a layer a rig is one on a half-space, of spheres and cylinders alone.
refused "missing key substrate.thickness" rig "$source_dir/examples/cases/body_cone.toml"
refused "this is a study, not a contact case; tricontact sweep computes it" rig \
    "$source_dir/examples/studies/rig_layer.toml"
refused "[path]: the formulas of rigs on a layer are those of one normal force and of rolling back and forth; give" rig \
    "$source_dir/examples/cases/path_twist.toml"
refused "the file cannot be read" rig missing.toml
sed 's/"8 ± 0.1 mm"/"8 N"/' "$source_dir/examples/rigs/sphere_parallel.toml" >bad.toml
refused 'bad.toml:16:13: substrate.thickness = "8 N": "N" is a unit of force' rig ../bad.toml
sed 's/"8 ± 0.1 mm"/"0.02 mm"/' "$source_dir/examples/rigs/sphere_parallel.toml" >bad.toml
refused "layer" rig ../bad.toml

finish
