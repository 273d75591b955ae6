#include "contact/compliance.h"

namespace tricontact::contact {

ContactPoints ContactPoints::grid(int n_x, int n_y, Vector2 first, Vector2 spacing) {
    ContactPoints points;
    const std::size_t n = static_cast<std::size_t>(n_x) * n_y;
    points.n_x = n_x;
    points.n_y = n_y;
    points.first = first;
    points.spacing = spacing;
    points.x.reserve(n);
    points.y.reserve(n);
    for (int j = 0; j < n_y; ++j)
        for (int i = 0; i < n_x; ++i) {
            points.x.push_back(first[0] + i * spacing[0]);
            points.y.push_back(first[1] + j * spacing[1]);
        }
    points.area.assign(n, spacing[0] * spacing[1]);
    return points;
}

}  // namespace tricontact::contact
