#include "meshes/tetrahedra.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <map>
#include <utility>
#include <vector>

namespace tricontact::meshes {

namespace {

using Tag = std::size_t;

constexpr int quadratic_triangle = 9, quadratic_tetrahedron = 11;

// The node amid the edge of two corners, as gmsh counts.
constexpr std::array<std::array<int, 4>, 4> amid{
    {{-1, 4, 6, 7}, {4, -1, 5, 9}, {6, 5, -1, 8}, {7, 9, 8, -1}}};
// From each corner the other three, by even permutations: all four hexahedra are right-handed if
// the tetrahedron is.
constexpr std::array<std::array<int, 4>, 4> from_corner{
    {{0, 1, 2, 3}, {1, 2, 0, 3}, {2, 0, 1, 3}, {3, 1, 0, 2}}};

const MshModel::Node* find_node(const MshModel& model, Tag tag) {
    const auto at = std::ranges::lower_bound(model.nodes, tag, {}, &MshModel::Node::tag);
    return at == model.nodes.end() || at->tag != tag ? nullptr : &*at;
}

class Division {
  public:
    explicit Division(MshModel& model) : model_(model) {
        if (!model.nodes.empty()) next_node_ = model.nodes.back().tag + 1;
        for (const auto& [key, elements] : model.elements)
            for (const Tag tag : elements.tags) next_element_ = std::max(next_element_, tag + 1);
    }

    void run() {
        const auto take = [&](int type) {
            std::vector<std::pair<MshModel::ElementKey, MshModel::Elements>> taken;
            for (auto& [key, elements] : model_.elements)
                if (key.type == type) taken.emplace_back(key, std::move(elements));
            for (const auto& [key, elements] : taken) model_.elements.erase(key);
            return taken;
        };
        for (const auto& [key, elements] : take(quadratic_tetrahedron))
            for (std::size_t e = 0; e < elements.tags.size(); ++e)
                divide_tetrahedron(key, &elements.nodes[10 * e]);
        for (const auto& [key, elements] : take(quadratic_triangle))
            for (std::size_t e = 0; e < elements.tags.size(); ++e)
                divide_triangle(key, &elements.nodes[6 * e]);
        model_.nodes.insert(model_.nodes.end(), made_.begin(), made_.end());  // tags still ascend
    }

  private:
    void divide_tetrahedron(MshModel::ElementKey key, const Tag* n) {
        Point sum{};
        for (int i = 0; i < 10; ++i) add(sum, n[i], i < 4 ? -1. / 8 : 1. / 4);
        const Tag centre = make(sum);
        key.type = hexahedron;
        for (const auto& [i, j, k, l] : from_corner)
            append(key, {n[i], n[amid[i][j]], amid_face(n, i, j, k), n[amid[i][k]], n[amid[i][l]],
                         amid_face(n, i, j, l), centre, amid_face(n, i, k, l)});
    }

    // Edges 0-1, 1-2, 2-0 of the triangle have its nodes 3, 4, 5.
    void divide_triangle(MshModel::ElementKey key, const Tag* n) {
        const Tag centre = amid_corners({n[0], n[1], n[2]}, {n[3], n[4], n[5]});
        key.type = quadrilateral;
        append(key, {n[0], n[3], centre, n[5]});
        append(key, {n[1], n[4], centre, n[3]});
        append(key, {n[2], n[5], centre, n[4]});
    }

    Tag amid_face(const Tag* n, int i, int j, int k) {
        return amid_corners({n[i], n[j], n[k]}, {n[amid[i][j]], n[amid[j][k]], n[amid[k][i]]});
    }

    // The same node for both tetrahedra that share the face, and its triangle.
    Tag amid_corners(std::array<Tag, 3> corners, const std::array<Tag, 3>& edges) {
        std::ranges::sort(corners);
        Tag& tag = amid_faces_[corners];
        if (tag != 0) return tag;
        Point sum{};
        for (const Tag corner : corners) add(sum, corner, -1. / 9);
        for (const Tag edge : edges) add(sum, edge, 4. / 9);
        return tag = make(sum);
    }

    void add(Point& sum, Tag node, double weight) const {
        const Point& x = find_node(model_, node)->position;
        for (int d = 0; d < 3; ++d) sum[d] += weight * x[d];
    }
    Tag make(const Point& position) {
        made_.push_back({next_node_, position});
        return next_node_++;
    }
    void append(const MshModel::ElementKey& key, std::initializer_list<Tag> nodes) {
        MshModel::Elements& to = model_.elements[key];
        to.tags.push_back(next_element_++);
        to.nodes.insert(to.nodes.end(), nodes);
    }

    MshModel& model_;
    Tag next_node_ = 1, next_element_ = 1;
    std::vector<MshModel::Node> made_;
    std::map<std::array<Tag, 3>, Tag> amid_faces_;  // 0: none yet
};

bool has_all_nodes(const MshModel& model) {
    return std::ranges::all_of(model.elements, [&](const auto& part) {
        const auto& [key, elements] = part;
        if (key.type != quadratic_tetrahedron && key.type != quadratic_triangle) return true;
        return std::ranges::all_of(elements.nodes, [&](Tag tag) { return find_node(model, tag); });
    });
}

}  // namespace

void divide_tetrahedra(MshModel& model) {
    const bool has_some = std::ranges::any_of(
        model.elements, [](const auto& part) { return part.first.type == quadratic_tetrahedron; });
    if (has_some && has_all_nodes(model)) Division(model).run();
}

}  // namespace tricontact::meshes
