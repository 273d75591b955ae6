#!/usr/bin/env bash
# Problems with bodies of a finite size: the model's own surface on three meshes passes, that of a body 5 % stiffer and
# that of the half-space fail; decks and references that there are not are refused.
# usage: fem_finite_bodies.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
export TRICONTACT_CACHE=$work/cache OPENBLAS_NUM_THREADS=1

"$program" benchmark show hemisphere --case >hemisphere.toml || complain "no case"
own() { "$program" run hemisphere.toml --no-report --no-studies --quiet --output "$@" || complain "run $*"; }
for h in .256 .128 .064; do
    own "own_$h" --set "fem.size=\"$h mm\""
    own "stiff_$h" --set "fem.size=\"$h mm\"" --set 'indenter.young="2.1 MPa"'
done
# The half-space of Hertz: 7.1 % too soft.
for n in 10 20 40; do own "hertz_$n" --models bem --set "bem.cells_per_radius=$n"; done
verdict() {
    local expected=$1 status=0
    shift
    "$program" benchmark compare --case hemisphere "$@" --output out >said.txt 2>err.txt || status=$?
    [ "$status" -eq "$expected" ] || complain "$*: exit code $status: $(cat err.txt said.txt)"
}
surfaces() { for one in "${@:2}"; do echo "$one/$1/surface.ex2"; done; }
mapfile -t exact < <(surfaces fem-axisymmetric own_.256 own_.128 own_.064)
mapfile -t stiff < <(surfaces fem-axisymmetric stiff_.256 stiff_.128 stiff_.064)
mapfile -t hertz < <(surfaces bem hertz_10 hertz_20 hertz_40)
verdict 0 "${exact[@]}"
verdict 3 "${stiff[@]}"
verdict 3 "${hertz[@]}"

# The deck's radius is that of the reference, 1.0246 mm by an independent program.
"$program" benchmark deck hemisphere --code freefem --levels 1 --output deck >readme.txt || complain "no deck"
grep -q 'contact radius 1.024[567]' deck/hemisphere_n4.edp || complain "radius of the deck: $(head -1 deck/hemisphere_n4.edp)"
! grep -q block_width deck/submission.toml || complain "half a ball has no block"
refused 'are pressed along their axis' benchmark deck hemisphere_on_layer --code mesh --half --output deck --quiet
# Meshes alone of both bodies, which the program reads no further.
"$program" benchmark deck hemisphere_on_layer --code mesh --levels 1 --output meshes >readme.txt || complain "no meshes"
for body in lower upper; do
    grep -q '"contact"' "meshes/hemisphere_on_layer_n4_$body.msh" && grep -q '"base"' "meshes/hemisphere_on_layer_n4_$body.msh" ||
        complain "parts of the mesh of the $body body"
done

# Two bodies by the decks of FreeFem++ and GetFEM, as these computed them.
foreign=$source_dir/tests/benchmarks/foreign
for code in freefem_p2 getfem_q2; do
    "$program" benchmark compare --case hemisphere_on_layer "$foreign/${code}_hemisphere_on_layer_"{4,8,16}.csv \
        --output out >said.txt 2>err.txt || complain "$code: $(cat err.txt said.txt)"
done
# Of revolution nothing pulls such bodies.
sed 's/^coupling = false/coupling = true/; s/^tangential_ratio = .*/tangential_ratio = 0.5/; s/fem-axisymmetric/fem/' hemisphere.toml >pulled.toml
refused 'pulled once in plane strain' benchmark deck "$PWD/pulled.toml" --code calculix --output deck --quiet
finish
