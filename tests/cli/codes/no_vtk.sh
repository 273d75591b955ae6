#!/usr/bin/env bash
# Where a library of VTK cannot be loaded, the file that needs it is refused by one line with the remedy, and nothing is
# written; files that need none are compared.
# usage: no_vtk.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
foreign=$source_dir/tests/benchmarks/foreign
reader=$(dirname "$program")/tricontact_vtk_reader
[ -x "$reader" ] || { echo "built without VTK"; exit 0; }

# An empty file in the place of the first library: the loader refuses it.
library=$(readelf -d "$reader" | sed -n 's/.*NEEDED.*\[\(libvtkIOXML.*\)\]/\1/p')
[ -n "$library" ] || complain "the reader needs no libvtkIOXML"
mkdir empty
: >"empty/$library"
code=0
LD_LIBRARY_PATH=$PWD/empty "$program" benchmark compare --case layer_pressed "$foreign/getfem_q2_1.vtu" --output out \
    >log 2>&1 || code=$?
[ "$code" -eq 2 ] || complain "ends with $code: $(cat log)"
[ "$(grep -c . log)" -eq 1 ] || complain "more than one line: $(cat log)"
grep -qF "getfem_q2_1.vtu: files of this kind are read by VTK, whose library $PWD/empty/$library cannot be loaded; apt-get install libvtk9.1" \
    log || complain "not said: $(cat log)"
[ ! -e out ] || complain "something is written"
code=0
LD_LIBRARY_PATH=$PWD/empty "$program" benchmark compare --case layer_pressed "$foreign/getfem_q2_1.csv" --output out \
    >log 2>&1 || code=$?
[ "$code" -ne 2 ] || complain "a table is refused: $(cat log)"
finish
