#!/usr/bin/env bash
# Commands and features of cases: each command's answer depends on the feature, or it refuses it by name, or says that it
# leaves it out. The table of docs/command-features.md is what is found.
# usage: command_features.sh PROGRAM SOURCE_DIR [COMMAND|FEATURE]...
source "$(dirname -- "${BASH_SOURCE[0]}")/prepare.bash"
PYTHONDONTWRITEBYTECODE=1 "$python" "$source_dir/tests/cli/command_features.py" "$program" \
    "$source_dir/docs/command-features.md" "${@:3}" || complain "commands and features"
finish
