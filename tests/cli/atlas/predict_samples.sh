#!/usr/bin/env bash
# tricontact predict --samples: shares of a power law's variance, the chance of ratcheting, refusals.
# usage: predict_samples.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# rig FRACTION MODEL: a case whose numbers are uncertain by 3 % each, its load at this part of mu F_N.
rig() {
    cat >rig.toml <<END
models = ["$2"]
[indenter]
radius = "40 mm ± 3 %"
[substrate]
young = "5 MPa ± 3 %"
poisson = 0.5
thickness = "8 mm"
[friction]
coefficient = "0.6 ± 3 %"
[load]
normal_force = "20 N ± 3 %"
tangential_ratio = $1
[rolling]
amplitude = "1 mm"
END
}
# number PATH: of the model's samples in json, by python's notation of keys.
number() { "$python" -S -c "import json; print(json.load(open('json'))['models']['$model']['over_uncertainties']$1)"; }
holds() { awk "BEGIN { exit !($1) }" || complain "$1: $2"; }

# 1. On the half-space U_max goes with mu F_N^(2/3) E^(-2/3) R^(-1/3) (Hertz): shares of 1/18, 2/9, 1/2 and 2/9 of the
# variance, the exponents squared over their sum 2; 3 % is small enough for a logarithm to be linear to 1e-3.
model=bem
rig 0.4 bem
"$program" predict rig.toml --models bem --samples 4096 --json >json || complain "half-space"
[ "$(number "['numbers']")" = "['indenter.radius', 'substrate.young', 'friction.coefficient', 'load.normal_force']" ] ||
    complain "numbers: $(number "['numbers']")"
i=0
for share in 0.0556 0.2222 0.5 0.2222; do
    for kind in first_order total; do
        found=$(number "['quantities']['unit_shift_m']['${kind}_indices'][$i]")
        holds "($found - $share)^2 < 0.01^2" "$kind index $i of U_max: $found, not $share"
    done
    i=$((i + 1))
done
deviation=$(number "['quantities']['unit_shift_m']['standard_deviation']")
mean=$(number "['quantities']['unit_shift_m']['mean']")
holds "($deviation / $mean / 0.03 / sqrt(2) - 1)^2 < 0.02^2" "deviation of U_max: $deviation of $mean"
[ "$(number "['share_that_ratchets']")" = 0.0 ] || complain "it ratchets"

# 2. A load at its own limit of shakedown ratchets in half of the cases: 1 - 3/2 w + 1/2 w^3 = f_T.
limit=$("$python" -S -c "
a = (0.75 * 20 * 40e-3 * 0.75 / 5e6) ** (1 / 3)
w = 1e-3 / a
print(1 - 1.5 * w + 0.5 * w ** 3)")
rig "$limit" bem
"$program" predict rig.toml --models bem --samples 4096 --json >json || complain "at the limit: $(cat json)"
found=$(number "['share_that_ratchets']")
holds "$found > 0.4 && $found < 0.6" "share that ratchets at the limit: $found"
"$program" predict rig.toml --models bem --samples 64 >text || complain "text"
grep -qE 'ratchets in [0-9.]+ % of them' text || complain "no chance of ratcheting: $(cat text)"

# 2b. Correlated numbers: the relative variance of U_max = mu F_N^(2/3) E^(-2/3) R^(-1/3) is sum_ij p_i r_ij p_j 3 %^2,
# here 2 + 2 (2/3) (-2/3) 0.9 = 1.2 of F_N and E; the shares are not told.
model=bem
rig 0.3 bem
printf '[correlation]\n"load.normal_force and substrate.young" = 0.9\n' >>rig.toml
"$program" predict rig.toml --models bem --samples 4096 --json >json || complain "correlated: $(cat json)"
relative=$("$python" -S -c "
import json
q = json.load(open('json'))['models']['bem']['over_uncertainties']['quantities']['unit_shift_m']
assert q['first_order_indices'] is None
print(q['standard_deviation'] / q['mean'])")
holds "$relative > 0.98 * 0.03 * sqrt(1.2) && $relative < 1.02 * 0.03 * sqrt(1.2)" "correlated U_max: $relative"
"$program" predict rig.toml --models bem --samples 64 >text || complain "text of correlated numbers"
grep -q 'numbers are correlated' text || complain "nothing says that numbers are correlated"
! grep -q '; by ' text || complain "shares of correlated numbers"

# 3. The layer: its thickness counts once it is uncertain.
model=bem-layer
rig 0.3 bem-layer
sed -i 's/thickness = .*/thickness = "8 ± 0.4 mm (uniform)"/' rig.toml
"$program" predict rig.toml --models bem-layer --samples 256 >text || complain "layer: $(cat text)"
grep -q 'substrate.thickness' text || complain "no thickness: $(cat text)"

# 4. The same file, the same bytes; refusals.
"$program" predict rig.toml --models bem-layer --samples 256 >again
cmp -s text again || complain "another time, other samples"
sed 's/ ± 0.4 mm (uniform)/ mm/; s/ ± 3 %//' rig.toml | sed 's/"0.6"/0.6/' >exact.toml
refused "no number of the case states an uncertainty" predict ../exact.toml --samples 100
refused "--samples" predict ../rig.toml --samples 1
finish
