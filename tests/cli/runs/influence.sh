#!/usr/bin/env bash
# Influence coefficients written and read again give the same bytes; files that do not fit are
# refused before anything is written.
# usage: influence.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
set -e

cat >case.toml <<'TOML'
models = ["bem", "bem-layer"]
[indenter]
radius = "40 mm"
young = "206 GPa"
poisson = 0.3
[substrate]
young = "5.2 MPa"
poisson = 0.45
thickness = "6 mm"
base = "half-space"
[ground]
young = "70 MPa"
poisson = 0.3
[lower_layer]
thickness = ["1 mm", "0.5 mm"]
young = ["1 MPa", "9 MPa"]
poisson = [0.5, 0.2]
[friction]
coefficient = 0.57
[load]
normal_force = "21.1 N"
tangential_ratio = 0.56
press_steps = 3
[rolling]
amplitude_ratio = 0.24
periods = 1
steps = "turning-points"
[bem]
cells_per_radius = 8
TOML

# 1. Round trip: a run with the file is the run without, and so is the file that it would write.
for model in bem bem-layer; do
    "$program" influence case.toml --models "$model" --output "$model.txt" >"$model.told"
    grep -q "^written  *$model.txt$" "$model.told" || complain "$model: says $(cat "$model.told")"
    "$program" run case.toml --models "$model" --output "own_$model" --quiet --no-report \
        --no-studies
    "$program" run case.toml --models "$model" --output "file_$model" --quiet --no-report \
        --no-studies --set "bem.influence=$model.txt"
    diff -r "own_$model/$model" "file_$model/$model" >differences ||
        complain "$model: $(head -3 differences)"
    "$program" influence case.toml --models "$model" --output again.txt --threads 2 \
        --set "bem.influence=$model.txt" >/dev/null
    cmp "$model.txt" again.txt || complain "$model: the file does not write itself"
    # The resolved case names the file in full and runs anywhere.
    (mkdir -p elsewhere && cd elsewhere &&
        "$program" run "../file_$model/case.toml" --output "$work/resolved_$model" --quiet \
            --no-report --no-studies)
    diff -r "own_$model/$model" "resolved_$model/$model" >differences ||
        complain "$model, resolved: $(head -3 differences)"
done
cmp -s bem.txt bem-layer.txt && complain "half-space and layer have the same coefficients"

# refused EXPECTED ARGUMENTS...: exit code 2, one line, nothing written.
refused() {
    local expected=$1 code=0 message
    shift
    message=$("$program" "$@" 2>&1 >/dev/null) || code=$?
    [ "$code" -eq 2 ] || complain "exit code $code instead of 2: $*"
    [[ $message == "error: "*"$expected"* ]] || complain "$*: expected $expected, got $message"
    [ "$(wc -l <<<"$message")" -eq 1 ] || complain "more than one line: $message"
    [ ! -e out ] || complain "something was written: $*"
}

# 2. What is wrong with the file is told with its line, before a folder is made.
layer=(run case.toml --models bem-layer --output out)
head -c 3000 bem-layer.txt >short.txt
refused "short.txt:" "${layer[@]}" --set bem.influence=short.txt
sed '12s/^\([0-9]* [0-9]*\) [^ ]*/\1 nan/' bem-layer.txt >nan.txt
refused "nan.txt:12: nan is no finite number; correct it" "${layer[@]}" --set bem.influence=nan.txt
sed 's/version 1/version 7/' bem-layer.txt >version.txt
refused "version.txt:1: version 7 is not 1, the only one known" "${layer[@]}" \
    --set bem.influence=version.txt
awk '$1 == 3 && $2 == 2 { $9 = -$9 } { print }' bem-layer.txt >signs.txt
refused "K_xz = -K_zx at 3 2 is broken" "${layer[@]}" --set bem.influence=signs.txt
sed 's/^spacing_m .*/spacing_m 0.0005/' bem-layer.txt >spacing.txt
refused "spacing.txt: coefficients of cells of 0.0005 m, but those of the case have" \
    "${layer[@]}" --set bem.influence=spacing.txt
refused "there is no such file" "${layer[@]}" --set bem.influence=missing.txt
refused "this is no file of influence coefficients" "${layer[@]}" --set bem.influence=case.toml
refused "cannot be those of bem and bem-layer" run case.toml --output out \
    --set bem.influence=bem.txt
refused "do not describe periodic contacts" "${layer[@]}" --set bem.influence=bem-layer.txt \
    --set "bem.period=40 mm"

# 3. The command itself.
refused "choose one by --models" influence case.toml --output out
refused "choose bem or bem-layer by --models" influence case.toml --output out \
    --set 'models=["mdr"]' --set substrate.poisson=0.5
sed '/^base/d; /^\[ground\]/,+2d; /^young = "206/d; /^poisson = 0.3/d' case.toml >rigid.toml
refused "has no influence coefficients of single cells" influence rigid.toml --models bem-layer \
    --output out --set "bem.period=40 mm"

finish
