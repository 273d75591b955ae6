#!/usr/bin/env bash
# Archives that are none, damaged, incomplete, altered, or that lead somewhere else: one error, exit code 2,
# nothing written.
# usage: bad_archives.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/prepare.bash"
"$program" run "$source_dir/examples/cases/rig_sphere_parallel.toml" --models mdr --set mdr.springs=500 \
    --set rolling.steps=turning-points --set rolling.periods=1 --no-studies --output out --export paper \
    --quiet >/dev/null || complain "export"

# bad KIND EXPECTED
bad() {
    "$python" "$source_dir/tests/cli/papers.py" spoil paper/archive.zip "$1.zip" "$1" || complain "$1"
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
bad option "run: The following argument was not expected: --frobnicate"
bad place "run: "
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
"$python" "$source_dir/tests/cli/papers.py" change paper/archive.zip newer.zip \
    inputs/rig_sphere_parallel.toml "[friction]" "[fiction]" || complain "newer"
refused "$work/newer.zip: inputs/rig_sphere_parallel.toml:" reproduce "$work/newer.zip"
finish
