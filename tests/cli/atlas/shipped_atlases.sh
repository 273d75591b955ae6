#!/usr/bin/env bash
# Shipped atlases against runs at random points that took no part in them, computed one level finer: within the bars,
# and u_stat, u_sd and Delta u within 0.5, 0.5 and 3 %, u_sd under a shear strength 1.5 %. Their studies are those in atlas/studies.
# usage: shipped_atlases.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# POINTS of the atlas: as many as cost some seconds.
checked=()
while read -r name points; do
    checked+=("$name")
    "$program" atlas "$source_dir/atlas/studies/$name.toml" --atlas "$source_dir/atlas/data/$name.json" \
        --output "$name" --check "$points" --seed 2026 --jobs 2 --quiet >said || complain "$name: $(cat said)"
    grep -q ' points, error median' said || complain "$name says nothing: $(cat said)"
    $python - "$name/check.csv" <<'END' || complain "$name: off its runs"
import csv, sys
allowed = {"static_shift_ratio": 5e-3, "settled_shift_ratio": 5e-3, "shift_increment_ratio": 3e-2,
           "limit_tangential_ratio": 1e-3, "indentation_m": 1e-3, "contact_radius_m": 1e-3, "peak_pressure_Pa": 1e-3,
           "unit_shift_m": 1e-3, "kappa": 2e-2, "eta": 5e-2}
if "strength" in sys.argv[1]:  # parts of cells at the edge: first order
    allowed |= {"settled_shift_ratio": 1.5e-2, "kappa": 3e-2}
rows = list(csv.DictReader(open(sys.argv[1])))
assert rows
for row in rows:
    computed, read = float(row["computed"]), float(row["atlas"])
    assert abs(read / computed - 1) < allowed[row["quantity"]], row
END
done <<END
cylinder_half_space_ratcheting 1
cylinder_layer 4
cylinder_layer_pressed 10
cylinder_layer_ratcheting 1
cylinder_layer_static 5
sphere_half_space 4
sphere_half_space_ratcheting 1
sphere_half_space_static 4
sphere_half_space_strength 3
sphere_half_space_strength_static 2
sphere_layer 6
sphere_layer_pressed 10
sphere_layer_ratcheting 1
sphere_layer_static 3
sphere_springs_ratcheting 5
END
[ "$(printf '%s\n' "${checked[@]}" | sort | tr '\n' ' ')" = \
    "$(basename -s .json "$source_dir"/atlas/data/*.json | sort | tr '\n' ' ')" ] || complain "an atlas is not checked"

finish
