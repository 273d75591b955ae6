#!/usr/bin/env bash
# Builds the documents as a site, build/docs/index.html, with the references of Python and C++ and the notebooks; warnings
# are errors, every link within it has to lead somewhere, to the heading it names, and check_site.py has its say.
# usage: docs.sh
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
site=$root/build/docs
sources=$root/build/site

"$root/scripts/setup.sh" docs
rm -rf "$site" "$sources"

# What pages are made of: the tree by its names, and beside its documents those that are written here.
mkdir -p "$sources"
for entry in "$root"/*; do
    case ${entry##*/} in build | docs | results) ;; *) ln -s "$entry" "$sources" ;; esac
done
cp -rs "$root/docs" "$sources"
python=/usr/bin/python3
compiled=("$root"/build/release/python/_core*.so)
$python "$root/scripts/site/python_reference.py" "$root" "$sources/docs/reference" "${compiled[0]}"
$python "$root/scripts/site/cpp_reference.py" "$root" "$sources/docs/reference/cpp"
$python "$root/scripts/site/notebooks.py" "$root/docs/tutorials" "$sources/docs/tutorials"

sphinx-build -q -n -W --keep-going -c "$root/docs" -b html "$sources" "$site"
printf '<!doctype html><meta http-equiv="refresh" content="0; url=docs/index.html">\n' >"$site/index.html"

$python "$root/scripts/check_links.py" "$site"
$python "$root/scripts/check_site.py" "$site"
printf 'The documents: %s\n' "$site/index.html"
