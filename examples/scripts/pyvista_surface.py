#!/usr/bin/env python3
"""Draws the contact surface of a run with PyVista: pressure, or zones, and the friction's arrows.

    python3 examples/scripts/pyvista_surface.py results/rig_sphere_parallel/bem picture.png [--phase 2.25] [--zones]

The folder is that of one model; PyVista comes by `pip install pyvista`.
"""

import argparse
import pathlib

PRESSURE = "normal_traction_Pa"
FRICTION = "tangential_traction_Pa"
ZONES = "contact_state"  # 0 open, 1 stick, 2 slip
POSITION = "indenter_position_m"


def surface_at(series, phase):
    """The surface of surface.pvd at the last phase that is not beyond the given one."""
    import pyvista

    reader = pyvista.get_reader(str(series))
    phases = [value for value in reader.time_values if phase is None or value <= phase + 1e-9]
    if not phases:
        raise SystemExit(f"{series}: begins at phase {reader.time_values[0]}")
    reader.set_active_time_value(phases[-1])
    return reader.read()[0], phases[-1]


def arrows(surface):
    """The tangential traction at the points of contact, the longest arrow a tenth of the surface."""
    centres = surface.cell_centers() if FRICTION in surface.cell_data else surface
    centres = centres.extract_points(centres[ZONES] > 0, include_cells=False)
    strongest = (centres[FRICTION] ** 2).sum(axis=1).max() ** 0.5
    factor = 0.1 * surface.length / strongest if strongest > 0 else 0
    return centres.glyph(orient=FRICTION, scale=FRICTION, factor=factor)


def draw(surface, phase, zones, picture):
    import pyvista

    plotter = pyvista.Plotter(off_screen=True)
    plotter.add_mesh(surface, scalars=ZONES if zones else PRESSURE,
                     cmap="Greys" if zones else "viridis")
    plotter.add_mesh(arrows(surface), color="firebrick")
    x, y = surface.field_data[POSITION].ravel()[:2]
    plotter.add_text(f"phase {phase:g}, indenter at ({1e3 * x:.3g}, {1e3 * y:.3g}) mm", font_size=10)
    plotter.view_xy()
    plotter.screenshot(picture)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("model", type=pathlib.Path, help="folder of one model's results")
    parser.add_argument("picture", help="file to be written (PNG)")
    parser.add_argument("--phase", type=float, help="rolling periods since the start (the last)")
    parser.add_argument("--zones", action="store_true", help="stick and slip instead of pressure")
    given = parser.parse_args()
    surface, phase = surface_at(given.model / "surface.pvd", given.phase)
    draw(surface, phase, given.zones, given.picture)


if __name__ == "__main__":
    main()
