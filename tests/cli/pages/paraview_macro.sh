#!/usr/bin/env bash
# The macro for ParaView beside the results and the example for PyVista are valid Python, and the
# fields that they name are in the files, as VTK's own Python reads them. Where there is no python3, or none
# with VTK, that much is not checked.
# usage: paraview_macro.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

command -v "$python" >/dev/null || { echo "no python3: not checked"; exit 0; }
run=("$program" run "$source_dir/examples/cases/rig_sphere_inside.toml" --models mdr,bem --quiet --no-studies
    --no-report --set 'bem.spacing="1 mm"' --set mdr.springs=500
    --set 'output.volume_depth="3 mm"' --output run)
"${run[@]}" >told.txt 2>&1 || complain "$(cat told.txt)"
"$program" run "$source_dir/examples/cases/rolling_cylinder.toml" --points 0 --quiet --no-report --output roll \
    --set bem.cells_per_radius=6 --set tractive_rolling.distance=1 >told.txt 2>&1 ||
    complain "$(cat told.txt)"
cp "$source_dir/examples/scripts/pyvista_surface.py" .
for script in run/open_run.py roll/open_run.py pyvista_surface.py; do
    [ "$(wc -l <"$script")" -gt 50 ] || complain "$script is missing"
    "$python" -m py_compile "$script" || complain "$script is no Python"
done

cat >fields.py <<'PYTHON'
import ast, glob, sys
from vtkmodules.vtkIOExodus import vtkExodusIIReader

def constants(path):
    """What a script assigns to names in capitals."""
    found = {}
    for node in ast.parse(open(path).read()).body:
        if isinstance(node, ast.Assign) and node.targets[0].id.isupper():
            found[node.targets[0].id] = ast.literal_eval(node.value)
    return found

def names(path):
    """As VTK's reader puts them together; it keeps the _ before x, y, z."""
    reader = vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    return {reader.GetObjectArrayName(kind, i).removesuffix("_") for kind in
            (reader.NODAL, reader.ELEM_BLOCK, reader.GLOBAL) for i in range(reader.GetNumberOfObjectArrays(kind))}

macro, example = constants("run/open_run.py")["FIELDS"], constants("pyvista_surface.py")
checked = 0
for kind, fields in macro.items():
    for path in glob.glob(f"r*/*/{kind}.ex2"):
        missing = ({"elastic_displacement_m"} | set(fields)) - names(path)
        if kind != "volume":
            missing |= set(example.values()) - names(path)
        checked += 1
        if missing:
            sys.exit(f"{path} lacks {missing}")
for kind in macro:
    if not glob.glob(f"r*/*/{kind}.ex2"):
        sys.exit(f"no {kind}.ex2")
if checked < 5:
    sys.exit(f"only {checked} files to be checked")
PYTHON
if "$python" -c 'import vtkmodules.vtkIOExodus' 2>/dev/null; then
    "$python" fields.py >told.txt 2>&1 || complain "$(tail -1 told.txt)"
else
    echo "no python3 with VTK: fields not checked"
fi
finish
