#!/usr/bin/env bash
# The installed program runs its installed examples from any folder, with finite elements where it
# has them, and also under a link.
# usage: program.sh COPY
set -uo pipefail
copy=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

complain() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$*"
}

ln -s "$copy/bin/tricontact" linked
./linked run "$copy/share/tricontact/examples/cases/rig_sphere_parallel.toml" --models mdr --quiet \
    --no-report --output mdr || complain "the program does not run a case"
[ -s mdr/summary.json ] || complain "no summary.json"
if ./linked list | grep -q '^  fem '; then
    ./linked mesh "$copy/share/tricontact/examples/cases/rig_layer_parallel.toml" --set 'fem.size=2 mm' \
        --output mesh >/dev/null || complain "the program does not find its finite elements"
fi
# A file of VTK's is refused by its reader, not for the want of it.
printf '<VTKFile/>' >broken.vtu
message=$(./linked benchmark compare --case layer_pressed broken.vtu --output none 2>&1)
case $message in
    *"not where it was installed"* | '') complain "the program does not find its reader of VTK's files: $message" ;;
esac

printf '%d failures\n' "$failures"
exit $((failures > 0))
