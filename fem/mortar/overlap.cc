#include "fem/mortar/overlap.h"

#include <array>
#include <cmath>

// A convex quadrilateral cut by a rectangle (Sutherland and Hodgman 1974) is a convex polygon, a
// fan of triangles. Each triangle is a square with one side collapsed, with five Gauss points along
// each of its directions.

namespace tricontact::fem {

using contact::Vector2;

namespace {

using Polygon = std::vector<Vector2>;

constexpr std::array<double, 5> gauss_place{.046910077030668004, .23076534494715845, .5,
                                            .76923465505284155, .953089922969332};
constexpr std::array<double, 5> gauss_part{.11846344252809454, .23931433524968324,
                                           .28444444444444444, .23931433524968324,
                                           .11846344252809454};

/// What lies on the side of x[d] = bound where sign (x[d] - bound) >= 0.
Polygon cut_at(const Polygon& polygon, int d, double bound, double sign) {
    Polygon kept;
    const auto inside = [&](const Vector2& x) { return sign * (x[d] - bound); };
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        const double at_a = inside(a), at_b = inside(b);
        if (at_a >= 0) kept.push_back(a);
        if ((at_a >= 0) == (at_b >= 0)) continue;
        const double part = at_a / (at_a - at_b);
        Vector2 between{a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])};
        between[d] = bound;
        kept.push_back(between);
    }
    return kept;
}

Polygon shared(const SeenFace& face, const Rectangle& rectangle) {
    Polygon polygon(face.corners.begin(), face.corners.end());
    for (int d = 0; d < 2; ++d) {
        polygon = cut_at(polygon, d, rectangle.low[d], 1);
        polygon = cut_at(polygon, d, rectangle.high[d], -1);
    }
    return polygon;
}

double twice_area(const Vector2& a, const Vector2& b, const Vector2& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace

void integrate_shared(const SeenFace& face, const Rectangle& rectangle, const AtPoint& at) {
    const Polygon polygon = shared(face, rectangle);
    for (std::size_t k = 2; k < polygon.size(); ++k) {
        const Vector2 &a = polygon[0], &b = polygon[k - 1], &c = polygon[k];
        const double doubled = twice_area(a, b, c);
        for (std::size_t i = 0; i < gauss_place.size(); ++i)
            for (std::size_t j = 0; j < gauss_place.size(); ++j) {
                const double s = gauss_place[i], t = s * gauss_place[j];
                const Vector2 x{a[0] + s * (b[0] - a[0]) + t * (c[0] - b[0]),
                                a[1] + s * (b[1] - a[1]) + t * (c[1] - b[1])};
                at(x, gauss_part[i] * gauss_part[j] * s * doubled);
            }
    }
}

double shared_area(const SeenFace& face, const Rectangle& rectangle) {
    const Polygon polygon = shared(face, rectangle);
    double doubled = 0;
    for (std::size_t k = 2; k < polygon.size(); ++k)
        doubled += twice_area(polygon[0], polygon[k - 1], polygon[k]);
    return doubled / 2;
}

}  // namespace tricontact::fem
