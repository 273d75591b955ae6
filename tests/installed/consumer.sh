#!/usr/bin/env bash
# A project outside finds the installed copy by find_package; what it computes there agrees with
# closed forms. The code in docs/how-to/cpp.md is that project's.
# usage: consumer.sh COPY SOURCE_DIR COMPILER
set -euo pipefail
copy=$(realpath "$1")
source_dir=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The libraries behind deal.II cost the default linker a minute, this one seconds.
linker=
if command -v ld.gold >/dev/null; then linker=-fuse-ld=gold; fi
cp -r "$source_dir/tests/consumer" "$work/project"
cmake -G Ninja -S "$work/project" -B "$work/build" --log-level=WARNING \
    -DCMAKE_PREFIX_PATH="$copy" -DCMAKE_CXX_COMPILER="$3" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_EXE_LINKER_FLAGS="$linker"
cmake --build "$work/build"
"$work/build/sphere"
[ ! -x "$work/build/layer" ] || "$work/build/layer"

# Each block of code in the document, line by line, stands in the project.
awk '/^```(cmake|cpp)$/ { in_code = 1; next } /^```$/ { in_code = 0 } in_code' \
    "$source_dir/docs/how-to/cpp.md" | while read -r line; do
    grep -rqF -- "$line" "$work/project" || {
        printf 'FAILED: docs/how-to/cpp.md: not in tests/consumer: %s\n' "$line"
        exit 1
    }
done
