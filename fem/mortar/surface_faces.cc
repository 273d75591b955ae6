#include "fem/mortar/surface_faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"

namespace tricontact::fem {

using contact::Vector2;

namespace {

double cross_of(const Vector2& a, const Vector2& b) {
    return a[0] * b[1] - a[1] * b[0];
}

Vector2 from_to(const Vector2& a, const Vector2& b) {
    return {b[0] - a[0], b[1] - a[1]};
}

void refuse_turned(const SeenFace& face) {
    for (int k = 0; k < 4; ++k) {
        const Vector2 &before = face.corners[(k + 3) % 4], &here = face.corners[k],
                      &after = face.corners[(k + 1) % 4];
        if (cross_of(from_to(before, here), from_to(here, after)) > 0) continue;
        throw contact::InputError(fmt::format(
            "mesh: the contact face with a corner at x = {:.6g} m, y = {:.6g} m does not face the "
            "other body; name \"contact\" only what faces it, with convex faces",
            here[0], here[1]));
    }
}

std::array<double, 3> quadratic_at(double s) {
    return {(1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1)};
}

}  // namespace

Vector2 SeenFace::low() const {
    Vector2 low = corners[0];
    for (const Vector2& x : corners)
        for (int d = 0; d < 2; ++d) low[d] = std::min(low[d], x[d]);
    return low;
}

Vector2 SeenFace::high() const {
    Vector2 high = corners[0];
    for (const Vector2& x : corners)
        for (int d = 0; d < 2; ++d) high[d] = std::max(high[d], x[d]);
    return high;
}

double SeenFace::longest_edge() const {
    double longest = 0;
    for (int k = 0; k < 4; ++k) {
        const Vector2 edge = from_to(corners[k], corners[(k + 1) % 4]);
        longest = std::max(longest, std::hypot(edge[0], edge[1]));
    }
    return longest;
}

// Newton's method on x = a + b s + c t + d s t, from the middle.
std::optional<Vector2> SeenFace::place_of(const Vector2& x) const {
    const Vector2 b = from_to(corners[0], corners[1]), c = from_to(corners[0], corners[3]);
    const Vector2 far = from_to(corners[3], corners[2]), d = from_to(b, far);
    const double scale = longest_edge();
    double s = .5, t = .5;
    for (int k = 0; k < 30; ++k) {
        const Vector2 along_s{b[0] + d[0] * t, b[1] + d[1] * t};
        const Vector2 along_t{c[0] + d[0] * s, c[1] + d[1] * s};
        const Vector2 rest{x[0] - corners[0][0] - b[0] * s - along_t[0] * t,
                           x[1] - corners[0][1] - b[1] * s - along_t[1] * t};
        if (std::hypot(rest[0], rest[1]) <= 1e-13 * scale) return Vector2{s, t};
        const double area = cross_of(along_s, along_t);
        if (!(area > 0)) return std::nullopt;
        s += cross_of(rest, along_t) / area;
        t += cross_of(along_s, rest) / area;
    }
    return std::nullopt;
}

std::array<double, 9> biquadratic(double s, double t) {
    const auto u = quadratic_at(s), v = quadratic_at(t);
    return {u[0] * v[0], u[2] * v[0], u[2] * v[2], u[0] * v[2], u[1] * v[0],
            u[2] * v[1], u[1] * v[2], u[0] * v[1], u[1] * v[1]};
}

std::vector<SeenFace> seen_faces(const contact::ContactPoints& surface) {
    std::vector<SeenFace> faces;
    for (const auto& quad : surface.quads) {
        SeenFace& face = faces.emplace_back();
        face.nodes = quad;
        for (int k = 0; k < 4; ++k) face.corners[k] = {surface.x[quad[k]], surface.y[quad[k]]};
        refuse_turned(face);
    }
    return faces;
}

}  // namespace tricontact::fem
