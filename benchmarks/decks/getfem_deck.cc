#include <fmt/format.h>

#include "benchmarks/decks/deck_family.h"
#include "benchmarks/decks/getfem_words.h"
#include "benchmarks/decks/graded_line.h"
#include "benchmarks/decks/script_text.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

constexpr const char* getfem_template =
    R"(# @name@, @n@ elements in the contact radius @a@ mm; units mm, N, MPa.
# @words@; augmented Lagrangian, undeformed surface.
# Run: /usr/bin/python3 @job@.py        Writes: @job@.csv, @job@.vtu
import getfem as gf
import numpy as np

gf.util('trace level', 0)
gf.util('warning level', 0)
young, poisson = @young@, @poisson@
# Nodes along the surface and upwards from the base.
X = np.array([@x@])
Z = np.array([@z@])
mesh = gf.Mesh('@cartesian@', X, Z)
BASE, AXIS, TOP = 1, 2, 3
mesh.set_region(BASE, @base@)
mesh.set_region(AXIS, mesh.outer_faces_with_direction([-1, 0], 0.01))
mesh.set_region(TOP, mesh.outer_faces_in_box([-1e-9, -1e-9], [@reach@, 1e-9]))
@place@
mf_u = gf.MeshFem(mesh, 2)
mf_u.set_fem(gf.Fem('FEM_QK(2, @degree@)'))
mf_p = gf.MeshFem(mesh, 1)   # pressures, on the surface only
mf_p.set_fem(gf.Fem('FEM_QK(2, 1)'))
mim = gf.MeshIm(mesh, gf.Integ('IM_GAUSS_PARALLELEPIPED(2, 8)'))

md = gf.Model('real')
md.add_fem_variable('u', mf_u)
md.add_filtered_fem_variable('p', mf_p, TOP)
@variables@md.add_initialized_data('la', young*poisson/((1 + poisson)*(1 - 2*poisson)))
md.add_initialized_data('mu', young/(2*(1 + poisson)))
md.add_initialized_data('ga', @augmentation@)   # of the augmented Lagrangian [MPa/mm]: matters on coarse meshes only
md.add_linear_term(mim, '@elastic@')
@support@
md.add_linear_term(mim, '1e8*mu*u(1)*Test_u(1)', AXIS)   # u = 0 there
@depth@
# Pressure that the penetration of the undeformed profile asks for.
push = 'pos_part(p + ga*(u(2) + depth - @gap@))'
@contact@@load@@solve@

force = @share@gf.asm_generic(mim, 0, '@weight@*p', TOP, md)
depth = float(np.ravel(md.variable('depth'))[0])
x = X[X <= @reach@]
@middle@pressure = md.interpolation('p', np.array([x, @surface@]), mesh)
@traction@with open('@job@.csv', 'w') as table:
    table.write('# @code@, @element@, augmented Lagrangian, undeformed surface\n')
    table.write(f'# normal_force = {force:.10g} @force_unit@\n# indentation = {depth:.10g} mm\n')
    table.write('# size = @size@ mm\n@heading@\n')
    for row in zip(@columns@):
        table.write(','.join(f'{value:.10g}' for value in row) + '\n')
mf_u.export_to_vtu('@job@.vtu', mf_u, md.variable('u'), 'displacement')
print(f'normal_force = {force:.10g} @force_unit@, depth = {depth:.10g} mm')
)";

// Pole up. The pressure acts on the area of the plane: Normal(2) of that of the arc.
constexpr const char* getfem_place = R"(R = @round@
def place(s, z):
    """Lengths of arc from the pole, and z in the lattice, to r and z in the body."""
    return np.array([(1 + z/R)*R*np.sin(s/R) - z*s/(R*np.pi), R*((1 + z/R)*np.cos(s/R) - 1)])
mesh.set_pts(place(*mesh.pts()))
)";
constexpr const char* getfem_round_points =
    R"(x, z = place(x, 0*x)   # nodes; the middles are those of chords
)";
constexpr const char* getfem_round_middles =
    R"(x, z = (np.insert(c, np.arange(1, len(c)), (c[1:] + c[:-1])/2) for c in (x, z))
)";
constexpr const char* getfem_down = "mesh.outer_faces_with_direction([0, -1], 0.01)";
constexpr const char* getfem_right = "mesh.outer_faces_with_direction([1, 0], 0.01)";

constexpr const char* getfem_frictionless =
    R"(md.add_nonlinear_term(mim, f'@weight@*({push}*Test_u(2) + ({push} - p)/ga*Test_p)', TOP)
)";
// The traction t on the body opposes the slip of a step, u - old: Alart and Curnier (1991).
constexpr const char* getfem_friction = R"(bound = f'friction*{push}'
drag = f'min({bound}, max(-({bound}), t - ga*(u(1) - old(1))))'
md.add_nonlinear_term(mim, f'@weight@*({push}*Test_u(2) - {drag}*Test_u(1)'
                           f' + ({push} - p)/ga*Test_p + ({drag} - t)/ga*Test_t)', TOP)
)";
constexpr const char* getfem_variables =
    R"(md.add_filtered_fem_variable('t', mf_p, TOP)   # tractions along the surface
md.add_fem_data('old', mf_u)   # displacements at the end of the step before
md.add_initialized_data('friction', @mu@)
)";
constexpr const char* getfem_solve =
    R"(iterations, converged = md.solve('max_res', 1e-9, 'max_iter', 100, 'lsearch', 'simplest')
if not converged:
    raise SystemExit('error: the contact did not converge in 100 iterations'))";
constexpr const char* getfem_steps =
    R"(for depth in np.linspace(0, @depth_end@, @increments@ + 1)[1:]:
    md.set_variable('depth', depth)
    iterations, converged = md.solve('max_res', 1e-9, 'max_iter', 100, 'lsearch', 'simplest')
    if not converged:
        raise SystemExit('error: the contact did not converge in 100 iterations')
    md.set_variable('old', md.variable('u')))";

std::string middles_of(const DeckModel& model, bool has_middles) {
    if (model.round_radius > 0)
        return std::string(getfem_round_points) + (has_middles ? getfem_round_middles : "");
    return has_middles ? "x = np.sort(np.concatenate([x, (x[1:] + x[:-1])/2]))\n" : "";
}

}  // namespace

DeckFamily getfem_family(const DeckModel& model, const DeckWishes& wishes) {
    if (model.upper) return getfem_pair_family(model, wishes);
    const bool has_friction = model.mu > 0;
    if (model.shape == DeckModel::Shape::half || model.is_shifted() ||
        (has_friction && (model.has_force() || model.steps.size() > 1)))
        throw contact::InputError(
            "deck: the deck for GetFEM is axisymmetric or plane, with friction pressed to one "
            "depth; take calculix");
    const std::string element = wishes.elements.empty() ? "Q2" : wishes.elements;
    if (element != "Q1" && element != "Q2")
        throw contact::InputError("deck: elements " + element +
                                  " are none of GetFEM's deck; choose of Q2, Q1");
    const bool is_plane = model.shape == DeckModel::Shape::plane, is_force = model.last().is_force;
    DeckFamily family;
    family.code = getfem_version;
    family.elements = element;
    family.method = "augmented-lagrangian";
    family.kinematics = "undeformed";

    for (int level = 0; level < levels_of(model, wishes); ++level) {
        const DeckLines lines = deck_lines(model, coarsest_elements(model), level);
        const std::vector<double> heights = heights_of(lines);
        const std::string job = add_run(family, model);
        DeckRun& run = family.runs.back();
        const std::string depth =
            is_force
                ? fmt::format(
                      "md.add_variable('depth', 1)   # [mm], found\nmd.set_variable('depth', {})",
                      number(model.depth_scale))
                : fmt::format("md.add_initialized_data('depth', {})   # [mm]",
                              number(model.last().normal));
        const std::string load =
            is_force ? fmt::format(
                           "md.add_nonlinear_term(mim, f'@weight@*{{push}}*Test_depth', TOP)\n"
                           "md.add_explicit_rhs('depth', [{}])   # F_N{}\n",
                           number(model.last().normal / (is_plane ? 2 : 1)), is_plane ? "/2" : "")
                     : "";
        run.files.push_back(
            {job + ".py",
             filled(getfem_template,
                    {{"variables", has_friction ? getfem_variables : ""},
                     {"contact", has_friction ? getfem_friction : getfem_frictionless},
                     {"solve", has_friction ? getfem_steps : getfem_solve},
                     {"mu", number(model.mu)},
                     {"depth_end", number(model.last().normal)},
                     {"increments", std::to_string(model.last().increments)},
                     {"traction",
                      has_friction ? "traction = md.interpolation('t', np.array([x, 0*x]), mesh)\n"
                                   : ""},
                     {"heading",
                      std::string("@column@ [mm],p [MPa]") + (has_friction ? ",tx [MPa]" : "")},
                     {"columns", has_friction ? "x, pressure, traction" : "x, pressure"},
                     {"load", load},
                     {"depth", depth},
                     {"name", model.name},
                     {"n", std::to_string(run.n)},
                     {"a", number(model.a)},
                     {"job", job},
                     {"young", number(model.young)},
                     {"poisson", number(model.poisson)},
                     {"augmentation", number(2 * model.stiffness)},
                     {"gap", with_radius(model.gap, "X(1)")},
                     {"x", number_list(lines.x)},
                     {"z", number_list(heights)},
                     {"element", element},
                     {"degree", element.substr(1)},
                     {"weight", std::string(is_plane ? "1" : "2*pi*X(1)") +
                                    (model.round_radius > 0 ? "*Normal(2)" : "")},
                     {"cartesian", model.round_radius > 0 ? "cartesian Q1" : "cartesian"},
                     {"place", model.round_radius > 0
                                   ? filled(getfem_place, {{"round", number(model.round_radius)}})
                                   : ""},
                     {"elastic", getfem_elasticity(model)},
                     {"share", is_plane ? "2*" : ""},
                     {"code", family.code},
                     {"force_unit", is_plane ? "N/mm" : "N"},
                     {"size", number(run.size)},
                     {"column", is_plane ? "x" : "r"},
                     {"reach", number(model.lattice_reach())},
                     {"middle", middles_of(model, element != "Q1")},
                     {"surface", model.round_radius > 0 ? "z" : "0*x"},
                     {"words", body_words(model)},
                     {"base", model.round_radius > 0 ? fmt::format("np.hstack([{},\n    {}])",
                                                                   getfem_down, getfem_right)
                                                     : getfem_down},
                     {"support", model.has_sliding_base
                                     ? "md.add_linear_term(mim, '1e8*mu*u(2)*Test_u(2)', BASE)   # "
                                       "free along itself"
                                     : "md.add_Dirichlet_condition_with_simplification('u', "
                                       "BASE)"}})});
        run.command = "/usr/bin/python3 " + job + ".py";
        run.field = job + ".csv";
    }
    return family;
}

}  // namespace tricontact::benchmarks
