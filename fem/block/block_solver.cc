#include "fem/block/block_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/compliances/blocks.h"

// Bramble and Pasciak (1988). With P ~ A^-1 and a diagonal S ~ B A^-1 B' + C
//
//   M^-1 K = [ P         0     ] [ A  B' ]     H = [ A - P^-1  0 ]
//            [ S^-1 B P  -S^-1 ] [ B  -C ]         [ 0         S ]
//
// M^-1 K is symmetric in H, and so conjugate gradients in H solve with one product and one P an
// iteration: pressures belong to one element each, so that what the next direction needs of them
// comes with the product (apply_eliminated). H is positive if P is large enough, some five times
// A^-1, and convergence then certain. With P as it is iterations are half of those; they find the
// same solution unless they break down, which residuals show (none was seen to). Then P is doubled.

namespace tricontact::fem {

namespace {

// B A^-1 B' of a pressure: between 3/(4 G) of its mass, where a gradient carries it, and less.
constexpr double share_of_shear = .75;
constexpr int most_iterations = 1000;
constexpr double worst_growth = 1e3;  // of residuals
constexpr double rounding = 1.1;      // of residuals by recursion

}  // namespace

/// Vectors of unknowns; [u, p] of two of which the parts go together. K of the mixed form.
struct BlockSolver::Iterates {
    explicit Iterates(std::size_t n)
        : residual(n), z(n), of_z(n), direction(n), of_direction(n), v(n), of_v(n) {}

    std::vector<double> residual;      // r = f - K x
    std::vector<double> z;             // P r_u
    std::vector<double> of_z;          // [A z + B' s, s], s = (B z - r_p) / S
    std::vector<double> direction;     // d, of x
    std::vector<double> of_direction;  // t = K d
    std::vector<double> v;             // [P t_u, t_p]
    std::vector<double> of_v;          // as of_z, of v
    double weight = 1;                 // of P
    double rho = 0;                    // M^-1 r in H, squared
};

BlockSolver::BlockSolver(const BlockGrid& grid, int n_threads)
    : operator_(grid, n_threads),
      shear_(grid, n_threads),
      scale_(operator_.pressure_scale(share_of_shear, 1)),
      without_bulk_(operator_.pressure_scale(share_of_shear, 0)) {}

double BlockSolver::bytes(const BlockGrid& grid) {
    constexpr double n_vectors = 10;
    double modes = 0;
    for (const BlockAxis& axis : grid.axes) modes += 3. * axis.n_nodes() * axis.n_nodes();
    return 8 * (n_vectors * (3. * grid.n_nodes() + 4. * grid.n_elements()) + grid.n_nodes() +
                8. * grid.n_elements() + modes);
}

void BlockSolver::precondition(double weight, std::span<const double> r, std::span<double> z) {
    const std::size_t n = operator_.n_nodes();
    for (int c = 0; c < 3; ++c) shear_.solve(c, r.subspan(c * n, n), z.subspan(c * n, n));
    if (weight == 1) return;
    contact::Blocks(3 * n, operator_.n_threads()).for_points([&](std::size_t i) {
        z[i] *= weight;
    });
}

/// In the norm of P and S.
double BlockSolver::norm(const Iterates& it) const {
    const std::size_t n = 3 * operator_.n_nodes();
    const int n_threads = operator_.n_threads();
    const auto &r = it.residual, &z = it.z;
    const double of_forces =
        contact::Blocks(n, n_threads).sum_terms([&](std::size_t i) { return r[i] * z[i]; });
    const double of_pressures =
        contact::Blocks(scale_.size(), n_threads).sum_terms([&](std::size_t m) {
            return r[n + m] * r[n + m] / scale_[m];
        });
    return std::sqrt(of_forces / it.weight + of_pressures);
}

/// Of the forces less K x.
void BlockSolver::set_residual(std::span<const double> forces, const std::vector<double>& x,
                               Iterates& it) {
    operator_.apply(x, it.residual);
    contact::Blocks(x.size(), operator_.n_threads()).for_points([&](std::size_t i) {
        it.residual[i] = forces[i] - it.residual[i];
    });
    operator_.clear_held(it.residual);
    precondition(it.weight, it.residual, it.z);
}

/// One iteration; false if it breaks down, x as before.
bool BlockSolver::iterate(Iterates& it, std::vector<double>& x) {
    const std::size_t n = 3 * operator_.n_nodes(), n_p = scale_.size();
    const int n_threads = operator_.n_threads();
    const contact::Blocks forces(n, n_threads), pressures(n_p, n_threads);
    auto &r = it.residual, &z = it.z, &g = it.of_z, &d = it.direction, &t = it.of_direction,
         &v = it.v, &y = it.of_v;
    const double rho = forces.sum_terms([&](std::size_t i) { return z[i] * (g[i] - r[i]); }) -
                       pressures.sum_terms([&](std::size_t m) { return g[n + m] * r[n + m]; });
    const double of_last = it.rho == 0 ? 0 : rho / it.rho;
    forces.for_points([&](std::size_t i) {
        d[i] = z[i] + of_last * d[i];
        t[i] = g[i] + of_last * t[i];
    });
    pressures.for_points([&](std::size_t m) {
        d[n + m] = g[n + m] + of_last * d[n + m];
        t[n + m] = v[n + m] = without_bulk_[m] * g[n + m] + r[n + m] + of_last * t[n + m];
    });
    precondition(it.weight, t, v);
    operator_.apply_eliminated(v, scale_, y);
    const double delta = forces.sum_terms([&](std::size_t i) { return d[i] * (y[i] - t[i]); }) +
                         pressures.sum_terms([&](std::size_t m) {
                             return (without_bulk_[m] * d[n + m] - t[n + m]) * y[n + m];
                         });
    const double step = rho / delta;
    if (!std::isfinite(step) || step == 0) return false;
    forces.for_points([&](std::size_t i) {
        x[i] += step * d[i];
        r[i] -= step * t[i];
        g[i] -= step * y[i];
        z[i] -= step * v[i];
    });
    pressures.for_points([&](std::size_t m) {
        x[n + m] += step * d[n + m];
        r[n + m] -= step * t[n + m];
        g[n + m] -= step * y[n + m];
    });
    it.rho = rho;
    return true;
}

/// Iterations until the residual's norm is `goal`, or they do not lead there; at most `most`.
int BlockSolver::iterate_until(double goal, int most, Iterates& it, std::vector<double>& x) {
    const auto n = static_cast<std::ptrdiff_t>(3 * operator_.n_nodes());
    std::copy(it.residual.begin() + n, it.residual.end(), it.z.begin() + n);
    operator_.apply_eliminated(it.z, scale_, it.of_z);
    it.rho = 0;
    const double largest = worst_growth * norm(it);
    for (int k = 1; k <= most; ++k) {
        if (!iterate(it, x)) return k;
        const double now = norm(it);
        if (!(now > goal && now <= largest)) return k;
    }
    return most;
}

int BlockSolver::solve(std::span<const double> forces, double tolerance, std::vector<double>& x) {
    x.resize(operator_.size());
    Iterates it(operator_.size());
    std::ranges::copy(forces, it.residual.begin());
    operator_.clear_held(it.residual);
    precondition(it.weight, it.residual, it.z);
    const double goal = tolerance * norm(it);
    if (goal == 0) {
        std::ranges::fill(x, 0.);
        return 0;
    }
    double last = 0;
    for (int k = 0;; it.weight *= 2) {
        set_residual(forces, x, it);
        last = norm(it);
        if (last <= rounding * goal) return k;
        if (k == most_iterations) break;
        k += iterate_until(goal, most_iterations - k, it, x);
    }
    throw contact::NotConverged(
        fmt::format("the block's displacements: residual {:.1e} of {:.1e} after {} iterations",
                    last, goal, most_iterations));
}

}  // namespace tricontact::fem
