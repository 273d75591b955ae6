#include "fem/planar/sections.h"

#include <cmath>
#include <numbers>

namespace tricontact::fem::planar {

namespace {

constexpr double pi = std::numbers::pi;

NodeLine across(const Sizes& s, double width) {
    return continued(equal_elements(s.n, s.size), width, s.growth);
}
// Where elements of the patch are larger than the body is thick: two of them, if less square.
NodeLine in_depth(const Sizes& s, double depth) {
    if (s.n_deep * s.size > depth) return equal_elements(2, depth / 2);
    return continued(equal_elements(s.n_deep, s.size), depth, s.growth);
}

/// Angles of nodes whose x is uniform in the patch, up to `end` [rad].
NodeLine angles(const Sizes& s, double radius, double end) {
    NodeLine line = equal_elements(s.n, s.size);
    for (double& x : line) x = std::asin(x / radius);
    return continued(line, end, s.growth);
}

/// Ring between two radii, whose elements are small at the one that touches.
Mesh ring(const Sizes& s, const NodeLine& angle, double contact, double other) {
    const Point centre{0, contact};
    const auto at_contact = arc(centre, contact, 0, pi), at_other = arc(centre, other, 0, pi);
    const auto between = [&](bool top, bool outwards) {
        const double sign = top ? 1 : -1;
        const Point a{0, contact + sign * contact}, b{0, contact + sign * other};
        return outwards ? line_between(b, a) : line_between(a, b);
    };
    const NodeLine depth = normalised(in_depth(s, std::abs(other - contact)));
    const bool hole = other > contact;  // v runs inwards: from the outer edge
    Block block{normalised(angle),
                hole ? reversed(depth) : depth,
                hole ? at_other : at_contact,
                between(true, hole),
                hole ? at_contact : at_other,
                between(false, hole),
                {Boundary::contact, Boundary::symmetry, Boundary::support, Boundary::symmetry},
                s.n};
    if (hole) std::swap(block.boundaries[0], block.boundaries[2]);
    return join({block});
}

}  // namespace

Sizes Sizes::halved() const {
    return {2 * n, size / 2, std::sqrt(growth), 2 * n_deep};
}

Mesh layer_section(const Sizes& s, double width, double thickness) {
    return join({{normalised(across(s, width)),
                  reversed(normalised(in_depth(s, thickness))),
                  line_between({0, -thickness}, {width, -thickness}),
                  line_between({width, -thickness}, {width, 0}),
                  line_between({0, 0}, {width, 0}),
                  line_between({0, -thickness}, {0, 0}),
                  {Boundary::support, Boundary::free, Boundary::contact, Boundary::symmetry},
                  s.n}});
}

Mesh block_section(const Sizes& s, double width, double height,
                   const std::function<double(double)>& profile) {
    const auto lower = [=](double u) -> Point { return {u * width, profile(u * width)}; };
    return join({{normalised(across(s, width)),
                  normalised(in_depth(s, height)),
                  lower,
                  line_between(lower(1), {width, height}),
                  line_between({0, height}, {width, height}),
                  line_between({0, 0}, {0, height}),
                  {Boundary::contact, Boundary::free, Boundary::support, Boundary::symmetry},
                  s.n}});
}

// Three blocks about the point c; the one at the pole has the small elements:
//
//     o------b---------e   held
//     |  3   |    2   /
//     a------c       /
//     |  1     \    /
//     |          m
//     p-------/
Mesh half_disc_section(const Sizes& s, double radius) {
    const Point centre{0, radius};
    const double right = pi / 2, middle = pi / 4;
    const auto lower = arc(centre, radius, 0, middle), upper = arc(centre, radius, middle, right);
    const Point p{0, 0}, a{0, .55 * radius}, c{.5 * radius, .62 * radius}, m = upper(0);
    const Point o = centre, b{.5 * radius, radius}, e{radius, radius};
    const NodeLine u = normalised(angles(s, radius, middle));
    const NodeLine v = normalised(in_depth(s, a[1]));
    // Small elements at the held edge e, whose stresses are singular.
    const NodeLine w = reversed(continued(equal_elements(1, .02), 1, s.growth));
    return join({{u,
                  v,
                  lower,
                  line_between(m, c),
                  line_between(a, c),
                  line_between(p, a),
                  {Boundary::contact, Boundary::free, Boundary::free, Boundary::symmetry},
                  s.n},
                 {reversed(v),
                  w,
                  line_between(c, m),
                  upper,
                  line_between(b, e),
                  line_between(c, b),
                  {Boundary::free, Boundary::free, Boundary::support, Boundary::free}},
                 {u,
                  w,
                  line_between(a, c),
                  line_between(c, b),
                  line_between(o, b),
                  line_between(a, o),
                  {Boundary::free, Boundary::free, Boundary::support, Boundary::symmetry}}});
}

Mesh disc_section(const Sizes& s, double radius, double hub_radius) {
    return ring(s, angles(s, radius, pi), radius, hub_radius);
}

Mesh pin_section(const Sizes& s, double radius, double hub_radius) {
    return ring(s, continued(equal_elements(s.n, s.size / radius), pi, s.growth), radius,
                hub_radius);
}

Mesh hole_section(const Sizes& s, double radius, double outer_radius) {
    return ring(s, continued(equal_elements(s.n, s.size / radius), pi, s.growth), radius,
                outer_radius);
}

}  // namespace tricontact::fem::planar
