#!/usr/bin/env bash
# Builds everything, or these targets. One at a time in a clone: who comes second waits.
# usage: build.sh [TARGET]...
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)

"$root/scripts/setup.sh" build
mkdir -p "$root/build"
exec 9>"$root/build/lock"
flock 9
cmake -S "$root" --preset release --log-level=NOTICE
cmake --build "$root/build/release" ${1:+--target "$@"} 9>&-
