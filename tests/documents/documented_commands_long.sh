#!/usr/bin/env bash
# Command lines of README and documents in the shorter form of documented_commands.txt.
# usage: documented_commands_long.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/prepare.bash"
"$python" "$source_dir/tests/documents/documented_commands.py" "$program" "$source_dir" slow
exit $?
