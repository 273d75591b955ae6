"""Run by check_paraview.sh in pvpython: results as ParaView reads and draws them.
usage: check_paraview.py WORK_FOLDER RESULTS_FOLDER..."""

import contextlib
import glob
import io
import json
import math
import os
import re
import shutil
import struct
import sys
from pathlib import Path

from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

# What docs/ promise of each series; units stand behind the name where there are some.
FIELDS = {
    "surface": ["normal_traction", "tangential_traction", "elastic_displacement", "gap", "slip", "dissipation", "contact_state",
                "friction_bound"],
    "volume": ["elastic_displacement", "stress", "von_mises", "pressure"],
    "indenter": [],
    "machine": ["displacement", "normal_force", "tangential_force", "spring_force", "contact_state", "part"],
}
FIELDS["steady"] = FIELDS["surface"]
failures = []


def complain(text):
    failures.append(text)
    print("FAILED:", text)


def arrays(source):
    data = [source.PointData, source.CellData]
    return {part.GetArray(i).Name: part.GetArray(i).GetRange(-1) for part in data for i in range(len(part))}


def states_in(path):
    """How many states the file tells, by its bytes."""
    with open(path, "rb") as file:
        return struct.unpack(">I", file.read(8)[4:])[0]  # netCDF's classic format: "CDF", version, number of records


def series_in(folder, depth="*"):
    """Paths of all series in folders of models, or in all folders ("**")."""
    return sorted(glob.glob(os.path.join(glob.escape(folder), depth, "*.ex2"), recursive=True))


def one_block(source):
    """A surface as one grid; of the reader at its last time."""
    block = MergeBlocks(Input=source, MergePoints=0)
    block.UpdatePipeline(source.TimestepValues[-1])
    return block


def check_files(folder, series):
    """At most 50 files for ParaView, times that begin with 0 and are those of one clock: most states of a model with
    as many steps are at the times of another's."""
    files = [path for path in Path(folder).rglob("*") if path.suffix == ".ex2" or path.suffix.startswith(".vt")]
    print(f"{folder}: {len(files)} files for ParaView, {sum(path.stat().st_size for path in files) / 1e6:.0f} MB")
    if len(files) > 50:
        complain(f"{folder}: {len(files)} files for ParaView")
    clocks = {}
    for path in series:
        if os.path.basename(path) == "surface.ex2":
            clocks[path] = list(OpenDataFile(path).TimestepValues)
            if clocks[path][0] != 0:
                complain(f"{path}: begins at the time {clocks[path][0]}")
    longest = max(clocks.values(), key=lambda times: times[-1], default=[])
    for path, times in clocks.items():
        rolling = [t for t in times if t >= longest[-1] / 100]
        off = [t for t in rolling if min(abs(t - one) for one in longest) > 1e-9 * longest[-1]]
        if off:
            complain(f"{path}: {len(off)} of {len(rolling)} times are no model's else, {off[:3]}")
    ResetSession()


def check_series(path):
    """All steps of the series, in order of time, each with the fields of the first."""
    kind = os.path.splitext(os.path.basename(path))[0]
    source = OpenDataFile(path)
    source.UpdatePipeline()
    times = list(source.TimestepValues)
    if times != sorted(set(times)) or len(times) != states_in(path):
        complain(f"{path}: the {len(times)} steps {times[:3]} ... are not the {states_in(path)} of the file in order")
    first = None
    for time in source.TimestepValues:
        source.UpdatePipeline(time)
        found = arrays(source)
        first = first or set(found)
        missing = [name for name in FIELDS[kind] if not any(re.match(name + r"(_[A-Za-z].*)?$", a) for a in found)]
        if missing or set(found) != first:
            complain(f"{path} at {time}: fields {sorted(found)}, without {missing}")
        bounds = source.GetDataInformation().GetBounds()
        if kind == "volume" and not bounds[2] < 0 < bounds[3] and bounds[3] > bounds[2]:
            complain(f"{path} at {time}: y from {bounds[2]} to {bounds[3]} is one half")
        if not 0 <= found.get("contact_state", (0, 0))[0] <= found.get("contact_state", (0, 0))[1] <= 2:
            complain(f"{path} at {time}: contact_state {found['contact_state']}")
    Delete(source)
    return len(times)


def check_picture(path):
    """Something is drawn in the middle, where neither scale nor axes are."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    middle = pixels[height // 4:, width // 5:2 * width // 3, :3].reshape(-1, 3).astype(int)
    codes = middle @ [65536, 256, 1]
    drawn = (codes != codes[0]).mean()
    colours = len(set(codes.tolist()))
    least = 2 if path.endswith("stick_slip.png") else 3  # all of a line of springs may stick
    if drawn < 0.001 or colours < least:
        complain(f"{path}: {100 * drawn:.2f} % drawn in {colours} colours")
    print(f"{os.path.basename(path)}: {100 * drawn:.1f} % drawn in {colours} colours")


def run_macro(folder, *arguments, imported=False):
    """open_run.py, or its text alone as the window runs an imported macro: no __file__, no file name; what it says."""
    path = os.path.join(folder, "open_run.py")
    with open(path, encoding="utf-8") as file:
        text = file.read()
    said = io.StringIO()
    sys.argv = ["", *arguments]
    name = "<string>" if imported else path
    with contextlib.redirect_stdout(said):
        exec(compile(text, name, "exec"), {"__name__": "__main__", "__file__": None})
    return said.getvalue()


def areas(folder):
    """Models whose surface is one of the plane."""
    n = 0
    for path in glob.glob(os.path.join(glob.escape(folder), "*", "surface.ex2")):
        source = OpenDataFile(path)
        source.UpdatePipeline()
        bounds = source.GetDataInformation().GetBounds()
        n += bounds[3] > bounds[2]
        Delete(source)
    return n


def check_moved(folder, series, work):
    """The smallest model and the macro in another folder: it opens that one, also imported, as soon as a series is
    open; without results it says so."""
    model = min((os.path.dirname(path) for path in series),
                key=lambda name: sum(file.stat().st_size for file in Path(name).iterdir()))
    moved = os.path.realpath(os.path.join(work, "moved"))
    shutil.rmtree(moved, ignore_errors=True)
    shutil.copytree(model, os.path.join(moved, os.path.basename(model)))
    shutil.copy(os.path.join(folder, "open_run.py"), moved)
    lost = os.path.join(work, "lost")
    os.makedirs(lost, exist_ok=True)
    os.chdir(lost)
    for imported in (False, True):
        if imported:
            OpenDataFile(series_in(moved)[0])
        said = run_macro(moved, imported=imported)
        if os.path.realpath(said.strip().removeprefix("results of ")) != moved:
            complain(f"{moved}: the macro says '{said.strip()}'")
        ResetSession()
    try:
        run_macro(moved, imported=True)
        complain("the macro is content without results")
    except RuntimeError as error:
        print("without results:", error)
    os.chdir(work)


def check_macro(folder, work):
    pictures = os.path.join(work, "pictures")
    shutil.rmtree(pictures, ignore_errors=True)
    os.makedirs(pictures)
    said = run_macro(folder, pictures)
    if os.path.realpath(said.strip().removeprefix("results of ")) != folder:
        complain(f"{folder}: the macro says '{said.strip()}'")
    ResetSession()
    series = series_in(folder)
    n_areas = areas(folder)
    if os.path.exists(os.path.join(pictures, "models.png")) != (n_areas > 1):
        complain(f"{folder}: {n_areas} surfaces of the plane, and models.png or none")
    drawn = glob.glob(os.path.join(pictures, "*.png"))
    # Of each model stick and slip, tractions, section and a plot; of a machine its motion and a plot.
    for model in {os.path.dirname(path) for path in series}:
        names = {os.path.basename(path)[len(os.path.basename(model)) + 1:-len(".png")] for path in drawn
                 if os.path.basename(path).startswith(os.path.basename(model) + "_")}
        machine = os.path.exists(os.path.join(model, "machine.ex2"))
        due = {"machine", "motion"} if machine else {"stick_slip", "tractions", "section"}
        if not due <= names:
            complain(f"{model}: pictures {sorted(names)}, without {sorted(due - names)}")
    for picture in sorted(drawn):
        check_picture(picture)
    ResetSession()
    check_moved(folder, series, work)


def last_state(folder, model):
    source = OpenDataFile(os.path.join(folder, model, "surface.ex2"))
    source.UpdatePipeline(source.TimestepValues[-1])
    return source


def check_overlay(folder):
    """Surfaces of fem, sampled by ParaView at the points of bem-layer in the last state. In the inner half of the
    contact, away from its edge of cells, the root mean square of what the pressures differ by lies within the
    numerical bar of fem's peak pressure: both models are of the same layer."""
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    error = summary.get("numerical_error") or {}
    if error.get("model") != "fem" or not os.path.exists(os.path.join(folder, "bem-layer", "surface.ex2")):
        return
    bar, name = error["half_widths"]["peak_pressure_Pa"], "normal_traction_Pa"
    last = last_state(folder, "bem-layer")
    fem, layer = one_block(last_state(folder, "fem")), one_block(last)
    sampled = ResampleWithDataset(SourceDataArrays=fem, DestinationMesh=layer)
    sampled.UpdatePipeline(last.TimestepValues[-1])
    of_fem, of_layer = servermanager.Fetch(sampled), servermanager.Fetch(layer)
    pressures = [vtk_to_numpy(data.GetPointData().GetArray(name)).astype(float) for data in (of_fem, of_layer)]
    x, y = (last.FieldData["indenter_position_m"].GetRange(d)[0] for d in (0, 1))
    inner = 0.5 * summary["models"]["bem-layer"]["contact_radius_m"]
    points = map(of_layer.GetPoint, range(of_layer.GetNumberOfPoints()))
    apart = [a - b for a, b, p in zip(*pressures, points) if math.hypot(p[0] - x, p[1] - y) < inner]
    rms = math.sqrt(sum(d * d for d in apart) / len(apart))
    print(f"{folder}: fem at {len(apart)} points of bem-layer: p differs by {rms:.0f} Pa, bar of fem {bar:.0f} Pa")
    if not rms <= bar:
        complain(f"{folder}: fem and bem-layer differ by more than the bar")
    ResetSession()


def check_movie(folder, n_steps, work):
    """Of each view but charts a picture of each instant, the first unlike the last."""
    pictures = os.path.join(work, "movie")
    shutil.rmtree(pictures, ignore_errors=True)
    run_macro(folder, "--movie", pictures)
    views = {os.path.basename(path).split(".")[0] for path in glob.glob(os.path.join(pictures, "*.png"))}
    if not views:
        complain(f"{folder}: no movie")
    for view in sorted(views):
        frames = sorted(glob.glob(os.path.join(pictures, view + ".*.png")))
        first, last = (Path(frames[i]).read_bytes() for i in (0, -1))
        if len(frames) != n_steps or first == last:
            complain(f"{view}: {len(frames)} pictures of {n_steps} instants, or they do not move")
        check_picture(frames[-1])
    print(f"{folder}: movies of {', '.join(sorted(views))}, {n_steps} instants")
    ResetSession()


def check_animation(path, work):
    """The walking machine, coloured by its parts, at its last step."""
    source = OpenDataFile(path)
    view = CreateView("RenderView")
    display = Show(source, view)
    ColorBy(display, ["CELLS", "part"])
    view.ViewTime = source.TimestepValues[-1]
    view.CameraPosition, view.CameraViewUp = [0, -1, 0], [0, 0, 1]
    ResetCamera(view)
    Render(view)
    picture = os.path.join(work, "machine.png")
    SaveScreenshot(picture, view)
    check_picture(picture)
    ResetSession()


def main():
    work, folders = sys.argv[1], sys.argv[2:]
    os.chdir(work)
    for folder in folders:
        series = series_in(folder, "**")
        if not series:
            complain(f"{folder}: no series")
        check_files(folder, series)
        n_steps = [check_series(path) for path in series]
        for path, n in zip(series, n_steps):
            print(f"{path}: {n} steps")
        if os.path.exists(os.path.join(folder, "open_run.py")):
            check_macro(folder, work)
            if os.path.isdir(os.path.join(folder, "fem")):
                check_overlay(folder)
            if len(series) == 1:  # of several it takes minutes
                check_movie(folder, n_steps[0], work)
        for path in series:
            if os.path.basename(path) == "machine.ex2":
                check_animation(path, work)
    print(f"{len(failures)} failures")
    sys.stdout.flush()
    os._exit(len(failures) > 0)


main()
