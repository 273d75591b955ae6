#include "theory/half_space_interior.h"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <complex>
#include <numbers>

namespace tricontact::theory {

namespace {

/// Derivatives by the directions 0, 1, 2 in any order.
struct Harmonic {
    const HarmonicDerivatives& of_;

    double l(int i) const { return of_[L_x + i]; }
    double l(int i, int j) const {
        const int n_z = (i == 2) + (j == 2);
        if (n_z == 2) return -(of_[L_xx] + of_[L_yy]);
        if (n_z == 1) return of_[L_xz + (i == 2 ? j : i)];
        return of_[L_xx + i + j];
    }
    double l(int i, int j, int k) const {
        const int n_z = (i == 2) + (j == 2) + (k == 2);
        const int rest = i + j + k - 2 * n_z;  // how many y
        if (n_z == 3) return -(of_[L_xxz] + of_[L_yyz]);
        if (n_z == 2) return -(of_[L_xxx + rest] + of_[L_xxx + rest + 2]);
        return of_[(n_z == 1 ? L_xxz : L_xxx) + rest];
    }
    double m(int i, int j) const { return of_[M_xx + i + j]; }
    double m(int i, int j, int k) const { return of_[M_xxx + i + j + k]; }
};

// Of stresses: i and j of XX YY ZZ XY YZ XZ.
constexpr std::array<std::array<int, 2>, 6> indices = {
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};

/// 2 pi sigma_ij under a pressing force.
double pressed_stress(const Harmonic& h, double nu, double z, int i, int j) {
    const double deep = -z * h.l(i, j, 2);
    if (i < 2 && j < 2) return deep - (1 - 2 * nu) * h.l(i, j) + (i == j ? 2 * nu * h.l(2, 2) : 0);
    return i == j ? deep + h.l(2, 2) : deep;
}

/// 2 pi sigma_ij under a force along d.
double sheared_stress(const Harmonic& h, double nu, double z, int i, int j, int d) {
    const double deep = -z * h.l(i, j, d);
    if (i < 2 && j < 2)
        return deep + (i == d ? h.l(2, j) : 0) + (j == d ? h.l(2, i) : 0) + 2 * nu * h.m(i, j, d) +
               (i == j ? 2 * nu * h.l(2, d) : 0);
    return i == d && j == 2 ? deep + h.l(2, 2) : deep;
}

using Complex = std::complex<double>;

/// Derivatives at (x, y, z) with a complex z, Re z > 0; the real parts.
HarmonicDerivatives derivatives(double x, double y, Complex z) {
    const Complex rho = std::sqrt(x * x + y * y + z * z), sum = rho + z;
    const Complex rho3 = rho * rho * rho;
    // 1/(rho sum) and -its derivative by rho over rho, twice: L_x = x g, M_x = -x/sum.
    const Complex g = 1. / (rho * sum);
    const Complex g1 = (2. * rho + z) / (rho3 * sum * sum);
    const Complex g2 =
        (8. * rho * rho + 9. * rho * z + 3. * z * z) / (rho3 * rho * rho * sum * sum * sum);
    // 1/sum in the same way.
    const Complex m1 = 1. / (rho * sum * sum);
    const Complex m2 = (3. * rho + z) / (rho3 * sum * sum * sum);
    HarmonicDerivatives out{};
    auto set = [&](HarmonicDerivative which, const Complex& value) { out[which] = value.real(); };
    set(L_x, x * g);
    set(L_y, y * g);
    set(L_z, 1. / rho);
    set(L_xx, g - x * x * g1);
    set(L_xy, -x * y * g1);
    set(L_yy, g - y * y * g1);
    set(L_xz, -x / rho3);
    set(L_yz, -y / rho3);
    set(L_xxx, x * (-3. * g1 + x * x * g2));
    set(L_xxy, y * (-g1 + x * x * g2));
    set(L_xyy, x * (-g1 + y * y * g2));
    set(L_yyy, y * (-3. * g1 + y * y * g2));
    const Complex rho5 = rho3 * rho * rho;
    set(L_xxz, -1. / rho3 + 3. * x * x / rho5);
    set(L_xyz, 3. * x * y / rho5);
    set(L_yyz, -1. / rho3 + 3. * y * y / rho5);
    set(M_xx, -1. / sum + x * x * m1);
    set(M_xy, x * y * m1);
    set(M_yy, -1. / sum + y * y * m1);
    set(M_xxx, x * (3. * m1 - x * x * m2));
    set(M_xxy, y * (m1 - x * x * m2));
    set(M_xyy, x * (m1 - y * y * m2));
    set(M_yyy, y * (3. * m1 - y * y * m2));
    return out;
}

/// Of all derivatives at once, each to 1e-11 of its largest part or `depth` halvings.
template <class Integrand>
HarmonicDerivatives integral(const Integrand& integrand, double from, double to, int depth) {
    using Kronrod = boost::math::quadrature::gauss_kronrod<double, 31>;
    using Gauss = boost::math::quadrature::gauss<double, 15>;
    constexpr double tolerance = 1e-11;
    const double middle = (from + to) / 2, half = (to - from) / 2;
    HarmonicDerivatives fine{}, coarse{}, size{};
    // Every other point of Kronrod's rule is one of Gauss', from the middle on.
    for (std::size_t i = 0; i < Kronrod::abscissa().size(); ++i) {
        const double place = Kronrod::abscissa()[i] * half;
        const double weight = Kronrod::weights()[i] * half;
        const double rough = i % 2 == 0 ? Gauss::weights()[i / 2] * half : 0;
        for (const double side : {-1., 1.}) {
            if (i == 0 && side > 0) continue;
            const HarmonicDerivatives at = integrand(middle + side * place);
            for (std::size_t k = 0; k < at.size(); ++k) {
                fine[k] += weight * at[k];
                coarse[k] += rough * at[k];
                size[k] += weight * std::abs(at[k]);
            }
        }
    }
    bool is_enough = true;
    for (std::size_t k = 0; k < fine.size(); ++k)
        is_enough = is_enough && std::abs(fine[k] - coarse[k]) <= tolerance * size[k];
    if (is_enough || depth == 0) return fine;
    HarmonicDerivatives sum = integral(integrand, from, middle, depth - 1);
    const HarmonicDerivatives right = integral(integrand, middle, to, depth - 1);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += right[k];
    return sum;
}

}  // namespace

InteriorResponse half_space_response(const contact::Material& material, double depth,
                                     const HarmonicDerivatives& derivatives) {
    const Harmonic h{derivatives};
    const double nu = material.poisson, z = depth;
    const double soft = 1 / (4 * std::numbers::pi * material.shear_modulus());
    InteriorResponse out;
    for (int i = 0; i < 2; ++i) {
        out.displacement[i][2] = soft * (-z * h.l(i, 2) - (1 - 2 * nu) * h.l(i));
        out.displacement[2][i] = soft * (-z * h.l(i, 2) + (1 - 2 * nu) * h.l(i));
        for (int d = 0; d < 2; ++d)
            out.displacement[i][d] =
                soft * ((i == d ? 2 * h.l(2) : 0) - z * h.l(i, d) + 2 * nu * h.m(i, d));
    }
    out.displacement[2][2] = soft * (-z * h.l(2, 2) + 2 * (1 - nu) * h.l(2));
    for (int c = 0; c < 6; ++c) {
        const auto [i, j] = indices[c];
        for (int d = 0; d < 2; ++d)
            out.stress[c][d] = sheared_stress(h, nu, z, i, j, d) / (2 * std::numbers::pi);
        out.stress[c][2] = pressed_stress(h, nu, z, i, j) / (2 * std::numbers::pi);
    }
    return out;
}

InteriorResponse axisymmetric_interior(const contact::Material& material,
                                       const std::function<double(double t)>& line_load,
                                       double radius, double x, double y, double z) {
    const auto integrand = [&](double t) {
        HarmonicDerivatives at = derivatives(x, y, Complex(z, t));
        const double load = 2 * line_load(t);
        for (double& one : at) one *= load;
        return at;
    };
    return half_space_response(material, z, integral(integrand, 0, radius, 12));
}

}  // namespace tricontact::theory
