#include "fem/finite_strain/contact_frames.h"

#include <cmath>

// Axes at a point of the indenter's surface, z into the substrate, g its slope:
//
//   n = (g, 1)/|(g, 1)|      p pushes along (g, 1): its vertical part is p itself
//   E = R [x y]              tangents of length 1, R the rotation that takes (0, 0, 1) to n
//
// R turns by the shortest way, so that neither x nor y is preferred: E'[x y] is a symmetric matrix
// (Tilt in contact/solvers/tangential_system.h), so the shift and the force balance see the same
// one. `turned` rotates the compliance from both sides and keeps it symmetric: solvers for plane
// surfaces work on it.

namespace tricontact::fem {

using contact::Vector2;

ContactFrames::ContactFrames(const contact::Indenter& indenter,
                             const std::vector<Vector3>& position, const Vector2& lowest_point)
    : height_(position.size()),
      stretch_(position.size(), 1),
      slope_(position.size()),
      tangent_(position.size(), {Vector3{1, 0, 0}, Vector3{0, 1, 0}}) {
    for (std::size_t i = 0; i < position.size(); ++i) {
        const double x = position[i][0] - lowest_point[0], y = position[i][1] - lowest_point[1];
        height_[i] = indenter.height(x, y);
        if (!std::isfinite(height_[i])) continue;
        const Vector2 g = indenter.slope(x, y);
        slope_.set(i, g);
        const double n = stretch_[i] = std::sqrt(1 + contact::dot(g, g));
        const double f = 1 / (n * (n + 1));
        tangent_[i] = {Vector3{1 - f * g[0] * g[0], -f * g[0] * g[1], -g[0] / n},
                       Vector3{-f * g[0] * g[1], 1 - f * g[1] * g[1], -g[1] / n}};
    }
}

Vector3 ContactFrames::traction(std::size_t i, double p, const Vector2& t) const {
    Vector3 sum{p * slope_.x[i], p * slope_.y[i], p};
    for (int a = 0; a < 3; ++a) sum[a] += t[0] * tangent_[i][0][a] + t[1] * tangent_[i][1][a];
    return sum;
}

DenseCompliance ContactFrames::turned(const contact::Compliance& compliance, double factor) const {
    const std::size_t n = size(), stride = 3 * n;
    const double* const from = compliance.dense();
    std::vector<double> to(stride * stride);
    // Of each point the directions x, y and into the substrate become those of its frame.
    std::vector<std::array<Vector3, 3>> axes(n);
    for (std::size_t i = 0; i < n; ++i)
        axes[i] = {tangent_[i][0], tangent_[i][1], Vector3{slope_.x[i], slope_.y[i], 1}};
    std::vector<double> column(stride);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t c = 0; c < 3; ++c) {
            const Vector3& axis = axes[j][c];
            const double* const x = from + stride * j;
            const double* const y = from + stride * (n + j);
            const double* const z = from + stride * (2 * n + j);
            for (std::size_t k = 0; k < stride; ++k)
                column[k] = axis[0] * x[k] + axis[1] * y[k] + axis[2] * z[k];
            double* const turned = to.data() + stride * (c * n + j);
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t r = 0; r < 3; ++r)
                    turned[r * n + i] =
                        factor * dot(axes[i][r], {column[i], column[n + i], column[2 * n + i]});
        }
    return {compliance.points(), std::move(to)};
}

}  // namespace tricontact::fem
