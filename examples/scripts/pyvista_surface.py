#!/usr/bin/env python3
"""Draws the contact surface of a run with PyVista: pressure, or zones, and the friction's arrows.

    python3 examples/scripts/pyvista_surface.py results/rig_sphere_parallel/bem picture.png [--time 2.25] [--zones]

The folder is that of one model, of `tricontact run`; PyVista comes by `pip install pyvista`. Times are those of
surface.ex2: seconds where the case has a speed or times of its own, else periods of rolling, rows of a prescribed path, or
the way rolled on over the contact's half length. Pressing comes in the first half of the first step.
"""

import argparse
import pathlib

PRESSURE = "normal_traction_Pa"
FRICTION = "tangential_traction_Pa"
ZONES = "contact_state"  # 0 open, 1 stick, 2 slip
POSITION = "indenter_position_m"


def surface_at(series, time):
    """The last surface of surface.ex2 that is not after the time, and when it is."""
    import pyvista

    reader = pyvista.ExodusIIReader(str(series)) if hasattr(pyvista, "ExodusIIReader") else pyvista.get_reader(str(series))
    rounding = 1e-9 * max(map(abs, reader.time_values))
    times = [value for value in reader.time_values if time is None or value <= time + rounding]
    if not times:
        raise SystemExit(f"{series}: begins at {reader.time_values[0]}")
    reader.set_active_time_value(times[-1])
    return reader.read()[0], times[-1]


def arrows(surface):
    """The tangential traction at the points of contact, the longest arrow a tenth of the surface."""
    centres = surface.cell_centers() if FRICTION in surface.cell_data else surface
    centres = centres.extract_points(centres[ZONES] > 0, include_cells=False)
    strongest = (centres[FRICTION] ** 2).sum(axis=1).max() ** 0.5
    factor = 0.1 * surface.length / strongest if strongest > 0 else 0
    return centres.glyph(orient=FRICTION, scale=FRICTION, factor=factor)


def time_text(surface, time):
    """What the time of a state is, its field tells."""
    texts = {"time_s": "t = {:g} s", "time_periods": "n = {:g}", "time_half_lengths": "rolled {:g} a"}
    return next(text for name, text in texts.items() if name in surface.field_data).format(time)


def draw(surface, time, zones, picture):
    import pyvista

    plotter = pyvista.Plotter(off_screen=True)
    plotter.add_mesh(surface, scalars=ZONES if zones else PRESSURE,
                     cmap="Greys" if zones else "viridis")
    plotter.add_mesh(arrows(surface), color="firebrick")
    x, y = surface.field_data[POSITION].ravel()[:2]
    plotter.add_text(f"{time_text(surface, time)}, indenter at ({1e3 * x:.3g}, {1e3 * y:.3g}) mm", font_size=10)
    plotter.view_xy()
    plotter.screenshot(picture)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("model", type=pathlib.Path, help="folder of one model's results")
    parser.add_argument("picture", help="file to be written (PNG)")
    parser.add_argument("--time", type=float, help="of surface.ex2; the last state until then (the last of all)")
    parser.add_argument("--zones", action="store_true", help="stick and slip instead of pressure")
    given = parser.parse_args()
    surface, time = surface_at(given.model / "surface.ex2", given.time)
    draw(surface, time, given.zones, given.picture)


if __name__ == "__main__":
    main()
