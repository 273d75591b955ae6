#!/usr/bin/env bash
# What scripts/setup.sh installs and unpacks, with and without ParaView: Debian's own tools are replaced by ones that
# say what they were asked for. (With a real ParaView the demo was run to its end in a chroot.)
# usage: setup.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

mkdir scripts bin
cp "$source_dir"/scripts/{setup.sh,unpack.sh,packages.txt} scripts
cat >bin/dpkg-query <<'SH'
#!/bin/sh
case $3 in *Version*) echo 9.1-5; exit ;; esac
echo 'config-files-only config-files'
sed 's/$/ installed/' installed.txt
SH
cat >bin/apt-get <<'SH'
#!/bin/sh
echo "apt-get $*" >>"$ASKED"
case " $* " in *" download "*) [ -z "${REFUSED:-}" ] || exit 100; touch libvtk9-dev_9.1-5_amd64.deb ;; esac
SH
cat >bin/dpkg <<'SH'
#!/bin/sh
mkdir -p "$3/usr/lib/$(gcc -print-multiarch)/cmake/vtk-9.1"
SH
printf '#!/bin/sh\necho "${USER_ID:-0}"\n' >bin/id
printf '#!/bin/sh\nexit 0\n' >bin/npm
chmod +x bin/*
export ASKED=$work/asked.txt
# all NEED...: packages.
all() { awk -v needs=" $* " '{ sub(/#.*/, "") } $2 && index(needs, " " $2 " ") { print $1 }' scripts/packages.txt; }
# setup CODE ARGUMENTS...: what it asked for is in asked.txt, what it said in said.txt.
setup() {
    local due=$1
    shift
    : >asked.txt
    PATH=$work/bin:$PATH scripts/setup.sh "$@" >said.txt 2>&1
    local code=$?
    [ $code -eq "$due" ] || complain "exit code $code instead of $due: $(cat said.txt)"
}

# Without ParaView: everything is installed, nothing unpacked; of a later start nothing is asked.
all build fem | grep -vx libvtk9-dev >installed.txt
setup 0 build
grep -q 'install --no-install-recommends libvtk9-dev$' asked.txt || complain "not installed: $(cat asked.txt)"
[ -e build/vtk ] && complain "unpacked without ParaView"
all build fem >installed.txt
setup 0
[ -s asked.txt ] && complain "asked for nothing: $(cat asked.txt)"

# Without the finite elements: their packages are not asked for.
all build >installed.txt
setup 0 no-fem
[ -s asked.txt ] && complain "asked for without finite elements: $(cat asked.txt)"
setup 0
grep -q 'install .*libdeal.ii-dev' asked.txt || complain "no finite elements: $(cat asked.txt)"
all build fem >installed.txt

# Another npm will do, no other package's place is taken by a command.
grep -vx 'npm' installed.txt >rest.txt && mv rest.txt installed.txt
setup 0
rm bin/npm
if ! command -v npm >/dev/null; then
    setup 0
    grep -q ' npm$' asked.txt || complain "npm is not installed: $(cat asked.txt)"
fi

# Beside ParaView: not libvtk9-dev, but what its files look for, and they themselves unpacked.
{ all build fem | grep -vx libvtk9-dev; echo npm; echo paraview; echo python3-paraview; } >installed.txt
USER_ID=1000 setup 2 build
grep -q 'sudo apt-get install .*libdouble-conversion-dev' said.txt || complain "what is missing: $(cat said.txt)"
grep -q 'libvtk9-dev' said.txt && complain "the conflict: $(cat said.txt)"
REFUSED=yes setup 2 build
grep -q 'sudo apt-get update && sudo apt-get install libvtk9.1' said.txt || complain "no remedy: $(cat said.txt)"
setup 0 build
grep 'install' asked.txt | grep -q 'libvtk9-dev' && complain "the conflict: $(cat asked.txt)"
grep -q 'download libvtk9-dev=9.1-5 ' asked.txt || complain "not fetched: $(cat asked.txt)"
[ -d build/vtk/usr ] || complain "not unpacked"
all beside-paraview >>installed.txt
USER_ID=1000 setup 0 build
[ -s asked.txt ] && complain "fetched twice: $(cat asked.txt)"

# ParaView gone, the package there: what was unpacked would be found first.
{ all build fem; echo npm; } >installed.txt
setup 0 build
[ -e build/vtk ] && complain "the unpacked files stay in the way"

finish
