#include "fem/element.h"

#include <cmath>

// The element Q2/P1 of docs/explanation/models/fem.md. Volume and shape are integrated apart,
//
//   int 2 G dev eps : dev eps + K (P div u)^2,
//
// P the projection onto psi = {1, x, y, z} of the element. With the mass matrix of psi, M = L L',
// and b_m = int psi_m div u, it is (P div u)^2 integrated = b' M^-1 b = |L^-1 b|^2: the rows of Y =
// L^-1 b are what `Dilatation` keeps. Q2 has 81 unknowns for these four conditions, so K/G may be
// 1e6 without locking; continuous pressures could not be eliminated per element, and fewer of them
// would let pressures oscillate (Brezzi and Fortin 1991).
//
// psi is taken about the element's centre and over its size: M is then well conditioned wherever
// the element lies.

namespace tricontact::fem {

namespace {

constexpr int n_nodes = 27, n_unknowns = 81;

// Lower triangle of S: products of the derivatives a of shape function i and b of j, integrated.
void integrate_derivatives(const ElementValues& values, ElementStiffness& s) {
    const auto weights = values.weights;
    const auto gradients = values.gradients;
    for (auto& row : s) row.fill(0);
    std::array<double, n_unknowns> derivative{};
    for (std::size_t q = 0; q < weights.size(); ++q) {
        for (int a = 0; a < 3; ++a)
            for (int i = 0; i < n_nodes; ++i) derivative[a * n_nodes + i] = gradients[q][i][a];
        for (int r = 0; r < n_unknowns; ++r) {
            const double factor = weights[q] * derivative[r];
            for (int c = 0; c <= r; ++c) s[r][c] += factor * derivative[c];
        }
    }
}

}  // namespace

Moduli moduli_of(const contact::Material& material, double largest_bulk_ratio) {
    const double shear = material.shear_modulus(), nu = material.poisson;
    // K/G = 2 (1 + nu) / (3 (1 - 2 nu))
    const double numerator = 2 * (1 + nu), denominator = 3 * (1 - 2 * nu);
    const bool cut = numerator >= largest_bulk_ratio * denominator;
    return {shear, shear * (cut ? largest_bulk_ratio : numerator / denominator)};
}

Dilatation::Dilatation(const ElementValues& values) {
    const auto weights = values.weights;
    const auto points = values.points;
    const auto gradients = values.gradients;
    double volume = 0;
    for (std::size_t q = 0; q < weights.size(); ++q) {
        volume += weights[q];
        for (int a = 0; a < 3; ++a) centre_[a] += weights[q] * points[q][a];
    }
    for (double& x : centre_) x /= volume;
    size_ = std::cbrt(volume);

    auto& mass = mass_factor_;
    for (std::size_t q = 0; q < weights.size(); ++q) {
        const auto psi = functions(points[q]);
        for (int m = 0; m < 4; ++m) {
            const double factor = weights[q] * psi[m];
            for (int n = 0; n <= m; ++n) mass[m][n] += factor * psi[n];
            for (int a = 0; a < 3; ++a)
                for (int i = 0; i < n_nodes; ++i)
                    rows_[m][a * n_nodes + i] += factor * gradients[q][i][a];
        }
    }
    for (int m = 0; m < 4; ++m)
        for (int n = 0; n <= m; ++n) {
            for (int l = 0; l < n; ++l) mass[m][n] -= mass[m][l] * mass[n][l];
            mass[m][n] = n == m ? std::sqrt(mass[m][m]) : mass[m][n] / mass[n][n];
        }
    for (int r = 0; r < n_unknowns; ++r) {
        std::array<double, 4> column{rows_[0][r], rows_[1][r], rows_[2][r], rows_[3][r]};
        solve_lower(column);
        for (int m = 0; m < 4; ++m) rows_[m][r] = column[m];
    }
}

std::array<double, 4> Dilatation::functions(const std::array<double, 3>& x) const {
    return {1, (x[0] - centre_[0]) / size_, (x[1] - centre_[1]) / size_,
            (x[2] - centre_[2]) / size_};
}

double Dilatation::at(const std::array<double, 3>& x,
                      const std::array<double, 4>& amplitude) const {
    auto orthonormal = functions(x);
    solve_lower(orthonormal);
    double sum = 0;
    for (int m = 0; m < 4; ++m) sum += orthonormal[m] * amplitude[m];
    return sum;
}

// Rows that sum to zero over the nodes but for rounding of entries of the size of K/G are given
// that sum exactly, at the cost of the last node: rigid translations, which a ground far away holds
// by shear alone, would else meet a stiffness of rounding errors.
void free_translations(ElementStiffness& k) {
    constexpr int last = n_nodes - 1;
    const auto rest = [&](int r, int b) {
        long double sum = 0;
        for (int j = 0; j < last; ++j) sum += k[r][b * n_nodes + j];
        return -static_cast<double>(sum);
    };
    for (int b = 0; b < 3; ++b)
        for (int r = 0; r < n_unknowns; ++r)
            if (r % n_nodes != last)
                k[r][b * n_nodes + last] = k[b * n_nodes + last][r] = rest(r, b);
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b <= a; ++b) {
            const int r = a * n_nodes + last, c = b * n_nodes + last;
            k[r][c] = k[c][r] = rest(r, b);
        }
}

// 2 G dev eps : dev eps of the shape functions i in direction a and j in direction b is
// G (delta_ab grad_i . grad_j + d_b i d_a j - 2/3 d_a i d_b j).
void element_stiffness(const ElementValues& values, const Moduli& moduli, ElementStiffness& k) {
    thread_local ElementStiffness s;
    integrate_derivatives(values, s);
    const auto product = [](int r, int c) { return r >= c ? s[r][c] : s[c][r]; };
    const Dilatation dilatation(values);
    const auto& y = dilatation.rows();
    for (int a = 0; a < 3; ++a)
        for (int i = 0; i < n_nodes; ++i) {
            const int r = a * n_nodes + i;
            for (int c = 0; c <= r; ++c) {
                const int b = c / n_nodes, j = c % n_nodes;
                double shear = product(b * n_nodes + i, a * n_nodes + j) - 2. / 3 * s[r][c];
                if (a == b)
                    for (int d = 0; d < 3; ++d) shear += product(d * n_nodes + i, d * n_nodes + j);
                const double volumetric =
                    y[0][r] * y[0][c] + y[1][r] * y[1][c] + y[2][r] * y[2][c] + y[3][r] * y[3][c];
                k[r][c] = moduli.shear * shear + moduli.bulk * volumetric;
                k[c][r] = k[r][c];
            }
        }
    free_translations(k);
}

}  // namespace tricontact::fem
