#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <type_traits>

#include "meshes/messages.h"
#include "meshes/msh_model.h"

namespace tricontact::meshes {

namespace {

// An element as the file has it; `what` is its name.
template <std::size_t n, class What>
struct Element {
    std::size_t tag;
    std::array<std::size_t, n> nodes;
    What what;
};
using HexElement = Element<8, Region>;
using QuadElement = Element<4, Boundary>;

template <class What>
constexpr int dimension_of = std::is_same_v<What, Region> ? 3 : 2;
template <class What>
constexpr const char* entity_word = std::is_same_v<What, Region> ? "volume" : "surface";

template <class What>
What parse_name(const std::string& text, const std::string& name) {
    for (int i = 0; i < n_names<What>; ++i)
        if (text == name_of(static_cast<What>(i))) return static_cast<What>(i);
    fail(name, fmt::format("unknown name {} of a physical {}", in_quotes(text), entity_word<What>),
         "the names are " + all_names<What>());
}

// What each named entity of a dimension is.
template <class What>
std::map<long, What> named_entities(const MshModel& model, const std::string& name) {
    std::map<long, What> entities;
    for (const auto& [key, groups] : model.groups) {
        const auto& [dimension, entity] = key;
        if (dimension != dimension_of<What>) continue;
        for (const long group : groups) {
            const auto found = model.names.find({dimension, group});
            const What what =
                parse_name<What>(found == model.names.end() ? "" : found->second, name);
            const auto [at, is_new] = entities.emplace(entity, what);
            if (!is_new && at->second != what)
                fail(name,
                     fmt::format("{} {} is named twice: {} and {}", entity_word<What>, entity,
                                 name_of(at->second), name_of(what)),
                     "put it into one physical group only");
        }
    }
    return entities;
}

/// Elements of the volumes, or of the named surfaces, all of which must be of the type.
template <std::size_t n, class What>
std::vector<Element<n, What>> elements_of(const MshModel& model, int type, bool unnamed_too,
                                          const std::string& name) {
    const std::map<long, What> names = named_entities<What>(model, name);
    std::vector<Element<n, What>> found;
    for (const auto& [key, elements] : model.elements) {
        const auto at = names.find(key.entity);
        if (key.dimension != dimension_of<What> || elements.tags.empty()) continue;
        if (at == names.end() && !unnamed_too) continue;
        if (key.type != type)
            fail(name,
                 fmt::format("{} {} holds {} elements of type \"{}\"", entity_word<What>,
                             key.entity, elements.tags.size(), msh_type(key.type)->name),
                 "use straight hexahedra with 8 nodes and faces with 4 (gmsh: transfinite volumes, "
                 "recombined surfaces, Mesh.ElementOrder = 1), or tetrahedra with 10 and faces "
                 "with 6 (Mesh.ElementOrder = 2)");
        if (at == names.end())
            fail(name,
                 fmt::format("{} hexahedra of volume {} belong to no physical volume",
                             elements.tags.size(), key.entity),
                 "name it: " + all_names<What>());
        for (std::size_t e = 0; e < elements.tags.size(); ++e) {
            Element<n, What> element{elements.tags[e], {}, at->second};
            std::copy_n(elements.nodes.begin() + e * n, n, element.nodes.begin());
            found.push_back(element);
        }
    }
    std::ranges::stable_sort(found, {}, &Element<n, What>::tag);
    return found;
}

/// Numbers of the hexahedra's nodes, in the order of their tags.
class NodeNumbers {
  public:
    explicit NodeNumbers(const MshModel& model)
        : nodes_(model.nodes), numbers_(model.nodes.size(), -1) {}

    /// Where the node stands among those of the model, which ascend; npos if nowhere.
    std::size_t find(std::size_t tag) const {
        if (nodes_.empty() || tag < nodes_.front().tag) return npos;
        const std::size_t guess = tag - nodes_.front().tag;  // where they are numbered through
        if (guess < nodes_.size() && nodes_[guess].tag == tag) return guess;
        const auto at = std::ranges::lower_bound(nodes_, tag, {}, &MshModel::Node::tag);
        return at == nodes_.end() || at->tag != tag ? npos
                                                    : static_cast<std::size_t>(at - nodes_.begin());
    }
    void use(std::size_t at) { numbers_[at] = 0; }
    /// Numbers those that are used; their positions.
    std::vector<Point> count(double unit) {
        std::vector<Point> positions;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            if (numbers_[i] < 0) continue;
            numbers_[i] = static_cast<int>(positions.size());
            Point position = nodes_[i].position;
            for (double& x : position) x *= unit;
            positions.push_back(position);
        }
        return positions;
    }
    int operator[](std::size_t at) const { return numbers_[at]; }

    static constexpr std::size_t npos = static_cast<std::size_t>(-1);

  private:
    const std::vector<MshModel::Node>& nodes_;
    std::vector<int> numbers_;
};

// Of elements that are not used, too: a file with one that has no nodes is damaged.
void check_nodes(const MshModel& model, const NodeNumbers& numbers, const std::string& name) {
    for (const auto& [key, elements] : model.elements) {
        const auto n = static_cast<std::size_t>(msh_type(key.type)->n_nodes);
        for (std::size_t i = 0; i < elements.nodes.size(); ++i)
            if (numbers.find(elements.nodes[i]) == NodeNumbers::npos)
                fail(name,
                     fmt::format("node {} of element {} is not among its nodes", elements.nodes[i],
                                 elements.tags[i / n]),
                     "save or copy the mesh again");
    }
}

template <std::size_t n, class What>
std::array<int, n> node_numbers_of(const Element<n, What>& element, const NodeNumbers& numbers,
                                   const std::string& name) {
    std::array<int, n> nodes{};
    for (std::size_t i = 0; i < n; ++i) {
        nodes[i] = numbers[numbers.find(element.nodes[i])];
        if (nodes[i] < 0)
            fail(name,
                 fmt::format("node {} of element {} belongs to no hexahedron", element.nodes[i],
                             element.tag),
                 "name boundary faces of the body only");
    }
    return nodes;
}

}  // namespace

HexMesh mesh_of(const MshModel& model, double unit, const std::string& name) {
    NodeNumbers numbers(model);
    check_nodes(model, numbers, name);
    const auto hexes = elements_of<8, Region>(model, hexahedron, true, name);
    if (hexes.empty())
        fail(name, "holds no hexahedra",
             "mesh the volume before saving, and name it (gmsh saves nothing else once a surface "
             "has a name): " +
                 all_names<Region>());
    const auto faces = elements_of<4, Boundary>(model, quadrilateral, false, name);
    for (const HexElement& hex : hexes)
        for (const std::size_t tag : hex.nodes) numbers.use(numbers.find(tag));
    HexMesh mesh;
    mesh.nodes = numbers.count(unit);
    for (const HexElement& hex : hexes) {
        mesh.hexes.push_back(node_numbers_of(hex, numbers, name));
        mesh.regions.push_back(hex.what);
    }
    for (const QuadElement& face : faces)
        mesh.faces.push_back({node_numbers_of(face, numbers, name), face.what});
    return mesh;
}

}  // namespace tricontact::meshes
