#!/usr/bin/env bash
# Reads reports in chromium, wide and on a phone, by day and by night: no message on the console, no
# request to the network, every chart drawn in the page's colours, no sideways scrolling, every link
# and button within reach of the keyboard, tables that sort, drawings that can be saved.
# usage: check_report.sh REPORT.html...
# Exit codes: 0 nothing to complain about, 1 complaints, 2 wrong call, or no chromium and not root.
set -euo pipefail
scripts=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" >/dev/null && pwd)
[ $# -gt 0 ] || { sed -n '/^# usage/s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
"$scripts/setup.sh" report
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

complain() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$*"
}

# Both widths in frames of one page that notes what the readers inside say.
cat >"$work/readers.html" <<'END'
<!DOCTYPE html>
<meta name="color-scheme" content="light dark">
<script>
addEventListener("message", event => {
    const said = document.createElement("pre");
    said.textContent = event.data;
    document.body.append(said);
});
</script>
<body>
<iframe src="report.html" style="width: 1200px; height: 800px"></iframe>
<iframe src="report.html" style="width: 400px; height: 800px"></iframe>
END

for report in "$@"; do
    [ -r "$report" ] || { echo "error: cannot read $report" >&2; exit 2; }
    { cat "$report" && echo "<script>" && cat "$scripts/check_report.js" && echo "</script>"; } \
        >"$work/report.html"
    for preference in dark:0 light:1; do
        where="$report, ${preference%:*}"
        timeout 120 chromium --headless --no-sandbox --disable-gpu --window-size=1300,1700 \
            --user-data-dir="$work/profile" --host-resolver-rules="MAP * ~NOTFOUND" \
            --blink-settings="preferredColorScheme=${preference#*:}" --enable-logging=stderr \
            --virtual-time-budget=20000 --dump-dom "file://$work/readers.html" \
            >"$work/page" 2>"$work/log" || complain "$where: chromium ends with exit code $?"
        while read -r message; do complain "$where: $message"; done \
            < <(grep -o 'CONSOLE.*' "$work/log" || true)
        readers=$(grep -o '<pre>\[[^<]*\]</pre>' "$work/page" || true)
        [ "$(grep -c . <<<"$readers")" -eq 2 ] || complain "$where: not both widths were read"
        while read -r complaint; do complain "$where: $complaint"; done \
            < <(grep -o '"[^"]*"' <<<"$readers" || true)
    done
done
printf '%d failures\n' "$failures"
[ "$failures" -eq 0 ]
