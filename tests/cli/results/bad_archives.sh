#!/usr/bin/env bash
# Archives that are none, damaged, incomplete, altered, or that lead somewhere else: one error, exit code 2,
# nothing written.
# usage: bad_archives.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
"$program" run "$source_dir/examples/cases/rig_sphere_parallel.toml" --models mdr --set mdr.springs=500 \
    --set rolling.steps=turning-points --set rolling.periods=1 --no-studies --output out --export paper \
    --quiet >/dev/null || complain "export"

# bad KIND EXPECTED
bad() {
    "$python" "$source_dir/tests/cli/results/papers.py" spoil paper/archive.zip "$1.zip" "$1" || complain "$1"
    refused "$work/$1.zip: $2" reproduce "$work/$1.zip"
}
bad text "is no zip archive, or only a part of one"
bad empty "holds no archive.json: no archive of tricontact"
bad truncated "is no zip archive, or only a part of one"
bad foreign "holds no archive.json: no archive of tricontact"
bad lacking "lacks its file inputs/rig_sphere_parallel.toml"
bad added "inputs/more.toml does not belong to it"
bad altered "inputs/rig_sphere_parallel.toml is not as it was written: its digest differs"
bad list "archive.json is damaged"
bad format "is of a format that this version does not read"
bad idle "names no command"
bad command "asks for frobnicate, which is no command that exports"
bad verify "asks for verify, which is no command that exports"
bad option "run: holds the argument --frobnicate, which is none of those that an archive may have"
bad place "run: holds the argument --output, which is none"
bad cache "run: holds the argument --set=fem.cache=/tmp/layers, which is none"
bad cache_key "an argument names fem.cache=layers, outside the archive"
bad second "an argument names /etc/passwd"
bad texts "an argument names /etc/passwd, outside the archive"
bad export "run: holds the argument --export=./.config, which is none"
bad export_value "run: holds the argument --export=./.config, which is none"
bad short "run: holds the argument -h, which is none"
bad rest "run: holds the argument --, which is none"
bad inner "an argument names x{archive}/inputs, outside the archive"
for kind in deep nan huge wide; do
    bad $kind "results/summary.json is no JSON, or nests too deep, or has a number beyond double; take the archive"
done
bad escape "an argument names ../../case.toml, outside the archive"
bad override "an argument names /etc/passwd, outside the archive"
bad toml "inputs/rig_sphere_parallel.toml names ../../../etc/passwd, outside the archive"
bad spelt "inputs/rig_sphere_parallel.toml names /etc/passwd, outside the archive"
bad traversal "holds ../outside.toml, which is no name within an archive"
bad link "holds inputs/link, which is a link or no regular file"
bad bomb "holds more than 500 MB"
refused "missing.zip: the file cannot be read (No such file or directory)" reproduce missing.zip
refused "is a directory" reproduce "$work"
refused "is not a regular file" reproduce /dev/null

# A case that this program refuses is told by its place in the archive.
"$python" "$source_dir/tests/cli/results/papers.py" change paper/archive.zip newer.zip \
    inputs/rig_sphere_parallel.toml "[friction]" "[fiction]" || complain "newer"
refused "$work/newer.zip: inputs/rig_sphere_parallel.toml:" reproduce "$work/newer.zip"

# One that is killed leaves nothing behind, by whatever signal.
"$python" "$source_dir/tests/cli/results/papers.py" change paper/archive.zip long.zip archive.json \
    mdr.springs=500 mdr.springs=10000 rolling.steps=turning-points rolling.run_all=true \
    rolling.periods=1 rolling.periods=40000 || complain "long"
mkdir temporary
for signal in KILL TERM HUP; do
    TMPDIR=$work/temporary "$program" reproduce long.zip --quiet >/dev/null 2>&1 &
    child=$!
    for _ in $(seq 1 500); do
        [ -n "$(find temporary -name '*.toml')" ] && break
        sleep 0.01
    done
    [ -n "$(find temporary -name '*.toml')" ] || complain "no inputs before $signal"
    kill -s $signal "$child" || complain "over before $signal"
    wait "$child" 2>/dev/null
    for _ in $(seq 1 500); do
        [ -z "$(ls temporary)" ] && break
        sleep 0.01
    done
    [ -z "$(ls temporary)" ] || complain "$signal leaves $(ls temporary)"
    rm -rf temporary/*
done

# At random: run again, or refused; nothing is written beside the folder of the output.
# More of them: bad_archives_random.py PROGRAM ARCHIVE SEED N
"$program" run "$source_dir/examples/cases/rig_sphere_parallel.toml" --models mdr --set mdr.springs=100 \
    --set rolling.steps=turning-points --set rolling.periods=1 --no-studies --output small --export small_paper \
    --quiet >/dev/null || complain "export of a small archive"
"$python" "$source_dir/tests/cli/results/bad_archives_random.py" "$program" small_paper/archive.zip 20261127 100 ||
    complain "archives changed at random"
finish
