#include "contact/placement.h"

namespace tricontact::contact {

std::vector<double> heights_over(const ContactPoints& points, const Indenter& indenter,
                                 const Vector2& offset) {
    std::vector<double> height(points.size());
    for (std::size_t i = 0; i < height.size(); ++i)
        height[i] = indenter.height(points.x[i] - offset[0], points.y[i] - offset[1]);
    return height;
}

bool reaches_edge(const ContactPoints& points, const std::vector<double>& pressure) {
    for (int j = 0; j < points.n_y; ++j)
        for (int i = 0; i < points.n_x; ++i) {
            const bool edge = i == 0 || j == 0 || i == points.n_x - 1 || j == points.n_y - 1;
            if (edge && pressure[static_cast<std::size_t>(j) * points.n_x + i] > 0) return true;
        }
    return false;
}

}  // namespace tricontact::contact
