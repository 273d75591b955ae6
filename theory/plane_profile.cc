#include "theory/plane_profile.h"

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

namespace tricontact::theory {

double plane_profile(const contact::AxisymmetricIndenter& indenter, double x) {
    if (x == 0) return 0;
    thread_local boost::math::quadrature::tanh_sinh<double> quadrature;  // keeps its abscissas
    double mean_slope = 0, begin = 0;
    auto add_piece = [&](double end) {
        // Strictly inside: rounding must not read the slope beyond a kink or the rim.
        const double least = std::nextafter(begin, end), most = std::nextafter(end, begin);
        const double start = std::asin(begin / x), length = std::asin(end / x) - start;
        auto slope = [&](double part) {
            const double r = x * std::sin(start + part * length);
            return indenter.profile_slope(std::clamp(r, least, most));
        };
        mean_slope += length * quadrature.integrate(slope, 0., 1., 1e-12);
        begin = end;
    };
    for (const double kink : indenter.kinks())
        if (kink < x) add_piece(kink);
    add_piece(x);
    return x * mean_slope;
}

}  // namespace tricontact::theory
