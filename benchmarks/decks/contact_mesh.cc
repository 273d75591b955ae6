#include "benchmarks/decks/contact_mesh.h"

#include <algorithm>
#include <cmath>

#include "benchmarks/decks/graded_line.h"

namespace tricontact::benchmarks {

namespace {

using Point = DeckMesh::Point;

// Faces whose nodes all belong to a set.
std::vector<ElementFace> faces_of(const DeckMesh& mesh, int face, const std::string& set) {
    std::vector<char> belongs(mesh.nodes.size(), 0);
    for (const int node : mesh.node_sets.at(set)) belongs[node] = 1;
    std::vector<ElementFace> faces;
    for (int e = 0; e < mesh.n_elements(); ++e)
        if (std::ranges::all_of(mesh.face_nodes({e, face}),
                                [&](int node) { return belongs[node] != 0; }))
            faces.push_back({e, face});
    return faces;
}

}  // namespace

DeckMesh block_mesh(const DeckModel& model, int n, int level, bool is_quadratic) {
    const DeckLines grid = deck_lines(model, n, level);
    const bool is_spatial = model.shape == DeckModel::Shape::half;
    const int up = is_spatial ? 2 : 1;
    std::vector<double> height;
    for (auto depth = grid.depth.rbegin(); depth != grid.depth.rend(); ++depth)
        height.push_back(*depth == 0 ? 0 : -*depth);
    DeckMesh mesh;
    mesh.dimension = is_spatial ? 3 : 2;
    mesh.is_quadratic = is_quadratic;
    const double bottom = height.front(), left = grid.x.front(), right = grid.x.back();
    const double round = model.round_radius;
    const double reach = model.lattice_reach();
    const auto may_touch = [=](const Point& p) {
        return p[up] == 0 && std::abs(p[0]) <= reach && (!is_spatial || p[1] <= reach);
    };
    const auto is_side = [=](const Point& p) {
        return p[0] == right || (left < 0 && p[0] == left) || (is_spatial && p[1] == right);
    };
    // Half a ball or cylinder has no sides: its flat face is what is left and below.
    const auto is_base = [=](const Point& p) {
        return p[up] == bottom || (round > 0 && is_side(p));
    };
    std::vector<BlockSet> sets{{"NBASE", is_base},
                               {"NTOP", [=](const Point& p) { return p[up] == 0; }},
                               {"NCONTACT", may_touch}};
    if (round == 0) sets.push_back({"NSIDE", is_side});
    if (left == 0) sets.push_back({"NAXIS", [](const Point& p) { return p[0] == 0; }});
    if (is_spatial) sets.push_back({"NSYM", [](const Point& p) { return p[1] == 0; }});
    const BlockLines lines =
        is_spatial ? BlockLines{grid.x, grid.y, height} : BlockLines{grid.x, height, {}};
    add_block(
        mesh, lines,
        [=](const Point& p) -> Point {
            if (round == 0) return p;
            const auto [x, z] = placed_round(round, p[0], p[1]);
            return {x, z, 0};
        },
        sets);
    mesh.n_body_elements = mesh.n_elements();
    mesh.surfaces["SLAYER"] = faces_of(mesh, is_spatial ? 2 : 3, "NCONTACT");
    return mesh;
}

void add_upper_body(DeckMesh& mesh, const DeckModel& model, int n, int level) {
    DeckModel body = model;
    const double radius = body.round_radius = body.thickness = model.upper->radius;
    const DeckLines grid = deck_lines(body, n, level);
    const double right = grid.x.back(), reach = body.lattice_reach();
    const int first = mesh.n_elements(), columns = static_cast<int>(grid.x.size()) - 1;
    // Upside down: depth from the pole counts upwards.
    add_block(mesh, {grid.x, grid.depth, {}},
              [=](const Point& p) -> Point {
                  const auto [x, z] = placed_round(radius, p[0], -p[1]);
                  return {x, -z, 0};
              },
              {{"NIND", [=](const Point& p) { return p[1] == radius || p[0] == right; }},
               {"NAXIS", [](const Point& p) { return p[0] == 0; }}});
    for (int i = 0; i < columns && grid.x[i + 1] <= reach; ++i)
        mesh.surfaces["SIND"].push_back({first + i, 1});
}

void add_indenter(DeckMesh& mesh, const DeckModel& model, int n, int level) {
    const DeckLines grid = deck_lines(model, n, level);
    const bool is_spatial = mesh.dimension == 3;
    const int up = is_spatial ? 2 : 1;
    const double reach = std::max(model.indenter_reach, model.contact_reach);
    // Equal elements as in the contact: the profile is met equally well everywhere.
    const double size = model.a / n;
    const int count = static_cast<int>(std::ceil(reach / size - 1e-9));
    const std::vector<double> out =
        refined_line(graded_line(0, size, count, count * size, 2), level);
    const std::vector<double> x = grid.x.front() < 0 ? mirrored_line(out) : out;
    const double thickness = model.a;
    const std::vector<double> up_line{0, thickness};
    const int first = mesh.n_elements();
    const auto lift = [&](Point p) {
        const double height = model.height(p[0], is_spatial ? p[1] : 0);
        p[up] += height - model.overlap;
        return p;
    };
    std::vector<BlockSet> sets{{"NIND", [](const Point&) { return true; }}};
    // The node that the others follow where a force acts.
    if (model.has_force() || model.has_tangential_force())
        sets.push_back({"NDEPTH", [=](const Point& p) {
                            return p[0] == 0 && p[up] == thickness && (!is_spatial || p[1] == 0);
                        }});
    add_block(mesh, is_spatial ? BlockLines{x, out, up_line} : BlockLines{x, up_line, {}}, lift,
              sets);
    for (int e = first; e < mesh.n_elements(); ++e) mesh.surfaces["SIND"].push_back({e, 1});
}

DeckMesh bodies_of(const DeckModel& model, int n, int level, bool is_quadratic) {
    if (model.own_mesh) return model.own_mesh(n, level, is_quadratic);
    DeckMesh mesh = block_mesh(model, n, level, is_quadratic);
    if (model.upper)
        add_upper_body(mesh, model, n, level);
    else
        add_indenter(mesh, model, n, level);
    return mesh;
}

}  // namespace tricontact::benchmarks
