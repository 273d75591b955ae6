#!/usr/bin/env bash
# Sees to the Debian packages of packages.txt: root installs what is missing, anybody else is told
# the command. Beside an installed ParaView, VTK's development files are unpacked into build/vtk instead,
# where CMake finds them: libvtk9-dev needs python3-vtk9, which conflicts with python3-paraview.
# usage: setup.sh [build|no-fem|fuzz|report|docs|codes|cluster|paraview|package]...   (build)
#   no-fem: what a build without the finite elements needs
# Exit codes: 0 all packages are there, 2 some are missing or cannot be fetched, else apt-get's.
set -euo pipefail
scripts=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" >/dev/null && pwd)
vtk=$scripts/../build/vtk
[ $# -gt 0 ] || set -- build
# The words of packages.txt.
case " $* " in
    *" build "*) set -- "$@" fem ;;
    *" no-fem "*) set -- "$@" build ;;
esac

if ! command -v dpkg-query >/dev/null; then
    printf 'error: this is no Debian system; %s names what has to be installed\n' \
        "$scripts/packages.txt" >&2
    exit 2
fi

# Asked once for all: one question per package takes seconds.
installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' | sed -n 's/ installed$//p')
is_installed() {
    [[ $'\n'$installed$'\n' == *$'\n'"$1"$'\n'* ]]
}

beside_paraview=
if is_installed python3-paraview; then
    beside_paraview=yes
    [[ " $* " != *" build "* ]] || set -- "$@" beside-paraview
fi

missing=()
while read -r package need _; do
    case " $* " in *" $need "*) ;; *) continue ;; esac
    [[ $beside_paraview && $package == libvtk9-dev ]] && continue
    # Not only Debian has npm and node, and others' conflict with Debian's.
    [ "$package" = npm ] && command -v npm >/dev/null && continue
    [ "$package" = nodejs ] && command -v node >/dev/null && continue
    is_installed "$package" || missing+=("$package")
done < <(sed 's/#.*//; /^[[:space:]]*$/d' "$scripts/packages.txt")

if [ ${#missing[@]} -gt 0 ] && [ "$(id -u)" -ne 0 ]; then
    printf 'Packages are missing, and only root may install them. Please run\n\n' >&2
    printf '  sudo apt-get install --no-install-recommends %s\n\n' "${missing[*]}" >&2
    printf 'and start this script again (if a package is not found: sudo apt-get update).\n' >&2
    exit 2
fi
if [ ${#missing[@]} -gt 0 ]; then
    printf 'Installing %d packages: %s\n' "${#missing[@]}" "${missing[*]}"
    export DEBIAN_FRONTEND=noninteractive
    apt-get -qq update
    apt-get -qq -o Dpkg::Use-Pty=0 install --no-install-recommends "${missing[@]}" >/dev/null
fi

[[ " $* " == *" build "* ]] || exit 0
if [ ! "$beside_paraview" ]; then
    rm -rf "$vtk"
    exit 0
fi
version=$(dpkg-query -W -f '${Version}' libvtk9.1)
if ! "$scripts/unpack.sh" "$vtk" "libvtk9-dev=$version" "python3-vtk9=$version" "libvtk9-java=$version" \
    "vtk9=$version"; then
    # The archive holds one version of a package: not that of a library that was never brought up to date.
    printf 'error: the development files of the installed libvtk9.1 cannot be fetched. If there is no such version:\n\n' >&2
    printf '  sudo apt-get update && sudo apt-get install libvtk9.1\n\nand start this script again.\n' >&2
    exit 2
fi
# The libraries themselves are installed; CMake looks for them beside the rest.
for library in /usr/lib/*/libvtk*-9.1.so.*; do
    ln -sf "$library" "$vtk${library%/*}"
done
