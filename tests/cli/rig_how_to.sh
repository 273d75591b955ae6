#!/usr/bin/env bash
# Each block of docs/rig-how-to.md works, and what is said of their numbers is so.
# usage: rig_how_to.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/prepare.bash"
source "$source_dir/tests/cli/document_blocks.bash"

mkdir -p examples/cases
ln -s "$source_dir/examples/measurements" examples/measurements
cp -r "$source_dir/examples/records" examples
cp "$source_dir"/examples/cases/rig_layer_parallel.toml examples/cases
run_blocks rig-how-to.md
[ "$blocks" -ge 6 ] || complain "only $blocks blocks"

# said BLOCK TEXT: the block printed it.
said() { grep -qF -- "$2" "$1.out" || complain "block $1 does not say '$2': $(cat "$1.out")"; }
said 2 'b/D_c = 0.843'
said 2 'Indentation is 37.7 % below Hertz'
said 2 'The stiffness is 2.06 times'
said 2 'finds 2.50 MPa where the layer has 2.02 MPa: 24 % too high'
said 2 'changes the static shift by 0.24 % only'
said 2 'not given: rig.eigenfrequency'
said 2 'not given: rig.pivot_displacement'
grep -q '^indentation .* 37.5, 18.7, 7.48$' 3.out || complain "thicknesses for the indentation"
grep -q '^unit_shift .* 2.85$' 3.out || complain "thicknesses for U_max"
grep -q '^bem-layer .* 0.703[0-9]* *0.703' 4.out || complain "the limit: $(cat 4.out)"
said 4 '0.6953125: shakedown after 26 periods'
grep -q '5.71 MPa' 5.out && grep -q '4.22 MPa' 5.out || complain "E: $(cat 5.out)"
grep -qi 'shakedown' 6.out || complain "no verdict: $(cat 6.out)"

finish
