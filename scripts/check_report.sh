#!/usr/bin/env bash
# Reads reports in chromium, wide and on a phone, by day and by night: no message on the console, no
# request to the network, every chart drawn in the page's colours, no sideways scrolling, whatever can be chosen
# within reach of the keyboard and seen when it is, axe-core's rules of accessible pages, tables that sort, drawings
# that can be saved.
# usage: check_report.sh REPORT.html...
# Exit codes: 0 nothing to complain about, 1 complaints, 2 wrong call, or no chromium and not root.
set -euo pipefail
scripts=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" >/dev/null && pwd)
[ $# -gt 0 ] || { sed -n '/^# usage/s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
"$scripts/setup.sh" report
cmake -DFOLDER="$scripts/../build/axe" -P "$scripts/../cmake/fetch_axe.cmake"
axe=$scripts/../build/axe/package/axe.min.js
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

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

# look FOLDER PREFERENCE: at report.html in the folder; complaints, a line each.
look() {
    cp "$work/readers.html" "$1"
    # Without a processor for graphics WebGL is computed, which takes several times as long.
    local graphics=(--disable-gpu)
    ! grep -q 'id="player_open_scene"' "$1/report.html" ||
        graphics=(--use-angle=swiftshader --enable-unsafe-swiftshader)
    timeout 600 chromium --headless --no-sandbox "${graphics[@]}" --window-size=1300,1700 \
        --user-data-dir="$1/profile" --host-resolver-rules="MAP * ~NOTFOUND" \
        --blink-settings="preferredColorScheme=$2" --enable-logging=stderr \
        --virtual-time-budget=20000 --dump-dom "file://$1/readers.html" \
        >"$1/page" 2>"$1/log" || echo "chromium ends with exit code $?"
    # That the readers look at what WebGL has drawn is their own doing.
    grep -o 'CONSOLE.*' "$1/log" | grep -v 'GPU stall due to ReadPixels' || true
    local readers
    readers=$(grep -o '<pre>\[[^<]*\]</pre>' "$1/page" || true)
    [ "$(grep -c . <<<"$readers")" -eq 2 ] || echo "not both widths were read"
    grep -o '"[^"]*"' <<<"$readers" || true
}

# measure REPORT: has the player of a report draw in real time, which stands still for the readers above; at most 33 ms per
# instant make 30 a second. The page is painted before its first figure is drawn.
measure() {
    grep -q 'id="player"' "$1" || return 0
    chromium --headless --no-sandbox --disable-gpu --window-size=1300,1700 --user-data-dir="$work/measured" \
        --enable-logging=stderr "file://$1#measure" >/dev/null 2>"$work/measured.log" &
    local browser=$! said="" tries
    for ((tries = 0; tries < 300; ++tries)); do
        said=$(grep -o 'player: ready[^"]*' "$work/measured.log" || true)
        [ -z "$said" ] || break
        sleep 0.2
    done
    kill "$browser" 2>/dev/null || true
    wait "$browser" 2>/dev/null || true
    printf '%s\n' "$said" >&2
    ! grep -e 'DRAWN BEFORE' -e 'NO MOVIE' <<<"$said" || true
    awk '{ exit !($0 ~ /player/ && $6 < 33) }' <<<"$said" || echo "more than 33 ms per instant: ${said:-nothing is drawn}"
}

# Two readers at a time on two cores, each with a profile of its own.
n=0
for report in "$@"; do
    [ -r "$report" ] || { echo "error: cannot read $report" >&2; exit 2; }
    for preference in dark:0 light:1; do
        n=$((n + 1))
        mkdir "$work/$n"
        {
            sed "s/default-src 'none'/&; media-src blob:/" "$report"  # readers look at the movie that it records
            printf '<script>\n%s\n</script>\n<script>\n%s\n</script>\n' "$(cat "$axe")" "$(cat "$scripts/check_report.js")"
        } >"$work/$n/report.html"
        [ "$(jobs -rp | wc -l)" -lt "$(nproc)" ] || wait -n
        look "$work/$n" "${preference#*:}" | sed "s|^|FAILED: $report, ${preference%:*}: |" >"$work/$n.said" &
    done
done
wait
n=0
for report in "$@"; do  # alone on the machine
    n=$((n + 1))
    measure "$work/$((2 * n))/report.html" | sed "s|^|FAILED: $report: |" >"$work/measured_$n.said"
done
cat "$work"/*.said
failures=$(cat "$work"/*.said | wc -l)
printf '%d failures\n' "$failures"
[ "$failures" -eq 0 ]
