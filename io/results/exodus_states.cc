// Surfaces and insides as meshes and fields of Exodus II.

#include <algorithm>

#include "contact/compliances/interior_parts.h"
#include "io/results/exodus_file.h"
#include "io/results/state_fields.h"

namespace tricontact::io {

namespace {

using contact::Interior;
using contact::Surface;
using contact::SurfaceView;

/// A single row of cells, which has an extent across: its points twice, at both sides.
bool is_row(const SurfaceView& s) {
    return s.layout == Surface::Layout::grid && s.n_y == 1 && s.spacing[1] > 0;
}

std::vector<double> grid_of(const SurfaceView& s) {
    return {static_cast<double>(s.n_x),
            static_cast<double>(s.n_y),
            s.first[0],
            s.first[1],
            s.spacing[0],
            s.spacing[1]};
}

const char* layout_of_points(const SurfaceView& s) {
    return s.layout == Surface::Layout::nodes  ? "nodes"
           : s.layout == Surface::Layout::line ? "line"
                                               : "grid";
}

ExodusBlock quads(int n_x, int n_y) {
    ExodusBlock block{.name = "surface", .element = "QUAD4", .nodes_per_element = 4};
    block.nodes.reserve(std::size_t{4} * n_x * n_y);
    for (int j = 0; j + 1 < n_y; ++j)
        for (int i = 0; i + 1 < n_x; ++i) {
            const int corner = j * n_x + i + 1;
            block.nodes.insert(block.nodes.end(),
                               {corner, corner + 1, corner + n_x + 1, corner + n_x});
        }
    return block;
}

ExodusBlock bars(int n) {
    ExodusBlock block{.name = "surface", .element = "BAR2", .nodes_per_element = 2};
    for (int i = 1; i < n; ++i) block.nodes.insert(block.nodes.end(), {i, i + 1});
    return block;
}

/// VTK's order of 27 nodes as Exodus II has it: edges up come before those above; the centre comes
/// before the faces, which are below, above, then along x and y.
constexpr std::array<int, 27> exodus_order{0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 16, 17,
                                           18, 19, 12, 13, 14, 15, 26, 24, 25, 20, 21, 22, 23};

bool is_of_indenter(const Interior& interior, std::size_t hex) {
    return hex < interior.region.size() && interior.region[hex] == contact::indenter_region;
}

/// Values of hexahedra in the order of the file: those of the substrate, then of the indenter.
template <class Value>
std::vector<Value> by_blocks(const Interior& interior, const std::vector<Value>& values) {
    std::vector<Value> sorted;
    for (const bool indenter : {false, true})
        for (std::size_t c = 0; c < values.size(); ++c)
            if (is_of_indenter(interior, c) == indenter) sorted.push_back(values[c]);
    return sorted;
}

}  // namespace

ExodusMesh mesh_of(const SurfaceView& s) {
    ExodusMesh mesh;
    mesh.grid = grid_of(s);
    mesh.layout = layout_of_points(s);
    if (s.layout == Surface::Layout::nodes) {
        ExodusBlock block{.name = "surface", .element = "QUAD9", .nodes_per_element = 9};
        for (std::size_t i = 0; i < s.size(); ++i)
            mesh.points.push_back({s.node_x[i], s.node_y[i], 0.});
        for (const auto& quad : s.quads)
            for (const int node : quad) block.nodes.push_back(node + 1);
        mesh.blocks.push_back(std::move(block));
        return mesh;
    }
    const double before = is_row(s) ? s.spacing[1] / 2 : 0;
    for (int copy = 0; copy < (is_row(s) ? 2 : 1); ++copy)
        for (int j = 0; j < s.n_y; ++j)
            for (int i = 0; i < s.n_x; ++i)
                mesh.points.push_back({s.x(i), s.y(j) + (2 * copy - 1) * before, 0.});
    mesh.blocks = {s.n_y > 1 || is_row(s) ? quads(s.n_x, is_row(s) ? 2 : s.n_y) : bars(s.n_x)};
    return mesh;
}

bool is_grid_of(const ExodusMesh& mesh, const SurfaceView& s) {
    return s.layout != Surface::Layout::nodes && mesh.layout == layout_of_points(s) &&
           mesh.grid == grid_of(s);
}

ExodusMesh mesh_of(const Interior& interior) {
    ExodusMesh mesh;
    ExodusBlock block{.name = "inside", .element = "HEX8", .nodes_per_element = 8};
    if (!interior.is_grid()) {
        block.element = "HEX27";
        block.nodes_per_element = 27;
        mesh.points = interior.points;
        ExodusBlock indenter = block;
        indenter.name = "indenter";
        for (std::size_t c = 0; c < interior.hexes.size(); ++c) {
            ExodusBlock& its = is_of_indenter(interior, c) ? indenter : block;
            for (const int k : exodus_order)
                its.nodes.push_back(interior.hexes[c].at(static_cast<std::size_t>(k)) + 1);
        }
        if (!block.nodes.empty() || indenter.nodes.empty()) mesh.blocks.push_back(std::move(block));
        if (!indenter.nodes.empty()) mesh.blocks.push_back(std::move(indenter));
        return mesh;
    }
    const auto& [x, y, z] = interior.axes;
    mesh.points.reserve(x.size() * y.size() * z.size());
    block.nodes.reserve(8 * mesh.points.capacity());
    for (const double c : z)
        for (const double b : y)
            for (const double a : x) mesh.points.push_back({a, b, c});
    const auto n_x = static_cast<int>(x.size()), n_xy = n_x * static_cast<int>(y.size());
    for (int k = 0; k + 1 < static_cast<int>(z.size()); ++k)
        for (int j = 0; j + 1 < static_cast<int>(y.size()); ++j)
            for (int i = 0; i + 1 < n_x; ++i) {
                const int at = k * n_xy + j * n_x + i + 1;
                for (const int corner : {at, at + n_xy})
                    block.nodes.insert(block.nodes.end(),
                                       {corner, corner + 1, corner + n_x + 1, corner + n_x});
            }
    mesh.blocks.push_back(std::move(block));
    return mesh;
}

void begin_state(ExodusFields& fields, const Instant& instant, const SurfaceView& s) {
    fields.begin({.copies = is_row(s) ? 2 : 1, .mirrored_columns = s.is_half ? s.n_x : 0});
    fields.add_number(instant.name, instant.time);
    fields.add_number("indenter_position_m_x", s.offset[0]);
    fields.add_number("indenter_position_m_y", s.offset[1]);
    fields.add_number("indenter_position_m_z", 0);
    add_surface_fields(fields, s);
    if (s.layout == Surface::Layout::nodes) {
        fields.begin_elements();
        fields.add_bytes("contact_state", states_of_quads(s), s.quads.size());
    }
}

void begin_state(ExodusFields& fields, const Instant& instant, const Interior& interior) {
    fields.begin({});
    fields.add_number(instant.name, instant.time);
    fields.add_number("strain_energy_J", interior.strain_energy);
    const auto add_force = [&](const std::string& name, const std::array<double, 3>& force) {
        for (std::size_t d = 0; d < 3; ++d) fields.add_number(name + "_" + "xyz"[d], force.at(d));
    };
    add_force("applied_force_N", interior.applied);
    if (const auto& base = interior.base_reaction) add_force("base_reaction_N", *base);
    add_point_fields(fields, interior, interior.size());
    if (!interior.is_grid()) {
        fields.begin_elements();
        fields.add_bytes("region", by_blocks(interior, interior.region), interior.hexes.size());
        fields.add_scalar("strain_energy_density_J_per_m3",
                          by_blocks(interior, interior.energy_density), interior.hexes.size());
    }
}

}  // namespace tricontact::io
