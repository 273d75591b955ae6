#!/usr/bin/env bash
# Version, date and licence agree in all places that state them, and every file has a licence (REUSE, where reuse is
# installed).
# usage: metadata.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/prepare.bash"
version=$("$program" --version)
$python "$source_dir/tests/documents/metadata.py" "$source_dir" "${version#tricontact }" || complain "they do not agree"
if command -v reuse >/dev/null && git -C "$source_dir" rev-parse --git-dir >/dev/null 2>&1; then
    reuse --root "$source_dir" lint >lint 2>&1 || complain "reuse lint: $(cat lint)"
fi
# A version that differs in one place, a misspelt key and a folder that is left out are found.
mkdir -p copy/debian copy/docs/how-to copy/cmake copy/LICENSES copy/scripts
for file in CMakeLists.txt CHANGELOG.md CITATION.cff codemeta.json MANIFEST.in README.md LICENSE LICENSES/GPL-3.0-or-later.txt \
    debian/changelog debian/control debian/copyright debian/README.source docs/how-to/install.md docs/how-to/questions.md \
    cmake/npm_packages.cmake scripts/packages.txt; do
    cp "$source_dir/$file" "copy/$file"
done
sed -i '/^graft io$/d' copy/MANIFEST.in
sed -i 's/^version: .*/version: 9.9.9/; s/^keywords:/keyword:/' copy/CITATION.cff
$python "$source_dir/tests/documents/metadata.py" copy "${version#tricontact }" >found
for text in "CITATION.cff: version: '9.9.9'" "CITATION.cff: the format has no keyword" \
    "MANIFEST.in: no io"; do
    grep -qF -- "$text" found || complain "not found: $text"
done
finish
