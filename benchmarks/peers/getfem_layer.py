"""GetFEM on the rig's layer: Q2/Q1 incompressible block, linear or neo-Hookean, rigid paraboloid,
Coulomb friction by the augmented Lagrangian of Alart and Curnier in its integral form
(GetFEM's operator `Coulomb_friction_coupled_projection`, which its contact bricks assemble too).
Prints one JSON object. Run by run.sh; needs Debian's python3-getfem, hence /usr/bin/python3."""

import argparse
import json
import resource
import sys

import getfem as gf
import numpy as np

import exact_layer
import getfem_bulk as bulk
import layer_grid as rig

CONTACT, BASE, SYMMETRY = 1, 3, 5

# s, d: shift along x and indentation of the roller; W: its offset by rolling.
RESULTANT = "(lam(3)+FN/(2*Area))*Test_d + (lam(1)-FT/(2*Area))*Test_s"
# What the roller's own material does in a step: shift, descent, and turning about the contact.
ROLLER = "[s-s_old;0;d_old-d-(W-W_old)/R*(X(1)+u(1)-W-s)]"
# where a surface point lies from the roller's axis
OFFSET = {"linear": "[X(1)-W;X(2)]", "deformed": "[X(1)+u(1)-W-s;X(2)+u(2)]"}
PROJECTION = {
    # gap and normal in the undeformed configuration: z_roller - z_surface at X
    "linear": "Coulomb_friction_coupled_projection(lam, [0;0;1], u-u_old-[1;0;0]*(s-s_old),"
              f"(Norm_sqr({OFFSET['linear']})/(2*R)-d-u(3)), Mu, Aug)",
    # both at the displaced point x = X + u: distance and normal to the first order of the slope
    "deformed": "Coulomb_friction_coupled_projection(lam,"
                "Normalized([-(X(1)+u(1)-W-s)/R;-(X(2)+u(2))/R;1]),"
                f"u-u_old-{ROLLER},"
                f"(Norm_sqr({OFFSET['deformed']})/(2*R)-d-u(3))"
                f"/sqrt(1+Norm_sqr({OFFSET['deformed']})/sqr(R)), Mu, Aug)",
}


def cpu():
    return resource.getrusage(resource.RUSAGE_SELF).ru_utime


def boundaries(mesh, size, axes):
    faces = mesh.outer_faces()
    normals = mesh.normal_of_faces(faces)
    px, py = rig.patch(axes, size)

    def middle(face):
        points = mesh.pts()[:, mesh.pid_in_faces(np.array([[face[0]], [face[1]]]))]
        return points.mean(axis=1)

    top = faces[:, normals[2] > 0.9]
    inside = [i for i in range(top.shape[1])
              if abs(middle(top[:, i])[0]) < px and middle(top[:, i])[1] < py]
    mesh.set_region(CONTACT, top[:, inside])
    mesh.set_region(BASE, faces[:, normals[2] < -0.9])
    side = faces[:, normals[1] < -0.9]
    mesh.set_region(SYMMETRY, side)
    return 2 * px * py


def model(mesh, area, args):
    fem_u, fem_q, fem_lam = gf.MeshFem(mesh, 3), gf.MeshFem(mesh, 1), gf.MeshFem(mesh, 3)
    if args.element == "20":
        fem_u.set_fem(gf.Fem("FEM_Q2_INCOMPLETE(3)"))
    else:
        fem_u.set_classical_fem(2)
    fem_q.set_classical_fem(1)
    fem_lam.set_classical_fem(args.multiplier)
    volume = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(3,4)"))
    surface = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(3,6)"))
    md = gf.Model("real")
    md.add_fem_variable("u", fem_u)
    md.add_fem_data("u_old", fem_u)
    md.add_filtered_fem_variable("lam", fem_lam, CONTACT)
    for name in ("d", "s"):
        md.add_variable(name, 1)
    values = {"s_old": 0, "d_old": 0, "W": 0, "W_old": 0, "R": rig.R, "G": rig.G,
              "Mu": 0 if args.frictionless else rig.MU, "Aug": args.augmentation,
              "FN": rig.FN, "FT": 0, "Area": area}
    for name, value in values.items():
        md.add_initialized_data(name, value)
    if args.volume == "mixed":
        md.add_fem_variable("q", fem_q)
        bulk.add_incompressible(md, volume, args.bulk, "Grad_u")
    else:
        reduced = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(3,3)"))
        bulk.add_nearly_incompressible(md, volume, reduced, args.bulk, "Grad_u", args.bulk_ratio)
    md.add_Dirichlet_condition_with_simplification("u", BASE)
    md.add_linear_term(volume, "1e6*G*u(2)*Test_u(2)", SYMMETRY)
    if args.frictionless:  # nothing else holds the shift
        md.add_linear_term(surface, "s*Test_s", CONTACT)
    contact = PROJECTION[args.kinematics]
    md.add_nonlinear_term(surface, f"-lam.Test_u + (1/Aug)*(lam-{contact}).Test_lam + {RESULTANT}",
                          CONTACT)
    return md, surface


class Run:
    """Steps of one load path; every solved step becomes the friction history of the next."""

    def __init__(self, md, verbose):
        self.md, self.verbose, self.iterations = md, verbose, 0
        md.set_variable("d", [0.02])

    def step(self, **data):
        for name, value in data.items():
            self.md.set_variable(name, [value])
        iterations = bulk.solve(self.md, data, self.verbose)
        self.iterations += iterations
        self.md.set_variable("u_old", self.md.variable("u"))
        for name in ("s", "d", "W"):
            self.md.set_variable(name + "_old", self.md.variable(name))
        print(f"{data} {iterations} iterations, {cpu():.1f} s", file=sys.stderr, flush=True)


def traction_nodes(md):
    """Coordinates [mm] of the traction's nodes, 3 x n."""
    fem = md.mesh_fem_of_variable("lam")
    return fem.basic_dof_nodes(fem.basic_dof_on_region(CONTACT))[:, ::3]


def press(run, steps):
    """F_N in equal steps, with friction unless it is left out."""
    for k in range(1, steps + 1):
        run.step(FN=rig.FN * k / steps)


def normal_state(md, surface, kinematics):
    def load(moment):
        return gf.asm_generic(surface, 0, f"-lam(3)*{moment}", CONTACT, md)

    lam = md.variable("lam").reshape(-1, 3)
    p = -lam[:, 2]
    offset = OFFSET[kinematics]
    gap = f"(Norm_sqr({offset})/(2*R)-d-u(3))"
    area = gf.asm_generic(surface, 0, f"Heaviside(-lam(3)-Aug*{gap})", CONTACT, md)
    nodes = traction_nodes(md)
    return {"d": float(md.variable("d")[0]), "a": float(np.sqrt(2 * area / np.pi)),
            "effective_radius": bulk.effective_radius(load("1"), load(f"Norm_sqr({offset})"))} \
        | exact_layer.pressure_summary(nodes[0], nodes[1], p)


def excess(md):
    lam = md.variable("lam").reshape(-1, 3)
    return rig.friction_excess(-lam[:, 2], lam[:, 0], lam[:, 1])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("mesh", help="written by tricontact mesh")
    parser.add_argument("size", type=float, help="element at the contact [mm]")
    parser.add_argument("--bulk", choices=bulk.DISTORTION, default="linear")
    parser.add_argument("--kinematics", choices=PROJECTION, default="linear", help="of the contact")
    parser.add_argument("--press-steps", type=int, default=20)
    parser.add_argument("--frictionless", action="store_true", help="pressing only")
    parser.add_argument("--rolling", type=int, default=0, help="increments of 0.2 mm")
    parser.add_argument("--multiplier", type=int, default=1, help="degree of the traction")
    parser.add_argument("--augmentation", type=float, default=10.0, help="[MPa/mm]")
    parser.add_argument("--element", choices=["27", "20"], default="27", help="nodes")
    parser.add_argument("--volume", choices=["mixed", "reduced"], default="mixed",
                        help="pressure of its own (Q1) or K tr(eps) at 2 x 2 x 2 points")
    parser.add_argument("--bulk-ratio", type=float, default=5000.0, help="K/G of 'reduced'")
    parser.add_argument("--verbose", action="store_true")
    args = parser.parse_args()
    axes = rig.read_axes(args.mesh)
    mesh = gf.Mesh("cartesian", *axes)
    area = boundaries(mesh, args.size, axes)
    md, surface = model(mesh, area, args)
    run = Run(md, args.verbose)
    press(run, args.press_steps)
    result = {"size": args.size, "bulk": args.bulk, "kinematics": args.kinematics,
              "steps": args.press_steps, "unknowns": int(md.nbdof())} \
        | normal_state(md, surface, args.kinematics)
    shift = float(md.variable("s")[0])
    if args.frictionless:
        print(json.dumps(result))
        return
    run.step(FT=rig.FT)
    result |= {"u_stat": float(md.variable("s")[0]) - shift, "excess": excess(md),
               "iterations": run.iterations, "cpu_loaded": cpu()}
    for k in range(1, args.rolling + 1):
        run.step(W=0.2 * k)
    if args.rolling:
        result |= {"cpu_per_increment": (cpu() - result["cpu_loaded"]) / args.rolling,
                   "excess_rolled": excess(md)}
    result["memory_MB"] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(json.dumps(result))


if __name__ == "__main__":
    main()
