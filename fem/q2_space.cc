#include "fem/q2_space.h"

#include <algorithm>

#include "fem/brick_elements.h"

namespace tricontact::fem {

const std::array<std::array<int, 3>, 27> node_positions{{
    {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},  // corners
    {0, 2, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2},  // edges
    {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1},             //
    {0, 1, 1}, {2, 1, 1}, {1, 0, 1}, {1, 2, 1}, {1, 1, 0}, {1, 1, 2},             // faces
    {1, 1, 1},
}};

std::array<int, 9> nodes_on_face(int axis, bool upper) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    constexpr std::array<std::array<int, 2>, 9> quad{
        {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}}};
    std::array<int, 9> nodes{};
    for (int i = 0; i < 9; ++i) {
        std::array<int, 3> at{};  // on the lower side u and v change places: outward
        at[axis] = upper ? 2 : 0;
        at[upper ? u : v] = quad[i][0];
        at[upper ? v : u] = quad[i][1];
        nodes[i] = static_cast<int>(std::find(node_positions.begin(), node_positions.end(), at) -
                                    node_positions.begin());
    }
    return nodes;
}

Q2Space::Q2Space(const meshes::HexMesh& mesh, Elements elements) {
    if (elements == Elements::bricks_if_all_are) elements_ = brick_elements(mesh, *this);
    if (!elements_) elements_ = q2_elements(mesh, *this);
}

}  // namespace tricontact::fem
