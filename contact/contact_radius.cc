#include "contact/contact_radius.h"

#include <cmath>
#include <numbers>

namespace tricontact::contact {

double contact_radius(const ContactPoints& points, const std::vector<double>& pressure,
                      const Vector2& centre) {
    double area = 0, force = 0, second = 0, fourth = 0;
    for (std::size_t i = 0; i < pressure.size(); ++i) {
        if (!(pressure[i] > 0)) continue;
        const double x = points.x[i] - centre[0], y = points.y[i] - centre[1];
        const double s = x * x + y * y, f = points.area[i] * pressure[i];
        area += points.area[i];
        force += f;
        second += f * s;
        fourth += f * s * s;
    }
    const double counted = std::sqrt(area / std::numbers::pi);
    const double m1 = second / force, m2 = fourth / force;
    // With s = r^2/a^2 and int sqrt(1 - s) s^k ds = B(k + 1, 3/2), the two equations for a^2 and
    // c1/c0 leave a^4 - 7 m1 a^2 + 63/8 m2 = 0.
    const double discriminant = 49 * m1 * m1 - 31.5 * m2;
    if (!(discriminant >= 0)) return counted;
    const double radius = std::sqrt((7 * m1 - std::sqrt(discriminant)) / 2);
    return std::abs(radius / counted - 1) < 0.3 ? radius : counted;
}

}  // namespace tricontact::contact
