"""What the GetFEM scripts share: strain energies of the layer by the displacement gradient H,
radius of the contact from its pressure, Newton's method."""

import numpy as np

# energy of distortion, stress-free at rest; change of volume
DISTORTION = {"linear": "G*Norm_sqr(Sym(H))",
              "neo-hookean": "(G/2*(Norm_sqr(Id(3)+H)-3) - G*log(Det(Id(3)+H)))"}
DILATATION = {"linear": "Trace(H)", "neo-hookean": "(Det(Id(3)+H)-1)"}


def add_energy(md, integration, bulk, expression, gradient):
    """A linear term is assembled once, a nonlinear one in every iteration."""
    add = md.add_linear_term if bulk == "linear" else md.add_nonlinear_term
    add(integration, f"Def H := {gradient}; {expression}")


def add_incompressible(md, integration, bulk, gradient, weight="1"):
    """Energy of an incompressible layer whose pressure q is an unknown of its own."""
    add_energy(md, integration, bulk,
               f"{weight}*({DISTORTION[bulk]} - q*{DILATATION[bulk]})", gradient)


def add_nearly_incompressible(md, integration, reduced, bulk, gradient, ratio):
    """The same with a bulk modulus of `ratio` G, integrated at fewer points."""
    add_energy(md, integration, bulk, DISTORTION[bulk], gradient)
    add_energy(md, reduced, bulk, f"{ratio}*G/2*sqr({DILATATION[bulk]})", gradient)


def effective_radius(load, moment):
    """Contact radius [mm] by the moments of p and p r^2; exact for Hertz' pressure."""
    return float(np.sqrt(2.5 * moment / load))


def solve(md, state, verbose=False):
    """Newton iterations of one step."""
    options = ["max_res", 1e-6, "max_iter", 60, "lsolver", "mumps"]
    iterations, converged = md.solve(*options, *(["noisy"] if verbose else []))
    if not converged:
        raise SystemExit(f"not converged after {iterations} iterations: {state}")
    return iterations
