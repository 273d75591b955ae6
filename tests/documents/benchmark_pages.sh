#!/usr/bin/env bash
# The pages of the problems for contact codes are those that the program writes; their references are computed again.
# usage: benchmark_pages.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../cli/prepare.bash"
mkdir -p docs/reference
cp "$source_dir/docs/reference/benchmarks.md" docs/reference/
"$source_dir/scripts/benchmark_pages.sh" "$program" "$work" || complain "no pages"
diff -r "$source_dir/docs/reference/benchmarks" docs/reference/benchmarks >differences ||
    complain "run scripts/benchmark_pages.sh: $(head -20 differences)"
diff "$source_dir/docs/reference/benchmarks.md" docs/reference/benchmarks.md || complain "the table of problems"
finish
