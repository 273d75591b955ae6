#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "benchmarks/decks/closed_families.h"
#include "benchmarks/decks/deck_family.h"
#include "benchmarks/decks/deck_texts.h"
#include "benchmarks/decks/graded_line.h"
#include "benchmarks/decks/ring_mesh.h"

// Steel on aluminium, x >= 0: bodies with nodes of the same x, or length of arc, where they touch.

namespace tricontact::benchmarks {

namespace {

using Point = DeckMesh::Point;

constexpr double steel = 210000, aluminium = 70000, konter_poisson = .3;  // [MPa]
constexpr double block_side = 200, block_reach = 100;                     // [mm]

/// Of elements of `size` to `equal` times of it, then growing to the end.
std::vector<double> konter_line(double size, int equal, double end, int level) {
    return refined_line(graded_line(0, size, equal, end, 1.5), level);
}

/// The aluminium, its base held; `x` are the nodes along its upper face.
DeckMesh konter_base(const std::vector<double>& x, double size, int level, bool is_quadratic,
                     double reach) {
    DeckMesh mesh;
    mesh.is_quadratic = is_quadratic;
    const std::vector<double> below = konter_line(size, 1, block_side, level);
    std::vector<double> heights;
    for (auto at = below.rbegin(); at != below.rend(); ++at) heights.push_back(0 - *at);
    const double bottom = heights.front();
    add_block(mesh, {x, heights, {}}, [](const Point& p) { return p; },
              {{"NBASE", [=](const Point& p) { return p[1] == bottom; }},
               {"NAXIS", [](const Point& p) { return p[0] == 0; }}});
    mesh.n_body_elements = mesh.n_elements();
    add_face_row(mesh, "SLAYER", x, mesh.n_elements() - static_cast<int>(x.size()) + 1, 3, reach);
    return mesh;
}

DeckModel konter_model(const std::string& name) {
    DeckModel model;
    model.name = name;
    model.young = aluminium;
    model.poisson = konter_poisson;
    model.upper = {{.radius = 0, .young = steel, .poisson = konter_poisson}};
    model.indenter = flat_face();
    model.stiffness = 1e6;
    return model;
}

// Benchmark 1: rings about the roller's axis, from its surface to the hub.
constexpr double roller = 50, roller_hub = 5, roller_contact = 6.21466;
// Else nothing holds the roller when the load begins; the hub's depth counts from there.
constexpr double roller_overlap = .1;

DeckMesh roller_mesh(int n, int level, bool is_quadratic) {
    using std::numbers::pi;
    const double size = roller_contact / n, reach = 2 * roller_contact;
    DeckMesh mesh =
        konter_base(konter_line(size, 2 * n, block_reach, level), size, level, is_quadratic, reach);
    const std::vector<double> arcs = konter_line(size, 2 * n, pi * roller, level),
                              depths = konter_line(size, 1, roller - roller_hub, level);
    add_ring(mesh, roller, roller_overlap, arcs, depths);
    add_face_row(mesh, "SIND", arcs, mesh.n_body_elements, 1, reach);
    return mesh;
}

// Benchmark 2.
constexpr double punch_flat = 40, punch_edge = 10, punch_side = 50, punch_height = 100;

DeckMesh konter_punch_mesh(int n, int level, bool is_quadratic) {
    const double size = punch_flat / n, reach = punch_flat + 4;
    DeckMesh mesh = konter_base(konter_line(size, n + 1, block_reach, level), size, level,
                                is_quadratic, std::max(reach, punch_flat + size));
    const std::vector<double> x = konter_line(size, n, punch_side, level),
                              up = konter_line(size, 1, punch_height, level);
    const double top = up.back();
    const auto is_leader = [=](const Point& p) { return p[0] == 0 && p[1] == top; };
    add_block(mesh, {x, up, {}},
              [=](const Point& p) -> Point {
                  const double beyond = std::max(0., p[0] - punch_flat),
                               rise = beyond * beyond / (2 * punch_edge);
                  return {p[0], p[1] + rise * (1 - p[1] / punch_height), 0};
              },
              {{"NIND", is_leader}, {"NDEPTH", is_leader}, {"NAXIS", [=](const Point& p) {
                                                                return p[0] == 0 && !is_leader(p);
                                                            }}});
    add_face_row(mesh, "SIND", x, mesh.n_body_elements, 1, punch_side);
    const int columns = static_cast<int>(x.size()) - 1;
    add_face_row(mesh, "SLOAD", x, mesh.n_elements() - columns, 3, punch_side);
    return mesh;
}

}  // namespace

std::vector<DeckFile> nafems_roller_deck(const DeckWishes& wishes) {
    DeckModel model = konter_model(wishes.problem);
    model.shape = DeckModel::Shape::plane;
    model.title = "NAFEMS contact benchmark 1: steel roller on an aluminium block";
    model.a = roller_contact;
    model.gap = "r*r/(50+sqrt(50*50-r*r))";
    model.own_mesh = roller_mesh;
    model.own_words =
        "Block: 100 mm to either side, 200 mm deep, its base held; E = 70000 MPa. Roller: R = 50 "
        "mm, E = 210000 MPa, on a rigid hub of 5 mm, which carries the force and begins 0.1 mm in "
        "the block. nu = 0.3. All is "
        "symmetric about x = 0.";
    model.depth_scale = 1.3;
    model.steps.push_back({.is_force = true, .normal = 35000, .increments = 10});
    model.remarks.push_back(
        "Closed form (Hertz): half width 6.2147 mm, peak pressure 3585.4 MPa. Published: 1.307 mm "
        "depth of the middle of the block's face, with large strains: add NLGEOM to *STEP.");
    return family_files(model, wishes);
}

std::vector<DeckFile> nafems_punch_deck(const DeckWishes& wishes) {
    DeckModel model = konter_model(wishes.problem);
    model.title = "NAFEMS contact benchmark 2: steel punch with a rounded edge on a cylinder";
    model.a = punch_flat;
    model.gap = "0.5*(r-40+abs(r-40))*0.5*(r-40+abs(r-40))/(2*10)";
    model.has_depth = false;      // the pressed face bends
    model.has_sharp_edge = true;  // nearly: the pressure rises by 1/(element size) at r = 40 mm
    model.own_mesh = konter_punch_mesh;
    model.own_words =
        "Cylinder: 100 mm radius, 200 mm high, its base held; E = 70000 MPa. Punch: 50 mm radius, "
        "100 mm high, its edge rounded beyond 40 mm by a parabola of 10 mm; E = 210000 MPa. nu = "
        "0.3. A pressure of 100 MPa acts on its upper face.";
    model.depth_scale = .134;
    using std::numbers::pi;
    model.loaded_area = pi * punch_side * punch_side;
    model.steps.push_back({.is_force = true, .normal = 100 * model.loaded_area, .increments = 10});
    model.remarks.push_back(
        "No closed form. Displacement of the middle of the cylinder's face: -0.1339 mm on fine "
        "meshes; published -0.1307 mm on elements of 4 nodes, -0.1329 mm on those of 8 nodes.");
    return family_files(model, wishes);
}

}  // namespace tricontact::benchmarks
