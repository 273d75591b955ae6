#!/usr/bin/env bash
# Words of the command line: commands that there are not, files that another command takes, the help,
# what a run says at its end.
# usage: commands.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/prepare.bash"
cases=$source_dir/examples/cases

refused "unknown command foo; tricontact --help lists them" foo
refused "unknown command swep; did you mean tricontact sweep?" swep examples/studies/a.toml
refused "is no command; write one before the file, as in tricontact check $cases/rough_plane.toml" \
    "$cases/rough_plane.toml"
refused "no command is given; tricontact --help lists them"
refused "unknown option --hlep where a command is due" --hlep
refused "unknown option --threads where a command is due" --threads 2 run "$cases/rough_plane.toml"

# Each kind of file with every command that reads files of another kind.
study=$source_dir/examples/studies/rig_layer.toml
walking=$cases/walking_set_b.toml
rolling=$cases/rolling_sphere.toml
contact=$cases/rig_sphere_parallel.toml
"$program" export "$contact" --model bem --output exported --set rolling.periods=1 \
    --set 'bem.spacing="1 mm"' >/dev/null || complain "no input of CONTACT"
input=$(find exported -name '*.inp' | head -1)
[ -n "$input" ] || complain "no input of CONTACT"
for command in run check walk roll refine limit deviation export "influence --output x" sweep fit experiment \
    identify rig; do
    case $command in
        run | check | refine | limit | deviation | influence*) own=contact ;;
        walk) own=walking ;;
        roll) own=rolling ;;
        sweep | fit) own=study ;;
        rig) own="contact walking rolling" ;; # what they lack, it says itself
        experiment | identify | export) own="contact rolling" ;;
    esac
    while read -r kind right file; do
        [[ " $own " == *" $kind "* ]] && continue
        [[ $command == influence* && $kind == rolling ]] && continue # its coefficients are as good
        [ "$command" = check ] && [[ $kind == walking || $kind == rolling ]] && continue
        # shellcheck disable=SC2086
        refused "; tricontact $right " $command "$file"
    done <<FILES
contact run $contact
walking walk $walking
rolling roll $rolling
study sweep $study
input import $(realpath "$input")
FILES
done
refused "this is no input file of the program CONTACT; tricontact export" import "$contact" --output a.toml

refused "unknown key substrate.E; did you mean substrate.young?" check "$contact" --set "substrate.E=5 MPa"
printf 'case = "%s"\n[vary]\nsubstrate.E = ["1 MPa", "2 MPa"]\n' "$contact" >study.toml
refused "did you mean substrate.young?" sweep "$work/study.toml"

# Numbers as people type them.
for number in .24 24e-2 +0.24 +.24 2.4e-1; do
    "$program" check "$contact" --set rolling.amplitude_ratio=$number >told.txt 2>&1 &&
        grep -qx 'amplitude_ratio = 0.24' told.txt || complain "$number: $(head -3 told.txt)"
done
for number in 1e3 +1000 01000; do
    "$program" check "$contact" --set mdr.springs=$number >told.txt 2>&1 && grep -qx 'springs = 1000' told.txt ||
        complain "$number springs: $(head -3 told.txt)"
done
for force in '.5 N' '+.5 N' '5e-1 N' '"0.5 N"'; do
    "$program" check "$contact" --set "load.normal_force=$force" >told.txt 2>&1 &&
        grep -q '^normal_force = "0.5 N"' told.txt || complain "$force: $(grep normal_force told.txt)"
done

# The help shows flags as they are typed.
for command in "" run walk roll refine limit deviation export import influence sweep fit merge experiment \
    identify rig verify keys list; do
    "$program" $command --help >help.txt || complain "$command --help"
    grep '[{}]\|->' help.txt && complain "$command --help shows more than is typed"
done

# A run ends with its results, the numbers those of summary.json.
"$program" run "$contact" --output out --set rolling.periods=2 --set rolling.steps=turning-points \
    --set 'bem.spacing="0.5 mm"' --no-studies >out.txt 2>err.txt || complain "$(cat err.txt)"
[ "$(tail -1 out.txt)" = "report: out/report.html" ] || complain "the report's path: $(cat out.txt)"
grep -q '^bem: shakedown (f_T is below the exact limit), U' out.txt || complain "who decided: $(cat out.txt)"
sed -i 's/ (f_T is below the exact limit)//' out.txt
for model in mdr bem; do
    due=$(awk -v model="\"$model\":" '/^  "models": {/ { models = 1 }
        models && $1 == model { here = 1 }
        here && /"final_shift_ratio"/ { ratio = $2 + 0 }
        here && /"final_shift_m"/ { shift = $2 + 0 }
        here && /"state"/ { gsub(/[",]/, "", $2)
            printf "%s: %s, U = %.3g um (%.4g U_max)", substr(model, 2, length(model) - 3), $2, shift * 1e6, ratio; exit }' \
        out/summary.json)
    grep -qE "^$(sed 's/[().]/\\&/g' <<<"$due"); [0-9.]+ s$" out.txt || complain "no '$due' in $(cat out.txt)"
done
"$program" run "$contact" --output out --models mdr --set rolling.periods=1 --no-report --quiet >out.txt 2>&1
[ -s out.txt ] && complain "--quiet is not silent: $(cat out.txt)"

finish
