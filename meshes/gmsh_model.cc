#include "meshes/gmsh_model.h"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "meshes/messages.h"

namespace tricontact::meshes {

namespace {

using Tag = std::size_t;

// An element as gmsh knows it; `what` is its name.
template <std::size_t n, class What>
struct Element {
    Tag tag;
    std::array<Tag, n> nodes;
    What what;
};
using HexElement = Element<8, Region>;
using QuadElement = Element<4, Boundary>;

template <class What>
constexpr int dimension = std::is_same_v<What, Region> ? 3 : 2;
template <class What>
constexpr const char* entity_word = std::is_same_v<What, Region> ? "volume" : "surface";

template <class What>
What parse_name(const std::string& text, const std::string& name) {
    for (int i = 0; i < n_names<What>; ++i)
        if (text == name_of(static_cast<What>(i))) return static_cast<What>(i);
    fail(name, fmt::format("unknown name {} of a physical {}", in_quotes(text), entity_word<What>),
         "the names are " + all_names<What>());
}

// What each entity of a dimension is, by tag.
template <class What>
std::map<int, What> named_entities(const std::string& name) {
    gmsh::vectorpair groups;
    gmsh::model::getPhysicalGroups(groups, dimension<What>);
    std::map<int, What> entities;
    for (const auto& [dim, group] : groups) {
        std::string text;
        gmsh::model::getPhysicalName(dim, group, text);
        const What what = parse_name<What>(text, name);
        std::vector<int> tags;
        gmsh::model::getEntitiesForPhysicalGroup(dim, group, tags);
        for (const int tag : tags) {
            const auto [at, is_new] = entities.emplace(tag, what);
            if (!is_new && at->second != what)
                fail(name,
                     fmt::format("{} {} is named twice: {} and {}", entity_word<What>, tag,
                                 name_of(at->second), name_of(what)),
                     "put it into one physical group only");
        }
    }
    return entities;
}

// Elements of one entity, all of which must be of the type.
template <std::size_t n, class What>
void collect_elements(int entity, int type, What what, const std::string& name,
                      std::vector<Element<n, What>>& elements) {
    std::vector<int> types;
    std::vector<std::vector<Tag>> tags, nodes;
    gmsh::model::mesh::getElements(types, tags, nodes, dimension<What>, entity);
    for (std::size_t t = 0; t < types.size(); ++t) {
        if (types[t] != type) {
            std::string kind;
            std::vector<double> coordinates;
            int dim = 0, order = 0, n_nodes = 0, n_primary = 0;
            gmsh::model::mesh::getElementProperties(types[t], kind, dim, order, n_nodes,
                                                    coordinates, n_primary);
            fail(name,
                 fmt::format("{} {} holds {} elements of type \"{}\"", entity_word<What>, entity,
                             tags[t].size(), kind),
                 "use straight hexahedra with 8 nodes and faces with 4 only (gmsh: transfinite "
                 "volumes, recombined surfaces, Mesh.ElementOrder = 1)");
        }
        for (std::size_t e = 0; e < tags[t].size(); ++e) {
            Element<n, What> element{tags[t][e], {}, what};
            std::copy_n(nodes[t].begin() + e * n, n, element.nodes.begin());
            elements.push_back(element);
        }
    }
}

std::vector<HexElement> hexahedra(const std::string& name) {
    const std::map<int, Region> names = named_entities<Region>(name);
    gmsh::vectorpair volumes;
    gmsh::model::getEntities(volumes, 3);
    std::vector<HexElement> hexes;
    for (const auto& [dim, volume] : volumes) {
        const auto at = names.find(volume);
        const std::size_t n_before = hexes.size();
        collect_elements(volume, hexahedron, at == names.end() ? Region::layer : at->second, name,
                         hexes);
        if (at == names.end() && hexes.size() > n_before)
            fail(name,
                 fmt::format("{} hexahedra of volume {} belong to no physical volume",
                             hexes.size() - n_before, volume),
                 "name it: " + all_names<Region>());
    }
    if (hexes.empty())
        fail(name, "holds no hexahedra",
             "mesh the volume before saving, and name it (gmsh saves nothing else once a surface "
             "has a name): " +
                 all_names<Region>());
    return hexes;
}

std::vector<QuadElement> quadrilaterals(const std::string& name) {
    std::vector<QuadElement> faces;
    for (const auto& [surface, boundary] : named_entities<Boundary>(name))
        collect_elements(surface, quadrilateral, boundary, name, faces);
    return faces;
}

// Numbers of the hexahedra's nodes, in the order of their tags.
std::map<Tag, int> node_numbers(const std::vector<HexElement>& hexes) {
    std::map<Tag, int> numbers;
    for (const HexElement& hex : hexes)
        for (const Tag tag : hex.nodes) numbers.emplace(tag, 0);
    int next = 0;
    for (auto& [tag, number] : numbers) number = next++;
    return numbers;
}

template <std::size_t n, class What>
std::array<int, n> node_numbers_of(const Element<n, What>& element,
                                   const std::map<Tag, int>& numbers, const std::string& name) {
    std::array<int, n> nodes{};
    for (std::size_t i = 0; i < n; ++i) {
        const auto at = numbers.find(element.nodes[i]);
        if (at == numbers.end())
            fail(name,
                 fmt::format("node {} of element {} belongs to no hexahedron", element.nodes[i],
                             element.tag),
                 "name boundary faces of the body only");
        nodes[i] = at->second;
    }
    return nodes;
}

std::vector<std::array<double, 3>> positions(const std::map<Tag, int>& numbers, double unit) {
    std::vector<Tag> tags;
    std::vector<double> coordinates, unused;
    gmsh::model::mesh::getNodes(tags, coordinates, unused, -1, -1, false, false);
    std::vector<std::array<double, 3>> nodes(numbers.size());
    for (std::size_t k = 0; k < tags.size(); ++k)
        if (const auto at = numbers.find(tags[k]); at != numbers.end())
            for (int d = 0; d < 3; ++d) nodes[at->second][d] = coordinates[3 * k + d] * unit;
    return nodes;
}

template <class Elements>
void sort_by_tag(Elements& elements) {
    std::stable_sort(elements.begin(), elements.end(),
                     [](const auto& a, const auto& b) { return a.tag < b.tag; });
}

}  // namespace

HexMesh collect_model(double unit, const std::string& name) {
    std::vector<HexElement> hexes = hexahedra(name);
    std::vector<QuadElement> faces = quadrilaterals(name);
    sort_by_tag(hexes);
    sort_by_tag(faces);
    const std::map<Tag, int> numbers = node_numbers(hexes);
    HexMesh mesh;
    mesh.nodes = positions(numbers, unit);
    for (const HexElement& hex : hexes) {
        mesh.hexes.push_back(node_numbers_of(hex, numbers, name));
        mesh.regions.push_back(hex.what);
    }
    for (const QuadElement& face : faces)
        mesh.faces.push_back({node_numbers_of(face, numbers, name), face.what});
    return mesh;
}

}  // namespace tricontact::meshes
