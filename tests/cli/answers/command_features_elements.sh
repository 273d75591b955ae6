#!/usr/bin/env bash
# As command_features.sh: the columns with finite elements, refinements, atlases and identification.
# usage: command_features_elements.sh PROGRAM SOURCE_DIR [COMMAND|FEATURE]...
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
[ $# -gt 2 ] || set -- "$@" elements
PYTHONDONTWRITEBYTECODE=1 "$python" "$source_dir/tests/cli/answers/command_features.py" "$program" \
    "$source_dir/docs/reference/command-features.md" "${@:3}" || complain "commands and features"
finish
