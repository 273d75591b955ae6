#!/usr/bin/env bash
# Other laws of friction than Coulomb's: closed forms, models beside each other, refusals, pages.
# usage: friction_laws.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../summaries.bash"
lens=$source_dir/examples/cases/lens_on_silicone.toml

# 1. A shear strength: springs settle where the closed form does (five digits of it), and the limit
# is the lens of both extreme contacts. Nothing on the page speaks of Coulomb's formulas.
"$program" run "$lens" --quiet --no-studies --output lens || complain "the lens does not run"
near "$(value mdr settled_shift_ratio lens/summary.json)" 0.30024 2e-4 "settled shift"
near "$(value mdr static_shift_ratio lens/summary.json)" 0.23788 2e-4 "static shift"
near "$(value mdr limit_tangential_ratio lens/summary.json)" 0.7470601 1e-5 "limit of mdr"
# Cells of a/22.5 count whole or not.
near "$(value bem limit_tangential_ratio lens/summary.json)" 0.7470601 0.01 "limit of bem"
grep -q "350 kPa" lens/report.html || complain "the page does not say the law"
for coulombs in "1 − 3/2 w" "μF_N" "μ <i>F" "μp" "Cattaneo" "Coulomb friction of one"; do
    grep -qF -- "$coulombs" lens/report.html && complain "the page speaks of $coulombs"
done
near "$(value mdr kappa lens/summary.json)" 1.2732395 2e-3 "kappa of springs, 4/pi"
"$program" run "$lens" --models mdr --set friction.coefficient=0.1 --quiet --no-studies --no-report --output sum ||
    complain "a sum of laws does not run"
[ "$(value mdr kappa sum/summary.json)" = None ] || complain "a kappa of another law"

# 2. Three models of a layer, of which a build may lack elements. Their nodes are farther apart than
# cells; both of the first order at the edge. What springs of a layer settle at is that of MDR, their
# shifts at first are exact.
layers='"mdr-layer", "bem-layer"'
has_fem && layers+=', "fem"'
sed -e 's/shear_strength.*/coefficient = 0.3\npressure_exponent = 0.6\nreference_pressure = "50 kPa"/' \
    -e "s/^models.*/models = [$layers]/" \
    -e 's/poisson = 0.5/poisson = 0.5\nthickness = "4 mm"/' "$lens" >power.toml
"$program" run power.toml --set "fem.size=0.25 mm" --set rolling.steps=turning-points --quiet \
    --no-studies --no-report --output power || complain "a power of the pressure does not run"
if has_fem; then
    near "$(value fem static_shift_m power/summary.json)" \
        "$(value bem-layer static_shift_m power/summary.json)" 0.01 "static shift of fem"
    near "$(value fem settled_shift_m power/summary.json)" \
        "$(value bem-layer settled_shift_m power/summary.json)" 0.02 "settled shift of fem"
fi
near "$(value mdr-layer static_shift_m power/summary.json)" \
    "$(value bem-layer static_shift_m power/summary.json)" 0.005 "static shift of mdr-layer"
near "$(value mdr-layer limit_tangential_ratio power/summary.json)" \
    "$(value bem-layer limit_tangential_ratio power/summary.json)" 0.002 "limit of mdr-layer"
near "$(value mdr-layer limit_amplitude_ratio power/summary.json)" \
    "$(value bem-layer limit_amplitude_ratio power/summary.json)" 0.005 "amplitude of mdr-layer"

# 3. Rolling on: springs and cells beside the closed forms of a shear strength, first order in both.
sed 's/^coefficient.*/shear_strength = "30 kPa"/' "$source_dir/examples/cases/rolling_cylinder.toml" >cylinder.toml
sed 's/^coefficient.*/shear_strength = "30 kPa"/' "$source_dir/examples/cases/rolling_sphere.toml" >ball.toml
# over_theory FILE THEORY: creepage of the first model.
over_theory() {
    "$python" -S - "$1" "$2" <<'END'
import json, sys
summary = json.load(open(sys.argv[1]))
theory = next(one for one in summary["theories"] if one["theory"] == sys.argv[2])
print(summary["models"][0]["steady"]["longitudinal_creepage"] / theory["longitudinal_creepage"])
END
}
"$program" run cylinder.toml --points 0 --set tractive_rolling.distance=1 --no-report --quiet --output cylinder >text ||
    complain "a cylinder with a shear strength does not roll: $(cat text)"
near "$(over_theory cylinder/summary.json carter_strength)" 1 0.005 "creepage of the cylinder"
grep -q "F_x/F_lim" text || complain "the table is not over F_lim"
grep -q "F_N)" text && complain "the table is over mu F_N"
"$program" run ball.toml --models mdr --set mdr.springs=2000 --points 0 --set tractive_rolling.distance=1 --no-report --quiet --output ball >text ||
    complain "springs with a shear strength do not roll: $(cat text)"
near "$(over_theory ball/summary.json mdr_closed_form)" 1 0.005 "creepage of springs"

# 4. Numbers that do not go together, and what knows Coulomb's law alone.
sed '/^shear_strength/d' "$lens" >none.toml
refused "missing key friction.coefficient" check "$work/none.toml"
refused "friction.pressure_exponent = 0.5: no part of the friction grows" check "$lens" \
    --set friction.pressure_exponent=0.5 --set friction.reference_pressure=1MPa
refused "is Coulomb's law" check "$lens" --set friction.coefficient=0.5 \
    --set friction.pressure_exponent=1 --set friction.reference_pressure=1MPa
refused "is not above friction.shear_strength" check "$lens" --set friction.coefficient=0.5 \
    --set friction.strength_limit=0.3MPa
refused "no atlas is about laws of friction other than Coulomb's and a shear strength alone" predict "$lens" \
    --set friction.coefficient=0.1
refused "no atlas is about layers under a shear strength" predict "$lens" --set substrate.thickness=4mm
"$program" predict "$lens" --json >maps.json || complain "no prediction under a strength"
"$python" -S - maps.json <<'END' || complain "predicted: $(cat maps.json)"
import json, math, sys
models = json.load(open(sys.argv[1]))["models"]
springs, bem = models["mdr"], models["bem"]
assert abs(springs["kappa"] - 4 / math.pi) < 1e-12
assert abs(springs["settled_shift_ratio"] - .30024) < 1e-5  # w = 0.2, f = 0.3
assert .72 < bem["kappa"] - bem["kappa_error"] < bem["kappa"] + bem["kappa_error"] < .82
assert bem["static_shift_ratio"] < bem["settled_shift_ratio"] < springs["settled_shift_ratio"]
END
refused "friction: a deviation presumes Coulomb's law, tau = mu p, and the case has tau = 350 kPa" deviation "$lens" --set substrate.thickness=4mm
finish
