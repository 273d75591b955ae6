#!/usr/bin/env bash
# What CONTRIBUTING.md says about folders and files: includes point downwards, files stay short,
# links in the documents lead somewhere.
# usage: house_rules.sh PROGRAM SOURCE_DIR
set -euo pipefail
program=$(realpath "$1")
cd "$2"
failures=0

complain() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$*"
}

rooms=(app bem benchmarks comparisons contact contact_program experiments fem files io mdr meshes papers python report rolling runs statistics studies
    theory verification walking atlas wear)

# may_include FOLDER OTHERS...: files of a folder and its subfolders include their own and these, and these $headers.
headers=none
may_include() {
    local folder=$1 allowed include
    allowed=$(IFS='|' && echo "$*")
    [ -d "$folder" ] || complain "no folder $folder"
    while read -r include; do
        complain "$include: not for $folder"
    done < <(grep -rHnE --include='*.h' --include='*.cc' '^ *#include "' "$folder" | grep -vE "#include \"(($allowed)/|$headers\")")
}
# Core.
may_include files
may_include contact
may_include statistics contact
may_include theory contact
# Models.
may_include meshes contact files
may_include mdr contact theory
may_include bem contact theory files
may_include fem contact meshes files
# Services; above the models their settings are known, and nothing else of them.
may_include report contact statistics
headers='(bem|mdr|fem)/settings.h'
may_include io contact statistics files
may_include comparisons contact theory statistics io report
may_include runs contact io report comparisons files
# Features, which do not know each other, but for maps, which experiments read.
may_include atlas contact theory statistics io report comparisons files
may_include rolling contact theory statistics io report comparisons files
may_include walking contact theory statistics io report comparisons files
may_include wear contact theory statistics io report comparisons files
may_include experiments contact theory statistics io report comparisons files atlas
may_include contact_program contact io files
may_include benchmarks contact theory statistics io report comparisons files
# What is made of many runs, by models that the program hands in.
may_include studies contact statistics io report comparisons files runs atlas walking
may_include papers contact io report comparisons files runs
may_include verification contact theory comparisons mdr bem rolling walking
# All.
may_include app "${rooms[@]}"
may_include python "${rooms[@]}"

# Of two folders one stands below the other; nor do several include each other in a circle.
arrows=$(find "${rooms[@]}" \( -name '*.h' -o -name '*.cc' \) -exec grep -oE '^ *#include "[^"]+/' {} + |
    sed -E 's|/[^/:]*: *#include "| |; s|/$||' | sort -u | awk '$1 != $2')
while read -r one other; do
    complain "$one and $other include each other"
done < <(awk '($2 " " $1) in seen { print $2, $1 } { seen[$0] }' <<<"$arrows")
circle=$(tsort <<<"$arrows" 2>&1 >/dev/null | sed 's/^tsort: //' | paste -sd' ') || true
[ -z "$circle" ] || complain "folders include each other in a circle: $circle"

# Who looks for a unit reads thirty names at the most.
while read -r n folder; do
    [ "$n" -le 30 ] || complain "$folder has $n units, more than 30"
done < <(find "${rooms[@]}" tests \( -name '*.h' -o -name '*.cc' \) | sed 's/\.[^.]*$//' | sort -u |
    sed 's|/[^/]*$||' | sort | uniq -c)

# only_in FOLDER PATTERN: a library's headers stay in one folder.
only_in() {
    local folder=$1 found
    found=$(grep -lrE "$2" --include='*.h' --include='*.cc' "${rooms[@]}" | grep -vE "^$folder/" || true)
    [ -z "$found" ] || complain "$found: $2 belongs to $folder"
}
only_in fem '#include <(deal\.II|petsc|cholmod|metis)'
only_in meshes '#include <gmsh'
only_in python '#include <pybind11'
only_in '(io|walking|benchmarks/vtk_reader)' '#include <(vtk|sqlite3)'
only_in '(contact|comparisons|statistics)' '#include <gsl/gsl_multifit'
only_in 'no_folder' '#include <regex>'  # calls itself once per character: no input may reach it

while read -r lines file; do
    most=350
    [[ $file != tests/* ]] || most=400
    [ "$lines" -le "$most" ] || complain "$file has $lines lines, more than $most"
done < <(find "${rooms[@]}" speed tests \
    \( -name '*.cc' -o -name '*.h' -o -name '*.sh' -o -name '*.py' \) -exec wc -l {} + | grep -v ' total$')

# What the numbers that are kept depend on has to be whole: all of what computes; of a part of comparisons or of the
# walking machines that is in the digest, all that it includes; and nothing that is not there.
sources=$(dirname "$program")/runs_numerics_digest.txt
if [ -e "$sources" ]; then
    # missing WHAT: names of files, one a line, that are not in the digest.
    missing() {
        while read -r file; do
            complain "$file$1 not in the digest of the numerics"
        done < <(sort -u | comm -23 - <(sort -u "$sources"))
    }
    missing " is" < <(find contact files statistics theory meshes mdr bem fem rolling io -name '*.cc' -o -name '*.h')
    while read -r file; do
        [ -e "$file" ] || complain "$file, in the digest of the numerics, is no file"
    done <"$sources"
    for room in app atlas comparisons fem/finite_strain runs studies walking wear; do
        grep -q "^$room/" "$sources" || complain "nothing of $room is in the digest of the numerics"
    done
    included=$(grep -E '^(comparisons|walking)/' "$sources" |
        xargs sed -n 's/^#include "\(\(comparisons\|walking\)\/.*\)"$/\1/p' | sort -u)
    [ -n "$included" ] || complain "nothing of comparisons is included"
    missing ", which is included, is" <<<"$included"
    missing ", the unit of what is included, is" < <(sed 's/h$/cc/' <<<"$included" | while read -r unit; do
        [ ! -e "$unit" ] || echo "$unit"
    done)
fi

# Keys of results are declared once. Steps of a run, arguments of Python's theory and totals of other codes' results,
# whose readers know no model, have words of their own.
keys=$("$program" keys results | sed -n 's/^| `\([^`]*_[^`]*\)`.*/"\1"/p' | grep -vE '^"(cpu|wall)_s"$')
found=$(grep -rnFf <(echo "$keys") --include='*.cc' --include='*.h' "${rooms[@]}" |
    grep -vE '^(comparisons/quantities/|comparisons/strength/strength_quantities.cc|walking/|io/results/history_csv.cc|io/keys/key_checks.cc|benchmarks/reference/reference.h|python/)' || true)
[ -z "$found" ] || complain "a key of a result stands as a string: $found"
found=$(grep -rnE --include='*_json.cc' --include='*_output.cc' --include='*_csv.cc' --include='study_fit.cc' \
    --include='*_command.cc' '[{[]"(state|kappa|eta|periods|steps)"[],]' comparisons app || true)
[ -z "$found" ] || complain "a key of a result stands as a string: $found"

# What follows from a model is asked of its row: names stand in the table of models, and its makers compare them.
found=$(grep -rnE --include='*.cc' --include='*.h' '"|models::' "${rooms[@]}" | sed 's|//.*||' |
    grep -vE '^(contact/models/|io/case/measurement_models.cc:|app/models/make_model.cc:)' |
    grep -E '"(mdr|bem|fem|mdr-layer|bem-layer)"|[!=]= *("(atlas|half-space|layer)"|(contact::)?models::)|_with\("(mdr|bem|fem|-?layer)"|(find|count)\([^()]*models::(mdr|bem|fem|atlas)' |
    grep -vE 'R"\(\[' || true)
[ -z "$found" ] || complain "the name of a model: $found: ask contact::model_kind()"

# What friction carries is asked of the law: models and rolling see no coefficient.
found=$(grep -rnE --include='*.cc' --include='*.h' 'friction_coefficient' contact bem fem mdr rolling/{run,steady_rolling,steady_solver,steady_normal,rolling_contact}.cc |
    grep -vE '^contact/case\.(h|cc):' || true)
[ -z "$found" ] || complain "a coefficient of friction: $found: ask contact::FrictionLaw"

# What a merge leaves where two changed the same lines.
found=$(grep -rnE '^(<{7}|>{7}) ' "${rooms[@]}" docs tests scripts speed examples ./*.md CMakeLists.txt cmake || true)
[ -z "$found" ] || complain "marks of a merge: $found"
# A file that nobody wrote (PEP 561's mark of a typed package is empty by its definition).
found=$(find . \( -path './build*' -o -path ./results -o -path ./.git \) -prune -o -type f -empty ! -name py.typed -print)
[ -z "$found" ] || complain "empty: $found"

# Debian's Python has the packages; the first python3 in PATH may be another one.
found=$(grep -nE '(^ *|[;&|({] *)python3? ' tests/cli/*/*.sh tests/documents/*.sh tests/installed/*.sh scripts/*.sh || true)
[ -z "$found" ] || complain "$found: take \"\$python\" of prepare.bash, or /usr/bin/python3"

# Package clients know registries, mirrors and proxies of the machine.
found=$(grep -rnE 'https?://' CMakeLists.txt ./*/CMakeLists.txt cmake scripts .ci/run | grep -v 'www.w3.org' || true)
[ -z "$found" ] || complain "a host in the sources: $found"

# Links [text](path#anchor) relative to their document.
n=0
while IFS=: read -r document target; do
    n=$((n + 1))
    [ -e "${document%/*}/$target" ] || complain "$document: no $target"
done < <(grep -roHE '\]\([^)]+\)' --include='*.md' ./*.md docs speed | sed 's/:](/:/; s/)$//; s/#.*//' |
    grep -vE ':(https?:.*)?$')
[ "$n" -ge 10 ] || complain "only $n links found"

printf '%d failures\n' "$failures"
[ "$failures" -eq 0 ]
