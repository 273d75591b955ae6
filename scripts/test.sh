#!/usr/bin/env bash
# Builds everything and runs the tests.
# usage: test.sh [CTEST_ARGUMENT]...   e.g. test.sh -L fast
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)

"$root/scripts/build.sh"
# One more than cores: some tests wait, for a disk or for what they killed.
ctest --test-dir "$root/build/release" --output-on-failure --parallel "$(($(nproc) + 1))" "$@"
