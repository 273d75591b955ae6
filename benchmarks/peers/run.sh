#!/bin/sh
# Public programs beside ours on the rig's layer: ./run.sh PROGRAM FOLDER, see README.md.
# One process at a time, one thread each; results and times go into FOLDER.
set -eu
program=$(realpath "$1")
mkdir -p "$2"
here=$(dirname "$(realpath "$0")")
case=$(realpath "$here/../../examples/cases/rig_layer_parallel.toml")
cd "$2"
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 PYTHONPATH="$here"
python=/usr/bin/python3

for size in 1.4 1 0.7 0.5; do
    "$program" mesh "$case" --set fem.size="$size mm" --output "mesh_$size" > "mesh_$size.log"
done

# own SIZE PERIODS: two lengths of one history give the cost of an increment
own() {
    name=own_$1_$2
    /usr/bin/time -v "$program" run "$case" --models fem --set fem.cache=none \
        --set fem.size="$1 mm" --set rolling.periods="$2" \
        --set rolling.run_all=true --set output.volume=none --no-report --threads 1 --output "$name" \
        > "$name.log" 2> "$name.time"
    "$python" "$here/own_layer.py" "$name" > "$name.json"
}

# getfem NAME SIZE OPTIONS...
getfem() {
    name=getfem_$1 size=$2
    shift 2
    /usr/bin/time -v "$python" "$here/getfem_layer.py" "mesh_$size/mesh.msh" "$size" "$@" \
        > "$name.json" 2> "$name.time"
}

# calculix NAME SIZE OPTIONS...
calculix() {
    name=calculix_$1 size=$2
    shift 2
    "$python" "$here/calculix_layer.py" deck "$name" --mesh "mesh_$size/mesh.msh" \
        --size "$size" "$@"
    /usr/bin/time -v ccx "$name" > "$name.log" 2> "$name.time" || true  # it may give up late
    "$python" "$here/calculix_layer.py" read "$name" > "$name.json"
}

# axisymmetric NAME OPTIONS...: GetFEM without friction
axisymmetric() {
    name=getfem_axisymmetric_$1
    shift
    /usr/bin/time -v "$python" "$here/getfem_axisymmetric.py" "$@" > "$name.json" 2> "$name.time"
}

# own_frictionless SIZE MATERIAL
# The exact solution is frictionless: pressure and indentation are judged without friction.
own_frictionless() {
    name=own_$1_frictionless_$2
    "$program" run "$case" --models fem --set fem.cache=none --set fem.size="$1 mm" \
        --set substrate.material="$2" \
        --set load.press=frictionless --set load.tangential_ratio=0.001 \
        --set rolling.amplitude_ratio=0 --set rolling.periods=1 --set output.volume=none \
        --no-report --threads 1 --output "$name" > "$name.log"
    "$python" "$here/own_layer.py" "$name" > "$name.json"
}

# own_pressed SIZE STEPS MATERIAL: as the peers press, which are too slow for 20 steps
own_pressed() {
    name=own_$1_pressed_$2_$3
    "$program" run "$case" --models fem --set fem.cache=none --set fem.size="$1 mm" \
        --set substrate.material="$3" \
        --set load.press_steps="$2" --set output.volume=none \
        --set rolling.amplitude_ratio=0 --set rolling.periods=1 --no-report --threads 1 \
        --output "$name" > "$name.log"
    "$python" "$here/own_layer.py" "$name" > "$name.json"
}

"$python" "$here/exact_layer.py" > exact.log
for size in 1 0.5; do
    own_frictionless $size linear
    own_pressed $size 1 linear
    own_pressed $size 5 linear
    own $size 1
    own $size 5
done

reduced="--element 20 --volume reduced --press-steps 1"
getfem 1_frictionless 1 $reduced --frictionless
getfem 1_linear 1 $reduced --rolling 2
getfem 1_deformed 1 $reduced --press-steps 5 --kinematics deformed
getfem 1_mixed 1 --press-steps 1
getfem 0.5_frictionless 0.5 $reduced --frictionless
getfem 0.5_linear 0.5 $reduced --rolling 2

calculix 1_frictionless 1 --press-steps 5 --frictionless
calculix 1_loaded 1 --press-steps 5
shift_found=$(sed 's/.*"u_stat": \([0-9.]*\).*/\1/' calculix_1_loaded.json)
calculix 1_rolled 1 --press-steps 5 --rolling 1 --shift "$shift_found"

# Finite strains: each program beside its own linear run on the same mesh, in as many steps
deformed="--kinematics deformed"
strained="$deformed --bulk neo-hookean"
own_frictionless 0.5 neo-hookean
own_pressed 0.7 5 linear
for size in 1 0.7; do
    own_pressed $size 5 neo-hookean
done
for size in 0.25 0.125; do
    axisymmetric ${size}_linear $size
    axisymmetric ${size}_deformed $size $deformed
    axisymmetric ${size}_strained $size $strained
done
getfem 1_linear_5 1 $reduced --press-steps 5
for size in 1.4 1 0.7; do
    getfem ${size}_mixed_linear $size --press-steps 5
    getfem ${size}_mixed_deformed $size --press-steps 5 $deformed
    getfem ${size}_mixed_strained $size --press-steps 5 $strained
done
# CalculiX holds d: linear once more at the normal force that neo-Hookean then has under F_T.
# At h = 1 mm neo-Hookean presses, but gives up under F_T.
calculix 1.4_held 1.4 --press-steps 5
calculix 1.4_held_strained 1.4 --press-steps 5 --bulk neo-hookean
force_found=$(sed 's/.*"force": \([0-9.]*\), "u_stat.*/\1/' calculix_1.4_held_strained.json)
calculix 1.4_force 1.4 --press-steps 5 --normal-force "$force_found"
calculix 1_held 1 --press-steps 10
calculix 1_held_strained 1 --press-steps 10 --bulk neo-hookean
