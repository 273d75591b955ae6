#include "meshes/body_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/base/special_values.h"
#include "meshes/mesh_checks.h"
#include "meshes/messages.h"
#include "meshes/msh_model.h"

namespace tricontact::meshes {

namespace {

// The names of a body's groups, and those of the reader of layers.
struct BodyName {
    const char *given, *as_read;
};
constexpr std::array surface_names{BodyName{"contact", "contact"}, BodyName{"support", "base"},
                                   BodyName{"symmetry", "symmetry"}};
constexpr std::array volume_names{BodyName{"body", "layer"}};

template <class Names>
std::string list_of(const Names& names) {
    std::string list;
    for (const BodyName& one : names)
        list.append(list.empty() ? "\"" : ", \"").append(one.given).append("\"");
    return list;
}

template <class Names>
const char* as_read(const Names& names, const std::string& given, const char* what,
                    const std::string& file) {
    for (const BodyName& one : names)
        if (given == one.given) return one.as_read;
    fail(file, fmt::format("unknown name {} of a physical {}", in_quotes(given), what),
         "those of a body are " + list_of(names));
}

// Only groups that an entity belongs to: names alone do no harm.
void rename_groups(MshModel& model, const std::string& file) {
    for (const auto& [entity, groups] : model.groups) {
        if (entity.first < 2) continue;
        const bool volume = entity.first == 3;
        if (groups.size() > 1)
            fail(file,
                 fmt::format("{} {} is in {} physical groups", volume ? "volume" : "surface",
                             entity.second, groups.size()),
                 "put it into one physical group only");
    }
    for (auto& [group, name] : model.names) {
        if (group.first == 2) name = as_read(surface_names, name, "surface", file);
        if (group.first == 3) name = as_read(volume_names, name, "volume", file);
    }
}

// Reading goes on with the names that are known: what has none would be called by another.
void require_names(const MshModel& model, const std::string& file) {
    const auto has = [&](int dimension, const char* name) {
        return std::ranges::any_of(model.groups, [&](const auto& entity) {
            return entity.first.first == dimension &&
                   std::ranges::any_of(entity.second, [&](long group) {
                       const auto at = model.names.find({dimension, group});
                       return at != model.names.end() && at->second == name;
                   });
        });
    };
    for (const auto& [key, elements] : model.elements) {
        if (key.dimension != 3 || elements.tags.empty()) continue;
        const auto at = model.groups.find({3, key.entity});
        if (at == model.groups.end() || at->second.empty())
            fail(file, fmt::format("volume {} belongs to no physical group", key.entity),
                 "make a physical volume \"body\" of it");
    }
    const auto require = [&](int dimension, const BodyName& name, const char* why) {
        if (!has(dimension, name.as_read))
            fail(file,
                 fmt::format("has no {} \"{}\"{}", dimension == 3 ? "volume" : "surface",
                             name.given, why),
                 fmt::format("make a physical {} of this name",
                             dimension == 3 ? "volume" : "surface"));
    };
    require(2, surface_names[0], ", which is to touch the other body");
    require(2, surface_names[1], ": nothing holds the body");
}

using Quad = std::array<int, 4>;

Quad outward(const HexMesh& mesh, const FaceTable::Side& side) {
    Quad nodes{};
    for (int i = 0; i < 4; ++i) nodes[i] = mesh.hexes[side.hex][hex_faces[side.face][i]];
    return nodes;
}

std::array<Point, 4> corners_of_face(const HexMesh& mesh, const Quad& nodes) {
    std::array<Point, 4> corners;
    std::ranges::transform(nodes, corners.begin(), [&](int node) { return mesh.nodes[node]; });
    return corners;
}

double half_width(const std::array<Point, 4>& corners) {
    return std::max(distance(corners[0], corners[2]), distance(corners[1], corners[3])) / 2;
}

// Free faces of a crack touch others: blocks that are divided differently, or not joined.
void refuse_cracks(const HexMesh& mesh, const std::vector<Quad>& free, const std::string& file) {
    struct Place {
        Point centre;
        double reach;
    };
    std::vector<Place> places;
    for (const Quad& nodes : free)
        places.push_back({centre_of(mesh, nodes), half_width(corners_of_face(mesh, nodes))});
    for (std::size_t a = 0; a < free.size(); ++a)
        for (std::size_t b = 0; b < free.size(); ++b) {
            if (a == b || distance(places[a].centre, places[b].centre) > places[b].reach) continue;
            if (!covers(corners_of_face(mesh, free[b]), places[a].centre,
                        negligible * places[a].reach))
                continue;
            fail(file,
                 fmt::format("the body is open at {}: a face touches another without sharing its "
                             "nodes",
                             place(places[a].centre)),
                 "divide the blocks on both sides alike and join them (gmsh: Coherence)");
        }
}

// Boundary faces without a name are free.
void name_free_faces(HexMesh& mesh, const std::string& file) {
    const FaceTable table(mesh);
    std::vector<bool> named(table.n_faces(), false);
    for (const HexMesh::Face& face : mesh.faces)
        if (const std::size_t at = table.find(face.nodes); at < table.n_faces()) named[at] = true;
    std::vector<Quad> free;
    for (std::size_t f = 0; f < table.n_faces(); ++f)
        if (table.sides(f).size() == 1 && !named[f])
            free.push_back(outward(mesh, table.sides(f)[0]));
    refuse_cracks(mesh, free, file);
    for (const Quad& nodes : free) mesh.faces.push_back({nodes, Boundary::free_top});
}

void check_support(const HexMesh& mesh, const std::string& file) {
    std::vector<bool> held(mesh.nodes.size(), false);
    for (const HexMesh::Face& face : mesh.faces)
        if (face.boundary == Boundary::base)
            for (const int node : face.nodes) held[node] = true;
    for (const HexMesh::Face& face : mesh.faces) {
        if (face.boundary != Boundary::contact) continue;
        for (const int node : face.nodes)
            if (held[node])
                fail(file,
                     fmt::format("the support touches the contact at {}", place(mesh.nodes[node])),
                     "leave free faces between both");
    }
}

void check_half(const HexMesh& mesh, const std::string& file) {
    if (!mesh.has_symmetry()) return;
    double size = 0;
    for (const Point& node : mesh.nodes) size = std::max(size, std::abs(node[1]));
    for (const Point& node : mesh.nodes)
        if (node[1] < -negligible * size)
            fail(file,
                 fmt::format("the node at {} lies beyond the plane of symmetry y = 0", place(node)),
                 "keep the half at y >= 0 only");
    for (const HexMesh::Face& face : mesh.faces) {
        if (face.boundary != Boundary::symmetry) continue;
        for (const int node : face.nodes)
            if (std::abs(mesh.nodes[node][1]) > negligible * size)
                fail(file,
                     fmt::format("the symmetry face at {} does not lie in the plane y = 0",
                                 place(centre_of(mesh, face.nodes))),
                     "the plane of symmetry is y = 0, with the body at y >= 0");
    }
}

}  // namespace

HexMesh read_body_mesh(const std::string& path, double unit) {
    if (!contact::is_positive_and_finite(unit))
        fail(path, fmt::format("the unit of length is {:g} m", unit), "make it a positive length");
    MshFile file;
    open_msh_file(path, file);
    MshModel model = read_msh_model(file);
    rename_groups(model, path);
    const bool has_volume = std::ranges::any_of(model.elements, [](const auto& elements) {
        return elements.first.dimension == 3 && !elements.second.tags.empty();
    });
    if (!has_volume)
        fail(path, "is open: it holds surfaces and no volume",
             "mesh the volume (gmsh -3) and put it into a physical volume \"body\"");
    require_names(model, path);
    HexMesh mesh = mesh_of(model, unit, path);
    check_shape(mesh, path);
    name_free_faces(mesh, path);
    check_solid(mesh, path);
    check_support(mesh, path);
    check_half(mesh, path);
    // Halves lie in their plane to the last digit.
    if (mesh.has_symmetry())
        for (const HexMesh::Face& face : mesh.faces)
            if (face.boundary == Boundary::symmetry)
                for (const int node : face.nodes) mesh.nodes[node][1] = 0;
    return mesh;
}

void check_facing(const HexMesh& mesh, bool up, const std::string& name) {
    constexpr double steepest = .5;  // cosine of 60 degrees
    const FaceTable table(mesh);
    for (const HexMesh::Face& face : mesh.faces) {
        if (face.boundary != Boundary::contact) continue;
        const auto corners =
            corners_of_face(mesh, outward(mesh, table.sides(table.find(face.nodes))[0]));
        const Point normal =
            cross(difference(corners[2], corners[0]), difference(corners[3], corners[1]));
        const double along = normal[2] / std::sqrt(dot(normal, normal));
        if (up ? along >= steepest : along <= -steepest) continue;
        fail(name,
             fmt::format("the contact face at {} does not face the other body: z of its outward "
                         "normal is {:.3g}, not {} {:g}",
                         place(centre_of(mesh, face.nodes)), along, up ? "above" : "below",
                         up ? steepest : -steepest),
             up ? "name \"contact\" what faces up, the body below it"
                : "turn the body so that its contact surface faces down, and name no more than "
                  "that");
    }
}

void check_above_plane(const HexMesh& mesh, const std::string& name) {
    double size = 0;
    for (const Point& node : mesh.nodes)
        size = std::max(size, std::abs(node[2] - mesh.nodes[0][2]));
    const auto lowest =
        std::ranges::min_element(mesh.nodes, {}, [](const Point& x) { return x[2]; });
    if ((*lowest)[2] >= -negligible * size) return;
    fail(name,
         fmt::format(
             "the bodies overlap: the node at {} lies {:.4g} m below the substrate's surface "
             "z = 0",
             place(*lowest), -(*lowest)[2]),
         "move the indenter up; it is let down until it touches");
}

HexMesh turned_over(const HexMesh& mesh) {
    HexMesh turned = mesh;
    for (Point& node : turned.nodes) node[2] = -node[2];
    for (auto& hex : turned.hexes)
        hex = {hex[4], hex[5], hex[6], hex[7], hex[0], hex[1], hex[2], hex[3]};
    for (HexMesh::Face& face : turned.faces) std::ranges::reverse(face.nodes);
    return turned;
}

}  // namespace tricontact::meshes
