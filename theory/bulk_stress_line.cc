#include "theory/bulk_stress_line.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace tricontact::theory {

namespace {

using Complex = std::complex<double>;

/// Of f(s) = sqrt(1 - s^2), |s| < 1: H = ∫ f/(zeta - s) ds = pi (zeta - sqrt(zeta^2 - 1)) and its
/// derivative, at zeta = x + i z, z >= 0.
struct Elliptic {
    Complex h, slope;
};

Elliptic elliptic(double x, double z) {
    // The root that goes with zeta at infinity; on the surface the limit from inside.
    const Complex zeta(x, z);
    const Complex root = std::sqrt(zeta - 1.) * std::sqrt(zeta + 1.);
    return {std::numbers::pi * (zeta - root), std::numbers::pi * (1. - zeta / root)};
}

/// What a normal load (0) and a tangential one (1) of this distribution and of unit peak make at
/// (x, z), in half widths: XX, ZZ, XZ. Superposed point forces, Johnson (1985), eq. 2.15 and 2.18.
std::array<std::array<double, 3>, 2> stresses(double x, double z) {
    const auto [h, slope] = elliptic(x, z);
    const double deep = z > 0 ? z * slope.real() : 0, across = z > 0 ? z * slope.imag() / 2 : 0;
    const double x2z = (-h.imag() - deep) / 2, z3 = (-h.imag() + deep) / 2;
    const double xz2 = across, x3 = h.real() - across;
    const double unit = -2 / std::numbers::pi;
    return {{{unit * x2z, unit * z3, unit * xz2}, {unit * x3, unit * xz2, unit * x2z}}};
}

double sign_of(double value) {
    return value < 0 ? -1 : 1;
}

}  // namespace

bool BulkStressLine::holds() const {
    return stick_half_width == 0 || stick_centre == 0 ||
           std::abs(stick_centre) + stick_half_width < half_width;
}

double BulkStressLine::traction(double x) const {
    const auto half_ellipse = [](double at) { return std::sqrt(std::max(0., 1 - at * at)); };
    double q = half_ellipse(x / half_width);
    if (stick_half_width > 0)
        q -= stick_half_width / half_width * half_ellipse((x - stick_centre) / stick_half_width);
    return sign_of(force_ratio) * friction * peak_pressure * q;
}

std::array<double, 6> BulkStressLine::stress(const contact::Material& material, double x,
                                             double z) const {
    const auto whole = stresses(x / half_width, z / half_width);
    const double shear = sign_of(force_ratio) * friction * peak_pressure;
    std::array<double, 3> sum{};  // XX, ZZ, XZ
    for (std::size_t k = 0; k < 3; ++k) sum[k] = peak_pressure * whole[0][k] + shear * whole[1][k];
    if (stick_half_width > 0) {
        const auto stuck = stresses((x - stick_centre) / stick_half_width, z / stick_half_width);
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] -= shear * stick_half_width / half_width * stuck[1][k];
    }
    sum[0] += bulk_stress;
    return {sum[0], material.poisson * (sum[0] + sum[1]), sum[1], 0, 0, sum[2]};
}

double BulkStressLine::trailing_stress() const {
    const double e = sign_of(force_ratio) * stick_centre, c = stick_half_width;
    const double reach = half_width + e;
    const double pulled = c > 0 ? std::sqrt(reach * reach - c * c) - e : half_width;
    return bulk_stress + 2 * friction * peak_pressure * pulled / half_width;
}

BulkStressLine bulk_stress_line(double effective_modulus, const contact::Material& half_space,
                                double radius, double normal_load, double friction,
                                double force_ratio, double bulk_stress) {
    BulkStressLine line;
    // a^2 = 4 F_N R/(pi E* L), p0 = 2 F_N/(pi a L); Johnson (1985), eq. 4.43 and 4.45.
    line.half_width = std::sqrt(4 * normal_load * radius / (std::numbers::pi * effective_modulus));
    line.peak_pressure = 2 * normal_load / (std::numbers::pi * line.half_width);
    line.friction = friction;
    line.force_ratio = force_ratio;
    line.bulk_stress = bulk_stress;
    line.stick_half_width = line.half_width * std::sqrt(std::max(0., 1 - std::abs(force_ratio)));
    const double strain = half_space.plane_compliance() * bulk_stress;
    if (line.stick_half_width > 0 && strain != 0)
        line.stick_centre = sign_of(force_ratio) * strain * effective_modulus * line.half_width /
                            (2 * friction * line.peak_pressure);
    return line;
}

}  // namespace tricontact::theory
