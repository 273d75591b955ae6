#!/usr/bin/env bash
# Builds the documents as a site, build/docs/index.html; warnings are errors, and every link within it
# has to lead somewhere, to the heading it names.
# usage: docs.sh
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
site=$root/build/docs

"$root/scripts/setup.sh" docs
rm -rf "$site"
cd "$root"
sphinx-build -q -n -W --keep-going -c docs -b html . "$site"
printf '<!doctype html><meta http-equiv="refresh" content="0; url=docs/index.html">\n' >"$site/index.html"

/usr/bin/python3 "$root/scripts/check_links.py" "$site"
printf 'The documents: %s\n' "$site/index.html"
