#include "benchmarks/decks/mesh_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "benchmarks/decks/contact_mesh.h"
#include "benchmarks/decks/pair_bodies.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

struct SetName {
    const char *set, *name;
};
constexpr SetName set_names[]{{"NBASE", "base"}, {"NSIDE", "side"},    {"NCONTACT", "contact"},
                              {"NAXIS", "axis"}, {"NSYM", "symmetry"}, {"NLOAD", "loaded"}};

std::vector<char> flags_of(const DeckMesh& mesh, const std::string& set) {
    std::vector<char> flags(mesh.nodes.size(), 0);
    if (const auto found = mesh.node_sets.find(set); found != mesh.node_sets.end())
        for (const int node : found->second) flags[node] = 1;
    return flags;
}

// Middles of edges of a hexahedron in Gmsh's order, as places in Abaqus'.
constexpr int gmsh_middles[]{8, 11, 16, 9, 17, 10, 18, 19, 12, 15, 13, 14};

std::vector<int> in_gmsh_order(const std::vector<int>& element) {
    if (element.size() != 20) return element;
    std::vector<int> ordered(element.begin(), element.begin() + 8);
    for (const int place : gmsh_middles) ordered.push_back(element[place]);
    return ordered;
}

// Gmsh's numbers of elements by their nodes: lines, quadrilaterals, hexahedra.
int gmsh_type(int dimension, std::size_t n_nodes) {
    if (dimension == 1) return n_nodes == 2 ? 1 : 8;
    if (dimension == 2) return n_nodes == 4 ? 3 : 16;
    return n_nodes == 8 ? 5 : 17;
}

std::string box_text(const DeckMesh& mesh) {
    DeckMesh::Point low = mesh.nodes.front(), high = low;
    for (const DeckMesh::Point& p : mesh.nodes)
        for (int k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    return fmt::format("{:.10g} {:.10g} {:.10g} {:.10g} {:.10g} {:.10g}", low[0], low[1], low[2],
                       high[0], high[1], high[2]);
}

using Out = std::back_insert_iterator<std::string>;

void write_msh_elements(Out out, int dimension, int entity, int& number,
                        const std::vector<std::vector<int>>& elements) {
    fmt::format_to(out, "{} {} {} {}\n", dimension, entity,
                   gmsh_type(dimension, elements.front().size()), elements.size());
    for (const std::vector<int>& element : elements) {
        fmt::format_to(out, "{}", number++);
        for (const int node : in_gmsh_order(element)) fmt::format_to(out, " {}", node + 1);
        fmt::format_to(out, "\n");
    }
}

DeckMesh mesh_of(const BodyMesh& body, bool is_quadratic) {
    DeckMesh mesh;
    mesh.is_quadratic = is_quadratic;
    mesh.nodes = body.nodes;
    mesh.elements = body.elements;
    mesh.n_body_elements = mesh.n_elements();
    const auto add = [&](const char* set, const std::vector<std::vector<int>>& sides) {
        for (const auto& edge : sides)
            mesh.node_sets[set].insert(mesh.node_sets[set].end(), edge.begin(), edge.end());
    };
    // A single node is that at which a force acts: the contact alone holds the body.
    if (body.held.size() > 1) mesh.node_sets["NBASE"] = body.held;
    if (!body.axis.empty()) mesh.node_sets["NAXIS"] = body.axis;
    add("NCONTACT", body.contact);
    add("NLOAD", body.loaded);
    return mesh;
}

/// Names of files and what they contain.
std::vector<std::pair<std::string, DeckMesh>> meshes_of(const DeckModel& model, int n, int level,
                                                        bool is_quadratic) {
    if (!model.upper) return {{"", block_mesh(model, n, level, is_quadratic)}};
    const BodyPair pair = body_pair(model, n, level, is_quadratic);
    return {{"_lower", mesh_of(pair.lower, is_quadratic)},
            {"_upper", mesh_of(pair.upper, is_quadratic)}};
}

}  // namespace

std::vector<NamedFaces> named_faces(const DeckMesh& mesh) {
    std::vector<NamedFaces> parts;
    for (const auto& [set, name] : set_names) {
        if (!mesh.node_sets.contains(set)) continue;
        NamedFaces part{name, {}};
        const std::vector<char> flags = flags_of(mesh, set);
        for (int e = 0; e < mesh.n_elements(); ++e)
            for (int f = 1; f <= (mesh.dimension == 2 ? 4 : 6); ++f) {
                const std::vector<int> nodes = mesh.face_nodes({e, f});
                if (std::ranges::all_of(nodes, [&](int node) { return flags[node] != 0; }))
                    part.faces.push_back({e, f});
            }
        parts.push_back(std::move(part));
    }
    return parts;
}

std::string msh_text(const DeckMesh& mesh) {
    const std::vector<NamedFaces> parts = named_faces(mesh);
    const int dimension = mesh.dimension, n_parts = static_cast<int>(parts.size());
    std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    const Out out = std::back_inserter(text);
    fmt::format_to(out, "$PhysicalNames\n{}\n{} {} \"body\"\n", n_parts + 1, dimension,
                   n_parts + 1);
    for (int i = 0; i < n_parts; ++i)
        fmt::format_to(out, "{} {} \"{}\"\n", dimension - 1, i + 1, parts[i].name);
    const std::string box = box_text(mesh);
    // Points, curves, surfaces, volumes; an entity for each part, the block's own last.
    fmt::format_to(
        out, "$EndPhysicalNames\n$Entities\n{}\n",
        dimension == 2 ? fmt::format("0 {} 1 0", n_parts) : fmt::format("0 0 {} 1", n_parts));
    for (int i = 0; i <= n_parts; ++i)
        fmt::format_to(out, "{} {} 1 {} 0\n", i < n_parts ? i + 1 : 1, box, i + 1);
    fmt::format_to(out, "$EndEntities\n$Nodes\n1 {0} 1 {0}\n{1} 1 0 {0}\n", mesh.nodes.size(),
                   dimension);
    for (std::size_t i = 1; i <= mesh.nodes.size(); ++i) fmt::format_to(out, "{}\n", i);
    for (const DeckMesh::Point& p : mesh.nodes)
        fmt::format_to(out, "{:.10g} {:.10g} {:.10g}\n", p[0], p[1], p[2]);
    std::size_t n_all = mesh.elements.size();
    for (const NamedFaces& part : parts) n_all += part.faces.size();
    fmt::format_to(out, "$EndNodes\n$Elements\n{} {} 1 {}\n", n_parts + 1, n_all, n_all);
    int number = 1;
    for (int i = 0; i < n_parts; ++i) {
        std::vector<std::vector<int>> faces;
        for (const ElementFace& face : parts[i].faces) faces.push_back(mesh.face_nodes(face));
        write_msh_elements(out, dimension - 1, i + 1, number, faces);
    }
    write_msh_elements(out, dimension, 1, number, mesh.elements);
    text += "$EndElements\n";
    return text;
}

std::string vtu_text(const DeckMesh& mesh) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
        "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n";
    const Out out = std::back_inserter(text);
    fmt::format_to(out, "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<PointData>\n",
                   mesh.nodes.size(), mesh.elements.size());
    for (const auto& [set, name] : set_names) {
        if (!mesh.node_sets.contains(set)) continue;
        fmt::format_to(out, "<DataArray type=\"UInt8\" Name=\"{}\" format=\"ascii\">\n", name);
        const std::vector<char> flags = flags_of(mesh, set);
        for (std::size_t i = 0; i < flags.size(); ++i)
            fmt::format_to(out, "{}{}", int{flags[i]},
                           i % 40 == 39 || i + 1 == flags.size() ? "\n" : " ");
        text += "</DataArray>\n";
    }
    text +=
        "</PointData>\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" "
        "format=\"ascii\">\n";
    for (const DeckMesh::Point& p : mesh.nodes)
        fmt::format_to(out, "{:.10g} {:.10g} {:.10g}\n", p[0], p[1], p[2]);
    text +=
        "</DataArray>\n</Points>\n<Cells>\n<DataArray type=\"Int32\" Name=\"connectivity\" "
        "format=\"ascii\">\n";
    for (const std::vector<int>& element : mesh.elements) {
        for (const int node : element) fmt::format_to(out, "{} ", node);
        text.back() = '\n';
    }
    text += "</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">\n";
    const std::size_t n = mesh.elements.front().size();
    for (std::size_t i = 1; i <= mesh.elements.size(); ++i) fmt::format_to(out, "{}\n", i * n);
    text += "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n";
    const int type =
        mesh.dimension == 2 ? (mesh.is_quadratic ? 23 : 9) : (mesh.is_quadratic ? 25 : 12);
    for (std::size_t i = 0; i < mesh.elements.size(); ++i) fmt::format_to(out, "{}\n", type);
    text += "</DataArray>\n</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    return text;
}

DeckFamily mesh_family(const DeckModel& model, const DeckWishes& wishes) {
    const std::string element = wishes.elements.empty() ? "quadratic" : wishes.elements;
    if (element != "quadratic" && element != "linear")
        throw contact::InputError("deck: elements " + element +
                                  " are none of a mesh; choose of quadratic, linear");
    DeckFamily family;
    family.elements = element;
    const int coarsest = coarsest_elements(model);
    for (int level = 0; level < levels_of(model, wishes); ++level) {
        const std::string job = add_run(family, model);
        DeckRun& run = family.runs.back();
        for (const auto& [name, mesh] : meshes_of(model, coarsest, level, element == "quadratic")) {
            run.files.push_back({job + name + ".msh", msh_text(mesh)});
            run.files.push_back({job + name + ".vtu", vtu_text(mesh)});
        }
        run.field = job + ".csv";
    }
    return family;
}

}  // namespace tricontact::benchmarks
