#!/usr/bin/env bash
# Installs the build and moves what was installed to another place: it must not know where it came
# from. The tests of the installed copy follow.
# usage: install.sh BUILD_DIR SOURCE_DIR COPY
set -euo pipefail
build=$(realpath "$1")
source_dir=$(realpath "$2")
copy=$3
failures=0

complain() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$*"
}

rm -rf "$copy" "$copy.prefix"
cmake --install "$build" --prefix "$copy.prefix" >/dev/null
mv "$copy.prefix" "$copy"

for file in bin/tricontact lib*/cmake/Tricontact/TricontactConfig.cmake include/tricontact/contact/case.h \
    lib*/libtricontact_contact.a share/tricontact/examples/cases/rig_sphere_parallel.toml; do
    compgen -G "$copy/$file" >/dev/null || complain "there is no $file"
done
# Neither by name nor by a path: the build, the sources, the first prefix.
for path in "$build" "$source_dir" "$copy"; do
    found=$(grep -rlF -- "$path" "$copy" || true)
    [ -z "$found" ] || complain "$path stands in $found"
done
while read -r file; do
    path=$(readelf -d "$file" 2>/dev/null | sed -n 's/.*R\(UN\)\?PATH.*\[\(.*\)\]/\2/p')
    [[ -z $path || $path == \$ORIGIN* ]] || complain "$file looks for libraries in $path"
done < <(find "$copy" -name '*.so' -o -path '*/bin/*')

printf '%d failures\n' "$failures"
exit $((failures > 0))
