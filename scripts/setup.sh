#!/usr/bin/env bash
# Sees to the Debian packages of packages.txt: root installs what is missing, anybody else is told
# the command.
# usage: setup.sh [build|fuzz|report|docs]...   (build)
# Exit codes: 0 all packages are there, 2 some are missing, else apt-get's.
set -euo pipefail
scripts=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" >/dev/null && pwd)
[ $# -gt 0 ] || set -- build

if ! command -v dpkg-query >/dev/null; then
    printf 'error: this is no Debian system; %s names what has to be installed\n' \
        "$scripts/packages.txt" >&2
    exit 2
fi

missing=()
while read -r package need _; do
    case " $* " in *" $need "*) ;; *) continue ;; esac
    status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || missing+=("$package")
done < <(sed 's/#.*//; /^[[:space:]]*$/d' "$scripts/packages.txt")
[ ${#missing[@]} -gt 0 ] || exit 0

if [ "$(id -u)" -ne 0 ]; then
    printf 'Packages are missing, and only root may install them. Please run\n\n' >&2
    printf '  sudo apt-get install --no-install-recommends %s\n\n' "${missing[*]}" >&2
    printf 'and start this script again (if a package is not found: sudo apt-get update).\n' >&2
    exit 2
fi
printf 'Installing %d packages: %s\n' "${#missing[@]}" "${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
apt-get -qq update
apt-get -qq -o Dpkg::Use-Pty=0 install --no-install-recommends "${missing[@]}" >/dev/null
