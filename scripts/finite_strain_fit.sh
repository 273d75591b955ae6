#!/usr/bin/env bash
# What finite strains change in static shift and indentation of a sphere on a bonded incompressible
# layer, over a/R, a/b and mu: runs, and the fit that the rig check takes (experiments/assumptions/
# rolling_strain.cc). Takes a quarter of an hour; finished runs are taken over.
# usage: finite_strain_fit.sh [PROGRAM] [FOLDER]   (build/release/app/tricontact results/finite_strain_fit)
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
program=$(realpath "${1:-$root/build/release/app/tricontact}")
folder=${2:-results/finite_strain_fit}
mkdir -p "$folder"
# Pressed and loaded, not rolled.
sed '/^\[rolling\]/,/^$/d' "$root/examples/cases/rig_layer_parallel.toml" >"$folder/static.toml"

# map NAME R [mm] F_N [N] MU
map() {
    "$program" deviation "$folder/static.toml" --finite-strain --output "$folder/$1" \
        --set "indenter.radius=\"$2 mm\"" --set "load.normal_force=\"$3 N\"" \
        --set "friction.coefficient=$4" >"$folder/$1.txt"
}
map rig 40 21.1 0.57
map sliding 40 21.1 0.3
map sticking 40 21.1 0.9
map flat 160 5.275 0.57

/usr/bin/python3 - "$folder" <<'END'
import csv, sys
import numpy as np

folder = sys.argv[1]
maps = {"rig": (0.04, 0.57), "sliding": (0.04, 0.3), "sticking": (0.04, 0.9), "flat": (0.16, 0.57)}
points = {"static_shift_m": [], "indentation_m": []}
for name, (radius, mu) in maps.items():
    with open(f"{folder}/{name}/finite_strain.csv", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            a = float(row["linear_contact_radius_m"])
            t = a / float(row["thickness_m"])
            if row["quantity"] in points and row["level"] == "0" and 0.14 <= t <= 0.7 \
                    and abs(float(row["tangential_ratio"]) - 0.56) < 1e-9 and a / radius <= 0.22:
                points[row["quantity"]].append((t, mu, a / radius, float(row["deviation"])))
for quantity, rows in points.items():
    t, mu, slope, deviation = np.array(rows).T
    terms = {"1": t**0, "t^2": t**2, "t^3": t**3}
    if quantity == "static_shift_m":
        terms |= {f"{power} {name}": mu ** (k + 1) * term
                  for k, power in enumerate(("mu", "mu^2")) for name, term in terms.items()}
    basis = np.stack(list(terms.values()), axis=1)
    # Deviations over a/R: all slopes weigh the same.
    factors, *_ = np.linalg.lstsq(basis, deviation / slope, rcond=None)
    left = deviation / slope - basis @ factors
    print(quantity, {name: round(value, 4) for name, value in zip(terms, factors)},
          f"n = {len(t)}, left over a/R: rms {np.sqrt(np.mean(left**2)):.4f}, largest {abs(left).max():.4f};"
          f" largest error {100 * abs(left * slope).max():.3f} %")
END
