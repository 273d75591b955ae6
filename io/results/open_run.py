# Opens the results beside this script in ParaView, at the last state: one layout per model with stick and slip,
# the tractions, a section through substrate and indenter, and the shift; one layout with the models side by side;
# of a walking machine its motion. Cameras of like views are linked. The folder may be moved.
#   paraview --script=open_run.py        (or, to save pictures, pvbatch open_run.py [--movie] FOLDER: with --movie one of
#   each instant)
import csv
import glob
import os
import sys

from paraview.simple import *

FIELDS = {"surface": ["normal_traction_Pa", "tangential_traction_Pa", "contact_state"],
          "steady": ["normal_traction_Pa", "tangential_traction_Pa", "contact_state"], "volume": ["von_mises_Pa"]}
CATEGORIES = {  # of whole numbers: what each stands for, and its colour
    "contact_state": [("open", "#e8e8e8"), ("stick", "#2f5d8c"), ("slip", "#e08a2e")],
    "part": [("spots", "#c0392b"), ("spring", "#444444"), ("body", "#7d9cc0"), ("ground", "#d9cdb8"),
             ("ground, marked", "#a8977a")],
}
TIMES = {"time_s": "t = {time:.4g} s", "time_periods": "n = {time:.3f} periods",
         "time_half_lengths": "rolled: {time:.3f} a", "time": "time {time:.4g}"}
PLOTS = [  # of the first that a table has the columns of: table, across, upwards, title
    ("history.csv", "time_s", {"shift_x_m": "along x", "shift_y_m": "along y"}, "Rigid shift U [m]"),
    ("history.csv", "phase", {"shift_x_m": "along x", "shift_y_m": "along y"}, "Rigid shift U [m]"),
    # Not the rows before it rolls and of the steady state.
    ("history.csv", "distance_m", {"longitudinal_creepage": "along x"}, "Creepage [-]"),
    ("../motion.csv", "time", {"x": "body", "base": "base of the spring"}, "Position"),
]
TITLES = {"time_s": "time [s]", "phase": "periods of rolling, or rows of the path",
          "distance_m": "rolled way [m]", "time": "time"}
STEADY = []  # the sources that are steady states
READERS = []  # each source of one block, and the reader that it is of
ENDING = ".ex2"  # of series


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


def opened_folder():
    """The folder of results of which a series is open, for a macro, whose copy lies with ParaView's settings."""
    for source in GetSources().values():
        names = getattr(source, "FileName", None) or ""
        name = names if isinstance(names, str) else names[0]
        if name.endswith(ENDING):
            return os.path.dirname(os.path.dirname(os.path.abspath(name)))
    return ""


def all_series():
    """The series of the first folder that has some."""
    folders = [folder for folder in (own_folder(), opened_folder(), os.getcwd()) if folder]
    for folder in folders:
        found = glob.glob(os.path.join(glob.escape(folder), "*", "*" + ENDING))
        if found:
            print("results of", folder)
            return found
    raise RuntimeError("no results (*/*.ex2) in " + " or ".join(folders) +
                       ": open one of their .ex2 first, or start paraview --script=FOLDER/open_run.py")


def fields_of(source):
    source = next((reader for one, reader in READERS if one == source), source)
    data = source.GetDataInformation().DataInformation.GetFieldDataInformation()
    return [data.GetArrayInformation(i).GetName() for i in range(data.GetNumberOfArrays())]


def largest(source, name):
    array = source.PointData[name] or source.CellData[name]
    return array.GetRange(-1)[1] if array else 0.0


def open_series(path):
    """The series, named after its model, up to date at the last of all states so far."""
    source = OpenDataFile(path)
    folder, name = os.path.split(os.path.splitext(path)[0])
    RenameSource(os.path.basename(folder) + " " + name, source)
    source.UpdatePipelineInformation()  # its times
    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.AnimationTime = max(scene.AnimationTime, source.TimestepValues[-1])
    source.UpdatePipeline(scene.AnimationTime)
    # Its reader gives blocks, of which there is one, of a machine one for each part.
    block = MergeBlocks(Input=source, MergePoints=0)
    RenameSource(os.path.basename(folder) + " " + name + " block", block)
    block.UpdatePipeline(scene.AnimationTime)
    READERS.append((block, source))
    return block


def new_view(kind="RenderView"):
    view = CreateView(kind)
    if kind == "RenderView":
        view.UseColorPaletteForBackground = 0
        view.Background = [1.0, 1.0, 1.0]
        view.OrientationAxesLabelColor = [0.0, 0.0, 0.0]
        view.CameraParallelProjection = 1
    return view


def parts(place, n, split):
    """The places of n equal parts of a place."""
    if n == 1:
        return [place]
    first = split(place, 1.0 / n)
    return [first, *parts(first + 1, n - 1, split)]


def lay_out(name, views):
    """The views in up to two rows, in a layout of this name."""
    layout = CreateLayout(name)
    rows = [views] if len(views) < 3 else [views[:(len(views) + 1) // 2], views[(len(views) + 1) // 2:]]
    for row, place in zip(rows, parts(0, len(rows), layout.SplitVertical)):
        for view, part in zip(row, parts(place, len(row), layout.SplitHorizontal)):
            layout.AssignView(part, view)
    return layout


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def look(view, direction, up, bounds):
    """Fits the bounds into the view, seen from that direction."""
    centre = [(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)]
    view.CameraFocalPoint = centre
    view.CameraPosition = [c + d for c, d in zip(centre, direction)]
    view.CameraViewUp = up
    length = sum(d * d for d in direction) ** 0.5
    ahead = [-d / length for d in direction]
    right = cross(ahead, up)
    width = sum(d * d for d in right) ** 0.5
    right = [d / width for d in right]
    half = [(bounds[2 * i + 1] - bounds[2 * i]) / 2 for i in range(3)]
    across, upwards = (sum(abs(a * h) for a, h in zip(axis, half)) for axis in (right, cross(right, ahead)))
    view.CameraParallelScale = 1.25 * max(upwards, across / 1.25)


def write_in(view, text, corner, size):
    """A text in black."""
    display = Show(text, view)
    display.Color, display.FontSize, display.WindowLocation = [0.0, 0.0, 0.0], size, corner


def say_time(source, view):
    """A line with the time of the state."""
    if source in STEADY:
        return write_in(view, Text(Text="steady state"), "Upper Left Corner", 14)
    formats = [text for name, text in TIMES.items() if name in fields_of(source)]
    if formats:
        write_in(view, AnnotateTimeFilter(Input=source, Format=formats[0]), "Upper Left Corner", 14)


def colour(display, view, association, name, title, corner="Lower Right Corner"):
    ColorBy(display, [association, name])
    table = GetColorTransferFunction(name)
    if name in CATEGORIES:
        table.InterpretValuesAsCategories = 1
        table.AnnotationsInitialized = 1
        table.Annotations = [text for i, (word, _) in enumerate(CATEGORIES[name]) for text in (str(i), word)]
        table.IndexedColors = [int(colour[i:i + 2], 16) / 255 for _, colour in CATEGORIES[name] for i in (1, 3, 5)]
        table.IndexedOpacities = [1.0] * len(CATEGORIES[name])
    else:
        table.ApplyPreset("Viridis (matplotlib)", True)
        display.RescaleTransferFunctionToDataRange(False, True)
    display.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
    bar.DrawBackground, bar.BackgroundColor, bar.BackgroundPadding = 1, [1.0, 1.0, 1.0, 0.8], 4.0
    bar.TitleFontSize = bar.LabelFontSize = 13
    bar.WindowLocation = corner


