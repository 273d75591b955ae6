#!/usr/bin/env bash
# The macro for ParaView beside the results is valid Python. Where there is no python3 there is
# nothing to check it with.
# usage: paraview_macro.sh PROGRAM SOURCE_DIR
set -euo pipefail
source_dir=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
command -v python3 >/dev/null || { echo "no python3: not checked"; exit 0; }
sed -n '/R"python(/,/^)python"/p' "$source_dir/io/paraview_macro.cc" |
    sed '1s/.*R"python(//; $d' >"$work/open_run.py"
[ "$(wc -l <"$work/open_run.py")" -gt 50 ] || { echo "FAILED: no macro found"; exit 1; }
python3 -m py_compile "$work/open_run.py"
