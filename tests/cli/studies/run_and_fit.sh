#!/usr/bin/env bash
# kappa and eta are one number each: what `run` says of a point is what `sweep` keeps and `fit` finds of it, to rounding, for
# each model, on a half-space and on a layer.
# usage: run_and_fit.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

cat >case.toml <<'END'
models = ["mdr", "bem", "bem-layer", "mdr-layer", "fem"]
[indenter]
shape = "paraboloid"
radius = "30 mm"
[substrate]
young = "4 MPa"
poisson = 0.5
thickness = "6 mm"
[friction]
coefficient = 0.5
[load]
normal_force = "15 N"
tangential_ratio = 0.3
press_steps = 4
[rolling]
amplitude_ratio = 0.2
amplitude_reference = "model"
angle = "30 deg"
periods = 30
steps_per_quarter = 2
[bem]
cells_per_radius = 5
[fem]
size = "1.8 mm"
[mdr]
springs = 200
END
has_fem || sed -i 's/, "fem"//; /^\[fem\]/,/^size/d' case.toml
# The first point settles, the second one ratchets.
cat >study.toml <<'END'
case = "case.toml"
[vary]
rolling.amplitude_ratio = [0.2, 0.7]
END
"$program" sweep study.toml --output sweep --quiet || complain "the sweep"
"$program" fit study.toml --output sweep --quiet || complain "the fit"
for w in 0.2 0.7; do
    "$program" run case.toml --set rolling.amplitude_ratio=$w --output "run_$w" --quiet --no-studies ||
        complain "the run at w = $w"
done
"$python" - <<'END' || complain "run and fit differ"
import json

fit = json.load(open("sweep/fit.json"))
n = {"kappa": 0, "eta": 0}
wrong = 0
for w in ("0.2", "0.7"):
    for model, run in json.load(open(f"run_{w}/summary.json"))["models"].items():
        for quantity, other in (("kappa", "eta"), ("eta", "kappa")):
            fitted = [
                point[quantity]["value"]
                for group in fit[quantity]
                if group["model"] == model
                for point in group["points"]
                if abs(point["amplitude_ratio"] - run["amplitude_ratio"]) < 1e-9
            ]
            value = run[quantity]
            if value is None:
                wrong += bool(fitted)
                continue
            n[quantity] += 1
            # The same numbers by the same formula: nothing but text stands between them.
            if len(fitted) != 1 or abs(fitted[0] / value - 1) > 1e-12:
                print(model, w, quantity, value, fitted)
                wrong += 1
models = len(json.load(open("run_0.2/summary.json"))["models"])
print(n, models)
raise SystemExit(wrong > 0 or n["kappa"] < models or n["eta"] < models)
END
finish
