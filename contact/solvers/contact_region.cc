#include "contact/solvers/contact_region.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "contact/base/memory.h"
#include "contact/compliances/blocks.h"
#include "contact/compliances/radial_points.h"

namespace tricontact::contact {

namespace {

/// a^2 from the mean squares m1 and fourth powers m2 of the distance, negative where the pressure
/// is not of the form. With int sqrt(1 - s) s^k ds = B(k + 1, 3/2), the two equations for a^2 and
/// c1/c0 leave a^4 - 7 m1 a^2 + 63/8 m2 = 0.
double radius_squared(double m1, double m2) {
    const double discriminant = 49 * m1 * m1 - 31.5 * m2;
    return discriminant >= 0 ? (7 * m1 - std::sqrt(discriminant)) / 2 : -1;
}

/// The same of a line contact, whose elements of x are s^(-1/2) ds/2: B(k + 1/2, 3/2) leaves
/// a^4 - 12 m1 a^2 + 16 m2 = 0.
double half_width_squared(double m1, double m2) {
    const double discriminant = 36 * m1 * m1 - 16 * m2;
    return discriminant >= 0 ? 6 * m1 - std::sqrt(discriminant) : -1;
}

/// Mean of the square and of the fourth power of the distance over a point's own function, which
/// for bilinear ones has the variance h^2/6 and the fourth moment h^4/15 along each axis.
struct OwnMoments {
    Vector2 variance{};
    double fourth = 0;

    explicit OwnMoments(const ContactPoints& points) {
        if (!points.bilinear) return;
        const auto [h, k] =
            std::pair(points.spacing[0] * points.spacing[0], points.spacing[1] * points.spacing[1]);
        variance = {h / 6, k / 6};
        fourth = (h * h + k * k) / 15 + h * k / 18;
    }
    /// What they add to the fourth power of the distance of the point itself.
    double fourth_beyond(double x, double y) const {
        const double s = x * x + y * y, v = variance[0] + variance[1];
        return 2 * s * v + 4 * (x * x * variance[0] + y * y * variance[1]) + fourth;
    }
};

// A radius begins at the axis, which is no edge.
bool edge_of_grid_carries(const ContactPoints& points, const std::vector<double>& pressure) {
    const bool radius = are_radii(points);
    for (int j = 0; j < points.n_y; ++j)
        for (int i = 0; i < points.n_x; ++i) {
            const bool edge_in_y = (j == 0 && !points.mirrored) || j == points.n_y - 1;
            const bool edge_in_x = (i == 0 && !radius) || i == points.n_x - 1;
            const bool edge = edge_in_x || (edge_in_y && points.line_length == 0 && !radius);
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

double counted_radius(const ContactPoints& points, const std::vector<double>& pressure) {
    double area = 0;
    for (std::size_t i = 0; i < pressure.size(); ++i)
        if (pressure[i] > 0) area += points.area[i];
    return points.line_length > 0 ? area / (2 * points.line_length)
                                  : std::sqrt(area / std::numbers::pi);
}

double shared_area(const ContactPoints& points, const std::vector<double>& share) {
    double area = 0;
    for (std::size_t i = 0; i < share.size(); ++i) area += share[i] * points.area[i];
    return area;
}

double shared_radius(const ContactPoints& points, const std::vector<double>& share) {
    const double area = shared_area(points, share);
    return points.line_length > 0 ? area / (2 * points.line_length)
                                  : std::sqrt(area / std::numbers::pi);
}

double contact_radius(const ContactPoints& points, const std::vector<double>& pressure,
                      const Vector2& centre) {
    const bool line = points.line_length > 0;
    const OwnMoments own(points);
    double force = 0, second = 0, fourth = 0;
    for (std::size_t i = 0; i < pressure.size(); ++i) {
        if (!(pressure[i] > 0)) continue;
        const double x = points.x[i] - centre[0], y = line ? 0 : points.y[i] - centre[1];
        const double s = x * x + y * y, f = points.area[i] * pressure[i];
        force += f;
        second += f * s + f * (own.variance[0] + own.variance[1]);
        fourth += f * s * s + f * own.fourth_beyond(x, y);
    }
    const double counted = counted_radius(points, pressure);
    const double m1 = second / force, m2 = fourth / force;
    const double square = line ? half_width_squared(m1, m2) : radius_squared(m1, m2);
    if (!(square >= 0)) return counted;
    const double radius = std::sqrt(square);
    return std::abs(radius / counted - 1) < 0.3 ? radius : counted;
}

std::vector<double> heights_over(const ContactPoints& points, const Indenter& indenter,
                                 const Vector2& offset, int n_threads) {
    std::vector<double> height = large_field(points.size());
    set_heights(points, indenter, offset, n_threads, height);
    return height;
}

void set_heights(const ContactPoints& points, const Indenter& indenter, const Vector2& offset,
                 int n_threads, std::vector<double>& height) {
    Blocks(height.size(), n_threads).for_points([&](std::size_t i) {
        height[i] = indenter.height(points.x[i] - offset[0], points.y[i] - offset[1]);
    });
}

bool reaches_edge(const ContactPoints& points, const std::vector<double>& pressure) {
    if (points.periodic || points.is_whole_face) return false;
    return points.n_x > 0 ? edge_of_grid_carries(points, pressure)
                          : edge_of_elements_carries(points, pressure);
}

}  // namespace tricontact::contact
