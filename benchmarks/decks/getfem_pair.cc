#include <fmt/format.h>

#include "benchmarks/decks/deck_family.h"
#include "benchmarks/decks/getfem_words.h"
#include "benchmarks/decks/pair_bodies.h"
#include "benchmarks/decks/script_text.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

// As in FreeFem++'s deck of two bodies: condensed bodies, linear pressures on both.
constexpr const char* getfem_pair_template =
    R"(# @name@, @n@ elements in the contact radius @a@ mm; units mm, N, MPa.
# Two elastic bodies, pressures linear between points of the lower one (mortar), undeformed surfaces.
# Run: /usr/bin/python3 @job@.py        Reads: @job@_lower.txt, @job@_upper.txt        Writes: @job@.csv
import getfem as gf
import numpy as np
from numpy import abs, cos, sqrt
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import splu

gf.util('trace level', 0)
gf.util('warning level', 0)
CONTACT, LOADED = 1, 2
S = np.array([@points@])   # along the surface [mm]
ALONG, WEIGHT = '@along@', '@weight@'
NORMAL = '@normal@'   # the direction that the upper body is pressed in
AREA = f'{WEIGHT}*abs({NORMAL}.Normal)*@stretch@'

def gap(r):
    """Between the undeformed surfaces along their common normal [mm]."""
    return @gap@

def read(name):
    """Nodes and sets of a body."""
    sets = {}
    with open(name) as file:
        for line in file:
            key, count = line.split()
            rows = [file.readline().split() for _ in range(int(count))]
            sets[key] = np.array(rows, float if key == 'nodes' else int)
    return sets

def hat(k):
    """The pressure that is 1 at S[k] and 0 at the other points."""
    rising = f'({ALONG}-({S[k - 1]!r}))/{S[k] - S[k - 1]!r}' if k > 0 else '1'
    falling = f'({S[k + 1]!r}-{ALONG})/{S[k + 1] - S[k]!r}' if k + 1 < len(S) else rising
    if k + 1 == len(S):
        return f'pos_part({rising})*Heaviside({S[k]!r}+1e-9-{ALONG})'
    return f'pos_part(min(1,min({rising},{falling})))'

def body(name, young, poisson, pressure):
    """Compliance of the pressures' points along NORMAL, and how the load moves them there."""
    sets = read(f'@job@_{name}.txt')
    nodes = sets['nodes']
    mesh = gf.Mesh('empty', 2)
    for element in sets['elements']:
        mesh.add_convex(gf.GeoTrans('GT_Q2_INCOMPLETE(2)'), nodes[element[[0, 4, 1, 7, 5, 3, 6, 2]]].T)
    for region, key in ((CONTACT, 'contact'), (LOADED, 'loaded')):
        if len(sets[key]):
            at = mesh.pid_from_coords(nodes[np.unique(sets[key])].T)
            mesh.set_region(region, mesh.faces_from_pid(at))
    mf = gf.MeshFem(mesh, 2)
    mf.set_fem(gf.Fem('FEM_QK(2, 2)'))
    mim = gf.MeshIm(mesh, gf.Integ('IM_GAUSS_PARALLELEPIPED(2, 8)'))
    md = gf.Model('real')
    md.add_fem_variable('u', mf)
    md.add_initialized_data('la', young*poisson/((1 + poisson)*(1 - 2*poisson)))
    md.add_initialized_data('mu', young/(2*(1 + poisson)))
    stiff = gf.asm_generic(mim, 2, '@elastic@', -1, md)
    K = csc_matrix((stiff.csc_val(), stiff.csc_ind()[1], stiff.csc_ind()[0]))
    place = mf.basic_dof_nodes()
    place = place[0] + 1j*place[1]
    held = np.zeros(len(place), bool)
    for key, parts in (('held', (0, 1)), ('axis', (0,))):
        for node in nodes[sets[key].ravel()]:
            near = np.flatnonzero(abs(place - (node[0] + 1j*node[1])) < 1e-7)
            held[[i for i in near if i % 2 in parts]] = True
    free = np.flatnonzero(~held)
    factor = splu(K[free][:, free].tocsc())
    P = np.array([gf.asm_generic(mim, 1, f'{AREA}*{hat(k)}*({NORMAL}.Test_u)', CONTACT, md)
                  for k in range(len(S))])[:, free]
    W = np.array([gf.asm_generic(mim, 0, f'{AREA}*{hat(k)}*(-[0;1].{NORMAL})', CONTACT, md)
                  for k in range(len(S))]).ravel()
    G = np.array([gf.asm_generic(mim, 0, f'{AREA}*{hat(k)}*(@getfem_gap@)', CONTACT, md)
                  for k in range(len(S))]).ravel()
    C = P.dot(factor.solve(P.T))
    middle = np.flatnonzero(abs(place[free] - (nodes[sets['contact'][0, 0]].dot([1, 1j]))) < 1e-7)[-1]
    down = -factor.solve(P.T)[middle]   # of the middle of the surface under each pressure
    if not len(sets['loaded']):
        return C, 0, W, G, down
    load = gf.asm_generic(mim, 1, f'-{WEIGHT}*{pressure!r}*Test_u(2)', LOADED, md)[free]
    return C, P.dot(factor.solve(load)), W, G, down

C, _, W, G, down = body('lower', @young_lower@, @poisson_lower@, 0)
upper, U, *_ = body('upper', @young_upper@, @poisson_upper@, @pressure@)
C = C + upper
# Pressures of what touches; the depth too where the force is given.
by_force, target = @by_force@, @target@
depth = 0 if by_force else target
touches = np.ones(len(S), bool)
for _ in range(100):
    on = np.flatnonzero(touches)
    right = (U - G)[on] if by_force else (U - G + depth*W)[on]
    if by_force:
        matrix = np.block([[C[np.ix_(on, on)], -W[on, None]], [-W[None, on], np.zeros((1, 1))]])
        *values, depth = np.linalg.solve(matrix, np.append(right, -target))
    else:
        values = np.linalg.solve(C[np.ix_(on, on)], right)
    p = np.zeros(len(S))
    p[on] = values
    g = C.dot(p) + G - U - depth*W
    now = np.where(touches, p >= 0, g < -1e-12*W.max())
    if (now == touches).all():
        break
    touches = now
else:
    raise SystemExit('error: the contact did not settle in 100 iterations')
force = @share@float(p.dot(W))
with open('@job@.csv', 'w') as table:
    table.write('# @code@, @element@, two bodies, mortar, undeformed surfaces\n')
    table.write(f'# normal_force = {force:.10g} @force_unit@\n')
@indentation@    table.write(f'# middle of the lower surface: {down.dot(p):.10g} mm down\n')
    table.write('# size = @size@ mm\n@column@ [mm],p [MPa]\n')
    for x, value in zip(@place@, p):
        table.write(f'{x:.10g},{value:.10g}\n')
print(f'normal_force = {force:.10g} @force_unit@, depth = {depth:.10g} mm')
)";

std::string getfem_pair_text(const DeckModel& model, const BodyPair& pair, const DeckRun& run,
                             const DeckFamily& family, const std::string& job) {
    const bool is_plane = model.shape == DeckModel::Shape::plane,
               is_hole = model.conforming_radius > 0, is_force = model.last().is_force;
    const std::string radius = number(model.conforming_radius);
    const std::string along = is_hole ? radius + "*atan2(X(1),-X(2))" : "X(1)";
    return filled(
        getfem_pair_template,
        pair_values(
            model, pair, run, family, job,
            {{"along", along},
             {"normal", is_hole ? "(X/Norm(X))" : "[0;-1]"},
             {"stretch", is_hole ? radius + "/Norm(X)" : "1"},
             {"weight", is_plane ? "1" : "(2*pi*X(1))"},
             {"getfem_gap", with_radius(model.gap, along)},
             {"elastic", getfem_elasticity(model)},
             {"young_lower", number(model.young)},
             {"poisson_lower", number(model.poisson)},
             {"young_upper", number(model.upper->young)},
             {"poisson_upper", number(model.upper->poisson)},
             {"pressure",
              number(model.loaded_area > 0 ? model.last().normal / model.loaded_area : 0)},
             {"by_force", is_force ? "True" : "False"},
             {"indentation",
              model.has_depth ? "    table.write(f'# indentation = {depth:.10g} mm\\n')\n" : ""},
             {"place", is_hole ? fmt::format("{0}*np.sin(S/{0})", radius) : "S"}}));
}

}  // namespace

DeckFamily getfem_pair_family(const DeckModel& model, const DeckWishes& wishes) {
    check_pair_deck(model, "GetFEM");
    if (!wishes.elements.empty() && wishes.elements != "Q2")
        throw contact::InputError("deck: elements " + wishes.elements +
                                  " are none of GetFEM's deck of two bodies; choose of Q2");
    DeckFamily family;
    family.code = getfem_version;
    family.elements = "Q2";
    family.method = "mortar";
    family.kinematics = "undeformed";
    for (int level = 0; level < levels_of(model, wishes); ++level) {
        const std::string job = add_run(family, model);
        DeckRun& run = family.runs.back();
        const BodyPair pair = body_pair(model, coarsest_elements(model), level, true);
        run.files.push_back({job + "_lower.txt", plain_mesh(pair.lower)});
        run.files.push_back({job + "_upper.txt", plain_mesh(pair.upper)});
        run.files.push_back({job + ".py", getfem_pair_text(model, pair, run, family, job)});
        run.command = "/usr/bin/python3 " + job + ".py";
        run.field = job + ".csv";
    }
    return family;
}

}  // namespace tricontact::benchmarks
