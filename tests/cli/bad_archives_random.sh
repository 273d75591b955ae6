#!/usr/bin/env bash
# Archives changed at random: run again, or refused; nothing is written beside the folder of the output.
# More of them: bad_archives_random.py PROGRAM ARCHIVE SEED N
# usage: bad_archives_random.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/prepare.bash"
"$program" run "$source_dir/examples/cases/rig_sphere_parallel.toml" --models mdr --set mdr.springs=100 \
    --set rolling.steps=turning-points --set rolling.periods=1 --no-studies --output out --export paper \
    --quiet >/dev/null || complain "export"
"$python" "$source_dir/tests/cli/bad_archives_random.py" "$program" paper/archive.zip 20261127 200 ||
    complain "archives changed at random"
finish
