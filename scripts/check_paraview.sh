#!/usr/bin/env bash
# Looks at results in ParaView: each series loads with all its steps and fields, open_run.py draws every
# model, also as the window of ParaView runs it, and no picture is empty.
# usage: check_paraview.sh RESULTS_FOLDER...
set -euo pipefail
scripts=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" >/dev/null && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The script as the window runs it: text without a file. What is appended looks at it from inside.
as_window() {
    cp "$1/open_run.py" "$1/.open_run_checked.py"
    cat >>"$1/.open_run_checked.py" <<PYTHON
with open("$work/window.txt", "w") as file:
    print(len(GetSources()), globals().get("__file__"), file=file)
os._exit(0)
PYTHON
    rm -f "$work/window.txt"
    (cd / && timeout 300 "$scripts/paraview.sh" paraview --dr --script="$1/.open_run_checked.py" >"$work/said.txt" 2>&1) ||
        true
    rm "$1/.open_run_checked.py"
    local sources file
    read -r sources file <"$work/window.txt" || { cat "$work/said.txt"; exit 1; }
    [ "$sources" -ge 2 ] || { echo "FAILED: $1: the window shows nothing"; exit 1; }
    echo "$1: $sources sources in the window, __file__ is $file"
}

folders=()
for folder in "$@"; do
    folders+=("$(realpath "$folder")")
done
"$scripts/paraview.sh" pvpython --force-offscreen-rendering "$scripts/check_paraview.py" "$work" "${folders[@]}"
for folder in "${folders[@]}"; do
    [ ! -e "$folder/open_run.py" ] || as_window "$folder"
done
