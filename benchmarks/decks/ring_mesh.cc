#include "benchmarks/decks/ring_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "benchmarks/decks/contact_mesh.h"
#include "benchmarks/decks/graded_line.h"

// Cylinders around a hub: rings about their axis, from the surface to the hub.

namespace tricontact::benchmarks {

namespace {

using Point = DeckMesh::Point;

/// Nodes from `first` on that lie at the same place, bit by bit, become one.
void join_nodes(DeckMesh& mesh, int first) {
    std::map<Point, int> at;
    std::vector<int> joined(mesh.nodes.size());
    std::vector<Point> nodes(mesh.nodes.begin(), mesh.nodes.begin() + first);
    for (int i = 0; i < static_cast<int>(joined.size()); ++i) {
        joined[i] = i;
        if (i < first) continue;
        const auto [found, is_new] = at.emplace(mesh.nodes[i], static_cast<int>(nodes.size()));
        joined[i] = found->second;
        if (is_new) nodes.push_back(mesh.nodes[i]);
    }
    mesh.nodes = std::move(nodes);
    for (auto& element : mesh.elements)
        for (int& node : element) node = joined[node];
    for (auto& [name, set] : mesh.node_sets) {
        for (int& node : set) node = joined[node];
        std::ranges::sort(set);
        const auto [from, to] = std::ranges::unique(set);
        set.erase(from, to);
    }
}

DeckMesh cylinder_on_block_mesh(const DeckModel& model, double hub_radius, int n, int level,
                                bool is_quadratic) {
    DeckMesh mesh = block_mesh(model, n, level, is_quadratic);
    constexpr double growth = 1.5;
    const double radius = model.upper->radius, size = model.a / n;
    const int equal = static_cast<int>(std::ceil(model.contact_reach / size - 1e-9));
    const std::vector<double> out = graded_line(0, size, equal, std::numbers::pi * radius, growth),
                              depths = refined_line(
                                  graded_line(0, size, 1, radius - hub_radius, growth), level);
    const std::vector<double> arcs =
        refined_line(model.is_shifted() ? mirrored_line(out) : out, level);
    add_ring(mesh, radius, model.overlap, arcs, depths);
    add_face_row(mesh, "SIND", arcs, mesh.n_body_elements, 1, model.contact_reach);
    return mesh;
}

}  // namespace

void add_face_row(DeckMesh& mesh, const char* name, const std::vector<double>& along, int first,
                  int face, double reach) {
    const double end = reach * (1 + 1e-9);
    for (int i = 0; i + 1 < static_cast<int>(along.size()); ++i)
        if (along[i] >= -end && along[i + 1] <= end)
            mesh.surfaces[name].push_back({first + i, face});
}

void add_ring(DeckMesh& mesh, double radius, double overlap, const std::vector<double>& arcs,
              const std::vector<double>& depths) {
    const double top = arcs.back(), inner = depths.back();
    const int first = static_cast<int>(mesh.nodes.size());
    const auto is_axis = [=](const Point& p) { return p[0] == 0 || std::abs(p[0]) == top; };
    const auto is_hub = [=](const Point& p) { return p[1] == inner; };
    add_block(mesh, {arcs, depths, {}},
              [=](const Point& p) -> Point {
                  const double angle = p[0] / radius, r = radius - p[1];
                  return {std::abs(p[0]) == top ? 0 : r * std::sin(angle),
                          radius - overlap - r * std::cos(angle), 0};
              },
              {{"NIND", is_hub},
               {"NDEPTH", [=](const Point& p) { return is_hub(p) && p[0] == 0; }},
               {"NAXIS", [=](const Point& p) { return is_axis(p) && !is_hub(p); }}});
    join_nodes(mesh, first);
}

void set_cylinder_on_block(DeckModel& model, double hub_radius) {
    model.own_words = fmt::format(
        "Block: {:.9g} mm to either side, {:.9g} mm thick, bonded to a rigid base, its sides free; "
        "E = {:.9g} MPa, nu = {:.9g}. On it a cylinder of R = {:.9g} mm around a rigid hub of "
        "{:.9g} mm, which carries the loads and does not turn; E = {:.9g} MPa, nu = {:.9g}. Under "
        "a force it begins {:.3g} mm in the block.",
        model.width, model.thickness, model.young, model.poisson, model.upper->radius, hub_radius,
        model.upper->young, model.upper->poisson, model.overlap);
    model.own_mesh = [bodies = model, hub_radius](int n, int level, bool is_quadratic) {
        return cylinder_on_block_mesh(bodies, hub_radius, n, level, is_quadratic);
    };
}

}  // namespace tricontact::benchmarks
