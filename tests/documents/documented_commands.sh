#!/usr/bin/env bash
# Command lines of README and documents that run as they stand, and the options that usages name.
# usage: documented_commands.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/prepare.bash"
"$python" "$source_dir/tests/documents/documented_commands.py" "$program" "$source_dir" fast
exit $?
