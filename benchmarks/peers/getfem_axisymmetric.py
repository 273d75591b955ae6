"""GetFEM, axisymmetric: the rig's frictionless layer, strains and contact taken as small or as
they are. Q2/Q1 incompressible, linear pressure of the contact. Prints one JSON object. Run by
run.sh; needs Debian's python3-getfem, hence /usr/bin/python3. Coordinates r, z; surface z = 0."""

import argparse
import json

import getfem as gf
import numpy as np

import getfem_bulk as bulk
import layer_grid as rig

CONTACT, BASE, AXIS = 1, 2, 3
OUTER = 48.0  # radius of the block [mm]: half the width of the other scripts' block
FINE = 8.0  # square elements up to this radius [mm]

# of the displacement in r, hoop, z
GRADIENT = "[Grad_u(1,1), 0, Grad_u(1,2); 0, u(1)/X(1), 0; Grad_u(2,1), 0, Grad_u(2,2)]"
# radius at which the contact takes gap and normal of the paraboloid, slope there
RADIUS = {"linear": "X(1)", "deformed": "(X(1)+u(1))"}
SLOPE = {"linear": "0", "deformed": "((X(1)+u(1))/R)"}


def layer_mesh(size):
    outside = np.geomspace(FINE, OUTER, 17)
    r = np.append(np.linspace(0, FINE, round(FINE / size) + 1), outside[1:])
    mesh = gf.Mesh("cartesian", r, np.linspace(-rig.DEPTH, 0, round(rig.DEPTH / size) + 1))
    for region, direction in (CONTACT, [0, 1]), (BASE, [0, -1]), (AXIS, [-1, 0]):
        mesh.set_region(region, mesh.outer_faces_with_direction(direction, 0.01))
    return mesh


def add_contact(md, integration, kinematics):
    """p per undeformed area acts along the paraboloid's normal n; d follows from F_N."""
    radius, slope = RADIUS[kinematics], SLOPE[kinematics]
    cosine = f"(1/sqrt(1+sqr({slope})))"
    gap = f"(sqr({radius})/(2*R)-d-u(2))*{cosine}"
    md.add_nonlinear_term(
        integration, f"X(1)*(p*{cosine}*(Test_u(2)-{slope}*Test_u(1))"
                     f"+ (1/Aug)*(p-pos_part(p-Aug*{gap}))*Test_p"
                     f"+ (FN/Weight-p*{cosine})*Test_d)", CONTACT)


def model(mesh, args):
    md = gf.Model("real")
    for name, components, degree in ("u", 2, 2), ("q", 1, 1), ("p", 1, 1):
        fem = gf.MeshFem(mesh, components)
        fem.set_classical_fem(degree)
        if name == "p":
            md.add_filtered_fem_variable(name, fem, CONTACT)
        else:
            md.add_fem_variable(name, fem)
    md.add_variable("d", 1)
    md.set_variable("d", [0.02])
    integration = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(2,6)"))
    values = {"R": rig.R, "G": rig.G, "FN": 0, "Aug": 10.0, "Weight": np.pi * OUTER**2}
    for name, value in values.items():
        md.add_initialized_data(name, value)
    bulk.add_incompressible(md, integration, args.bulk, GRADIENT, "X(1)")
    md.add_Dirichlet_condition_with_simplification("u", BASE)
    md.add_linear_term(integration, "1e6*G*u(1)*Test_u(1)", AXIS)
    add_contact(md, integration, args.kinematics)
    return md, integration


def state(md, mesh, integration, kinematics):
    def total(expression):
        return gf.asm_generic(integration, 0, f"X(1)*p*{expression}", CONTACT, md)

    axis = np.array([[0.0], [0.0]])
    pressure = {"linear": "p", "deformed": "p/sqr(1+Grad_u(1,1))"}  # u_r = r u_r,r on the axis
    return {"d": float(md.variable("d")[0]),
            "p0": float(md.interpolation(pressure[kinematics], axis, mesh)),
            "effective_radius": bulk.effective_radius(total("1"),
                                                      total(f"sqr({RADIUS[kinematics]})"))}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("size", type=float, help="element [mm]")
    parser.add_argument("--bulk", choices=bulk.DISTORTION, default="linear")
    parser.add_argument("--kinematics", choices=RADIUS, default="linear", help="of the contact")
    parser.add_argument("--press-steps", type=int, default=5)
    args = parser.parse_args()
    mesh = layer_mesh(args.size)
    md, integration = model(mesh, args)
    for k in range(1, args.press_steps + 1):
        md.set_variable("FN", [rig.FN * k / args.press_steps])
        bulk.solve(md, f"step {k}")
    print(json.dumps(vars(args) | state(md, mesh, integration, args.kinematics)))


if __name__ == "__main__":
    main()
