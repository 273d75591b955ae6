#include "fem/block/block_solver.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "contact/base/error.h"
#include "contact/compliances/blocks.h"

namespace tricontact::fem {

namespace {

// B A^-1 B' of a pressure: between 3/(4 G) of its mass, where a gradient carries it, and less.
constexpr double share_of_shear = .75;
constexpr int most_iterations = 1000;

}  // namespace

BlockSolver::BlockSolver(const BlockGrid& grid, int n_threads)
    : operator_(grid, n_threads),
      shear_(grid, n_threads),
      pressure_scale_(operator_.pressure_scale(share_of_shear)) {}

double BlockSolver::bytes(const BlockGrid& grid) {
    constexpr double n_vectors = 10;
    double modes = 0;
    for (const BlockAxis& axis : grid.axes) modes += 3. * axis.n_nodes() * axis.n_nodes();
    return 8 * (n_vectors * (3. * grid.n_nodes() + 4. * grid.n_elements()) + grid.n_nodes() +
                4. * grid.n_elements() + modes);
}

void BlockSolver::precondition(std::span<const double> r, std::span<double> z) {
    const std::size_t n = operator_.n_nodes();
    for (int c = 0; c < 3; ++c) shear_.solve(c, r.subspan(c * n, n), z.subspan(c * n, n));
    for (std::size_t m = 0; m < pressure_scale_.size(); ++m)
        z[3 * n + m] = r[3 * n + m] / pressure_scale_[m];
}

double BlockSolver::dot(std::span<const double> a, std::span<const double> b) const {
    return contact::Blocks(a.size(), operator_.n_threads()).sum_terms([&](std::size_t i) {
        return a[i] * b[i];
    });
}

// Preconditioned MINRES in the order of Elman, Silvester and Wathen (2014), algorithm 4.1.
int BlockSolver::solve(std::span<const double> forces, double tolerance, std::vector<double>& x) {
    const std::size_t n = operator_.size();
    const contact::Blocks all(n, operator_.n_threads());
    std::vector<double> v(forces.begin(), forces.end()), z(n), v_old(n), w(n), w_old(n), product(n);
    operator_.clear_held(v);
    precondition(v, z);
    const double goal = tolerance * std::sqrt(dot(v, z));
    x.resize(n);
    operator_.apply(x, product);
    all.for_points([&](std::size_t i) { v[i] -= product[i]; });
    precondition(v, z);
    double gamma = std::sqrt(dot(v, z)), gamma_old = 1, eta = gamma;
    double s = 0, s_old = 0, c = 1, c_old = 1;
    for (int k = 0; k <= most_iterations; ++k) {
        if (std::abs(eta) <= goal) return k;
        all.for_points([&](std::size_t i) { z[i] /= gamma; });
        operator_.apply(z, product);
        const double delta = dot(product, z);
        const double of_v = delta / gamma, of_old = gamma / gamma_old;
        all.for_points(
            [&](std::size_t i) { v_old[i] = product[i] - of_v * v[i] - of_old * v_old[i]; });
        std::swap(v, v_old);
        precondition(v, product);
        const double gamma_new = std::sqrt(std::max(0., dot(v, product)));
        const double a0 = c * delta - c_old * s * gamma, a1 = std::hypot(a0, gamma_new);
        const double a2 = s * delta + c_old * c * gamma, a3 = s_old * gamma;
        c_old = std::exchange(c, a0 / a1);
        s_old = std::exchange(s, gamma_new / a1);
        const double step = c * eta;
        all.for_points([&](std::size_t i) {
            w_old[i] = (z[i] - a3 * w_old[i] - a2 * w[i]) / a1;
            x[i] += step * w_old[i];
        });
        std::swap(w, w_old);
        std::swap(z, product);
        eta = -s * eta;
        gamma_old = std::exchange(gamma, gamma_new);
    }
    throw contact::NotConverged(
        fmt::format("the block's displacements: residual {:.1e} of {:.1e} after {} iterations",
                    std::abs(eta), goal, most_iterations));
}

}  // namespace tricontact::fem
