#!/usr/bin/env bash
# Reads reports in chromium, wide by day and on a phone by night: no message on the console, no
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

# The readers of number N look at $work/N.html, one after another within one chromium, in a frame; the page around it notes
# what they say.
n=0
for report in "$@"; do
    [ -r "$report" ] || { echo "error: cannot read $report" >&2; exit 2; }
    n=$((n + 1))
    {
        cat "$report"
        printf '<script>\n%s\n</script>\n<script>\n%s\n</script>\n' "$(cat "$axe")" "$(cat "$scripts/check_report.js")"
    } >"$work/$n.html"
done
cat >"$work/readers.js" <<'END'
function read(number) {
    return new Promise(resolve => {
        const frame = document.createElement("iframe");
        frame.style = `width: ${width}px; height: 800px`;
        frame.src = `../${number}.html`;
        function end(said) {
            frame.remove();
            resolve(said);
        }
        addEventListener("message", ({data}) => end(data), {once: true});
        setTimeout(end, 100000, '["is not read to its end"]');  // of the browser's clock, which leaps over what waits
        document.body.prepend(frame);  // in sight: what is not is not drawn
    });
}
(async () => {
    for (const number of numbers) {
        const said = document.createElement("pre");
        said.textContent = number + " " + await read(number);
        document.body.append(said);
    }
})();
END

# look FOLDER WIDTH PREFERENCE GRAPHICS NUMBER...: at the pages of these numbers; complaints, a line each, behind the number.
look() {
    local folder=$1 width=$2 preference=$3 graphics=$4
    shift 4
    [ $# -gt 0 ] || return 0
    mkdir "$folder"
    printf '<!DOCTYPE html>\n<meta name="color-scheme" content="light dark">\n<body>\n<script>\n' >"$folder/readers.html"
    printf 'const width = %d, numbers = [%s];\n%s\n</script>\n' "$width" "$(IFS=,; echo "$*")" \
        "$(cat "$work/readers.js")" >>"$folder/readers.html"
    # shellcheck disable=SC2086  # words
    timeout $((200 * $#)) chromium --headless --no-sandbox $graphics --window-size=1300,900 \
        --user-data-dir="$folder/profile" --host-resolver-rules="MAP * ~NOTFOUND" \
        --blink-settings="preferredColorScheme=$preference" --enable-logging=stderr \
        --virtual-time-budget=$((100000 * $#)) --dump-dom "file://$folder/readers.html" \
        >"$folder/page" 2>"$folder/log" || echo "0 chromium ends with exit code $?"
    # That the readers look at what WebGL has drawn is their own doing.
    grep -o 'CONSOLE.*' "$folder/log" | grep -v 'GPU stall due to ReadPixels' |
        sed -E "s|^(.*file://$work/([0-9]+)\.html.*)|\2 \1|; t; s|^|0 |" || true
    local number said
    for number in "$@"; do
        said=$(grep -oE "<pre>$number \[[^<]*\]</pre>" "$folder/page" || true)
        [ "$said" ] || echo "$number is not read"
        grep -o '"[^"]*"' <<<"$said" | sed "s|^|$number |" || true
    done
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
    ! grep 'DRAWN BEFORE' <<<"$said" || true
    awk '{ exit !($0 ~ /player/ && $6 < 33) }' <<<"$said" || echo "more than 33 ms per instant: ${said:-nothing is drawn}"
}

# Wide by day and narrow by night, at a time: colours do not depend on the width, nor sizes on the colours, as the readers
# make sure. Without a processor for graphics WebGL is computed, which takes several times as long: for views in three
# dimensions alone.
flat=() scenes=()
for ((n = 1; n <= $#; ++n)); do
    if grep -q 'id="player_open_scene"' "$work/$n.html"; then scenes+=("$n"); else flat+=("$n"); fi
done
computed="--use-angle=swiftshader --enable-unsafe-swiftshader"
look_at_all() {
    look "$work/$1_flat" "$2" "$3" --disable-gpu "${flat[@]}"
    look "$work/$1_scenes" "$2" "$3" "$computed" "${scenes[@]}"
}
look_at_all wide_light 1200 1 >"$work/wide_light" &
look_at_all narrow_dark 400 0 >"$work/narrow_dark" &
wait
for ((n = 1; n <= $#; ++n)); do measure "$work/$n.html" | sed "s|^|$n |"; done >"$work/alone"  # on the machine
failures=0
for look in wide_light narrow_dark alone; do
    while read -r n complaint; do
        failures=$((failures + 1))
        [ "$n" -eq 0 ] || complaint="${!n}: $complaint"
        printf 'FAILED: %s: %s\n' "$look" "$complaint"
    done <"$work/$look"
done
printf '%d failures\n' "$failures"
[ "$failures" -eq 0 ]
