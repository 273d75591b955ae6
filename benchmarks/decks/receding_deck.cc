#include <cmath>
#include <functional>

#include "benchmarks/decks/closed_families.h"
#include "benchmarks/decks/deck_family.h"
#include "benchmarks/decks/deck_texts.h"
#include "benchmarks/decks/graded_line.h"

// A loose strip on a block, x >= 0, with nodes of the same x where they touch; a line load on the
// strip's upper face.

namespace tricontact::benchmarks {

namespace {

using Point = DeckMesh::Point;

constexpr double strip_height = 2, strip_half = 60;    // [mm]
constexpr double block_half = 600, block_depth = 600;  // [mm]
constexpr double strip_contact = 1.324165 * strip_height;
constexpr double strip_reach = 1.5;  // of the half width

DeckMesh strip_mesh(int n, int level, bool is_quadratic) {
    DeckMesh mesh;
    mesh.is_quadratic = is_quadratic;
    const double size = strip_contact / n;
    const int equal = static_cast<int>(std::ceil(strip_reach * n));
    const auto across = [&](double end) {
        return refined_line(graded_line(0, size, equal, end, 1.5), level);
    };
    const auto is_axis = [](const Point& p) { return p[0] == 0; };
    const auto stay = [](const Point& p) { return p; };
    const std::vector<double> below =
        refined_line(graded_line(0, size, 1, block_depth, 1.6), level);
    std::vector<double> heights;
    for (auto at = below.rbegin(); at != below.rend(); ++at) heights.push_back(0 - *at);
    const double bottom = heights.front(), reach = strip_reach * strip_contact * (1 + 1e-9);
    const auto add_faces = [&](const char* name, const std::vector<double>& x, int first,
                               int face) {
        for (int i = 0; i + 1 < static_cast<int>(x.size()) && x[i + 1] <= reach; ++i)
            mesh.surfaces[name].push_back({first + i, face});
    };
    const std::vector<double> block_x = across(block_half), strip_x = across(strip_half);
    add_block(mesh, {block_x, heights, {}}, stay,
              {{"NBASE", [=](const Point& p) { return p[1] == bottom; }}, {"NAXIS", is_axis}});
    mesh.n_body_elements = mesh.n_elements();
    add_faces("SLAYER", block_x, mesh.n_elements() - static_cast<int>(block_x.size()) + 1, 3);
    // As many equal elements through the strip as come near the size of those along it.
    const int through = static_cast<int>(std::lround(strip_height / size));
    const std::vector<double> up =
        refined_line(graded_line(0, strip_height / through, through, strip_height, 2), level);
    const double top = up.back();
    const auto is_loaded = [=](const Point& p) { return p[0] == 0 && p[1] == top; };
    add_block(mesh, {strip_x, up, {}}, stay,
              {{"NIND", is_loaded}, {"NDEPTH", is_loaded}, {"NAXIS", [=](const Point& p) {
                                                                return is_axis(p) && !is_loaded(p);
                                                            }}});
    add_faces("SIND", strip_x, mesh.n_body_elements, 1);
    return mesh;
}

DeckModel strip_model(const std::string& name) {
    DeckModel model;
    model.shape = DeckModel::Shape::plane;
    model.name = name;
    model.title = "Strip of 2 mm on a thick block, a line load on its upper face";
    model.a = strip_contact;
    model.young = 2;
    model.poisson = .3;
    model.upper = {{.radius = 0, .young = model.young, .poisson = model.poisson}};
    model.indenter = flat_face();
    model.own_mesh = strip_mesh;
    model.own_words =
        "Block: 600 mm to either side and 600 mm deep, its base held. Strip: 60 mm to either side, "
        "2 mm thick, held by the contact and the symmetry about x = 0 alone. E = 2 MPa, nu = 0.3.";
    model.depth_scale = .01;
    model.stiffness = 1000;  // with 20 MPa/mm p is 1.5 % lower
    model.steps.push_back({.is_force = true, .normal = .0125, .increments = 1});
    model.remarks.push_back(
        "Closed form (Keer, Dundurs and Tsai 1972): the contact reaches to 2.64833 mm whatever the "
        "load, and p = 0.00445675 MPa below it.");
    return model;
}

}  // namespace

std::vector<DeckFile> receding_layer_deck(const DeckWishes& wishes) {
    return family_files(strip_model(wishes.problem), wishes);
}

}  // namespace tricontact::benchmarks
