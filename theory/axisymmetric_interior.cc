#include "theory/axisymmetric_interior.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <complex>

namespace tricontact::theory {

namespace {

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

}  // namespace

InteriorResponse axisymmetric_interior(const contact::Material& material,
                                       const std::function<double(double t)>& line_load,
                                       double radius, double x, double y, double z) {
    using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
    HarmonicDerivatives sum{};
    for (std::size_t k = 0; k < sum.size(); ++k)
        sum[k] =
            2 * Rule::integrate(
                    [&](double t) { return line_load(t) * derivatives(x, y, Complex(z, t))[k]; },
                    0., radius, 12, 1e-11);
    return half_space_response(material, z, sum);
}

}  // namespace tricontact::theory
