#!/usr/bin/env bash
# Broken results of contact codes from the shell: exit code 2, one line "error: ...", nothing written.
# tests/unit/benchmarks/submissions/bad_results.cc reads many more; what readers throw reaches the shell by one way.
# usage: bad_results.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
formats=$source_dir/tests/benchmarks/formats
foreign=$source_dir/tests/benchmarks/foreign

# of EXPECTED FILE...: compared with the layer.
of() {
    local expected=$1
    shift
    refused "$expected" benchmark compare --case layer_pressed "$@" --output out
}

printf 'r,p\n0,nan\n' >"$work/nan.csv"
printf '# normal_farce = 3 N\nr,p\n0,1\n' >"$work/key.csv"
head -c 3000 /dev/zero >"$work/zeros.csv"
head -c 3000 "$formats/layer.vtu" >"$work/cut.vtu"
head -c 6000 "$formats/layer.e" >"$work/cut.e"
head -n 100 "$formats/calculix_CAX4_2d.frd" >"$work/cut.frd"
gzip -c "$foreign/getfem_q2_1.csv" >"$work/gzip.csv"
: >"$work/empty.vtu"
of "nan.csv:2: p = nan: must be a finite number" "$work/nan.csv"
of "key.csv:1: unknown key normal_farce; did you mean normal_force?" "$work/key.csv"
of "holds zero bytes" "$work/zeros.csv"
of "holds zero bytes" "$work/gzip.csv"
of "; write it again, or a table of columns (.csv)" "$work/cut.vtu"
of "; write it again, or a table of columns (.csv)" "$work/cut.e"
of "the file ends within a block" "$work/cut.frd"
of "the file is empty" "$work/empty.vtu"
of "the file has u" "$foreign/getfem_q2_1.vtu"
of "unknown kind of file" "$foreign/layer_pressed.toml" "$foreign/getfem_q2_1.csv"
of "No such file" "$work/none.vtu"

printf 'case = "layer_pressed"\n[[mesh]]\nfield = "nan.csv"\n' >"$work/nan.toml"
printf 'case = "layer_pressed"\n[contact]\nstiffness = "260 MPa"\n[[mesh]]\nfield = "nan.csv"\n' >"$work/unit.toml"
refused "nan.csv:2: p = nan" benchmark compare "$work/nan.toml" --output out
refused 'contact.stiffness = "260 MPa": "MPa" is a unit of pressure' benchmark compare "$work/unit.toml" --output out
finish
