#!/usr/bin/env bash
# tricontact deviation --finite-strain on the coarsest meshes, of a case that is loaded and not rolled:
# files, sentences, taking over what is there; what is refused leaves nothing behind.
# usage: deviation_finite_strain.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
rig=$source_dir/examples/cases/rig_layer_parallel.toml
sed '/^\[rolling\]/,/^$/d' "$rig" >static.toml

deviation=(deviation static.toml --finite-strain --elements 2 --set load.press=frictionless --set fem.tolerance=1e-5)
"$program" "${deviation[@]}" --jobs 2 >out 2>err || complain "runs: $(cat err)"
folder=results/static_finite_strain
for file in report.html finite_strain.csv finite_strain.json; do
    [ -s "$folder/$file" ] || complain "no $file"
done
grep -qE '^static shift +U_stat ' out || complain "no static shift: $(cat out)"
grep -qE '^Linear elasticity puts U_stat [0-9.]+ ± [0-9.]+ % too high here; it is off by 1 % from F_N = ' out ||
    complain "sentence: $(cat out)"
! grep -q 'U_sd' out || complain "a settled shift without rolling: $(cat out)"
! grep -qE ' d .*off by 1 % from' out || complain "d is off by 1 %: $(cat out)"
# Pressed alone nothing is shifted, and what is not reached is not named.
grep -q '^Linear elasticity .*d .*not off by 1 % up to F_N = 169 N' out || complain "d: $(cat out)"

cp -r "$folder" before
"$program" "${deviation[@]}" >again 2>err
grep -qE '^([0-9]+) of \1 points are there already$' err || complain "computed again: $(cat err)"
for file in report.html finite_strain.csv finite_strain.json; do
    cmp -s "$folder/$file" "before/$file" || complain "$file differs the second time"
done

refused "drop --no-runs or --finite-strain" deviation "$rig" --finite-strain --no-runs
refused "always coupled; set it to true" deviation "$rig" --finite-strain --set contact.coupling=false
refused "at finite strains fem computes smooth paraboloids and spheres" deviation \
    "$source_dir/examples/cases/body_rounded_punch.toml" --finite-strain
refused "substrate.thickness is missing" deviation "$source_dir/examples/cases/rig_sphere_parallel.toml" --finite-strain
refused "substrate.relaxation" deviation "$source_dir/examples/cases/rig_sphere_layer_relaxing.toml" --finite-strain

finish
