# Opens the results beside this script in ParaView, at the last state: one layout per model, the
# contact surface and, where there are such, steady rolling and the inside.
#   paraview --script=open_run.py        (or pvpython open_run.py IMAGE_FOLDER to save pictures)
import glob
import os
import sys

from paraview.simple import *

FIELDS = {"surface": ["normal_traction_Pa"], "steady": ["normal_traction_Pa"], "volume": ["von_mises_Pa"]}
WRITTEN_TO = @folder@  # looked into where ParaView does not say where this script lies


def own_folder():
    """Where this script lies, as Python, the call stack or the command line tells; else empty. The GUI leaves
    __file__ None and calls the script "<string>"."""
    names = [globals().get("__file__"), sys._getframe().f_code.co_filename]
    if os.path.exists("/proc/self/cmdline"):
        with open("/proc/self/cmdline", encoding="utf-8", errors="surrogateescape") as line:
            words = line.read().split("\0")
        names += [word[len("--script="):] for word in words if word.startswith("--script=")]
        names += [following for word, following in zip(words, words[1:]) if word == "--script"]
    for name in names:
        if name and os.path.isfile(name):
            return os.path.dirname(os.path.abspath(name))
    return ""


def all_series():
    """The series of the first folder that has some."""
    folders = [folder for folder in (own_folder(), WRITTEN_TO, os.getcwd()) if folder]
    for folder in folders:
        found = glob.glob(os.path.join(glob.escape(folder), "*", "*.pvd"))
        if found:
            print("results of", folder)
            return found
    raise RuntimeError("no results (*/*.pvd) in " + " or ".join(folders) +
                       ": let WRITTEN_TO in this script name their folder")


def warp_scale(source, size):
    """1 if the deformation can be seen as it is, else such that it is a tenth of the size."""
    largest = source.PointData["displacement_m"].GetRange(-1)[1]
    return 1.0 if largest > 0.02 * size or largest == 0 else 0.1 * size / largest


def look_at(view, bounds, inside):
    """From above for a surface, from the front for a line, obliquely for a body."""
    centre = [(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)]
    above = not inside and bounds[3] > bounds[2]
    direction = [-0.6, -1.0, 0.6] if inside else [0.0, 0.0, 1.0] if above else [0.0, -1.0, 0.0]
    view.CameraFocalPoint = centre
    view.CameraPosition = [c + d for c, d in zip(centre, direction)]
    view.CameraViewUp = [0.0, 1.0, 0.0] if above else [0.0, 0.0, 1.0]
    view.CameraParallelProjection = 1
    ResetCamera(view)


def show(path, kind, view):
    """A series warped by its displacement and coloured by its main field."""
    source = OpenDataFile(path)
    RenameSource(os.path.basename(os.path.dirname(path)) + " " + kind, source)
    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.GoToLast()
    source.UpdatePipeline(scene.AnimationTime)
    bounds = source.GetDataInformation().GetBounds()
    size = max(bounds[1] - bounds[0], bounds[3] - bounds[2])
    if kind == "volume" and bounds[2] < 0:
        source = Clip(Input=source, ClipType="Plane")
        source.ClipType.Origin = [0.0, 0.0, 0.0]
        source.ClipType.Normal = [0.0, -1.0, 0.0]  # keeps y >= 0
    if len(source.CellData) and not len(source.PointData):
        source = CellDatatoPointData(Input=source)
    source.UpdatePipeline(scene.AnimationTime)
    warped = WarpByVector(Input=source, Vectors=["POINTS", "displacement_m"])
    warped.ScaleFactor = warp_scale(source, size)
    display = Show(warped, view)
    ColorBy(display, ["POINTS"] + FIELDS[kind])
    display.RescaleTransferFunctionToDataRange(False, True)
    display.SetScalarBarVisibility(view, True)
    look_at(view, bounds, kind == "volume")


def main():
    series = all_series()
    pictures = sys.argv[1] if len(sys.argv) > 1 else None
    for model in sorted(set(os.path.dirname(path) for path in series)):
        name = os.path.basename(model)
        kinds = [k for k in FIELDS if os.path.join(model, k + ".pvd") in series]
        layout = CreateLayout(name)
        for i, kind in enumerate(kinds):
            view = CreateView("RenderView")
            AssignViewToLayout(view=view, layout=layout, hint=0)
            show(os.path.join(model, kind + ".pvd"), kind, view)
            Render(view)
            if pictures:
                SaveScreenshot(os.path.join(pictures, name + "_" + kind + ".png"), view)


main()
