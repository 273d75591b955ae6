#!/usr/bin/env bash
# Words of the command line: commands that there are not, files that another command takes, the help,
# what a run says at its end.
# usage: commands.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
cases=$source_dir/examples/cases

refused "unknown command foo; tricontact --help lists them" foo
refused "unknown command swep; did you mean tricontact sweep?" swep examples/studies/a.toml
refused "is no command; write one before the file, as in tricontact check $cases/rough_plane.toml" \
    "$cases/rough_plane.toml"

# Alone and as help: the groups, with a line and an example each; alone a script is to stop.
"$program" >alone.txt 2>said.txt
[ $? -eq 2 ] && [ ! -s said.txt ] || complain "alone: $(cat said.txt)"
"$program" help >overview.txt || complain "help"
cmp -s alone.txt overview.txt || complain "alone and help differ"
[ "$(grep -c '^ *tricontact [a-z]* *[a-z]* *[a-z.]*$' overview.txt)" -eq 6 ] || complain "examples: $(cat overview.txt)"
"$program" help sweep merge >help.txt && grep -q '^Usage: .*sweep merge' help.txt || complain "help sweep merge"
refused "unknown command swep; did you mean tricontact sweep?" help swep
refused "--modles; did you mean --models?" run "$cases/rough_plane.toml" --modles mdr
refused "--model; did you mean --models?" run "$cases/rough_plane.toml" --model mdr
for command in refine influence "contact export"; do
    # shellcheck disable=SC2086
    refused "did you mean --models?" $command "$cases/rough_plane.toml" --output x --model bem
done
refused "--models: bem,fem not in" refine "$cases/rough_plane.toml" --models bem,fem
refused "--frobnicate; see tricontact run --help" run "$cases/rough_plane.toml" --frobnicate
refused "unknown option --hlep where a command is due" --hlep
refused "unknown option --threads where a command is due" --threads 2 run "$cases/rough_plane.toml"

# Each kind of file with every command that reads files of another kind.
study=$source_dir/examples/studies/rig_layer.toml
walking=$cases/walking_set_b.toml
rolling=$cases/rolling_sphere.toml
contact=$cases/rig_sphere_parallel.toml
"$program" contact export "$contact" --models bem --output exported --set rolling.periods=1 \
    --set 'bem.spacing="1 mm"' >/dev/null || complain "no input of CONTACT"
input=$(find exported -name '*.inp' | head -1)
[ -n "$input" ] || complain "no input of CONTACT"
for command in run check refine limit deviation "contact export" "influence --output x" sweep fit experiment \
    identify rig; do
    case $command in
        refine | limit | deviation | influence*) own=contact ;;
        run | check) own="contact walking rolling" ;;
        sweep | fit) own=study ;;
        rig) own="contact walking rolling" ;; # what they lack, it says itself
        experiment | identify | "contact export") own="contact rolling" ;;
    esac
    while read -r kind right file; do
        [[ " $own " == *" $kind "* ]] && continue
        [[ $command == influence* && $kind == rolling ]] && continue # its coefficients are as good
        # shellcheck disable=SC2086
        refused "; tricontact ${right/-/ } " $command "$file"
    done <<FILES
contact run $contact
walking run $walking
rolling run $rolling
study sweep $study
input contact-import $(realpath "$input")
FILES
done
refused "this is no input file of the program CONTACT; tricontact contact export" contact import "$contact" --output a.toml

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
for command in "" run refine limit deviation contact "contact export" "contact import" influence sweep "sweep merge" \
    fit experiment identify rig verify keys list; do
    # shellcheck disable=SC2086
    "$program" $command --help >help.txt || complain "$command --help"
    grep '[{}]\|->' help.txt && complain "$command --help shows more than is typed"
done

# It lists the commands in groups; parts of commands stand in the help of these.
"$program" --help >help.txt
groups=$(sed -n 's/^\([A-Z][a-z]*\):$/\1/p' help.txt | grep -v Options | tr '\n' ' ')
[ "$groups" = "Compute Trust Ask Rigs Exchange Tools " ] || complain "groups: $groups"
group_of() { awk -v name="$1" '/^[A-Z][a-z]*:$/ { group = $1 } $1 == name && /^  / { print group }' help.txt; }
for group in "Compute: new run sweep predict" "Trust: check refine verify reproduce benchmark compare" "Ask: limit deviation fit" \
    "Rigs: rig design identify experiment" "Exchange: contact influence" "Tools: atlas list keys manual"; do
    for command in ${group#*:}; do
        [ "$(group_of "$command")" = "${group%%:*}:" ] || complain "$command stands in $(group_of "$command")"
    done
done
n=$(sed -n '/^Compute:/,$p' help.txt | grep -c '^  [a-z]')
# A new command is a part of another where it can be: 25 with benchmark, whose own parts are many, compare, and new, which
# is for those who have no case yet: as a part of another they would not find it.
[ "$n" -le 25 ] || complain "$n commands"
for part in "contact export" "contact import" "sweep merge" "benchmark list" "benchmark show"; do
    "$program" "${part% *}" --help | grep -q "^  $part  " || complain "no $part in the help of ${part% *}"
    # shellcheck disable=SC2086
    "$program" $part --help | grep -q "^Usage: .* $part " || complain "$part --help"
done
refused "give export with a case, or import with a file of CONTACT" contact
refused "did you mean tricontact sweep merge?" sweep-merge

# Former names do the same, with one line that says the new name; answer, files and exit code are those of it.
# former OLD NEW ARGUMENTS: of files, folders by the name of the command; what is written is compared.
former() {
    local old=$1 new=$2 codes=()
    shift 2
    for name in "$old" "$new"; do
        rm -rf again && mkdir again
        # shellcheck disable=SC2086
        (cd again && "$program" $name "$@" >answer.txt 2>said.txt)
        codes+=($?)
        mv again/said.txt "said_${#codes[@]}.txt"
        sed -i 's/[0-9.]* s$//' again/answer.txt
        rm -rf "again_${#codes[@]}" && mv again "again_${#codes[@]}"
    done
    [ "${codes[0]}" = "${codes[1]}" ] || complain "$old: exit codes ${codes[*]}"
    find again_1 again_2 -name summary.json -exec sed -i '/"cpu_s"\|_per_s"/d' {} +
    diff -r --exclude='*.sqlite*' again_1 again_2 >diff.txt || complain "$old and $new differ: $(head -5 diff.txt)"
    [ "$(head -1 said_1.txt)" = "tricontact $old is now tricontact $new; the former name is gone in the next version" ] ||
        complain "$old says $(head -1 said_1.txt)"
    diff <(tail -n +2 said_1.txt) said_2.txt >/dev/null || complain "$old says more: $(cat said_1.txt)"
    grep -q 'is now' said_2.txt && complain "$new says a new name"
    grep -qw "^  $old" help.txt && complain "the help has $old"
}
former roll run "$rolling" --models mdr --points 0 --no-report --quiet --output out
former roll run "$study"
former walk run "$walking" --set time.end=50 --no-report --quiet --output out
former walk run "$walking" --models bem
former export "contact export" "$contact" --models bem --output out --set rolling.periods=1 --set 'bem.spacing="1 mm"'
former import "contact import" "$(realpath "$input")" --output out
printf 'case = "%s"\nmodels = ["mdr"]\n[set]\nmdr.springs = 100\nrolling.periods = 1\n[vary]\nload.tangential_ratio = [0.1, 0.2]\n' \
    "$contact" >part.toml
"$program" sweep part.toml --output part --jobs 1 --no-report --quiet || complain "no sweep"
former merge "sweep merge" whole "$work/part"
former merge "sweep merge" whole "$work/nowhere"
if has_fem; then
    [ "$n" -eq 25 ] || complain "$n commands"
    [ "$(group_of mesh)" = Exchange: ] && [ "$(group_of cache)" = Tools: ] || complain "groups of mesh and cache"
    former condense "cache condense" "$contact" --set fem.cache=none
fi

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
            printf "%s: %s, U = %.3g µm (%.4g U_max)", substr(model, 2, length(model) - 3), $2, shift * 1e6, ratio; exit }' \
        out/summary.json)
    grep -qE "^$(sed 's/[().]/\\&/g' <<<"$due"); [0-9.]+ s$" out.txt || complain "no '$due' in $(cat out.txt)"
done
"$program" run "$contact" --output out --models mdr --set rolling.periods=1 --no-report --quiet >out.txt 2>&1
[ -s out.txt ] && complain "--quiet is not silent: $(cat out.txt)"

finish
