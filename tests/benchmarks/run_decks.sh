#!/usr/bin/env bash
# Runs decks with the codes that are installed (scripts/packages.txt: codes), and compares their forces with exact
# ones: under a minute. Decks of a code that is not there are skipped, and named. Exit code 77 where there is none.
# usage: run_decks.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/prepare.bash"
export TRICONTACT_CACHE=$work/cache OMP_NUM_THREADS=1
tried=0

# deck NAME CODE ARGUMENTS...: writes it into the folder CODE_NAME.
deck() {
    "$program" benchmark deck "$1" --code "$2" --output "$2_$1" "${@:3}" >/dev/null || complain "no deck $1 for $2"
}
# near WHAT VALUE EXPECTED SHARE: within this share of the expected value.
near() {
    awk -v x="$2" -v y="$3" -v share="$4" 'BEGIN { d = x/y - 1; exit !(d*d <= share*share) }' ||
        complain "$1: $2 instead of $3"
}
# total FILE SET COLUMN: of the last time in CalculiX' print.
total() {
    awk -v set="$2" -v k="$3" '/total force/ { on = $6 == set; next } on && NF == 3 { value = $k } END { print value }' "$1"
}
# force_of FILE: of the head of a table.
force_of() { sed -n 's/^# normal_force = \([^ ]*\) .*/\1/p' "$1"; }

# pair CODE PROGRAM OPTION ENDING: decks of two bodies on 8 elements in a. Persson's peak at 30 degrees, Keer's below the
# line load, an independent program's hemisphere on a layer; order 2, so that 16 elements leave a quarter of what these do.
pair() {
    local name
    for name in pin_in_hole receding_layer hemisphere_on_layer nafems_punch; do
        deck $name "$1" --levels 2
        # shellcheck disable=SC2086
        (cd "$1_$name" && "$2" $3 ${name}_n8.$4 >/dev/null 2>&1)
    done
    middle() { awk -F, '/^0,/ { print $2 }' "$1"; }
    near "$1, p0 of the pin" "$(middle "$1_pin_in_hole/pin_in_hole_n8.csv")" 73.22575 .003
    near "$1, p below the line load" "$(middle "$1_receding_layer/receding_layer_n8.csv")" .00445675 .01
    near "$1, F of hemisphere and layer" "$(force_of "$1_hemisphere_on_layer/hemisphere_on_layer_n8.csv")" .21837 .0035
    near "$1, force of the loose punch" "$(force_of "$1_nafems_punch/nafems_punch_n8.csv")" 785398.16 1e-6
}

# F_N = 16.48962 N at nu = 0.3: the integral equation of the bonded layer (Lebedev and Ufliand 1958).
exact=16.48962
# F_N = 0.31530 N of the hemisphere, by an independent program; its penalty of 310 MPa/mm takes 0.36 %.
hemisphere=0.31530 with_penalty=0.31418

if command -v ccx >/dev/null; then
    tried=1
    deck layer_pressed calculix --levels 3
    for n in 4 8 16; do (cd calculix_layer_pressed && ccx layer_pressed_n$n >/dev/null 2>&1); done
    # The sector of two degrees. Penalty -0.42 %, displaced surface +2.20 % to first order, its square 0.4 %.
    force=$(total calculix_layer_pressed/layer_pressed_n16.dat NIND 2)
    near "CalculiX, F of the layer" "$(awk -v f="$force" 'BEGIN { print -180*f }')" "$(awk -v f=$exact 'BEGIN { print 1.0178*f }')" .005
    deck patch_test calculix
    for n in 4 8 16; do
        (cd calculix_patch_test && ccx patch_test_n$n >/dev/null 2>&1)
        # 100 N, of which the penalty takes 1e-4; seven digits are printed.
        near "CalculiX, patch test" "$(total calculix_patch_test/patch_test_n$n.dat LBASE 2)" 99.99000 1e-6
    done
    deck wedge calculix --levels 2
    for n in 4 8; do
        (cd calculix_wedge && ccx wedge_n$n >/dev/null 2>&1)
        # The slope is that of the displaced surface: it turns by the strains, p/E = 1e-4.
        near "CalculiX, wedge" "$(total calculix_wedge/wedge_n$n.dat ULEFT 1)" 412.3711 1e-4
    done
    deck hemisphere calculix --levels 2
    (cd calculix_hemisphere && ccx hemisphere_n8 >/dev/null 2>&1)
    # Mesh: 0.02 %.
    near "CalculiX, F of the hemisphere" "$(awk -v f="$(total calculix_hemisphere/hemisphere_n8.dat NIND 2)" 'BEGIN { print -180*f }')" $with_penalty .0005
else
    echo "skipped: CalculiX (ccx) is not installed"
fi

if command -v FreeFem++ >/dev/null; then
    tried=1
    deck layer_pressed freefem --levels 3
    for n in 4 8 16; do (cd freefem_layer_pressed && FreeFem++ -nw layer_pressed_n$n.edp >/dev/null); done
    # Penalty of 260 MPa/mm: -0.420 % by the envelope theorem; mesh 0.02 %.
    near "FreeFem++, F of the layer" "$(force_of freefem_layer_pressed/layer_pressed_n16.csv)" "$(awk -v f=$exact 'BEGIN { print 0.9958*f }')" 3e-4
    deck hemisphere freefem --levels 2
    (cd freefem_hemisphere && FreeFem++ -nw hemisphere_n8.edp >/dev/null)
    near "FreeFem++, F of the hemisphere" "$(force_of freefem_hemisphere/hemisphere_n8.csv)" $with_penalty 5e-4
    pair freefem FreeFem++ -nw edp
else
    echo "skipped: FreeFem++ is not installed"
fi

if "$python" -c 'import getfem' 2>/dev/null; then
    tried=1
    deck layer_pressed getfem --levels 3
    for n in 4 8 16; do (cd getfem_layer_pressed && "$python" layer_pressed_n$n.py >/dev/null 2>&1); done
    near "GetFEM, F of the layer" "$(force_of getfem_layer_pressed/layer_pressed_n16.csv)" $exact 2e-4
    # Half of 35 kN/mm: Hertz' peak pressure; 0.1 % by the mesh.
    deck cylinder_on_block getfem --levels 3
    for n in 4 8 16; do (cd getfem_cylinder_on_block && "$python" cylinder_on_block_n$n.py >/dev/null 2>&1); done
    near "GetFEM, F of the cylinder" "$(force_of getfem_cylinder_on_block/cylinder_on_block_n16.csv)" 35000 1e-6
    near "GetFEM, p0 of the cylinder" "$(awk -F, '/^0,/ { print $2 }' getfem_cylinder_on_block/cylinder_on_block_n16.csv)" 3585.4 1e-3
    deck hemisphere getfem --levels 2
    (cd getfem_hemisphere && "$python" hemisphere_n8.py >/dev/null 2>&1)
    near "GetFEM, F of the hemisphere" "$(force_of getfem_hemisphere/hemisphere_n8.csv)" $hemisphere 3e-4
    pair getfem "$python" "" py
else
    echo "skipped: GetFEM (python3-getfem) is not installed"
fi

[ "$tried" -eq 1 ] || { echo "no code is installed: nothing was run"; exit 77; }
finish
