#!/usr/bin/env bash
# tricontact convert: each old format becomes a case that its command takes, with the same numbers; what is refused.
# usage: convert.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/prepare.bash"

# tells FILE TEXT: a line of it holds the text.
tells() { grep -qF -- "$2" "$1" || complain "$1 does not say '$2': $(cat "$1")"; }
converted() { "$program" convert "$1" --output "$2" >out 2>&1 || complain "$1: $(cat out)"; }

# 1. A rolling rig: the same assumptions as the example that says it in the new format.
cat >rolling.toml <<'END'
rig = "rolling"
title = "Sphere, rolled along the load (thesis, section 5.1.1)"
[roller]
shape = "sphere"
radius = "40 mm"
young = "206 GPa"
poisson = 0.3
[substrate]
thickness = "8 ± 0.1 mm"
young = "5.2 MPa"
poisson = 0.5
density = "1100 kg/m3"
viscosity = "40 Pa s"
maxwell_ratio = 10
[friction]
coefficient = 0.57
[load]
normal_force = "21.1 ± 0.1 N"
[drive]
speed = "1 mm/s"
smallest_amplitude_ratio = 0.25
reference_radius = "4.56 mm"
eigenfrequency = "22 Hz"
[pivot]
displacement = "1.55 ± 0.13 um"
amplitude_ratio = 0.75
[measured]
contact_size = "9.0 ± 0.5 mm"
[printed]
contact_radius = {value = "4.56 mm", source = "table 5.1.1"}
END
converted rolling.toml rig.toml
tells rig.toml 'pivot_displacement = "1.55 ± 0.13 um"'
tells rig.toml '# not in the old file'
tells rig.toml 'contact_radius = {value = "4.56 mm", source = "table 5.1.1"}'
"$program" check rig.toml >/dev/null || complain "the converted rig is no case"
sed '/^work_of_adhesion/d' "$source_dir/examples/rigs/sphere_parallel.toml" >example.toml
"$program" rig rig.toml --output new | sed '/^printed numbers/,$d' >new.txt
"$program" rig example.toml --output example | sed '/^printed numbers/,$d' >example.txt
# What is measured is what the example has tables of.
sed -i "/effect of the assumption/d" new.txt example.txt
cmp -s new.txt example.txt || complain "other assumptions: $(diff new.txt example.txt)"

# 2. The walking machine.
cat >walking.toml <<'END'
rig = "micro-walking"
title = "set 3"
[specimen]
mass = "201 g"
disc_diameter = "60 mm"
disc_length = "5 mm"
centre_length = "18 mm"
edge_radius = "5 mm"
young = "1.4 GPa"
poisson = 0.4
[substrate]
young = "90 GPa"
poisson = 0.3
[friction]
coefficient = "0.68 ± 0.03"
[contact]
diameter = "1.8 ± 1.2 mm"
[spring]
stiffness = "60 N/m"
height_ratio = -0.47
[printed]
half_height = {value = "21.2 mm", source = "table 5.2.1"}
END
converted walking.toml machine.toml
tells machine.toml 'moment_of_inertia = "1.7e-4 kg m2"  # not in the old file'
"$program" check machine.toml >/dev/null || complain "the converted machine is no case"
"$program" rig machine.toml >/dev/null || complain "the converted machine is no rig"

# 3. A measurement: errors stand behind the values, the table is named from where the case is.
mkdir old
cp "$source_dir/examples/measurements/rig_static_shift.csv" old
cat >old/shift.toml <<'END'
measurement = "static-shift"
data = "rig_static_shift.csv"
models = ["half-space", "layer"]
[indenter]
radius = "40 mm"
young = "206 GPa"
poisson = 0.3
[substrate]
poisson = 0.5
thickness = "8 mm"
[load]
normal_force = "21.1 N"
[standard_errors]
load.normal_force = "0.1 N"
substrate.thickness = "0.1 mm"
END
converted old/shift.toml shift.toml
tells shift.toml 'normal_force = "21.1 N ± 0.1 N"'
tells shift.toml 'static_shift = "old/rig_static_shift.csv"'
tells shift.toml 'find = ["substrate.young", "friction.coefficient"]'
"$program" identify shift.toml --quiet >found.txt || complain "the converted measurement"
sed 's/, "bem-layer"//' "$source_dir/examples/measurements/rig_static_shift.toml" >example.toml
cp old/rig_static_shift.csv .
"$program" identify example.toml --quiet >due.txt || complain "the example"
cmp -s found.txt due.txt || complain "other properties: $(diff found.txt due.txt)"

# 4. An experiment and its case become one file.
cp -r "$source_dir/examples/records/synthetic" .
sed '/^\[record\]/,$d; s/"0.57 ± 0.01"/0.57/; s/21.1 ± 0.1 N/21.1 N/; s/^models.*/models = ["mdr"]/' \
    "$source_dir/examples/records/synthetic_shakedown.toml" >case.toml
cat >experiment.toml <<'END'
kind = "shakedown"
runs = ["synthetic/run_1.csv", "synthetic/run_2.csv"]
case = "case.toml"
[record]
resolution = "80 nm"
[errors]
friction.coefficient = 0.01
END
converted experiment.toml record.toml
tells record.toml 'coefficient = "0.57 ± 0.01"'
"$program" experiment record.toml --quiet >found.txt || complain "the converted experiment"
tells found.txt 'largest contributors: friction.coefficient'

# 5. Refused: what is of no old format, a file that is not of its making in the way, an old file to other commands.
refused "is of no old format" convert ../rig.toml --output new.toml
cp case.toml precious.toml
refused "" convert ../rolling.toml --output ../precious.toml
cmp -s case.toml precious.toml || complain "a file was replaced"
refused "this is a rig file of the old format, not a contact case; tricontact convert makes a case of it" rig ../rolling.toml
finish
