#!/usr/bin/env bash
# The draft of a paper, docs/paper: the length and sections that the Journal of Open Source Software asks for, each citation in the
# bibliography and the other way round, entries as in the bibliography of reports, numbers as in the documents.
# usage: paper.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/prepare.bash"
paper=$source_dir/docs/paper/paper.md
bibliography=$source_dir/docs/paper/paper.bib

words=$(awk '/^---$/ { ++n; next } n >= 2' "$paper" | wc -w)
[ "$words" -ge 750 ] && [ "$words" -le 1750 ] || complain "$words words, asked for are 750 to 1750"
for section in Summary 'Statement of need' 'State of the field' References; do
    grep -qx "# $section" "$paper" || complain "no section $section"
done
grep -oE '@[A-Z][A-Za-z]+[0-9]{4}' "$paper" | tr -d @ | sort -u >cited
sed -n 's/^@[a-z]*{\(.*\),$/\1/p' "$bibliography" | sort >listed
[ -s cited ] || complain "nothing is cited"
diff cited listed || complain "what is cited is not what is listed"

# An entry that reports have, too, is the same here.
entry() { sed -n "/^@[a-z]*{$1,\$/,/^}/p" "$2"; }
n=0
while read -r key; do
    entry "$key" "$source_dir/report/sources.bib" >there
    [ -s there ] || continue
    n=$((n + 1))
    entry "$key" "$bibliography" | diff there - || complain "$key: another entry than in report/sources.bib"
done <listed
[ "$n" -ge 10 ] || complain "only $n entries compared"

while read -r picture; do
    [ -s "$source_dir/docs/paper/$picture" ] || complain "no picture $picture"
done < <(grep -oE '\]\(\.\./images/[^)]*\)' "$paper" | sed 's/^](//; s/)$//')
rows=$(grep -cE '\| (pass|fail) \|$' "$source_dir/docs/reference/verification.md")
grep -q "^$rows rows for" "$paper" || complain "not the $rows rows of verification.md"
problems=$(find "$source_dir/docs/reference/benchmarks" -name '*.md' | wc -l)
grep -q "catalogue of $problems problems" "$paper" || complain "not the number of problems"
finish
