"""The rig's layer for other programs: the case in mm, N, MPa, and the grid of `tricontact mesh`."""

import numpy as np

E = 5.2  # Young's modulus of the layer [MPa]
NU = 0.5
G = E / (2 * (1 + NU))
DEPTH = 8.0  # thickness of the layer [mm]
R = 40.0  # radius of the rigid paraboloid z = r^2/2R [mm]
FN = 21.1  # normal force [N]; the half model carries half of it
MU = 0.57
FT = 0.56 * MU * FN  # tangential force along x [N]
EXACT = {"d": 0.32290, "a": 4.3638, "p0": 0.5330}  # one-dimensional integral equation


def read_axes(path):
    """Ascending node coordinates [mm] in x, y, z of a tensor grid: the .msh (4.1, metres, text)
    that `tricontact mesh` writes. Half model y >= 0, surface z = 0, body below."""
    lines = iter(open(path, encoding="utf-8"))
    for line in lines:
        if line.startswith("$Nodes"):
            break
    n_blocks = int(next(lines).split()[0])
    points = []
    for _ in range(n_blocks):
        count = int(next(lines).split()[3])
        for _ in range(count):
            next(lines)
        points += [[float(v) for v in next(lines).split()[:3]] for _ in range(count)]
    points = np.round(np.array(points) * 1e3, 9)
    axes = [np.unique(points[:, i]) for i in range(3)]
    if len(points) != np.prod([len(axis) for axis in axes]):
        raise SystemExit(f"{path}: not a tensor grid")
    return axes


def patch(axes, size):
    """Half widths [mm] of the patch of elements `size` [mm] wide about the origin: x, y."""
    def reach(axis):
        positive = axis[axis >= 0]
        fine = np.abs(np.diff(positive) - size) < 1e-6 * size
        return positive[len(fine) if fine.all() else np.argmin(fine)]
    return reach(axes[0]), reach(axes[1])


def friction_excess(p, tx, ty):
    """Largest nodal |t| - mu p over mu times the peak pressure; a node under tension bears no t.
    Means something where t and p act along fixed axes (linear kinematics)."""
    return float((np.hypot(tx, ty) - MU * np.maximum(p, 0)).max() / (MU * p.max()))
