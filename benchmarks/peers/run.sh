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

for size in 1 0.5; do
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

# The exact solution is frictionless: pressure and indentation are judged without friction.
own_frictionless() {
    name=own_$1_frictionless
    "$program" run "$case" --models fem --set fem.cache=none --set fem.size="$1 mm" \
        --set load.press=frictionless --set load.tangential_ratio=0.001 \
        --set rolling.amplitude_ratio=0 --set rolling.periods=1 --set output.volume=none \
        --no-report --threads 1 --output "$name" > "$name.log"
    "$python" "$here/own_layer.py" "$name" > "$name.json"
}

# own_pressed SIZE STEPS: as the peers press, which are too slow for 20 steps
own_pressed() {
    name=own_$1_pressed_$2
    "$program" run "$case" --models fem --set fem.cache=none --set fem.size="$1 mm" \
        --set load.press_steps="$2" --set output.volume=none \
        --set rolling.amplitude_ratio=0 --set rolling.periods=1 --no-report --threads 1 \
        --output "$name" > "$name.log"
    "$python" "$here/own_layer.py" "$name" > "$name.json"
}

for size in 1 0.5; do
    own_frictionless $size
    own_pressed $size 1
    own_pressed $size 5
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
