#include <cmath>
#include <functional>

#include "benchmarks/decks/closed_families.h"
#include "benchmarks/decks/deck_family.h"
#include "benchmarks/decks/deck_texts.h"
#include "benchmarks/decks/graded_line.h"

// Loose blocks on a thick one, x >= 0, with nodes of the same x where they touch: a strip under a
// line load, and a block with sharp edges under a pressure.

namespace tricontact::benchmarks {

namespace {

using Point = DeckMesh::Point;

/// Half of a block that nothing but the contact holds, and of the thick block below it [mm].
struct LooseBlock {
    double height, half;  ///< of the loose one
    double contact;       ///< half width, in which elements are counted
    double reach;         ///< of what may touch, in `contact`
    double base_half, base_depth;
    bool has_loaded_face = false;  ///< a pressure on the upper face; else a line load
};

DeckMesh loose_block_mesh(const LooseBlock& block, int n, int level, bool is_quadratic) {
    DeckMesh mesh;
    mesh.is_quadratic = is_quadratic;
    const double size = block.contact / n, reach = block.reach * block.contact * (1 + 1e-9);
    const int equal = static_cast<int>(std::ceil(block.reach * n));
    const auto across = [&](double end) {
        return refined_line(graded_line(0, size, equal, end, 1.5), level);
    };
    const auto is_axis = [](const Point& p) { return p[0] == 0; };
    const auto stay = [](const Point& p) { return p; };
    const std::vector<double> below =
        refined_line(graded_line(0, size, 1, block.base_depth, 1.6), level);
    std::vector<double> heights;
    for (auto at = below.rbegin(); at != below.rend(); ++at) heights.push_back(0 - *at);
    const double bottom = heights.front();
    const auto add_faces = [&](const char* name, const std::vector<double>& x, int first, int face,
                               double end) {
        for (int i = 0; i + 1 < static_cast<int>(x.size()) && x[i + 1] <= end; ++i)
            mesh.surfaces[name].push_back({first + i, face});
    };
    const std::vector<double> base_x = across(block.base_half), loose_x = across(block.half);
    add_block(mesh, {base_x, heights, {}}, stay,
              {{"NBASE", [=](const Point& p) { return p[1] == bottom; }}, {"NAXIS", is_axis}});
    mesh.n_body_elements = mesh.n_elements();
    add_faces("SLAYER", base_x, mesh.n_elements() - static_cast<int>(base_x.size()) + 1, 3, reach);
    // As many equal elements up to the load as come near the size of those along it.
    const int through = static_cast<int>(std::lround(block.height / size));
    const std::vector<double> up =
        refined_line(graded_line(0, block.height / through, through, block.height, 2), level);
    const double top = up.back();
    const auto is_leader = [=](const Point& p) { return p[0] == 0 && p[1] == top; };
    add_block(mesh, {loose_x, up, {}}, stay,
              {{"NIND", is_leader}, {"NDEPTH", is_leader}, {"NAXIS", [=](const Point& p) {
                                                                return is_axis(p) && !is_leader(p);
                                                            }}});
    add_faces("SIND", loose_x, mesh.n_body_elements, 1, reach);
    if (block.has_loaded_face)
        add_faces("SLOAD", loose_x, mesh.n_elements() - static_cast<int>(loose_x.size()) + 1, 3,
                  block.half * (1 + 1e-9));
    return mesh;
}

constexpr LooseBlock strip{.height = 2,
                           .half = 60,
                           .contact = 1.324165 * 2,
                           .reach = 1.5,
                           .base_half = 600,
                           .base_depth = 600};
constexpr LooseBlock sharp_block{.height = 10,
                                 .half = 5,
                                 .contact = 5,
                                 .reach = 1,
                                 .base_half = 3000,
                                 .base_depth = 300,
                                 .has_loaded_face = true};

/// Both of E = 2 MPa, nu = 0.3, in plane strain.
DeckModel loose_block_model(const std::string& name, const LooseBlock& block) {
    DeckModel model;
    model.shape = DeckModel::Shape::plane;
    model.name = name;
    model.a = block.contact;
    model.young = 2;
    model.poisson = .3;
    model.upper = {{.radius = 0, .young = model.young, .poisson = model.poisson}};
    model.indenter = flat_face();
    model.gap = "0";
    model.has_depth = false;  // of a line load, or of a face that bends
    model.own_mesh = [block](int n, int level, bool is_quadratic) {
        return loose_block_mesh(block, n, level, is_quadratic);
    };
    model.depth_scale = .01;
    return model;
}

DeckModel strip_model(const std::string& name) {
    DeckModel model = loose_block_model(name, strip);
    model.title = "Strip of 2 mm on a thick block, a line load on its upper face";
    model.own_words =
        "Block: 600 mm to either side and 600 mm deep, its base held. Strip: 60 mm to either side, "
        "2 mm thick, held by the contact and the symmetry about x = 0 alone. E = 2 MPa, nu = 0.3.";
    model.stiffness = 1000;  // with 20 MPa/mm p is 1.5 % lower
    model.steps.push_back({.is_force = true, .normal = .0125, .increments = 1});
    model.remarks.push_back(
        "Closed form (Keer, Dundurs and Tsai 1972): the contact reaches to 2.64833 mm whatever the "
        "load, and p = 0.00445675 MPa below it.");
    return model;
}

DeckModel sharp_block_model(const std::string& name) {
    DeckModel model = loose_block_model(name, sharp_block);
    model.title = "Block of 10 mm x 10 mm with sharp edges on a thick block";
    model.own_words =
        "Thick block: 3000 mm to either side and 300 mm deep, its base held. Upper block: 10 mm "
        "wide and 10 mm high, 0.1 MPa on its upper face, held by the contact and the symmetry "
        "about x = 0 alone. E = 2 MPa, nu = 0.3.";
    model.has_sharp_edge = true;
    model.stiffness = 1000;
    model.loaded_area = 2 * sharp_block.half;
    model.steps.push_back({.is_force = true, .normal = .1 * model.loaded_area, .increments = 1});
    model.remarks.push_back(
        "Closed form (Dundurs and Lee 1972): p ~ r^(s - 1) of the distance r from the edge, s = "
        "0.774013. The largest pressure of a mesh means nothing; the force within r of the edge is "
        "as r^s.");
    return model;
}

}  // namespace

std::vector<DeckFile> complete_punch_two_bodies_deck(const DeckWishes& wishes) {
    return family_files(sharp_block_model(wishes.problem), wishes);
}

std::vector<DeckFile> receding_layer_deck(const DeckWishes& wishes) {
    return family_files(strip_model(wishes.problem), wishes);
}

}  // namespace tricontact::benchmarks
