#!/usr/bin/env bash
# What a run says about its relaxing substrate is what other runs find: the elastic reference run, the drive
# speed from which on relaxation matters, its scaling, the fit to a DMA table.
# usage: relaxation_study.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

# run NAME CASE ARGUMENTS...: few springs, for speed.
run() {
    local name=$1
    shift
    "$program" run "$@" --models mdr --quiet --no-report --set mdr.springs=200 --output "$name" ||
        complain "run $name: $*"
}

# value NAME KEY: the first value of a key in a summary.
value() {
    grep -m1 "\"$2\":" "$1/summary.json" | sed 's/.*": //; s/,$//'
}

# holds EXPRESSION: an awk expression of numbers; an empty value makes it a syntax error.
holds() {
    awk "BEGIN { exit !($1) }" || complain "$1"
}

relaxing=$source_dir/examples/cases/rig_sphere_layer_relaxing.toml
sed '/^\[substrate.relaxation\]/,/^$/d; /^hold/d; /^speed/d' "$relaxing" >elastic.toml

run relaxing "$relaxing"
run elastic elastic.toml
[ "$(value relaxing elastic_final_shift_m)" = "$(value elastic final_shift_m)" ] ||
    complain "another elastic run: $(value relaxing elastic_final_shift_m)"
[ "$(value relaxing elastic_static_shift_m)" = "$(value elastic static_shift_m)" ] ||
    complain "another elastic static shift: $(value relaxing elastic_static_shift_m)"
grep -q '"relaxation": {$' elastic/summary.json && complain "an elastic case with relaxation"
# 2 pi f tau is about 1: relaxation is seen.
holds "$(value relaxing final_shift_error) < -0.05"

speed=$(value relaxing speed_m_per_s)
run at_limit "$relaxing" --set "rolling.speed=$speed m/s"
# Found to 5 %, where the error is in proportion to the speed.
error=$(value at_limit final_shift_error)
holds "$error * $error > 0.0095 ^ 2 && $error * $error < 0.0105 ^ 2"

# A tenth of the relaxation time: the same at ten times the speed.
run faster "$relaxing" --set "substrate.relaxation.eta=36.4 kPa s" --set "load.hold=6 s"
holds "$(value faster speed_m_per_s) / $speed / 10 - 1 < 1e-6"
holds "$(value faster speed_m_per_s) / $speed / 10 - 1 > -1e-6"

# The thesis' rubber is elastic at its drive: 2 pi f tau = 1e-4.
run thesis "$relaxing" --set "substrate.relaxation.eta=40 Pa s"
holds "$(value thesis final_shift_error) ^ 2 < 1e-4 ^ 2"

run alone "$relaxing" --no-studies
[ "$(value alone loss_tangent)" = "$(value relaxing loss_tangent)" ] || complain "no drive"
[ "$(value alone final_shift_m)" = "$(value relaxing final_shift_m)" ] || complain "--no-studies"
[ "$(value alone elastic_twin)" = null ] || complain "--no-studies runs the elastic reference run"

# Without F_T nothing shifts, and nothing is compared.
run unloaded "$relaxing" --set load.tangential_ratio=0
[ "$(value unloaded elastic_twin)" = null ] || complain "a twin without F_T"

cat >dma.csv <<'EOF'
frequency [Hz], G' [MPa], G'' [MPa]
0.003, 1.733, 0.0068
0.03, 1.742, 0.0674
0.3, 2.064, 0.252
3, 2.250, 0.0392
30, 2.253, 0.00394
EOF
sed 's/^G2.*/dma = "dma.csv"/; /^eta/d' "$relaxing" >dma.toml
run dma dma.toml
[ "$(value dma rows)" = 5 ] || complain "no table told"
# Written with three digits.
holds "$(value dma storage_residual_rms) < 5e-3 && $(value dma loss_residual_rms) < 5e-3"
# The resolved case has the fitted series and no table any more: nothing is told about a fit.
run again dma/case.toml
[ "$(value again dma_fit)" = null ] || complain "a fit without a table"
[ "$(value again final_shift_m)" = "$(value dma final_shift_m)" ] || complain "another run"

finish
