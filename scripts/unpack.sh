#!/usr/bin/env bash
# Unpacks Debian packages into a folder, without installing anything: what they need has to be there.
# Once per set of packages; another set replaces what is there.
# usage: unpack.sh FOLDER PACKAGE[=VERSION]...
set -euo pipefail
folder=$1
shift
[ "$(cat "$folder/.packages" 2>/dev/null)" != "$*" ] || exit 0

rm -rf "$folder"
mkdir -p "$folder"
archives=$(mktemp -d)
trap 'rm -rf "$archives"' EXIT
printf 'Unpacking into %s: %s\n' "$folder" "$*"
(cd "$archives" && apt-get -qq -o APT::Sandbox::User="$(id -un)" download "$@")
for archive in "$archives"/*.deb; do
    dpkg -x "$archive" "$folder"
done
printf '%s\n' "$*" >"$folder/.packages"
