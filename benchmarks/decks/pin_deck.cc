#include <cmath>
#include <functional>
#include <numbers>

#include "benchmarks/decks/closed_families.h"
#include "benchmarks/decks/deck_family.h"
#include "benchmarks/decks/deck_texts.h"
#include "benchmarks/decks/graded_line.h"

// A pin on a hub in the hole of a plate, x >= 0: rings in polar coordinates, whose angles are those
// of the contact's elements. x of their lattices is the length of arc from the lowest point.

namespace tricontact::benchmarks {

namespace {

using Point = DeckMesh::Point;
using std::numbers::pi;

constexpr double hole = 10, clearance = .02, pin = hole - clearance;  // radii [mm]
constexpr double half_angle = pi / 6;
// The hub holds the harmonics of the pin as its square over the radius.
constexpr double plate = 100 * hole, hub = hole / 50;
constexpr double may_touch = 1.5;  // of the half angle

/// A surface in contact: its radius, and the height of its centre.
struct Ring {
    double radius, centre;
};

std::function<Point(const Point&)> placed(const Ring& ring) {
    return [=](const Point& p) -> Point {
        const double angle = p[0] / hole, r = ring.radius - p[1];
        // No rounding beside the plane of symmetry above.
        const double x = angle > pi * (1 - 1e-12) ? 0 : r * std::sin(angle);
        return {x, ring.centre - r * std::cos(angle), 0};
    };
}

/// Heights from the far edge at -depth up to the surface at 0.
std::vector<double> up_to_surface(double size, double depth, int level) {
    std::vector<double> heights;
    const std::vector<double> line = refined_line(graded_line(0, size, 1, depth, 1.6), level);
    for (auto at = line.rbegin(); at != line.rend(); ++at) heights.push_back(0 - *at);
    return heights;
}

void add_faces(DeckMesh& mesh, const char* name, const std::vector<double>& arcs, int first,
               int face) {
    const double reach = may_touch * half_angle * hole * (1 + 1e-9);
    for (int i = 0; i + 1 < static_cast<int>(arcs.size()) && arcs[i + 1] <= reach; ++i)
        mesh.surfaces[name].push_back({first + i, face});
}

DeckMesh pin_mesh(int n, int level, bool is_quadratic) {
    DeckMesh mesh;
    mesh.is_quadratic = is_quadratic;
    const double edge = half_angle * hole, size = edge / n, end = pi * hole;
    const int equal = static_cast<int>(std::ceil(may_touch * n));
    const std::vector<double> arcs = refined_line(graded_line(0, size, equal, end, 1.5), level);
    const auto is_axis = [=](const Point& p) { return p[0] == 0 || p[0] == end; };
    const std::vector<double> plate_lines = up_to_surface(size, plate - hole, level);
    const double outer = plate_lines.front();
    add_block(mesh, {arcs, plate_lines, {}}, placed({hole, 0}),
              {{"NBASE", [=](const Point& p) { return p[1] == outer; }}, {"NAXIS", is_axis}});
    const int columns = static_cast<int>(arcs.size()) - 1;
    mesh.n_body_elements = mesh.n_elements();
    add_faces(mesh, "SLAYER", arcs, mesh.n_body_elements - columns, 3);
    const std::vector<double> pin_lines =
        refined_line(graded_line(0, size, 1, pin - hub, 1.6), level);
    const double inner = pin_lines.back();
    const auto is_hub = [=](const Point& p) { return p[1] == inner; };
    add_block(mesh, {arcs, pin_lines, {}}, placed({pin, -clearance}),
              {{"NIND", is_hub},
               {"NDEPTH", [=](const Point& p) { return p[1] == inner && p[0] == 0; }},
               {"NAXIS", [=](const Point& p) { return is_axis(p) && !is_hub(p); }}});
    add_faces(mesh, "SIND", arcs, mesh.n_body_elements, 1);
    return mesh;
}

DeckModel pin_model(const std::string& name) {
    DeckModel model;
    model.shape = DeckModel::Shape::plane;
    model.name = name;
    model.title = "Pin of R = 9.98 mm in a hole of 10 mm in a plate";
    model.a = hole * std::sin(half_angle);
    model.young = 210000;
    model.poisson = .3;
    model.upper = {{.radius = pin, .young = model.young, .poisson = model.poisson}};
    model.indenter = flat_face();
    model.conforming_radius = hole;
    model.gap = "0.02*(1-cos(r/10))";  // of both circles, touching at the lowest point
    model.own_mesh = pin_mesh;
    model.own_words =
        "Plate: its outer edge, of 1000 mm radius, is held; the hole has 10 mm. Pin: a rigid hub "
        "of 0.2 mm radius in its axis carries the force. E = 210000 MPa, nu = 0.3. All is "
        "symmetric "
        "about x = 0, and the pin touches the hole's lowest point when the load begins.";
    model.depth_scale = .02;
    model.stiffness = 5e6;  // yields by 1.5e-5 mm, .07 % of the clearance
    model.steps.push_back({.is_force = true, .normal = 581.0237, .increments = 1});
    model.remarks.push_back(
        "Closed form (Persson 1964): the contact reaches to 30 degrees, x = 5 mm, and p = 73.225 "
        "MPa at the lowest point. x of the points is that of the surface, p the pressure along its "
        "normal, so that the integral of p over x is the force.");
    return model;
}

}  // namespace

std::vector<DeckFile> pin_in_hole_deck(const DeckWishes& wishes) {
    return family_files(pin_model(wishes.problem), wishes);
}

}  // namespace tricontact::benchmarks
