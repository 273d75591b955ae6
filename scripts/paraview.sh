#!/usr/bin/env bash
# Runs a program of ParaView's: the installed one, else one unpacked into build/paraview, since the
# development files of VTK (libvtk9-dev) and ParaView cannot be installed side by side. Without a display it
# gets one of its own.
# usage: paraview.sh pvpython|paraview [ARGUMENT]...
#   e.g. paraview.sh pvpython --force-offscreen-rendering results/rig_sphere_layer_all/open_run.py PICTURE_FOLDER
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
unpacked=$root/build/paraview

# Which libraries ParaView needs and the machine lacks, as apt-get would install them. Its Python packages
# (matplotlib, autobahn) are for other work.
missing_libraries() {
    apt-get -s install --no-install-recommends paraview 2>/dev/null |
        awk '/^Inst lib/ && $2 !~ /-dev$/ { print $2 }'
}

surroundings=()
if ! command -v "$1" >/dev/null; then
    if [ ! -e "$unpacked/.packages" ]; then
        mapfile -t libraries < <(missing_libraries)
        "$root/scripts/unpack.sh" "$unpacked" paraview python3-paraview "${libraries[@]}" >&2
    fi
    folder=$(dirname "$(find "$unpacked/usr/lib" -name 'libvtkPVVTKExtensionsCore*' -print -quit)")
    surroundings=(env "PATH=$unpacked/usr/bin:$PATH" "LD_LIBRARY_PATH=$folder"
        "PYTHONPATH=$unpacked/usr/lib/python3/dist-packages")
fi

if [ -z "${DISPLAY:-}" ]; then
    command -v Xvfb >/dev/null || "$root/scripts/setup.sh" paraview >&2
    number=$(mktemp)
    # Without -noreset it starts again whenever its last window closes, and refuses the next one meanwhile.
    Xvfb -noreset -displayfd 3 -screen 0 1280x1024x24 -nolisten tcp 3>"$number" 2>/dev/null &
    display=$!
    trap 'kill $display; wait $display || true; rm -f "$number"' EXIT
    for _ in $(seq 600); do
        [ ! -s "$number" ] || break
        sleep 0.1
    done
    [ -s "$number" ] || { echo "error: Xvfb does not start" >&2; exit 1; }
    DISPLAY=:$(cat "$number")
    export DISPLAY
fi
"${surroundings[@]}" "$@"
