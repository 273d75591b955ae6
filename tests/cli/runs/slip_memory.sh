#!/usr/bin/env bash
# Friction that changes with the way of slip: what a run tells of states and jumps, and what is refused.
# usage: slip_memory.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../summaries.bash"
case_file=$source_dir/examples/cases/path_weakening.toml

run() { "$program" run "$@" --quiet --no-studies >told.txt 2>&1; }

# 1. Slid far beyond D_c every point has mu - drop: 0.38 F_N. What sticks again begins anew with mu.
run "$case_file" --set path.table='"indentation [mm], shift_x [um], shift_y [um]\n0.3, 0, 0\n0.3, 400, 0"' --output slid ||
    complain "the example: $(cat told.txt)"
last() { awk -F, -v column="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == column) at = i } END { print $at }' "$1/bem/history.csv"; }
awk -v t="$(last slid tangential_force_x_N)" -v n="$(last slid normal_force_N)" 'BEGIN { exit (t / n / 0.38 - 1) ^ 2 > 1e-12 }' ||
    complain "sliding carries $(last slid tangential_force_x_N) of $(last slid normal_force_N) N"
grep -q "falling by 0.19 p over a slip of 50" slid/report.html || complain "the law is not told"
grep -q "every step has one state alone" slid/report.html || complain "one state is not told"
grep -q "have another state, of more slip" slid/report.html && complain "another state is told"

# 2. Soft springs and a short D_c: points jump, which is told; a run that goes on from its states is the same one.
run "$case_file" --set 'friction.weakening.length="1 um"' --set 'interface.tangential_stiffness="0.5 MPa/mm"' --output jumps ||
    complain "jumps: $(cat told.txt)"
grep -q "have another state, of more slip" jumps/report.html || complain "other states are not told"
grep -q "the contact jumped" jumps/report.html || complain "a jump is not told"
awk -v e="$(value bem released_energy_J jumps/summary.json)" -v n="$(value bem steps_of_other_states jumps/summary.json)" 'BEGIN { exit !(e > 0 && n > 0) }' ||
    complain "a jump sets free $(value bem released_energy_J jumps/summary.json) J in $(value bem steps_of_other_states jumps/summary.json) steps"

# 3. Under a force up to the peak alone.
run "$case_file" --set path.table='"normal_force [N], tangential_force_x [N]\n9.6, 0\n9.6, 4.6"' --no-report --output force
[ $? = 2 ] || complain "a force beyond the peak: $(cat told.txt)"
grep -q "N is more than friction carries that falls with the slip (5.472 N at rest)" told.txt || complain "$(cat told.txt)"
[ ! -e force/summary.json ] || complain "a summary of no state"

# 4. Models beside each other: a layer that yields and hardens, tractions to 1 %.
sed '/friction.weakening/,/^$/d' "$case_file" >yield.toml
printf '[interface]\nyield_stress = "0.08 MPa"\nhardening = "0.5 MPa/mm"\n' >>yield.toml
if has_fem; then
    run yield.toml --set models='["bem-layer", "fem"]' --set 'substrate.thickness="12 mm"' --set bem.cells_per_radius=8 \
        --set path.table='"indentation [mm], shift_x [um], shift_y [um]\n0.3, 0, 0\n0.3, 150, 0"' --set path.steps=3 --no-report --output layer ||
        complain "a layer: $(cat told.txt)"
    "$python" -S - <<'PYTHON' || complain "fem and bem-layer differ"
import csv
end = {m: list(csv.DictReader(open(f"layer/{m}/history.csv")))[-1] for m in ("bem-layer", "fem")}
ratio = float(end["fem"]["tangential_force_x_N"]) / float(end["bem-layer"]["tangential_force_x_N"])
print("fem over bem-layer:", ratio)
raise SystemExit(abs(ratio - 1) > .01)
PYTHON
fi

# 5. Rolled back and forth a layer that hardens is worn in: the limit is that of the surfaces, from where it settles.
rolled=$source_dir/examples/cases/rig_sphere_parallel.toml
run "$rolled" --models bem --set bem.cells_per_radius=10 --set 'interface.yield_stress="0.1 MPa"' --set 'interface.hardening="2 MPa/mm"' \
    --no-report --output hard || complain "rolled: $(cat told.txt)"
run "$rolled" --models bem --set bem.cells_per_radius=10 --no-report --output coulomb || complain "rolled: $(cat told.txt)"
for key in unit_shift_m limit_tangential_ratio limit_amplitude_ratio; do
    awk -v a="$(value bem $key hard/summary.json)" -v b="$(value bem $key coulomb/summary.json)" 'BEGIN { exit !(a > 0 && (a / b - 1) ^ 2 < 1e-20) }' ||
        complain "$key: $(value bem $key hard/summary.json), $(value bem $key coulomb/summary.json) of the surfaces"
done
awk -v a="$(value bem settled_shift_m hard/summary.json)" -v b="$(value bem settled_shift_m coulomb/summary.json)" 'BEGIN { exit !(a > 1.01 * b) }' ||
    complain "the layer does not flow: $(value bem settled_shift_m hard/summary.json) and $(value bem settled_shift_m coulomb/summary.json) m"

if has_fem; then
    run "$rolled" --set models='["bem-layer", "fem"]' --set 'substrate.thickness="12 mm"' --set bem.cells_per_radius=10 --set rolling.periods=2 \
        --set 'interface.yield_stress="0.08 MPa"' --set 'interface.hardening="1 MPa/mm"' --no-report --output rolled_layer || complain "rolled on a layer: $(cat told.txt)"
    awk -v a="$(value fem final_shift_m rolled_layer/summary.json)" -v b="$(value bem-layer final_shift_m rolled_layer/summary.json)" 'BEGIN { exit !(a > 0 && (a / b - 1) ^ 2 < 1e-4) }' ||
        complain "rolled: fem $(value fem final_shift_m rolled_layer/summary.json), bem-layer $(value bem-layer final_shift_m rolled_layer/summary.json) m"
fi

# 6. Bodies that relax have it too.
run "$case_file" --set 'substrate.relaxation.relative_moduli=[0.5]' --set 'substrate.relaxation.times=["0.5 s"]' --set bem.cells_per_radius=8 \
    --set path.table='"time [s], indentation [mm], shift_x [um], shift_y [um]\n1, 0.3, 0, 0\n2, 0.3, 200, 0\n9, 0.3, 200, 0"' --no-report --output relaxing ||
    complain "a relaxing body: $(cat told.txt)"

# 7. Refused by name.
refused() {
    local expected=$1
    shift
    run "$@" --output refused
    [ $? = 2 ] || complain "not refused: $expected"
    grep -qF -- "$expected" told.txt || complain "expected '$expected': $(cat told.txt)"
    [ "$(wc -l <told.txt)" = 1 ] || complain "more than a line: $(cat told.txt)"
}
refused "what a spring of mdr slips is the slip of no point" "$case_file" --models mdr
refused "leaves nothing of friction.coefficient = 0.57" "$case_file" --set friction.weakening.drop=0.57
refused "only Coulomb's law falls with the way of slip" "$case_file" --set 'friction.shear_strength="1 kPa"'
refused "is a second friction.strength_limit" yield.toml --set 'friction.strength_limit="0.1 MPa"'
refused "is not above friction.shear_strength" yield.toml --set 'friction.shear_strength="0.1 MPa"'
refused "has no effect without interface.yield_stress" "$source_dir/examples/cases/path_twist.toml" --set 'interface.hardening="1 MPa/mm"'
rolled=$source_dir/examples/cases/rig_sphere_parallel.toml
refused "what becomes of a contact that rolls is not decided where friction falls with the slip" "$rolled" --models bem \
    --set 'interface.yield_stress="0.1 MPa"' --set 'interface.hardening="-1 MPa/mm"'
refused "what becomes of a contact that rolls is not decided where friction falls with the slip" "$rolled" --models bem \
    --set 'friction.weakening.law="linear"' --set friction.weakening.drop=0.1 --set 'friction.weakening.length="10 um"'
refused "what a spring of mdr slips is the slip of no point: a point's is a mean over springs" "$rolled" \
    --set 'interface.yield_stress="0.1 MPa"' --set 'interface.hardening="1 MPa/mm"'
refused "a contact that rolls on a relaxing substrate knows no friction that changes with the slip" "$rolled" --models bem \
    --set 'interface.yield_stress="0.1 MPa"' --set 'interface.hardening="1 MPa/mm"' --set 'substrate.relaxation.relative_moduli=[0.4]' \
    --set 'substrate.relaxation.times=["0.5 s"]' --set 'rolling.speed="1 mm/s"'

finish
