#include <fmt/format.h>

#include "benchmarks/decks/deck_family.h"
#include "benchmarks/decks/graded_line.h"
#include "benchmarks/decks/script_text.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

// The surface's traction is K times the penetration of the undeformed profile: a semi-smooth Newton
// iteration, whose active set is told at the points of integration by the last displacement.
constexpr const char* freefem_template =
    R"(// @name@, @n@ elements in the contact radius @a@ mm; units mm, N, MPa.
// @words@; penalty, linear kinematics.
// Run: FreeFem++ -nw @job@.edp        Writes: @job@.csv
verbosity = 0;
real young = @young@, poisson = @poisson@, K = @stiffness@;   // K [MPa/mm]
real lambda = young*poisson/((1 + poisson)*(1 - 2*poisson)), shear = young/(2*(1 + poisson));
// Between the undeformed surfaces [mm]; the indenter ends at @end@ mm.
func real gap(real r) { if (r > @end@) return 1e9; return @gap@; }

// Nodes along the surface and upwards from the base.
real[int] X = [@x@];
real[int] Z = [@z@];
int nx = X.n - 1, nz = Z.n - 1;
mesh Th = square(nx, nz, [X[int(x*nx + 0.5)], Z[int(y*nz + 0.5)]]@flags@);
@place@fespace Vh(Th, [@element@, @element@]);
Vh [u, w] = [0, 0], [v, q], [uo, wo] = [0, 0];
@weight@

real depth = @depth@;
varf stiff([u, w], [v, q])
    = int2d(Th)(weight*(@elastic@))
    + int1d(Th, 3, qforder=9)(weight*@normal@K*(wo + depth - gap(x) > 0)*w*q)
    + @support@ + on(4, u=0);
varf pushed([u, w], [v, q])
    = int1d(Th, 3, qforder=9)(-weight*@normal@K*(wo + depth - gap(x) > 0)*(depth - gap(x))*q)
    + @support@ + on(4, u=0);

func real normalForce() {
    return @share@int1d(Th, 3, qforder=9)(weight*@normal@K*max(0., w + depth - gap(x)));
}
// F_N at a depth [@force_unit@].
func real press(real d) {
    depth = d;
    real force = -1;
    for (int i = 0; i < 60; ++i) {
        uo[] = u[];
        matrix A = stiff(Vh, Vh, solver=sparsesolver);
        real[int] b = pushed(0, Vh);
        u[] = A^-1*b;
        real last = force;
        force = normalForce();
        if (i > 1 && abs(force - last) <= 1e-10*abs(force)) return force;
    }
    cout << "error: the contact did not converge in 60 iterations" << endl;
    exit(1);
    return 0;
}
@control@
ofstream table("@job@.csv");
table.precision(10);
table << "# @code@, @element@, penalty @stiffness@ MPa/mm, undeformed surface" << endl;
table << "# normal_force = " << force << " @force_unit@" << endl;
table << "# indentation = " << depth << " mm" << endl;
table << "# size = @size@ mm" << endl;
table << "@column@ [mm],p [MPa]" << endl;
for (int i = 0; i <= nx; ++i) {
    if (X[i] > @reach@) break;
@middle@    real r = @r@;
    table << r << "," << K*max(0., w(r, @height@) + depth - gap(r)) << endl;
}
cout << "normal_force = " << force << " @force_unit@, depth = " << depth << " mm" << endl;
)";

// Pole up; X are lengths of arc from it. The pressure acts on the area of the plane: N.y of that of
// the arc.
constexpr const char* freefem_place = R"(real R = @round@;
Th = movemesh(Th, [(1 + y/R)*R*sin(x/R) - y*x/(R*pi), R*((1 + y/R)*cos(x/R) - 1)]);
)";
constexpr const char* freefem_middle = R"(    if (i > 0) {
        real m = (X[i - 1] + X[i])/2;
        table << m << "," << K*max(0., w(m, 0.) + depth - gap(m)) << endl;
    }
)";
constexpr const char* freefem_round_middle = R"(    if (i > 0) {
        real m = R*(sin(X[i - 1]/R) + sin(X[i]/R))/2, h = R*(cos(X[i - 1]/R) + cos(X[i]/R))/2 - R;
        table << m << "," << K*max(0., w(m, h) + depth - gap(m)) << endl;
    }
)";

std::string freefem_support(const DeckModel& model) {
    if (model.round_radius == 0) return "on(1, u=0, w=0)";
    return model.has_sliding_base ? "on(1, w=0) + on(2, w=0)" : "on(1, u=0, w=0) + on(2, u=0, w=0)";
}

constexpr const char* freefem_depth = R"(real force = press(@target@);
)";
// Secants: the force grows with the depth.
constexpr const char* freefem_force =
    R"(real target = @target@, d0 = 0, f0 = 0, d1 = @depth_scale@, force = press(d1);
for (int i = 0; i < 40 && abs(force - target) > 1e-9*target; ++i) {
    real next = d1 + (target - force)*(d1 - d0)/(force - f0);
    d0 = d1; f0 = force; d1 = next;
    force = press(d1);
}
if (abs(force - target) > 1e-9*target) { cout << "error: no depth has this force" << endl; exit(1); }
)";

}  // namespace

DeckFamily freefem_family(const DeckModel& model, const DeckWishes& wishes) {
    if (model.upper) return freefem_pair_family(model, wishes);
    if (model.shape == DeckModel::Shape::half || model.mu > 0)
        throw contact::InputError(
            "deck: the deck for FreeFem++ is axisymmetric or plane and frictionless; take calculix "
            "or getfem");
    const std::string element = wishes.elements.empty() ? "P2" : wishes.elements;
    if (element != "P1" && element != "P2")
        throw contact::InputError("deck: elements " + element +
                                  " are none of FreeFem++'s deck; choose of P2, P1");
    const bool is_plane = model.shape == DeckModel::Shape::plane, is_round = model.round_radius > 0;
    DeckFamily family;
    family.code = "FreeFem++ 4.11";
    family.elements = element;
    family.method = "penalty";
    family.kinematics = "undeformed";
    family.has_stiffness = true;

    for (int level = 0; level < levels_of(model, wishes); ++level) {
        const DeckLines lines = deck_lines(model, coarsest_elements(model), level);
        const std::vector<double> heights = heights_of(lines);
        const std::string job = add_run(family, model);
        DeckRun& run = family.runs.back();
        const std::string control = filled(
            model.last().is_force ? freefem_force : freefem_depth,
            {{"target", number(model.last().normal)}, {"depth_scale", number(model.depth_scale)}});
        const std::string elastic =
            is_plane ? "lambda*(dx(u) + dy(w))*(dx(v) + dy(q))\n        + 2*shear*(dx(u)*dx(v) + "
                       "dy(w)*dy(q))"
                       " + shear*(dy(u) + dx(w))*(dy(v) + dx(q))"
                     : "lambda*(dx(u) + u/x + dy(w))*(dx(v) + v/x + dy(q))\n        + "
                       "2*shear*(dx(u)*dx(v)"
                       " + u*v/(x*x) + dy(w)*dy(q)) + shear*(dy(u) + dx(w))*(dy(v) + dx(q))";
        run.files.push_back(
            {job + ".edp",
             filled(
                 freefem_template,
                 {{"control", control},
                  {"name", model.name},
                  {"n", std::to_string(run.n)},
                  {"a", number(model.a)},
                  {"job", job},
                  {"young", number(model.young)},
                  {"poisson", number(model.poisson)},
                  {"stiffness", number(model.stiffness)},
                  {"gap", model.gap},
                  {"end", number(model.indenter_reach * (1 + 1e-9))},
                  {"x", number_list(lines.x)},
                  {"z", number_list(heights)},
                  {"element", element},
                  {"weight", is_plane ? "func weight = 1;" : "func weight = 2*pi*x;"},
                  {"elastic", elastic},
                  {"share", is_plane ? "2*" : ""},
                  {"depth", number(model.depth_scale)},
                  {"code", family.code},
                  {"force_unit", is_plane ? "N/mm" : "N"},
                  {"size", number(run.size)},
                  {"column", is_plane ? "x" : "r"},
                  {"words", body_words(model)},
                  {"place",
                   is_round ? filled(freefem_place, {{"round", number(model.round_radius)}}) : ""},
                  // Diagonals through the corner in the flat face, whose angle is flat.
                  {"flags", is_round ? ", flags=3" : ""},
                  {"normal", is_round ? "N.y*" : ""},
                  {"support", freefem_support(model)},
                  {"r", is_round ? "R*sin(X[i]/R)" : "X[i]"},
                  {"height", is_round ? "R*cos(X[i]/R) - R" : "0."},
                  {"reach", number(model.lattice_reach())},
                  {"middle", element == "P1" ? ""
                             : is_round      ? freefem_round_middle
                                             : freefem_middle}})});
        run.command = "FreeFem++ -nw " + job + ".edp";
        run.field = job + ".csv";
    }
    return family;
}

}  // namespace tricontact::benchmarks
