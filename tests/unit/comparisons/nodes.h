#pragma once

#include <functional>

#include "tests/unit/comparisons/history.h"

/// Surfaces of elements for tests of the comparison.
namespace tricontact::synthetic {

/// Quadrilaterals over the nodes of a grid with odd numbers of lines, x fastest.
inline std::vector<std::array<int, 9>> quads_of(int n_x, int n_y) {
    std::vector<std::array<int, 9>> quads;
    for (int j = 0; j + 2 < n_y; j += 2)
        for (int i = 0; i + 2 < n_x; i += 2) {
            const auto at = [&](int di, int dj) { return (j + dj) * n_x + i + di; };
            quads.push_back({at(0, 0), at(2, 0), at(2, 2), at(0, 2), at(1, 0), at(2, 1), at(1, 2),
                             at(0, 1), at(1, 1)});
        }
    return quads;
}

/// The same values on nodes in the grid's places.
inline contact::Surface as_regular_nodes(contact::Surface s) {
    s.layout = contact::Surface::Layout::nodes;
    for (int j = 0; j < s.n_y; ++j)
        for (int i = 0; i < s.n_x; ++i) {
            s.node_x.push_back(s.x(i));
            s.node_y.push_back(s.y(j));
        }
    s.quads = quads_of(s.n_x, s.n_y);
    s.normal_traction_consistent = s.normal_traction;
    s.tangential_traction_x_consistent = s.tangential_traction_x;
    s.tangential_traction_y_consistent = s.tangential_traction_y;
    return s;
}

/// Moves a node.
using Warp = std::function<contact::Vector2(double x, double y)>;
/// Nodes that form no grid any more, each with the value it had.
inline contact::Surface as_irregular_nodes(const contact::Surface& grid, const Warp& warp) {
    contact::Surface s = as_regular_nodes(grid);
    s.n_x = s.n_y = 0;
    s.first = s.spacing = {};
    for (std::size_t k = 0; k < s.size(); ++k) {
        const contact::Vector2 moved = warp(s.node_x[k], s.node_y[k]);
        s.node_x[k] = moved[0];
        s.node_y[k] = moved[1];
    }
    return s;
}

/// All surfaces of a history by `change`.
template <class Change>
contact::History with_surfaces(contact::History history, const Change& change) {
    for (auto& snapshot : history.snapshots) snapshot.surface = change(snapshot.surface);
    return history;
}

}  // namespace tricontact::synthetic
