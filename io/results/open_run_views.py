def surface_cells(source):
    """Where the state of a surface is shown: in its cells, or at its points."""
    return "CELLS" if source.CellData["contact_state"] else "POINTS"


def show_stick_slip(source, view):
    """Each point of a surface in the colour of its state, as a disc over the outline; of a single row as a strip."""
    display = Show(source, view)
    display.Ambient, display.Diffuse = 1.0, 0.0  # the colours of the scale
    data = source.GetDataInformation()
    is_row = data.GetNumberOfPoints() == 2 * (data.GetNumberOfCells() + 1)  # of cells, which are a strip
    nodes = source.PointData["contact_state"] and is_area(source) and not is_row
    if nodes:
        outline = Show(Outline(Input=source), view)
        outline.AmbientColor = outline.DiffuseColor = [0.0, 0.0, 0.0]
        bounds, n = source.GetDataInformation().GetBounds(), source.GetDataInformation().GetNumberOfPoints()
        display.SetRepresentationType("Point Gaussian")
        display.ShaderPreset = "Plain circle"
        display.GaussianRadius = 0.5 * ((bounds[1] - bounds[0]) * (bounds[3] - bounds[2]) / n) ** 0.5
    else:
        display.SetRepresentationType("Surface" if is_row else "Points")
    colour(display, view, "POINTS" if nodes else surface_cells(source), "contact_state", "contact")
    display.PointSize = 6
    say_time(source, view)


def evenly_placed(source):
    """The fields of a surface at points of equal distances, 24 along its longer side."""
    bounds = source.GetDataInformation().GetBounds()
    sides = [bounds[1] - bounds[0], bounds[3] - bounds[2]]
    places = Plane(Origin=[bounds[0], bounds[2], 0.0], Point1=[bounds[1], bounds[2], 0.0], Point2=[bounds[0], bounds[3], 0.0],
                   XResolution=max(1, round(24 * sides[0] / max(sides))), YResolution=max(1, round(24 * sides[1] / max(sides))))
    RenameSource("places of arrows", places)
    placed = ResampleWithDataset(SourceDataArrays=source, DestinationMesh=places)
    RenameSource("fields there", placed)
    return placed


def show_tractions(source, view, size, lift):
    display = Show(source, view)
    display.SetRepresentationType("Surface" if is_area(source) else "Points")
    display.Ambient, display.Diffuse = 1.0, 0.0  # the colours of the scale
    colour(display, view, "CELLS" if source.CellData["normal_traction_Pa"] else "POINTS", "normal_traction_Pa",
           "normal traction [Pa]")
    display.PointSize = 6
    strongest = largest(source, "tangential_traction_Pa")
    if strongest > 0:
        arrows = Glyph(Input=evenly_placed(source) if is_area(source) else source, GlyphType="Arrow")
        arrows.OrientationArray = ["POINTS", "tangential_traction_Pa"]
        arrows.ScaleArray = ["POINTS", "tangential_traction_Pa"]
        arrows.ScaleFactor = 0.06 * size / strongest
        arrows.GlyphMode = "All Points"
        RenameSource("tangential tractions", arrows)
        shown = Show(arrows, view)
        shown.ColorArrayName = ["POINTS", ""]
        bounds = source.GetDataInformation().GetBounds()
        is_line = not bounds[3] > bounds[2]  # beside which the arrows are
        shown.AmbientColor = shown.DiffuseColor = [0.3, 0.3, 0.3] if is_line else [1.0, 1.0, 1.0]
        shown.Ambient, shown.Diffuse = 1.0, 0.0
        shown.Position = [0.0, 0.02 * size if is_line else 0.0, lift]
    say_time(source, view)


def warp_scale(source, size):
    """1 if the deformation can be seen as it is, else such that it is a tenth of the size."""
    most = largest(source, "elastic_displacement_m")
    return 1.0 if most > 0.02 * size or most == 0 else 0.1 * size / most


def warped(source, scale):
    """Deformed as it is, or magnified along z alone, as the indenter is."""
    name = "elastic_displacement_m"
    if scale != 1:
        name = "normal_displacement_m"
        # Above the plane is an indenter that deforms, whose height is magnified with it.
        height = "max(coordsZ,0)*(%.9g)" % (1 - 1 / scale)
        source = Calculator(Input=source, Function="(elastic_displacement_m_Z+%s)*kHat" % height, ResultArrayName=name)
    return WarpByVector(Input=source, Vectors=["POINTS", name], ScaleFactor=scale)


def back_half(source, bounds):
    """What lies behind the plane y = 0; all of a line."""
    if not bounds[2] < 0 < bounds[3]:
        return source
    clip = Clip(Input=source, ClipType="Plane")
    clip.ClipType.Origin = [0.0, 0.0, 0.0]
    clip.ClipType.Normal = [0.0, -1.0, 0.0]
    return clip


def near(volume, bounds, depth, height):
    """What lies below the surface of these bounds, and a little beside it, down to the depth and up to the height."""
    beside = 0.15 * (bounds[1] - bounds[0])
    clip = Clip(Input=volume, ClipType="Box")
    clip.ClipType.Position = [bounds[0] - beside, bounds[2] - beside, -depth]
    clip.ClipType.Length = [bounds[1] - bounds[0] + 2 * beside, bounds[3] - bounds[2] + 2 * beside, depth + height]
    Hide3DWidgets(proxy=clip.ClipType)
    return clip


def shows_indenter(volume):
    """Whether the volume has the inside of an indenter that deforms."""
    regions = volume.CellData["region"] if volume else None
    return bool(regions) and regions.GetRange(0)[1] >= 2


def show_section(folder, surface, volume, view, size, depth, lift, scale=None):
    """Volume, surface and indenter, cut at y = 0."""
    bounds = surface.GetDataInformation().GetBounds()
    scale = scale or warp_scale(surface, size)
    time = GetAnimationScene().AnimationTime
    skin = back_half(warped(surface, scale), bounds)
    display = Show(skin, view)
    display.Position = [0.0, 0.0, lift]
    if volume:
        colour(display, view, surface_cells(surface), "contact_state", "contact", "Upper Right Corner")
        body = near(volume, bounds, depth, depth / scale)
        body.UpdatePipeline(time)
        inside = back_half(warped(body, scale), body.GetDataInformation().GetBounds())
        shown = Show(inside, view)
        colour(shown, view, "POINTS", "von_mises_Pa", "von Mises stress [Pa]")
    else:
        colour(display, view, "POINTS", "normal_traction_Pa", "normal traction [Pa]")
    path = os.path.join(folder, "indenter.ex2")
    if os.path.exists(path) and not shows_indenter(volume):
        indenter = open_series(path)
        body = back_half(Transform(Input=indenter, Transform="Transform"), indenter.GetDataInformation().GetBounds())
        shaped = body.Input if body.Input != indenter else body
        shaped.Transform.Scale = [1.0, 1.0, scale]
        shown = Show(body, view)
        shown.AmbientColor = shown.DiffuseColor = [0.75, 0.75, 0.75]
        shown.Opacity = 0.45
        Hide(indenter, view)
    say_time(surface, view)
    note = Text(Text="deformation as it is" if scale == 1 else "normal deformation and indenter's height x %.3g" % scale)
    write_in(view, note, "Lower Left Corner", 12)


def plot_of(folder):
    """Table, columns and title of what is plotted over the run; none if there is no such table."""
    for name, across, upwards, title in PLOTS:
        path = os.path.normpath(os.path.join(folder, name))
        if not os.path.exists(path):
            continue
        with open(path, encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        numbers = {c: [float(row[c] or 0) for row in rows] for c in [across, *upwards] if rows and c in rows[0]}
        most = {c: max(map(abs, numbers.get(c, [0.0]))) for c in upwards}
        moving = [c for c in upwards if most[c] > 1e-3 * max(most.values())]  # others: what solvers leave
        if any(numbers.get(across, [])) and moving:
            return path, across, {c: upwards[c] for c in moving}, title
    return None


def show_plot(path, across, upwards, title):
    table = CSVReader(FileName=[path])
    RenameSource(os.path.basename(os.path.dirname(path)) + " " + os.path.basename(path), table)
    if across == "distance_m":
        table = ThresholdTable(Input=table, Column=["ROWS", across], Mode="Between", MinValue=1e-300, MaxValue=1e300)
    view = new_view("XYChartView")
    SetActiveSource(None)  # the window's panel of an active source would set its own series and empty the chart
    display = Show(table, view, "XYChartRepresentation")
    SetActiveSource(None)
    display.UseIndexForXAxis = 0
    display.XArrayName = across
    display.SeriesVisibility = list(upwards)
    display.SeriesLabel = [text for pair in upwards.items() for text in pair]
    colours = [["0.18", "0.36", "0.55"], ["0.88", "0.54", "0.18"]]
    display.SeriesColor = [text for name, rgb in zip(upwards, colours) for text in (name, *rgb)]
    display.SeriesLineThickness = [text for name in upwards for text in (name, "2")]
    view.LeftAxisTitle, view.BottomAxisTitle = title, TITLES[across]
    return view


def touching(line, bounds):
    """Ends of what is shown of a line: of a bed along a long way only the surroundings of the contact."""
    contact = Threshold(Input=line, Scalars=["POINTS", "contact_state"], LowerThreshold=0.5, UpperThreshold=2.5)
    contact.UpdatePipeline(GetAnimationScene().AnimationTime)
    begin, end = contact.GetDataInformation().GetBounds()[:2]
    Delete(contact)
    beside = 0.4 * (end - begin)
    return (max(bounds[0], begin - beside), min(bounds[1], end + beside)) if end > begin else bounds[:2]


def show_model(folder, series, surfaces):
    """The views of a model, by name; adds its surface to the list."""
    views = {}
    kinds = [kind for kind in ("surface", "steady") if os.path.join(folder, kind + ".ex2") in series]
    volume = os.path.join(folder, "volume.ex2")
    for kind in kinds:
        prefix = "" if kind == "surface" else kind + "_"
        source = open_series(os.path.join(folder, kind + ".ex2"))
        if kind == "steady":
            STEADY.append(source)
        else:
            surfaces.append((folder, source))
        bounds = source.GetDataInformation().GetBounds()
        if not bounds[3] > bounds[2]:
            bounds = (*touching(source, bounds), *bounds[2:])
        size = max(bounds[1] - bounds[0], bounds[3] - bounds[2])
        lift = 2e-3 * size
        above = ([0.0, 0.0, 1.0], [0.0, 1.0, 0.0])
        if not bounds[3] > bounds[2]:  # a line, seen from the front
            bounds = (*bounds[:2], -0.1 * size, 0.1 * size, -0.1 * size, 0.1 * size)
        for name, show in (("stick_slip", show_stick_slip), ("tractions", show_tractions)):
            view = views[prefix + name] = new_view()
            show(source, view) if name == "stick_slip" else show(source, view, size, lift)
            look(view, *above, bounds)
        if kind == "surface":
            inside = open_series(volume) if volume in series else None
            view = views["section"] = new_view()
            depth = 0.5 * size if inside else 0.12 * size
            show_section(folder, source, inside, view, size, depth, lift)
            beside = 0.15 * (bounds[1] - bounds[0]) if inside else 0.0
            shown = (bounds[0] - beside, bounds[1] + beside, 0.0, max(bounds[3], 0.0) + beside, -depth,
                     depth if shows_indenter(inside) else 0.1 * size)
            look(view, [-0.35, -1.0, 0.5], [0.0, 0.0, 1.0], shown)
    plot = plot_of(folder)
    if plot:
        views["shift" if "shift_x_m" in plot[2] else "plot"] = show_plot(*plot)
    return views


def is_area(source):
    bounds = source.GetDataInformation().GetBounds()
    return bounds[3] > bounds[2]


def show_beside(surfaces):
    """Models side by side: normal traction from above, then the section of the surface, all in one scale."""
    named = [(os.path.basename(folder), folder, source) for folder, source in surfaces if is_area(source)]
    if len(named) < 2:
        return []
    spans = [source.GetDataInformation().GetBounds() for _, _, source in named]
    bounds = [(min, max)[i % 2](span[i] for span in spans) for i in range(6)]
    size = max(bounds[1] - bounds[0], bounds[3] - bounds[2])
    scale = min(warp_scale(source, size) for _, _, source in named)
    above, sections = [], []
    for name, folder, source in named:
        view = new_view()
        show_tractions(source, view, size, 2e-3 * size)
        write_in(view, Text(Text=name), "Upper Right Corner", 14)
        look(view, [0.0, 0.0, 1.0], [0.0, 1.0, 0.0], bounds)
        above.append(view)
        view = new_view()
        show_section(folder, source, None, view, size, 0.12 * size, 2e-3 * size, scale)
        write_in(view, Text(Text=name), "Upper Right Corner", 14)
        look(view, [-0.35, -1.0, 0.5], [0.0, 0.0, 1.0], (*bounds[:2], 0.0, bounds[3], -0.12 * size, 0.1 * size))
        sections.append(view)
    # One scale for all: of the largest traction.
    most = max(largest(source, "normal_traction_Pa") for _, _, source in named)
    GetColorTransferFunction("normal_traction_Pa").RescaleTransferFunction(0.0, most)
    link(above), link(sections)
    return [*above, *sections]


def link(views):
    """One camera for all: who turns one view turns the others."""
    for k, view in enumerate(views[1:]):
        AddCameraLink(views[0], view, "camera %d of %s" % (k + 2, id(views[0])))


def show_machine(folder):
    """A walking machine in motion, its displacements magnified, and its way."""
    source = open_series(os.path.join(folder, "machine.ex2"))
    reader = next(one for block, one in READERS if block == source)
    reader.DisplacementMagnitude = reader.FieldData["magnification"].GetRange(0)[0]
    source.UpdatePipeline(GetAnimationScene().AnimationTime)
    view = new_view()
    display = Show(source, view)
    display.PointSize = 10
    display.RenderPointsAsSpheres = 1
    display.LineWidth = 3
    colour(display, view, "CELLS", "part", "part")
    say_time(source, view)
    look(view, [-0.3, -1.0, 0.35], [0.0, 0.0, 1.0], source.GetDataInformation().GetBounds())
    views = {"machine": view}
    plot = plot_of(folder)
    if plot:
        views["motion"] = show_plot(*plot)
    return views


def save(view, path, is_movie):
    """The view as a picture; of a movie one of each instant, path.0000.png and so on, but for charts of all of them."""
    view.ViewSize = [1000, 800]  # charts are laid out for it
    Render(view)
    if not is_movie:
        SaveScreenshot(path + ".png", view, ImageResolution=[1000, 800], FontScaling="Do not scale fonts")
    elif view.GetXMLName() == "RenderView":
        SaveAnimation(path + ".png", view, ImageResolution=[1000, 800], FontScaling="Do not scale fonts")


def main():
    series = all_series()
    is_movie = "--movie" in sys.argv[1:]
    pictures = next((word for word in sys.argv[1:] if word != "--movie"), None)
    if is_movie and not pictures:
        sys.exit("usage: open_run.py [[--movie] FOLDER_OF_PICTURES]")
    if pictures:
        os.makedirs(pictures, exist_ok=True)
    empty = [] if GetSources() else list(GetLayouts().values())  # of a window that has just opened
    first, surfaces, alike = None, [], {}
    for model in sorted(set(os.path.dirname(path) for path in series)):
        is_machine = os.path.join(model, "machine.ex2") in series
        views = show_machine(model) if is_machine else show_model(model, series, surfaces)
        lay_out(os.path.basename(model), list(views.values()))
        first = first or next(iter(views.values()))
        for name, view in views.items():
            if view.GetXMLName() == "RenderView":
                alike.setdefault((name, len(surfaces) and is_area(surfaces[-1][1])), []).append(view)
            if pictures:
                save(view, os.path.join(pictures, os.path.basename(model) + "_" + name), is_movie)
            else:
                Render(view)
    for views in alike.values():
        link(views)
    beside = show_beside(surfaces)
    if beside:
        layout = lay_out("models", beside)
        if pictures:
            layout.SetSize(1600, 900)
            SaveScreenshot(os.path.join(pictures, "models.png"), layout, SaveAllViews=1)
        first = beside[0]
    for layout in empty:
        RemoveLayout(layout)
    SetActiveView(first)


main()
