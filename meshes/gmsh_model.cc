#include "meshes/gmsh_model.h"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <array>
#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "meshes/mesh_format.h"
#include "meshes/messages.h"

namespace tricontact::meshes {

namespace {

namespace fs = std::filesystem;

std::mutex& library_mutex() {
    static std::mutex mutex;
    return mutex;
}

std::string current_locale() {
    const char* name = std::setlocale(LC_ALL, nullptr);
    return name != nullptr ? name : "C";
}

// gmsh asks its window library FLTK 1.3 for an option as it starts, upon which FLTK writes empty
// preferences below the user's home and /etc. What was not there before is removed again.
class ToolkitPreferences {
  public:
    ToolkitPreferences() {
        const char* home = std::getenv("HOME");
        if (home != nullptr && *home != '\0') note_missing(fs::path(home) / ".fltk");
        note_missing("/etc/fltk");
    }
    ~ToolkitPreferences() {
        std::error_code ignored;  // a folder that others filled meanwhile stays
        for (const fs::path& path : missing_) fs::remove(path, ignored);
    }
    ToolkitPreferences(const ToolkitPreferences&) = delete;
    ToolkitPreferences& operator=(const ToolkitPreferences&) = delete;

  private:
    void note_missing(const fs::path& root) {
        const fs::path folder = root / "fltk.org";
        std::error_code ignored;
        for (const fs::path& path : {folder / "fltk.prefs", folder, root})
            if (!fs::exists(fs::symlink_status(path, ignored))) missing_.push_back(path);
    }
    std::vector<fs::path> missing_;
};

void start() {
    const ToolkitPreferences preferences;
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::model::add("tricontact");
}

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
constexpr int n_names = std::is_same_v<What, Region> ? n_regions : n_boundaries;
template <class What>
constexpr const char* entity_word = std::is_same_v<What, Region> ? "volume" : "surface";

template <class What>
What parse_name(const std::string& text, const std::string& name) {
    for (int i = 0; i < n_names<What>; ++i)
        if (text == name_of(static_cast<What>(i))) return static_cast<What>(i);
    fail(name, fmt::format("unknown name {} of a physical {}", in_quotes(text), entity_word<What>),
         "the names are " + (dimension<What> == 3 ? region_names() : boundary_names()));
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
                 "name it: " + region_names());
    }
    if (hexes.empty())
        fail(name, "holds no hexahedra",
             "mesh the volume before saving, and name it (gmsh saves nothing else once a surface "
             "has a name): " +
                 region_names());
    return hexes;
}

std::vector<QuadElement> quadrilaterals(const std::string& name) {
    std::vector<QuadElement> faces;
    for (const auto& [surface, boundary] : named_entities<Boundary>(name))
        collect_elements(surface, quadrilateral, boundary, name, faces);
    return faces;
}

// Tags of all nodes of the hexahedra, ascending.
std::vector<Tag> used_nodes(const std::vector<HexElement>& hexes) {
    std::vector<Tag> tags;
    tags.reserve(8 * hexes.size());
    for (const HexElement& hex : hexes) tags.insert(tags.end(), hex.nodes.begin(), hex.nodes.end());
    std::sort(tags.begin(), tags.end());
    tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
    return tags;
}

std::optional<int> position(const std::vector<Tag>& tags, Tag tag) {
    const auto at = std::lower_bound(tags.begin(), tags.end(), tag);
    if (at == tags.end() || *at != tag) return {};
    return static_cast<int>(at - tags.begin());
}

template <std::size_t n, class What>
std::array<int, n> numbers(const Element<n, What>& element, const std::vector<Tag>& tags,
                           const std::string& name) {
    std::array<int, n> nodes{};
    for (std::size_t i = 0; i < n; ++i) {
        const std::optional<int> at = position(tags, element.nodes[i]);
        if (!at)
            fail(name,
                 fmt::format("node {} of element {} belongs to no hexahedron", element.nodes[i],
                             element.tag),
                 "name boundary faces of the body only");
        nodes[i] = *at;
    }
    return nodes;
}

std::vector<std::array<double, 3>> positions(const std::vector<Tag>& used, double unit) {
    std::vector<Tag> tags;
    std::vector<double> coordinates, unused;
    gmsh::model::mesh::getNodes(tags, coordinates, unused, -1, -1, false, false);
    std::vector<std::array<double, 3>> nodes(used.size());
    for (std::size_t k = 0; k < tags.size(); ++k)
        if (const std::optional<int> at = position(used, tags[k]))
            for (int d = 0; d < 3; ++d) nodes[*at][d] = coordinates[3 * k + d] * unit;
    return nodes;
}

template <class Elements>
void sort_by_tag(Elements& elements) {
    std::stable_sort(elements.begin(), elements.end(),
                     [](const auto& a, const auto& b) { return a.tag < b.tag; });
}

}  // namespace

void GmshSession::call(const std::function<void()>& function) {
    // gmsh 4.8 throws strings; older ones threw numbers, exceptions may come from below it.
    try {
        function();
    } catch (const std::string& message) {
        throw std::runtime_error("gmsh: " + message);
    } catch (const int code) {
        throw std::runtime_error("gmsh: error " + std::to_string(code));
    }
}

GmshSession::GmshSession() : lock_(library_mutex()), locale_(current_locale()) {
    call(start);
}

GmshSession::~GmshSession() {
    try {
        gmsh::finalize();
    } catch (...) {  // nothing can be done about it here, and the model is gone anyway
    }
    std::setlocale(LC_ALL, locale_.c_str());
}

HexMesh collect_model(double unit, const std::string& name) {
    std::vector<HexElement> hexes = hexahedra(name);
    std::vector<QuadElement> faces = quadrilaterals(name);
    sort_by_tag(hexes);
    sort_by_tag(faces);
    const std::vector<Tag> used = used_nodes(hexes);
    HexMesh mesh;
    mesh.nodes = positions(used, unit);
    for (const HexElement& hex : hexes) {
        mesh.hexes.push_back(numbers(hex, used, name));
        mesh.regions.push_back(hex.what);
    }
    for (const QuadElement& face : faces)
        mesh.faces.push_back({numbers(face, used, name), face.what});
    return mesh;
}

template <class What>
void add_entity(What what) {
    constexpr int dim = dimension<What>;
    const int tag = physical_tag(what);
    gmsh::model::addDiscreteEntity(dim, tag);
    gmsh::model::addPhysicalGroup(dim, {tag}, tag);
    gmsh::model::setPhysicalName(dim, tag, name_of(what));
}
template void add_entity(Boundary what);
template void add_entity(Region what);

}  // namespace tricontact::meshes
