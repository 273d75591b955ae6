#include "contact/solvers/compliance.h"

#include <algorithm>

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

void Compliance::tangential_from_normal(std::span<const double>, TangentialField& u) const {
    u = TangentialField(points().size());
}

void Compliance::normal_from_tangential(const TangentialField&, std::span<double> u_z) const {
    std::fill(u_z.begin(), u_z.end(), 0.0);
}

std::vector<double> Compliance::consistent_traction(std::span<const double>, bool) const {
    return {};
}

std::optional<std::array<double, 3>> Compliance::missing_reaction(std::span<const double>,
                                                                  const TangentialField&) const {
    return std::nullopt;
}

std::unique_ptr<const Interior> Compliance::interior(std::span<const double>,
                                                     const TangentialField&) const {
    return nullptr;
}

}  // namespace tricontact::contact
