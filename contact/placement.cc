#include "contact/placement.h"

#include <map>

namespace tricontact::contact {

std::vector<double> heights_over(const ContactPoints& points, const Indenter& indenter,
                                 const Vector2& offset) {
    std::vector<double> height(points.size());
    for (std::size_t i = 0; i < height.size(); ++i)
        height[i] = indenter.height(points.x[i] - offset[0], points.y[i] - offset[1]);
    return height;
}

namespace {

bool edge_of_grid_carries(const ContactPoints& points, const std::vector<double>& pressure) {
    for (int j = 0; j < points.n_y; ++j)
        for (int i = 0; i < points.n_x; ++i) {
            const bool edge_in_y = (j == 0 && !points.mirrored) || j == points.n_y - 1;
            const bool edge =
                i == 0 || i == points.n_x - 1 || (edge_in_y && points.line_length == 0);
            if (edge && pressure[static_cast<std::size_t>(j) * points.n_x + i] > 0) return true;
        }
    return false;
}

/// Edges of only one element bound the surface, or lie in its plane of symmetry.
bool edge_of_elements_carries(const ContactPoints& points, const std::vector<double>& pressure) {
    std::map<int, int> uses;  // middle node of an edge -> elements
    for (const auto& quad : points.quads)
        for (int k = 4; k < 8; ++k) ++uses[quad[k]];
    for (const auto& quad : points.quads)
        for (int k = 0; k < 4; ++k) {
            const int middle = quad[4 + k];
            if (uses[middle] > 1 || (points.mirrored && points.y[middle] == 0)) continue;
            const bool along_x = points.y[quad[k]] == points.y[quad[(k + 1) % 4]];
            if (points.line_length > 0 && along_x) continue;
            for (const int node : {quad[k], middle, quad[(k + 1) % 4]})
                if (pressure[node] > 0) return true;
        }
    return false;
}

}  // namespace

bool reaches_edge(const ContactPoints& points, const std::vector<double>& pressure) {
    if (points.periodic) return false;
    return points.n_x > 0 ? edge_of_grid_carries(points, pressure)
                          : edge_of_elements_carries(points, pressure);
}

}  // namespace tricontact::contact
