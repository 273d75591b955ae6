#!/usr/bin/env bash
# Reads the site of docs.sh in chromium, each page 400 px wide as on a phone: nothing scrolls sideways but tables, formulas
# and code within themselves, no row stands outside of its table, no picture is missing, formulas have their fonts, nothing
# is asked of a network.
# usage: check_site.sh [FOLDER]   (build/docs)
# Exit codes: 0 nothing to complain about, 1 complaints, 2 no chromium and not root.
set -euo pipefail
scripts=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" >/dev/null && pwd)
site=$(realpath "${1:-$scripts/../build/docs}")
"$scripts/setup.sh" report
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

pages=$(cd "$site" && find . -name '*.html' ! -path ./index.html | sort | sed 's|^\./||; s|.*|"&",|')
cat >"$work/readers.html" <<END
<!DOCTYPE html>
<body>
<script>
const site = "file://$site/", pages = [$pages];
$(cat "$scripts/check_site.js")
</script>
END
timeout 300 chromium --headless --no-sandbox --disable-gpu --allow-file-access-from-files --window-size=1300,900 \
    --user-data-dir="$work/profile" --host-resolver-rules="MAP * ~NOTFOUND" --enable-logging=stderr \
    --virtual-time-budget=600000 --dump-dom "file://$work/readers.html" >"$work/page" 2>"$work/log" ||
    echo "chromium ends with exit code $?"
grep -o '<pre>[^<]*</pre>' "$work/page" | sed 's/<[^>]*>//g' || true
if ! grep -q '<pre>[1-9][0-9]* pages, 0 failures</pre>' "$work/page"; then
    grep -o 'CONSOLE.*' "$work/log" >&2 || true
    echo "error: see above, or not all pages were read" >&2
    exit 1
fi
