"""CalculiX on the rig's layer: writes an input deck (`deck`), reads its results (`read`).
20-node hexahedra with reduced integration (C3D20R), nu = 0.4999, linear or neo-Hookean,
face-to-face penalty contact, a rigid paraboloid whose 20-node faces hold z = r^2/2R exactly.
Run by run.sh; needs numpy."""

import argparse
import json
import re

import numpy as np

import exact_layer
import layer_grid as rig

NU = 0.4999  # the program has no element with a pressure of its own
G = rig.E / (2 * (1 + NU))
K = rig.E / (3 * (1 - 2 * NU))
# *MATERIAL and *STEP: what the layer is made of, whether its strains are finite
BULK = {"linear": (f"*ELASTIC\n{rig.E}, {NU}", ""),
        "neo-hookean": (f"*HYPERELASTIC, NEO HOOKE\n{G / 2}, {2 / K}", ", NLGEOM")}
CENTRE = rig.R  # height of the roller's centre, about which it rotates [mm]
# corners, then mid-edges, of a 20-node hexahedron on a grid of half elements
OFFSETS = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2),
           (1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
           (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)]


class Block:
    """20-node hexahedra over a tensor grid, numbered from given bases."""

    def __init__(self, axes, first_node, first_element):
        self.fine = [np.sort(np.append(a, (a[1:] + a[:-1]) / 2)) for a in axes]
        self.counts = [len(a) - 1 for a in axes]
        self.first_element = first_element
        self.nodes, self.elements = {}, []
        for k, j, i in np.ndindex(*self.counts[::-1]):
            self.elements.append([self._node(2 * i + a, 2 * j + b, 2 * k + c, first_node)
                                  for a, b, c in OFFSETS])

    def _node(self, i, j, k, first):
        return self.nodes.setdefault((i, j, k), first + len(self.nodes))

    def points(self):
        for (i, j, k), number in self.nodes.items():
            yield number, self.fine[0][i], self.fine[1][j], self.fine[2][k]

    def element(self, i, j, k):
        return self.first_element + (k * self.counts[1] + j) * self.counts[0] + i

    def write(self, out, name, kind, shape=lambda x, y, z: z):
        out.write(f"*NODE, NSET=N{name}\n")
        for number, x, y, z in self.points():
            out.write(f"{number}, {x:.9g}, {y:.9g}, {shape(x, y, z):.9g}\n")
        out.write(f"*ELEMENT, TYPE={kind}, ELSET=E{name}\n")
        for number, nodes in enumerate(self.elements, self.first_element):
            text = [str(n) for n in (number, *nodes)]
            out.write(",".join(text[:11]) + ",\n" + ",".join(text[11:]) + "\n")


def node_set(out, name, numbers):
    out.write(f"*NSET, NSET={name}\n" + "".join(f"{n},\n" for n in numbers))


def write_bodies(out, axes, size):
    layer = Block(axes, 1, 1)
    layer.write(out, "LAYER", "C3D20R")
    roller_axes = [np.arange(-9.0, 9.1, 2.0), np.arange(-2.0, 8.1, 2.0), np.array([0.0, 2.0])]
    roller = Block(roller_axes, len(layer.nodes) + 1, len(layer.elements) + 1)
    roller.write(out, "ROLLER", "C3D20", lambda x, y, z: z + (x * x + y * y) / (2 * rig.R))
    reference = len(layer.nodes) + len(roller.nodes) + 1
    out.write(f"*NODE, NSET=NCENTRE\n{reference}, 0, 0, {CENTRE}\n"
              f"*NODE, NSET=NTURN\n{reference + 1}, 0, 0, {CENTRE}\n")
    points = list(layer.points())
    node_set(out, "NBASE", [n for n, _, _, z in points if z == axes[2][0]])
    node_set(out, "NSYMMETRY", [n for n, _, y, z in points if y == 0 and z > axes[2][0]])
    px, py = rig.patch(axes, size)
    faces = [layer.element(i, j, layer.counts[2] - 1) for j in range(layer.counts[1])
             for i in range(layer.counts[0])
             if abs(axes[0][i] + axes[0][i + 1]) < 2 * px and axes[1][j] < py]
    out.write("*SURFACE, NAME=SLAYER\n" + "".join(f"{e}, S2\n" for e in faces))
    out.write("*SURFACE, NAME=SROLLER\nEROLLER, S1\n")
    out.write(f"*RIGID BODY, NSET=NROLLER, REF NODE={reference}, ROT NODE={reference + 1}\n")


def write_physics(out, args):
    friction = f"*FRICTION\n{rig.MU}, {args.stick_slope}\n"
    out.write(f"""*MATERIAL, NAME=RUBBER
{BULK[args.bulk][0]}
*SOLID SECTION, ELSET=ELAYER, MATERIAL=RUBBER
*SOLID SECTION, ELSET=EROLLER, MATERIAL=RUBBER
*SURFACE INTERACTION, NAME=DRY
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR
{args.stiffness}
{"" if args.frictionless else friction}*CONTACT PAIR, INTERACTION=DRY, TYPE=SURFACE TO SURFACE
SLAYER, SROLLER
*BOUNDARY
NBASE, 1, 3
NSYMMETRY, 2, 2
NCENTRE, 2, 2
NTURN, 1, 1
NTURN, 3, 3
""")


def write_step(out, options, time, boundary, load):
    out.write(f"*STEP{options}, INC=1000\n*STATIC\n{time}\n"
              "*BOUNDARY, OP=NEW\nNBASE, 1, 3\nNSYMMETRY, 2, 2\n"
              f"NCENTRE, 2, 2\nNTURN, 1, 1\nNTURN, 3, 3\n{boundary}")
    if load:
        out.write(f"*CLOAD, OP=NEW\n{load}")
    out.write("*NODE PRINT, NSET=NCENTRE\nU, RF\n*CONTACT PRINT\nCSTR\n"
              "*CONTACT PRINT, MASTER=SROLLER, SLAVE=SLAYER\nCF\n*CONTACT FILE\nCSTR\n*END STEP\n")


def write_deck(args):
    axes = rig.read_axes(args.mesh)
    with open(args.name + ".inp", "w", encoding="utf-8") as out:
        write_bodies(out, axes, args.size)
        write_physics(out, args)
        options = BULK[args.bulk][1]
        still = "NTURN, 2, 2\n"
        part = 1 / args.press_steps
        # The roller is held at its indentation: a given normal force did not converge.
        hold = f"NCENTRE, 3, 3, {-rig.EXACT['d']}\n"
        write_step(out, options, f"{part}, 1., 1e-6, {part}", still + "NCENTRE, 1, 1\n" + hold, "")
        if args.frictionless:
            return
        pull = f"NCENTRE, 1, {rig.FT / 2}\n"
        if args.normal_force:
            write_step(out, options, "1., 1.", still,
                       pull + f"NCENTRE, 3, {-args.normal_force / 2}\n")
        else:
            write_step(out, options, "1., 1.", still + hold, pull)
        # Rolling under a given F_T did not converge: it rolls at the shift of the loaded state.
        # Turning about +y moves the lowest point along -x.
        for k in range(1, args.rolling + 1):
            roll = f"NTURN, 2, 2, {0.2 * k / rig.R}\nNCENTRE, 1, 1, {args.shift + 0.2 * k}\n"
            write_step(out, options, "1., 1.", roll + hold, "")


def centre(name, what):
    """What *NODE PRINT wrote of the roller's centre at the end of each increment."""
    text = open(name + ".dat", encoding="utf-8").read()
    pattern = rf" {what} [^\n]* time +(\S+)\s+\d+ +(\S+) +(\S+) +(\S+)"
    return [[float(v) for v in found] for found in re.findall(pattern, text)]


def contact_radius(name, increment):
    """Of the circle whose half has the area [mm^2] that *CONTACT PRINT, CF reports [mm]."""
    text = open(name + ".dat", encoding="utf-8").read()
    areas = re.findall(r"shear force \(size\)\s+(\S+)", text)
    return float(np.sqrt(2 * float(areas[increment]) / np.pi))


def contact_points(name):
    """p, t1, t2 [MPa] at the contact's integration points, one array per increment."""
    blocks = open(name + ".dat", encoding="utf-8").read().split("contact stress (slave")[1:]
    rows = [re.findall(r"^ +\d+ +\d+ +(\S+) +(\S+) +(\S+)$", block, re.M) for block in blocks]
    return [np.array(row, dtype=float) for row in rows]


def nodal_pressures(name):
    """Points [mm] and CPRESS [MPa] of the surface's corner and mid nodes, one per increment."""
    points, blocks, mode = {}, [], None
    for line in open(name + ".frd", encoding="utf-8"):
        if line.startswith("    2C"):
            mode = "points"
        elif line.startswith(" -4"):
            mode = "contact" if "CONTACT" in line else None
            blocks += [{}] if mode else []
        elif line.startswith(" -3"):
            mode = None
        elif line.startswith(" -1") and mode:
            node, values = int(line[3:13]), line[13:].rstrip("\n")
            numbers = [float(values[k:k + 12]) for k in range(0, len(values), 12)]
            if mode == "points":
                points[node] = numbers
            else:
                blocks[-1][node] = numbers[3]
    return points, blocks


def read(args):
    shifts, forces = centre(args.name, "displacements"), centre(args.name, "forces")
    loaded = next((i for i, row in enumerate(shifts) if row[1] != 0), len(shifts) - 1)
    pressed = loaded - 1 if shifts[loaded][1] else loaded
    p, t1, t2 = contact_points(args.name)[loaded].T
    points, blocks = nodal_pressures(args.name)
    top = {}  # the roller's lowest node lies on the layer's and comes after it
    for n, xyz in sorted(points.items()):
        if xyz[2] == 0 and n in blocks[loaded]:
            top.setdefault(tuple(xyz), n)
    nodes = list(top.values())
    x, y, _ = np.array([points[n] for n in nodes]).T
    return {"d": -shifts[loaded][3], "force": -2 * forces[loaded][3],
            "u_stat": shifts[loaded][1],
            "a": contact_radius(args.name, loaded),
            "pressed": {"d": -shifts[pressed][3], "force": -2 * forces[pressed][3],
                        "a": contact_radius(args.name, pressed),
                        "p0": max(blocks[pressed][n] for n in nodes)},
            "excess": rig.friction_excess(p, t1, t2), "p_peak_point": float(p.max()),
            "p_least_point": float(p.min()), "increments": len(shifts)} \
        | exact_layer.pressure_summary(x, y, np.array([blocks[loaded][n] for n in nodes]))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("action", choices=["deck", "read"])
    parser.add_argument("name", help="of the deck, without .inp")
    parser.add_argument("--mesh", help="written by tricontact mesh")
    parser.add_argument("--size", type=float, default=1.0, help="element at the contact [mm]")
    parser.add_argument("--bulk", choices=BULK, default="linear")
    parser.add_argument("--normal-force", type=float,
                        help="[N] acts with F_T, instead of the indentation being held")
    parser.add_argument("--press-steps", type=int, default=20)
    parser.add_argument("--frictionless", action="store_true", help="pressing only")
    parser.add_argument("--rolling", type=int, default=0, help="increments of 0.2 mm")
    parser.add_argument("--shift", type=float, default=0.0, help="at which it rolls [mm]")
    parser.add_argument("--stiffness", type=float, default=50 * rig.E, help="penalty [MPa/mm]")
    parser.add_argument("--stick-slope", type=float, default=50 * rig.E, help="[MPa/mm]")
    args = parser.parse_args()
    if args.action == "deck":
        write_deck(args)
    else:
        print(json.dumps(read(args)))


if __name__ == "__main__":
    main()
