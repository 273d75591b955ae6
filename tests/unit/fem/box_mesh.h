#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "meshes/hex_mesh.h"

namespace tricontact::test {

/// n + 1 equally spaced coordinates.
inline std::vector<double> even(double from, double to, int n) {
    std::vector<double> x(n + 1);
    for (int i = 0; i <= n; ++i) x[i] = from + (to - from) * i / n;
    return x;
}

/// `size` up to `patch`, then growing by `growth` up to `end`.
inline std::vector<double> graded(double size, double patch, double end, double growth) {
    std::vector<double> x = even(0, patch, static_cast<int>(std::lround(patch / size)));
    std::vector<double> steps;
    double sum = 0;
    for (double step = size; sum < end - patch; step *= growth) steps.push_back(step), sum += step;
    for (const double step : steps) x.push_back(x.back() + step * (end - patch) / sum);
    return x;
}

/// Mirrored at 0, where it begins.
inline std::vector<double> mirrored(const std::vector<double>& x) {
    std::vector<double> both;
    for (std::size_t i = x.size(); i-- > 1;) both.push_back(-x[i]);
    both.insert(both.end(), x.begin(), x.end());
    return both;
}

/// A box of tensor-product hexahedra.
struct BoxSpec {
    std::vector<double> x, y, z;      ///< lines of nodes, increasing, z up to 0 [m]
    double patch_x = 0, patch_y = 0;  ///< faces of the top within +- these are the contact [m]
    bool half_model = false;          ///< y[0] = 0 is the plane of symmetry
    double interface = -1e300;        ///< elements below are of the lower layer [m]
};

inline meshes::HexMesh box_mesh(const BoxSpec& spec) {
    using meshes::Boundary;
    const int nx = static_cast<int>(spec.x.size()), ny = static_cast<int>(spec.y.size()),
              nz = static_cast<int>(spec.z.size());
    const auto node = [&](int i, int j, int k) { return i + nx * (j + ny * k); };
    meshes::HexMesh mesh;
    for (const double z : spec.z)
        for (const double y : spec.y)
            for (const double x : spec.x) mesh.nodes.push_back({x, y, z});
    const auto inside = [&](int i, int j) {
        const double x = (spec.x[i] + spec.x[i + 1]) / 2, y = (spec.y[j] + spec.y[j + 1]) / 2;
        return std::abs(x) < spec.patch_x && std::abs(y) < spec.patch_y;
    };
    const auto add = [&](std::array<int, 4> nodes, Boundary boundary) {
        mesh.faces.push_back({nodes, boundary});
    };
    for (int k = 0; k + 1 < nz; ++k)
        for (int j = 0; j + 1 < ny; ++j)
            for (int i = 0; i + 1 < nx; ++i) {
                const std::array<int, 8> n{node(i, j, k),
                                           node(i + 1, j, k),
                                           node(i + 1, j + 1, k),
                                           node(i, j + 1, k),
                                           node(i, j, k + 1),
                                           node(i + 1, j, k + 1),
                                           node(i + 1, j + 1, k + 1),
                                           node(i, j + 1, k + 1)};
                mesh.hexes.push_back(n);
                mesh.regions.push_back(
                    (spec.z[k] + spec.z[k + 1]) / 2 < spec.interface ? meshes::Region::lower_layer
                                                                     : meshes::Region::layer);
                if (k == 0) add({n[0], n[1], n[2], n[3]}, Boundary::base);
                if (k + 2 == nz)
                    add({n[4], n[5], n[6], n[7]},
                        inside(i, j) ? Boundary::contact : Boundary::free_top);
                if (i == 0) add({n[0], n[3], n[7], n[4]}, Boundary::sides);
                if (i + 2 == nx) add({n[1], n[2], n[6], n[5]}, Boundary::sides);
                if (j == 0)
                    add({n[0], n[1], n[5], n[4]},
                        spec.half_model ? Boundary::symmetry : Boundary::sides);
                if (j + 2 == ny) add({n[3], n[2], n[6], n[7]}, Boundary::sides);
            }
    return mesh;
}

/// Moves all nodes smoothly, by up to `amount` [m] times their distance [in extents] from the
/// box's boundary planes: those stay flat, elements become general hexahedra.
inline void distort(meshes::HexMesh& mesh, double amount) {
    std::array<double, 3> low = mesh.nodes[0], high = mesh.nodes[0];
    for (const auto& x : mesh.nodes)
        for (int d = 0; d < 3; ++d) {
            low[d] = std::min(low[d], x[d]);
            high[d] = std::max(high[d], x[d]);
        }
    for (auto& x : mesh.nodes) {
        std::array<double, 3> t{};
        for (int d = 0; d < 3; ++d) t[d] = (x[d] - low[d]) / (high[d] - low[d]);
        for (int d = 0; d < 3; ++d) {
            const double wave = std::sin(5 * t[0] + d) * std::cos(4 * t[1] - 2 * d) +
                                std::sin(7 * t[2] + 3 * d + t[0]);
            x[d] += amount * 4 * t[d] * (1 - t[d]) * wave / 2;
        }
    }
}

}  // namespace tricontact::test
