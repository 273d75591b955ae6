#include "benchmarks/decks/contact_mesh.h"

#include <algorithm>
#include <cmath>

#include "benchmarks/decks/graded_line.h"

namespace tricontact::benchmarks {

namespace {

using Point = DeckMesh::Point;

// Faces of the last elements in the lattice of a block whose nodes all fulfil a condition.
std::vector<ElementFace> faces_on(const DeckMesh& mesh, int first, int face,
                                  const std::function<bool(const Point&)>& holds) {
    std::vector<ElementFace> faces;
    for (int e = first; e < mesh.n_elements(); ++e) {
        const std::vector<int> nodes = mesh.face_nodes({e, face});
        if (std::ranges::all_of(nodes, [&](int node) { return holds(mesh.nodes[node]); }))
            faces.push_back({e, face});
    }
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
    const double reach = model.contact_reach * (1 + 1e-9);
    const auto may_touch = [=](const Point& p) {
        return p[up] == 0 && std::abs(p[0]) <= reach && (!is_spatial || p[1] <= reach);
    };
    std::vector<BlockSet> sets{{"NBASE", [=](const Point& p) { return p[up] == bottom; }},
                               {"NSIDE",
                                [=](const Point& p) {
                                    return p[0] == right || (left < 0 && p[0] == left) ||
                                           (is_spatial && p[1] == right);
                                }},
                               {"NTOP", [=](const Point& p) { return p[up] == 0; }},
                               {"NCONTACT", may_touch}};
    if (left == 0) sets.push_back({"NAXIS", [](const Point& p) { return p[0] == 0; }});
    if (is_spatial) sets.push_back({"NSYM", [](const Point& p) { return p[1] == 0; }});
    const BlockLines lines =
        is_spatial ? BlockLines{grid.x, grid.y, height} : BlockLines{grid.x, height, {}};
    add_block(
        mesh, lines, [](const Point& p) { return p; }, sets);
    mesh.n_body_elements = mesh.n_elements();
    mesh.surfaces["SLAYER"] = faces_on(mesh, 0, is_spatial ? 2 : 3, may_touch);
    return mesh;
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

}  // namespace tricontact::benchmarks
