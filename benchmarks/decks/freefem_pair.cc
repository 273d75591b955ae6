#include <fmt/format.h>

#include "benchmarks/decks/deck_family.h"
#include "benchmarks/decks/pair_bodies.h"
#include "benchmarks/decks/script_text.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

// Each body is condensed to the weighted displacements of its surface along n; pressures that are
// linear between the points S act on both (a mortar).
constexpr const char* freefem_pair_template =
    R"(// @name@, @n@ elements in the contact radius @a@ mm; units mm, N, MPa.
// Two elastic bodies, pressures linear between points of the lower one (mortar), undeformed surfaces.
// Run: FreeFem++ -nw @job@.edp        Reads: @job@_lower.msh, @job@_upper.msh        Writes: @job@.csv
verbosity = 0;
real[int] S = [@points@];   // along the surface [mm]
int n = S.n, k = 0;
// Between the undeformed surfaces along their common normal [mm].
func real gap(real r) { return @gap@; }
func real hat(real s) {
    if (k == 0 && s < S[0]) return 1;
    if (s < S[k]) return max(0., (s - S[k - 1])/(S[k] - S[k - 1]));
    if (k == n - 1) return s == S[k];
    return max(0., (S[k + 1] - s)/(S[k + 1] - S[k]));
}
func along = @along@;
func nx = @nx@;   // of the direction that the upper body is pressed in
func ny = @ny@;
func weight = @weight@;
func onto = abs(nx*N.x + ny*N.y)*@stretch@;

real[int, int] C(n, n), B(n + 1, n + 2);
real[int] U(n), G(n), W(n);
C = 0; U = 0;
@lower@@upper@
for (k = 0; k < n; ++k) {
    G[k] = int1d(Tlower, 3, qforder=9)(weight*onto*hat(along)*gap(along));
    W[k] = int1d(Tlower, 3, qforder=9)(-weight*onto*hat(along)*ny);
}
// Unknowns are the pressures of what touches, and the depth where the force is given.
bool byForce = @by_force@;
real target = @target@, depth = target;
real[int] p(n), g(n);
int[int] row(n), touches(n);
touches = 1; p = 0;
func int eliminate(int m) {
    for (int c = 0; c < m; ++c) {
        int pivot = c;
        for (int r = c + 1; r < m; ++r) if (abs(B(r, c)) > abs(B(pivot, c))) pivot = r;
        for (int j = c; j <= m; ++j) { real t = B(c, j); B(c, j) = B(pivot, j); B(pivot, j) = t; }
        for (int r = 0; r < m; ++r) {
            real f = B(r, c)/B(c, c);
            if (r != c) for (int j = c; j <= m; ++j) B(r, j) -= f*B(c, j);
        }
    }
    return m;
}
bool settled = false;
for (int i = 0; i < 100 && !settled; ++i) {
    int m = 0;
    for (int a = 0; a < n; ++a) if (touches[a]) { row[m] = a; m++; }
    for (int a = 0; a < m; ++a) {
        for (int b = 0; b < m; ++b) B(a, b) = C(row[a], row[b]);
        real right = U[row[a]] - G[row[a]];
        if (byForce) { B(a, m) = -W[row[a]]; B(m, a) = -W[row[a]]; B(a, m + 1) = right; }
        else B(a, m) = right + depth*W[row[a]];
    }
    if (byForce) { B(m, m) = 0; B(m, m + 1) = -target; }
    int size = eliminate(m + byForce);
    p = 0;
    for (int a = 0; a < m; ++a) p[row[a]] = B(a, size)/B(a, a);
    if (byForce) depth = B(m, size)/B(m, m);
    g = C*p; g += G; g -= U;
    real[int] lifted = depth*W;
    g -= lifted;
    settled = true;
    for (int a = 0; a < n; ++a) {
        if (touches[a] && p[a] < 0) { touches[a] = 0; settled = false; }
        else if (!touches[a] && g[a] < -1e-12*W.max) { touches[a] = 1; settled = false; }
    }
}
if (!settled) { cout << "error: the contact did not settle in 100 iterations" << endl; exit(1); }
real force = @share@(p'*W);
Vlower [um, wm];
{
    real[int] f = Plower*p;
    um[] = Alower^-1*f;
}
real middle = -wm(@middle_x@, @middle_y@);
ofstream table("@job@.csv");
table.precision(10);
table << "# @code@, @element@, two bodies, mortar, undeformed surfaces" << endl;
table << "# normal_force = " << force << " @force_unit@" << endl;
@indentation@table << "# size = @size@ mm" << endl;
table << "# middle of the lower surface: " << middle << " mm down" << endl;
table << "@column@ [mm],p [MPa]" << endl;
for (int a = 0; a < n; ++a) table << @place@ << "," << p[a] << endl;
cout << "normal_force = " << force << " @force_unit@, depth = " << depth << " mm" << endl;
)";

constexpr const char* freefem_body_template = R"(
mesh T@body@("@job@_@body@.msh");
fespace V@body@(T@body@, [@element@, @element@]);
real lambda@body@ = @lambda@, shear@body@ = @shear@;
varf stiff@body@([u, w], [v, q]) = int2d(T@body@)(weight*(@elastic@))
    + on(1, u=0, w=0) + on(4, u=0);
varf push@body@([u, w], [v, q]) = int1d(T@body@, 3, qforder=9)(weight*onto*hat(along)*(nx*v + ny*q));
matrix A@body@ = stiff@body@(V@body@, V@body@);
@pin@set(A@body@, solver=sparsesolver);
real[int, int] P@body@(V@body@.ndof, n);
for (k = 0; k < n; ++k) { real[int] f = push@body@(0, V@body@); P@body@(:, k) = f; }
for (int l = 0; l < n; ++l) {
    real[int] f = P@body@(:, l);
    real[int] moved = A@body@^-1*f;
    for (int a = 0; a < n; ++a) { real[int] h = P@body@(:, a); C(a, l) += h'*moved; }
}
@load@)";

// The one node that is held: no edge has a label for it.
constexpr const char* freefem_pin = R"({
    V@body@ [eu, ew] = [0, abs(x - @x@) + abs(y - @y@) < 1e-9];
    real[int] D = A@body@.diag;
    for (int i = 0; i < D.n; ++i) if (ew[][i] > .5) D[i] = 1e30;
    A@body@.diag = D;
}
)";
constexpr const char* freefem_load = R"({
    varf pressed([u, w], [v, q]) = int1d(T@body@, 5, qforder=9)(-weight*@pressure@*q);
    real[int] f = pressed(0, V@body@);
    real[int] moved = A@body@^-1*f;
    for (int a = 0; a < n; ++a) { real[int] h = P@body@(:, a); U[a] += h'*moved; }
}
)";

std::string freefem_body(const DeckModel& model, const BodyMesh& body, const std::string& name,
                         const std::string& job, const std::string& element) {
    const bool is_upper = name == "upper", is_plane = model.shape == DeckModel::Shape::plane;
    const double young = is_upper ? model.upper->young : model.young,
                 poisson = is_upper ? model.upper->poisson : model.poisson;
    const auto l = "lambda" + name, s = "shear" + name;
    const std::string elastic =
        is_plane ? fmt::format(
                       "{0}*(dx(u) + dy(w))*(dx(v) + dy(q)) + 2*{1}*(dx(u)*dx(v) + "
                       "dy(w)*dy(q)) + {1}*(dy(u) + dx(w))*(dy(v) + dx(q))",
                       l, s)
                 : fmt::format(
                       "{0}*(dx(u) + u/x + dy(w))*(dx(v) + v/x + dy(q)) + 2*{1}*("
                       "dx(u)*dx(v) + u*v/(x*x) + dy(w)*dy(q)) + {1}*(dy(u) + dx(w))*(dy(v) "
                       "+ dx(q))",
                       l, s);
    std::string pin, load;
    if (body.held.size() == 1) {
        const DeckMesh::Point& p = body.nodes[body.held.front()];
        pin = filled(freefem_pin, {{"body", name}, {"x", number(p[0])}, {"y", number(p[1])}});
    }
    if (!body.loaded.empty())
        load =
            filled(freefem_load,
                   {{"body", name}, {"pressure", number(model.last().normal / model.loaded_area)}});
    return filled(freefem_body_template,
                  {{"job", job},
                   {"element", element},
                   {"lambda", number(young * poisson / ((1 + poisson) * (1 - 2 * poisson)))},
                   {"shear", number(young / (2 * (1 + poisson)))},
                   {"elastic", elastic},
                   {"pin", pin},
                   {"load", load},
                   {"body", name}});
}

std::string freefem_pair_text(const DeckModel& model, const BodyPair& pair, const DeckRun& run,
                              const DeckFamily& family, const std::string& job) {
    const bool is_plane = model.shape == DeckModel::Shape::plane,
               is_hole = model.conforming_radius > 0, is_force = model.last().is_force;
    const std::string radius = number(model.conforming_radius);
    const DeckMesh::Point& middle = pair.lower.nodes[pair.lower.contact.front()[0]];
    return filled(
        freefem_pair_template,
        pair_values(
            model, pair, run, family, job,
            {{"lower", freefem_body(model, pair.lower, "lower", job, family.elements)},
             {"upper", freefem_body(model, pair.upper, "upper", job, family.elements)},
             {"along", is_hole ? radius + "*atan2(x, -y)" : "x"},
             {"nx", is_hole ? "x/sqrt(x*x + y*y)" : "0."},
             {"ny", is_hole ? "y/sqrt(x*x + y*y)" : "-1."},
             {"stretch", is_hole ? radius + "/sqrt(x*x + y*y)" : "1."},
             {"weight", is_plane ? "1." : "2*pi*x"},
             {"by_force", is_force ? "true" : "false"},
             {"indentation", model.has_depth
                                 ? "table << \"# indentation = \" << depth << \" mm\" << endl;\n"
                                 : ""},
             {"middle_x", number(middle[0])},
             {"middle_y", number(middle[1])},
             {"place", is_hole ? fmt::format("{0}*sin(S[a]/{0})", radius) : "S[a]"}}));
}

}  // namespace

DeckFamily freefem_pair_family(const DeckModel& model, const DeckWishes& wishes) {
    check_pair_deck(model, "FreeFem++");
    const std::string element = wishes.elements.empty() ? "P2" : wishes.elements;
    if (element != "P1" && element != "P2")
        throw contact::InputError("deck: elements " + element +
                                  " are none of FreeFem++'s deck; choose of P2, P1");
    DeckFamily family;
    family.code = "FreeFem++ 4.11";
    family.elements = element;
    family.method = "mortar";
    family.kinematics = "undeformed";
    for (int level = 0; level < levels_of(model, wishes); ++level) {
        const std::string job = add_run(family, model);
        DeckRun& run = family.runs.back();
        const BodyPair pair = body_pair(model, coarsest_elements(model), level, false);
        run.files.push_back({job + "_lower.msh", freefem_mesh(pair.lower)});
        run.files.push_back({job + "_upper.msh", freefem_mesh(pair.upper)});
        run.files.push_back({job + ".edp", freefem_pair_text(model, pair, run, family, job)});
        run.command = "FreeFem++ -nw " + job + ".edp";
        run.field = job + ".csv";
    }
    return family;
}

}  // namespace tricontact::benchmarks
