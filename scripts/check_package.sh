#!/usr/bin/env bash
# Installs the Debian package into a bare Debian 12 in a folder, which mmdebstrap makes, and tries it there: a case
# runs, Python imports the module, manual and completions are in place, nothing asks for VTK but the reader of its files,
# which says so. lintian, where it is installed, finds neither error nor warning. With `paraview` beside ParaView and its
# module for Python. As root; the archives of packages that the machine has are used, others are fetched.
# usage: check_package.sh PACKAGE.deb FOLDER [paraview]   FOLDER is kept: another call begins with its Debian
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/bare_debian.bash"
package=$(realpath "$1")
folder=$(realpath -m "$2")
beside=${3:-}
base=$folder/debian
root=$folder/root
mkdir -p "$folder"

if command -v lintian >/dev/null; then
    lintian --allow-root --fail-on error,warning "$package" || { echo "FAILED: lintian"; exit 1; }
else
    echo "no lintian: its rules are not checked"
fi

bare_debian "$base"
bare_copy "$base" "$root"
cp "$package" "$root/tmp/tricontact.deb"

install() {
    inside "$root" apt-get -qq -o Dpkg::Use-Pty=0 install --no-install-recommends "$@" \
        >>"$folder/install.log" 2>&1 || {
        tail -n 30 "$folder/install.log"
        exit 1
    }
}
: >"$folder/install.log"
inside "$root" apt-get -qq update
[ "$beside" != paraview ] || install paraview python3-paraview
install /tmp/tricontact.deb

complain() {
    printf 'FAILED: %s\n' "$*"
    exit 1
}
cases=/usr/share/tricontact/examples/cases
inside "$root" tricontact --version
inside "$root" tricontact run "$cases/rig_sphere_parallel.toml" --models mdr,bem --set rolling.periods=2 --no-studies \
    --no-report --quiet --output /tmp/out || complain "the case does not run"
[ -s "$root/tmp/out/summary.json" ] || complain "there is no summary.json"
inside "$root" tricontact mesh "$cases/rig_layer_parallel.toml" --set 'fem.size=2 mm' --output /tmp/mesh >/dev/null ||
    complain "the finite elements are not found"
inside "$root" python3 -c '
import tricontact
case = tricontact.Case.from_file("/usr/share/tricontact/examples/cases/rig_sphere_parallel.toml",
                                 {"rolling.periods": 2, "rolling.steps": "turning-points"})
print("Python:", tricontact.run(case, models=["mdr"], studies=False)["mdr"].state, "of", tricontact.__version__)
' || complain "import tricontact does not work"
for file in share/man/man1/tricontact.1.gz share/bash-completion/completions/tricontact share/doc/tricontact/README.md; do
    [ -s "$root/usr/$file" ] || complain "there is no $file"
done
if [ "$beside" != paraview ]; then
    [ -z "$(find "$root/usr/lib" -name 'libvtk*')" ] || complain "the package asks for VTK"
    printf '<VTKFile type="UnstructuredGrid"></VTKFile>\n' >"$root/tmp/field.vtu"
    if inside "$root" tricontact benchmark compare --case layer_pressed /tmp/field.vtu --output /tmp/compared >"$folder/vtk.log" 2>&1; then
        complain "a file of VTK is read without VTK"
    fi
    grep -q 'read by VTK, whose library .* cannot be loaded; apt-get install libvtk9.1' "$folder/vtk.log" ||
        complain "not said: $(cat "$folder/vtk.log")"
fi
if [ "$beside" = paraview ]; then
    inside "$root" pvpython -c 'import paraview.simple' || complain "ParaView has lost its module for Python"
fi
inside "$root" apt-get -qq -o Dpkg::Use-Pty=0 purge tricontact >/dev/null
found=$(find "$root/usr" -name '*tricontact*' -not -path '*/__pycache__*')
[ -z "$found" ] || complain "left behind: $found"
printf '%s%s: passed\n' "$(basename "$package")" "${beside:+ beside ParaView}"
