#!/usr/bin/env bash
# Commands and features of cases: each command's answer depends on the feature, or it refuses it by name, or says that it
# leaves it out. The tables of docs/reference/command-features.md are what is found. Here the columns that take little.
# usage: command_features.sh PROGRAM SOURCE_DIR [COMMAND|FEATURE]...
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
[ $# -gt 2 ] || set -- "$@" fast
PYTHONDONTWRITEBYTECODE=1 "$python" "$source_dir/tests/cli/answers/command_features.py" "$program" \
    "$source_dir/docs/reference/command-features.md" "${@:3}" || complain "commands and features"
finish
