#!/usr/bin/env bash
# The wheel of the Python module, made from a finished build, installs into an environment of its own, brings its
# finite elements, and needs nothing of the build.
# usage: wheel.sh BUILD_DIR SOURCE_DIR
set -euo pipefail
build=$(realpath "$1")
source_dir=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# setuptools writes beside its sources.
mkdir "$work/source"
cp -r "$source_dir"/{pyproject.toml,setup.py,MANIFEST.in,CMakeLists.txt,README.md,python} "$work/source"
cd "$work/source"
TRICONTACT_BUILD=$build /usr/bin/python3 -m build --no-isolation --wheel --outdir "$work" >"$work/log" 2>&1 || {
    cat "$work/log"
    exit 1
}
/usr/bin/python3 -m venv --system-site-packages "$work/venv"
"$work/venv/bin/pip" -q install --no-index --no-deps "$work"/tricontact-*.whl
rm -rf "$work/source"
cd "$work"
# Its platform tag promises no other distribution: what it needs is Debian 12's.
compgen -G "$work/tricontact-*-linux_x86_64.whl" >/dev/null || { echo "tag: $(ls "$work"/*.whl)"; exit 1; }
# The program comes along, and finds its way.
printed=$(env -u PYTHONPATH "$work/venv/bin/tricontact" check "$source_dir/examples/cases/rig_sphere_parallel.toml")
grep -q 'rig_sphere_parallel\|Sphere on rubber' <<<"$printed" || { echo "tricontact check printed: $printed"; exit 1; }
env -u PYTHONPATH "$work/venv/bin/python" - "$source_dir/examples/cases" "$work" <<'PYTHON'
import sys
from pathlib import Path

import tricontact

cases, work = map(Path, sys.argv[1:])
assert Path(tricontact.__file__).is_relative_to(work), tricontact.__file__
settings = {"rolling.steps": "turning-points", "rolling.periods": 200, "mdr.springs": 1000}
case = tricontact.Case.from_file(cases / "rig_sphere_parallel.toml", settings)
history = tricontact.run(case, models=["mdr"], studies=False)["mdr"]
# MDR's closed form (thesis); 1000 springs resolve the edge of contact to 1e-3.
settled = tricontact.theory.settled_shift_ratio(0.24, 0.56)
assert abs(history.shift_per_period[-1] / history.scales.unit_shift / settled - 1) < 1e-2
if list(Path(tricontact.__file__).parent.glob("tricontact_fem_module*")):
    arguments = [str(cases / "rig_layer_parallel.toml"), "--set", "fem.size=0.5 mm", "--output", str(work / "mesh")]
    tricontact._core._run_command("mesh", arguments, print, print)
    assert list((work / "mesh").glob("*.msh"))
print("wheel: passed")
PYTHON
