#!/usr/bin/env bash
# No sentence of the documents has more than 45 words.
# usage: sentences.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/prepare.bash"
sentences=$source_dir/tests/documents/sentences.py

"$python" "$sentences" "$source_dir" || complain "a sentence is too long"
# One of 46 words is found, in its line; neither two of 23 nor words of tables, code and formulas count.
mkdir docs
words() { for ((k = 0; k < $1; k++)); do printf 'word '; done; }
printf '# Title\n\nShort one. A %s.\n' "$(words 45)" >README.md
printf '| %s |\n\n    %s\n\nA word `%s`. %s. Word %s.\n' \
    "$(words 50)" "$(words 50)" "$(words 50)" "$(words 23)" "$(words 23)" >docs/page.md
touch CONTRIBUTING.md
"$python" "$sentences" . >told && complain "46 words pass"
grep -q '^README.md:3: 46 words' told || complain "$(cat told)"
grep -q '^docs/' told && complain "$(cat told)"
finish
