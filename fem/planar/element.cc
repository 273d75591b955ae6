#include "fem/planar/element.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "contact/base/error.h"

// With the mass matrix of psi = {1, x, z}, M = L L', and b_m = int psi_m div u, the projected
// volumetric strain squared and integrated is |L^-1 b|^2 (fem/element.cc). Three Gauss points along
// each axis. Integrals of a body of revolution carry 2 pi x, and points of the rule lie off the
// axis, where u_x/x has a limit, since u_x vanishes there.

namespace tricontact::fem::planar {

namespace {

constexpr int n_nodes = 9, n_psi = 3;
constexpr std::array<std::array<int, 2>, n_nodes> positions{
    {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}}};

/// Quadratic functions of the nodes -1, 0, 1, and their derivatives.
std::array<double, 3> values(double s) {
    return {s * (s - 1) / 2, 1 - s * s, s * (s + 1) / 2};
}
std::array<double, 3> derivatives(double s) {
    return {s - .5, -2 * s, s + .5};
}

/// Strains of the unknowns at a point: normal ones in x, z and around, shear gamma_xz.
struct Strains {
    double weight;  // of the point, with the extent [m^3]
    Point x;
    std::array<std::array<double, 4>, n_element_unknowns> of;
    double dilatation(int r) const { return of[r][0] + of[r][1] + of[r][2]; }
};

[[noreturn]] void refuse_inverted(const Point& x) {
    throw contact::InputError(fmt::format(
        "mesh: the element about ({:.6g}, {:.6g}) m is inverted; give its nodes anticlockwise",
        x[0], x[1]));
}

Strains strains_at(const ElementNodes& nodes, Solid solid, double s, double t, double weight) {
    const auto n_s = values(s), n_t = values(t), d_s = derivatives(s), d_t = derivatives(t);
    std::array<double, n_nodes> shape{};
    std::array<std::array<double, 2>, n_nodes> slope{};
    std::array<std::array<double, 2>, 2> jacobian{};  // dx_a/ds_b
    Strains strains{};
    for (int i = 0; i < n_nodes; ++i) {
        const auto [a, b] = positions[i];
        shape[i] = n_s[a] * n_t[b];
        slope[i] = {d_s[a] * n_t[b], n_s[a] * d_t[b]};
        for (int c = 0; c < 2; ++c) {
            strains.x[c] += shape[i] * nodes[i][c];
            for (int d = 0; d < 2; ++d) jacobian[c][d] += nodes[i][c] * slope[i][d];
        }
    }
    const double determinant = jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0];
    if (!(determinant > 0)) refuse_inverted(strains.x);
    strains.weight = weight * determinant * extent(solid, strains.x[0]);
    for (int i = 0; i < n_nodes; ++i) {
        const auto [u, v] = slope[i];
        const double dx = (u * jacobian[1][1] - v * jacobian[1][0]) / determinant;
        const double dz = (v * jacobian[0][0] - u * jacobian[0][1]) / determinant;
        // On the axis u_x/x has the limit du_x/dx.
        const double ratio = strains.x[0] > 0 ? shape[i] / strains.x[0] : dx;
        const double hoop = solid == Solid::of_revolution ? ratio : 0;
        strains.of[i] = {dx, 0, hoop, dz};
        strains.of[n_nodes + i] = {0, dz, 0, dx};
    }
    return strains;
}

std::array<Strains, 9> strains_of(const ElementNodes& nodes, Solid solid) {
    const double outer = std::sqrt(.6);
    const std::array<double, 3> at{-outer, 0, outer}, weight{5. / 9, 8. / 9, 5. / 9};
    std::array<Strains, 9> all{};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            all[3 * k + i] = strains_at(nodes, solid, at[i], at[k], weight[i] * weight[k]);
    return all;
}

/// Rows Y with int (projected div u)^2 = |Y u|^2; the projected dilatation is psi' L'^-1 Y u.
struct Projection {
    std::array<std::array<double, n_element_unknowns>, n_psi> rows;
    std::array<std::array<double, n_psi>, n_psi> factor;  // L
    Point centre;
    double size;

    std::array<double, n_psi> psi(const Point& x) const {
        return {1, (x[0] - centre[0]) / size, (x[1] - centre[1]) / size};
    }
};
Projection projection_of(const std::array<Strains, 9>& points) {
    double volume = 0;
    Point centre{};
    for (const Strains& p : points) {
        volume += p.weight;
        for (int a = 0; a < 2; ++a) centre[a] += p.weight * p.x[a];
    }
    for (double& x : centre) x /= volume;
    const double size =
        std::hypot(points[0].x[0] - points[8].x[0], points[0].x[1] - points[8].x[1]);

    Projection projection{{}, {}, centre, size};
    auto& rows = projection.rows;
    auto& mass = projection.factor;
    for (const Strains& p : points) {
        const auto psi = projection.psi(p.x);
        for (int m = 0; m < n_psi; ++m) {
            for (int n = 0; n <= m; ++n) mass[m][n] += p.weight * psi[m] * psi[n];
            for (int r = 0; r < n_element_unknowns; ++r)
                rows[m][r] += p.weight * psi[m] * p.dilatation(r);
        }
    }
    for (int m = 0; m < n_psi; ++m)
        for (int n = 0; n <= m; ++n) {
            for (int l = 0; l < n; ++l) mass[m][n] -= mass[m][l] * mass[n][l];
            mass[m][n] = n == m ? std::sqrt(mass[m][m]) : mass[m][n] / mass[n][n];
        }
    for (int r = 0; r < n_element_unknowns; ++r)
        for (int m = 0; m < n_psi; ++m) {
            for (int n = 0; n < m; ++n) rows[m][r] -= mass[m][n] * rows[n][r];
            rows[m][r] /= mass[m][m];
        }
    return projection;
}

}  // namespace

double extent(Solid solid, double x) {
    return solid == Solid::plane_strain ? 1 : 2 * std::numbers::pi * x;
}

// 2 G dev eps : dev eps = 2 G (eps : eps - theta^2/3), the shear in eps : eps as gamma^2/2.
void element_stiffness(const ElementNodes& nodes, Solid solid, const Moduli& moduli,
                       ElementStiffness& k) {
    const auto points = strains_of(nodes, solid);
    const Projection y = projection_of(points);
    for (int r = 0; r < n_element_unknowns; ++r)
        for (int c = 0; c <= r; ++c) {
            double shear = 0, volumetric = 0;
            for (const Strains& p : points) {
                const auto &a = p.of[r], &b = p.of[c];
                shear += p.weight * (a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] / 2 -
                                     p.dilatation(r) * p.dilatation(c) / 3);
            }
            for (int m = 0; m < n_psi; ++m) volumetric += y.rows[m][r] * y.rows[m][c];
            k[r][c] = k[c][r] = 2 * moduli.shear * shear + moduli.bulk * volumetric;
        }
}

ElementState element_state(const ElementNodes& nodes, Solid solid, const Moduli& moduli,
                           const std::array<double, n_element_unknowns>& displacement) {
    const auto points = strains_of(nodes, solid);
    const Projection y = projection_of(points);
    std::array<double, n_psi> projected{};  // Y u
    for (int m = 0; m < n_psi; ++m)
        for (int r = 0; r < n_element_unknowns; ++r) projected[m] += y.rows[m][r] * displacement[r];
    const auto strain_of = [&](const Strains& p) {
        std::array<double, 4> strain{};
        for (int r = 0; r < n_element_unknowns; ++r)
            for (int k = 0; k < 4; ++k) strain[k] += p.of[r][k] * displacement[r];
        return strain;
    };
    ElementState state{};
    for (const Strains& p : points) {
        const auto e = strain_of(p);
        const double theta = e[0] + e[1] + e[2];
        state.energy +=
            p.weight * moduli.shear *
            (e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + e[3] * e[3] / 2 - theta * theta / 3);
        state.volume += p.weight;
    }
    for (const double one : projected) state.energy += moduli.bulk / 2 * one * one;
    for (int i = 0; i < n_nodes; ++i) {
        const auto [a, b] = positions[i];
        const Strains p = strains_at(nodes, solid, a - 1, b - 1, 0);
        const auto e = strain_of(p);
        auto psi = y.psi(p.x);  // then L^-1 psi
        double dilatation = 0;
        for (int m = 0; m < n_psi; ++m) {
            for (int n = 0; n < m; ++n) psi[m] -= y.factor[m][n] * psi[n];
            psi[m] /= y.factor[m][m];
            dilatation += psi[m] * projected[m];
        }
        const double theta = e[0] + e[1] + e[2];
        const double mean = moduli.bulk * dilatation - 2 * moduli.shear * theta / 3;
        state.stress[i] = {2 * moduli.shear * e[0] + mean, 2 * moduli.shear * e[1] + mean,
                           2 * moduli.shear * e[2] + mean, moduli.shear * e[3]};
    }
    return state;
}

}  // namespace tricontact::fem::planar
