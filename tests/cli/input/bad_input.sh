#!/usr/bin/env bash
# Bad input from the shell: exit code 2, one line "error: ...", nothing written.
# usage: bad_input.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"
trap 'chmod -R u+rwx "$work" 2>/dev/null; rm -rf "$work"' EXIT
case_file=$source_dir/examples/cases/rig_sphere_parallel.toml

# A message of the option parser may have more than one line; the code and the silence count.
refused_option() {
    local expected=$1 code message
    shift
    message=$("$program" "$@" 2>&1 >/dev/null)
    code=$?
    [ "$code" -eq 2 ] || complain "exit code $code instead of 2: $*"
    [[ $message == *"$expected"* ]] || complain "$*: expected $expected, got $message"
}

# 1. Every bad case states its message in its first line, from line and column on (" ... " stands for a
#    path); run refuses it before it makes a folder. tests/unit/io/case/bad_cases.cc reads all of them; here
#    every eighth one is as good: what the reader throws reaches the shell by one way.
for folder in bad bad_walk; do
    $python "$source_dir/tests/cli/bad_inputs.py" "$source_dir/tests/cli/$folder" "$work/$folder" ||
        complain "the table of $folder"
done
n=0
for file in "$work"/bad/*.toml; do
    [ $((n++ % 8)) -eq 0 ] || continue
    read -r expected <"$file"
    expected=${expected#'# expect: '}
    refused "$file${expected%% ... *}" run "$file" --output out
    [[ $message == *"${expected##* ... }"* ]] || complain "$file: $message"
done
for file in "$work"/bad_walk/*.toml; do
    [ $((n++ % 8)) -eq 0 ] || continue
    read -r expected <"$file"
    refused "$file${expected#'# expect: '}" check "$file"
done
[ "$n" -gt 300 ] || complain "only $n bad inputs"

# 2. Files that are no case.
: >"$work/empty.toml"
head -c 5000 /dev/zero >"$work/zeros.toml"
head -c 1000001 /dev/zero | tr '\0' '#' >"$work/huge.toml"
refused "empty.toml:1:1: the file is empty" check "$work/empty.toml"
refused "zeros.toml:1:1: the file is binary" check "$work/zeros.toml"
refused "is larger than 1 MB" check "$work/huge.toml"
refused "the file cannot be read (No such file or directory)" check "$work/missing.toml"
refused "the file cannot be read (No such file or directory)" run missing.toml
refused "is a directory; name a case file inside it" check "$work"
refused "is a directory; name a case file inside it" run "$work"
refused "is not a regular file" check /dev/null

# 3. Overrides.
refused "--set load.tangential_ratio=2: load.tangential_ratio = 2: must be" \
    check "$case_file" --set load.tangential_ratio=2
refused "contradicts load.tangential_ratio = 0.1" \
    check "$case_file" --set load.tangential_ratio=0.1 --set "load.tangential_force=1 N"
refused "mdr.springs = 600: is set twice" \
    check "$case_file" --set mdr.springs=500 --set mdr.springs=600
refused "contradicts rolling.increment" \
    run "$case_file" --set "rolling.increment=0.1 mm" --set rolling.steps=turning-points
refused "unknown key load.tangential_ration; did you mean load.tangential_ratio?" \
    run "$case_file" --set load.tangential_ration=0.1
refused "is not of the form key=value" check "$case_file" --set nonsense
refused '"N" is a unit of force, but this is a length' \
    check "$case_file" --set "indenter.radius=40 N"

# 4. The output folder.
echo precious >"$work/precious"
refused "precious: is a file, not an output folder" run "$case_file" --output "$work/precious"
refused "precious/below: the output folder cannot be made (Not a directory)" \
    run "$case_file" --output "$work/precious/below"
[ "$(cat "$work/precious")" = precious ] || complain "a file in the way of the output was changed"
if [ "$(id -u)" -ne 0 ]; then
    mkdir "$work/locked"
    chmod 500 "$work/locked"
    refused "cannot be made (Permission denied)" run "$case_file" --output "$work/locked/below"
    refused "cannot be written to (Permission denied)" run "$case_file" --output "$work/locked"
fi
# Nobody may make folders in /proc, root included.
refused "the output folder cannot be made" run "$case_file" --output /proc/tricontact/results

# 5. A full disk: a limit on the size of files acts like one. What is there stays whole.
full=$work/full
message=$(cd "$work" && ulimit -f 1 && "$program" run "$case_file" --output "$full" --models mdr \
    --no-report --quiet 2>&1)
code=$?
[ "$code" -eq 2 ] || complain "exit code $code instead of 2 on a full disk"
case $message in
    "error: $full"*"cannot be written (File too large); free space on the disk"*) ;;
    *) complain "full disk: $message" ;;
esac
[ -z "$(find "$full" -name '.*.partial-*')" ] || complain "half-written files: $(ls -A "$full")"
[ -z "$(find "$full" -type f -size +2)" ] || complain "files beyond the limit: $(ls -lR "$full")"

# 6. The command line itself.
refused_option "" # no command
refused_option "" compute "$case_file"
refused_option "--frobnicate" run "$case_file" --frobnicate
refused_option "" run
refused_option "" check
refused_option "--threads" run "$case_file" --threads many
refused_option "ben" run "$case_file" --models mdr,ben

finish
