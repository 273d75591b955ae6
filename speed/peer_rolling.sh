#!/usr/bin/env bash
# Steady rolling beside CONTACT (docs/how-to/contact-program.md), which must be there: a sphere of radius 70 mm on an
# elastic half-space (E = 3 MPa, nu = 0.3, mu = 0.35, a = 4 mm) at a creepage of 0.7 mu a/R, spinning by mu/(2 R), or
# under F_x = -0.6 mu F_N, on 2 n + 7 cells a side. Both processes in turn, user time of the whole of each: influence
# coefficients, normal and tangential contact. CONTACT: the shorter of two of its GDsteady's settings, to EPS.
# usage: peer_rolling.sh BENCHMARK_STEADY_ROLLING CONTACT [N]... [-- DRIVE]...       N: 24, 68, 146; DRIVE: creeps, spins, pulled
set -euo pipefail
benchmark=$(realpath "$1")
contact=$(realpath "$2")
shift 2
sizes=() drives=()
while (($# > 0)) && [[ $1 != -- ]]; do sizes+=("$1") && shift; done
(($# > 0)) && shift
drives=("$@")
((${#sizes[@]} > 0)) || sizes=(24 68 146)
((${#drives[@]} > 0)) || drives=(creeps spins pulled)
repetitions=${REPETITIONS:-3} eps=${EPS:-1e-6}
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 LC_ALL=C
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# deck N DRIVE "GDsteady's parameters": two bodies of twice the modulus are one on a rigid one, and uncoupled
deck() {
    awk -v n="$1" -v drive="$2" -v solver="$3" -v eps="$eps" 'BEGIN {
        radius = 70; a = 4; mu = .35; nu = .3; young = 3; h = a/n; cells = 2*n + 7; first = -(n + 3.5)*h
        force = 4/3*young/(1 - nu^2)*a^3/radius; unit = mu*a/radius; shear = 2*young/(2*(1 + nu))
        along = drive == "creeps" ? .7*unit : drive == "pulled" ? -.6 : 0
        print " 3 MODULE"
        printf " 2031%d0 P-B-T-N-F-S\n 022020 L-D-C-M-Z-E\n 500111 G-I-A-O-W-R\n", drive == "pulled" ? 2 : 0
        printf " 9999 100 60 1 %s MAXGS MAXIN MAXNR MAXOUT EPS\n %s\n", eps, solver
        printf " %.12g %.12g 0. %.12g FN CKSI/FX CETA/FY CPHI\n", force, along, drive == "spins" ? .5*unit/a : 0
        printf " %g %g FSTAT FKIN\n 0. %.12g 1000. CHI DQ VELOC\n", mu, mu, h
        printf " %g %g %.12g %.12g POISS GG\n 1 IPOTCN\n", nu, nu, shear, shear
        printf " %d %d %.12g %.12g %.12g %.12g MX MY XL YL DX DY\n", cells, cells, first, first, h, h
        printf " 1 1 IBASE IPLAN\n %.12g 0. %.12g 0. 0. 0. B\n 0 MODULE\n", .5/radius, .5/radius
    }'
}

# seconds COMMAND...: user time; what it says goes to out.txt
seconds() {
    TIMEFORMAT=%U
    { time (cd "$folder" && "$@" >out.txt 2>&1 || true); } 2>&1
}
median() { sort -g | awk '{t[NR] = $1} END {print t[int((NR + 1)/2)]}'; }

for n in "${sizes[@]}"; do
    for drive in "${drives[@]}"; do
        ours=() theirs=()
        deck "$n" "$drive" "1. .05 1 1. 0. 1. 1. .9" >"$folder/first.inp"
        deck "$n" "$drive" ".9 .10 1 1. 1. 1. 1. .9" >"$folder/second.inp"
        for ((k = 0; k < repetitions; k++)); do
            ours+=("$(seconds "$benchmark" --benchmark_filter="driven_sphere/$drive/$n\$" --benchmark_min_time=1e-9)")
            if ! F=$(grep -o 'force=[^ ]*' "$folder/out.txt"); then
                echo "$benchmark: no benchmark driven_sphere/$drive/$n; build it anew" >&2
                cat "$folder/out.txt" >&2
                exit 1
            fi
            for solver in first second; do theirs+=("$(seconds "$contact" 2 $solver) $solver"); done
        done
        best=$(for solver in first second; do
            echo "$(printf '%s\n' "${theirs[@]}" | awk -v s=$solver '$2 == s {print $1}' | median) $solver"
        done | sort -g | head -1)
        read -r time solver <<<"$best"
        printf '%s\n' "${ours[@]}" | median | awk -v n="$n" -v drive="$drive" -v theirs="$time" -v force="$F" \
            -v printed="$(awk '/ FX  /{getline; print $2, $3; exit}' "$folder/$solver.out")" \
            '{printf "%d x %d %s: %.3g s beside %.3g s, %.1f times; %s beside %s N\n", 2*n + 7, 2*n + 7, drive, $1, theirs, theirs/$1, force, printed}'
    done
done
