#!/usr/bin/env bash
# The examples of module 3 of the program CONTACT are imported, and some computed: the numbers that CONTACT prints.
# usage: contact_examples.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/prepare.bash"
examples=$source_dir/tests/contact_program

# imports EXAMPLE WRITTEN OF: how many sequences of the file become cases.
imports() {
    "$program" contact import "$examples/$1.inp" --output "$1" >told.txt || complain "import of $1: $(cat told.txt)"
    grep -q "^written  *$2 of $3 in $1$" told.txt || complain "$1: $(tail -n 1 told.txt)"
}
imports bentall 6 6
imports carter2d 1 1
imports catt_to_cart 3 3
imports cattaneo 2 2
imports conformal 1 5
grep -q "^case 4 .*E = 9" told.txt || complain "what is left out is not named: $(cat told.txt)"
imports ertz_temperature 4 4
grep -q "^cell_ratio = 2.5$" ertz_temperature/*.toml || complain "the cells are not those of the file"
grep -q '^temperature = "150 degC"$' ertz_temperature/*_2.toml || complain "heat of case 2 is not that of the file"
grep -q "temperatures" told.txt && complain "temperatures are left out: $(cat told.txt)"
imports fastsim 1 8
imports spence35 1 1
imports tractcurv 60 60
grep -q '^tangential_stiffness = "6560 MPa/mm"$' tractcurv/*_60.toml || complain "the layer is not that of the file"
grep -q '^memory_length = "0.003 mm"$' tractcurv/*_60.toml || complain "the memory is not that of the file"
imports visc_cylindr 6 6
imports veldep_fric 1 2
grep -q "^cases 2 to 4 .*L = 4: friction that falls" told.txt || complain "what is left out is not named: $(cat told.txt)"
imports plastic_3bl 5 5
grep -q '^hardening = "-195 MPa/mm"$' plastic_3bl/*_32.toml || complain "the layer does not soften as that of the file"
refused "subsurf.inp:13:1: " contact import "$examples/subsurf.inp" --output none

# Cheap ones beside CONTACT: 0.5 % or a few cells; forces, creepages, pressures and energies agree closer.
$python "$source_dir/scripts/contact_examples.py" "$program" "$examples" carter2d \
    cattaneo bentall conformal ertz_temperature fastsim plastic_3bl veldep_fric visc_cylindr >table.md ||
    complain "the comparison"
[ "$(grep -c '%' table.md)" -ge 20 ] || complain "rows: $(grep -c '%' table.md)"
# But for temperatures by friction: there each cell heats itself twice.
awk -F'|' '/%/ { d = $7 + 0; if (d < 0) d = -d; if (d > ($3 ~ /MAXT/ ? 8.8 : 0.5)) { print; bad = 1 } } END { exit bad }' table.md ||
    complain "more than 0.5 % off"

finish
