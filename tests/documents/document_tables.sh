#!/usr/bin/env bash
# Tables of numbers in the documents are those that their commands compute: those that take seconds. Digits are the
# documents', so that a number differs where it has changed.
# usage: document_tables.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/prepare.bash"
tables=$source_dir/scripts/document_tables.py

"$python" "$tables" --program "$program" --check --cheap || complain "documents and commands differ"
# 1. A number that is not the command's is found.
cp -r "$source_dir/docs" "$source_dir/scripts" "$source_dir/examples" "$source_dir/README.md" .
sed -i '/<!-- table: bem_static -->/,/<!-- end of table -->/s/e-3 |/e-4 |/' docs/explanation/models/bem.md
"$python" scripts/document_tables.py --program "$program" --check bem_static >told 2>&1 && complain "other numbers pass"
grep -q "table bem_static has other numbers" told || complain "$(cat told)"
# 2. Each table of the documents is known, and each known one is there.
diff <("$python" "$tables" --list | sort) <(grep -rhoP '^<!-- table: \K.*(?= -->$)' "$source_dir/docs" --include='*.md' | sort) || complain "tables of documents and script"
finish
