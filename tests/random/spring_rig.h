#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace tricontact {

/// A rigid paraboloid on an incompressible half-space, springs between both (1/k_n, 1/k_t, 0:
/// rigid), under a law of friction tau(p) [Pa]: rings of constant traction, whose displacements are
/// Love's elliptic integrals. Nothing of the program is in here.
class SpringRig {
  public:
    using Law = std::function<double(double pressure)>;
    double radius, young, normal_compliance, tangential_compliance;
    Law law;

    double plane_modulus() const { return young / .75; }
    double shear_modulus() const { return 4 * young / 3 / 1.5; }

    struct Pressed {
        double contact_radius = 0, depth = 0, force = 0;
        std::vector<double> pressures;
    };
    Pressed at_radius(double a) const {
        const Rings& on = rings();
        const Matrix lu = factors(a / plane_modulus(), normal_compliance);
        std::vector<double> by_depth(n_rings, 1), by_shape;
        for (const double r : on.middles) by_shape.push_back(a * a * r * r / (2 * radius));
        by_depth = solved(lu, by_depth);
        by_shape = solved(lu, by_shape);
        Pressed found{.contact_radius = a};
        found.depth = at_edge(by_shape) / at_edge(by_depth);
        for (int i = 0; i < n_rings; ++i) {
            found.pressures.push_back(std::max(0., found.depth * by_depth[i] - by_shape[i]));
            found.force += a * a * on.areas[i] * found.pressures.back();
        }
        return found;
    }
    Pressed under(double force) const {
        return where([&](const Pressed& p) { return p.force - force; });
    }
    double load_at_depth(double depth) const {
        return where([&](const Pressed& p) { return p.depth - depth; }).force;
    }
    double limit(double load) const {
        const Pressed p = under(load);
        double sum = 0;
        for (int i = 0; i < n_rings; ++i)
            sum += p.contact_radius * p.contact_radius * rings().areas[i] * law(p.pressures[i]);
        return sum;
    }
    /// U [m] of each force below the limit, increasing.
    std::vector<double> shifts(double load, const std::vector<double>& forces) const {
        const Pressed p = under(load);
        const double a = p.contact_radius;
        std::vector<double> bound;
        for (const double pressure : p.pressures) bound.push_back(law(pressure));
        std::vector<double> at{0}, by{0};
        const Matrix lu = factors(a / shear_modulus(), tangential_compliance);
        for (int inside = n_rings; inside >= 0; --inside) {
            const auto [force, shift] = edge_of_stick(lu, a, bound, inside);
            if (force <= at.back()) continue;
            at.push_back(force);
            by.push_back(shift);
        }
        std::vector<double> found;
        for (const double force : forces) {
            const auto i = std::clamp<std::ptrdiff_t>(
                std::lower_bound(at.begin(), at.end(), force) - at.begin(), 1,
                static_cast<std::ptrdiff_t>(at.size()) - 1);
            found.push_back(by[i - 1] +
                            (by[i] - by[i - 1]) * (force - at[i - 1]) / (at[i] - at[i - 1]));
        }
        return found;
    }

  private:
    static constexpr int n_rings = 100;
    using Matrix = std::vector<std::vector<double>>;
    struct Rings {
        std::vector<double> middles, areas;
        Matrix influence;
    };

    /// Modulus times displacement at r of a unit traction within s.
    static double disc(double s, double r) {
        if (s == 0) return 0;
        if (r < s) return 4 * s / std::numbers::pi * std::comp_ellint_2(r / s);
        const double k = s / r;
        return 4 * r / std::numbers::pi *
               (std::comp_ellint_2(k) - (1 - k * k) * std::comp_ellint_1(k));
    }
    static const Rings& rings() {
        static const Rings made = [] {
            Rings on;
            std::vector<double> edges;
            for (int k = 0; k <= n_rings; ++k)
                edges.push_back(std::sin(std::numbers::pi / 2 * k / n_rings));
            for (int k = 0; k < n_rings; ++k) {
                on.middles.push_back((edges[k] + edges[k + 1]) / 2);
                on.areas.push_back(std::numbers::pi *
                                   (edges[k + 1] * edges[k + 1] - edges[k] * edges[k]));
            }
            for (const double r : on.middles) {
                std::vector<double>& row = on.influence.emplace_back();
                for (int k = 0; k < n_rings; ++k)
                    row.push_back(disc(edges[k + 1], r) - disc(edges[k], r));
            }
            return on;
        }();
        return made;
    }
    /// Triangles of the matrix; its leading blocks have the leading ones.
    static Matrix factors(double scale, double springs) {
        Matrix m = rings().influence;
        for (int i = 0; i < n_rings; ++i)
            for (int k = 0; k < n_rings; ++k) m[i][k] = scale * m[i][k] + (i == k ? springs : 0);
        for (int k = 0; k < n_rings; ++k)
            for (int i = k + 1; i < n_rings; ++i) {
                m[i][k] /= m[k][k];
                for (int j = k + 1; j < n_rings; ++j) m[i][j] -= m[i][k] * m[k][j];
            }
        return m;
    }
    static std::vector<double> solved(const Matrix& lu, std::vector<double> x) {
        const auto n = static_cast<int>(x.size());
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < i; ++k) x[i] -= lu[i][k] * x[k];
        for (int i = n - 1; i >= 0; --i) {
            for (int k = i + 1; k < n; ++k) x[i] -= lu[i][k] * x[k];
            x[i] /= lu[i][i];
        }
        return x;
    }
    /// Pressures go to the edge as the root of the distance on a half-space, and straight on
    /// springs: the depth is where either is nothing there.
    double at_edge(const std::vector<double>& p) const {
        const auto& m = rings().middles;
        const double last = 1 - m[n_rings - 1], before = 1 - m[n_rings - 2];
        return p[n_rings - 1] - (p[n_rings - 2] - p[n_rings - 1]) * last / (before - last);
    }
    template <typename Function>
    Pressed where(Function function) const {
        double low = 1e-4 * radius, high = radius;
        for (int i = 0; i < 40; ++i) {
            const double middle = std::sqrt(low * high);
            (function(at_radius(middle)) > 0 ? high : low) = middle;
        }
        return at_radius(low);
    }
    struct Edge {
        double force, shift;
    };
    /// Rings from `inside` on slip, and the one before begins to.
    Edge edge_of_stick(const Matrix& lu, double a, const std::vector<double>& bound,
                       int inside) const {
        const Matrix& m = rings().influence;
        std::vector<double> outer(std::max(inside, 1), 0.), t = bound;
        for (std::size_t i = 0; i < outer.size(); ++i)
            for (int k = inside; k < n_rings; ++k)
                outer[i] += (a / shear_modulus() * m[i][k] +
                             (static_cast<int>(i) == k ? tangential_compliance : 0)) *
                            bound[k];
        double shift = outer.front();
        if (inside > 0) {
            const auto unit = solved(lu, std::vector<double>(inside, 1.));
            const auto off = solved(lu, outer);
            shift = (bound[inside - 1] + off[inside - 1]) / unit[inside - 1];
            for (int i = 0; i < inside; ++i) t[i] = shift * unit[i] - off[i];
        }
        double force = 0;
        for (int i = 0; i < n_rings; ++i) force += a * a * rings().areas[i] * t[i];
        return {force, shift};
    }
};

}  // namespace tricontact
