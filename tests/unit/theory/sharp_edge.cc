#include "theory/sharp_edge.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tricontact::theory::sharp_edge_test {
namespace {

using tricontact::theory::edge_pressure_exponent;
constexpr double pi = std::numbers::pi;

// Williams' (1952) eigenfunctions on a wedge 0 <= t <= phi: stress function r^(l+1) f(t). Pressure
// r^(l-1) on t = 0 without shear, t = phi free; the normal displacement of t = 0 over r^l/E', up to
// a factor that all wedges share.
double flexibility(double phi, double l) {
    Eigen::Matrix4d conditions;
    const auto normal = [&](double t) {
        return Eigen::RowVector4d(std::cos((l + 1) * t), std::sin((l + 1) * t),
                                  std::cos((l - 1) * t), std::sin((l - 1) * t));
    };
    const auto shear = [&](double t) {
        return Eigen::RowVector4d(-(l + 1) * std::sin((l + 1) * t), (l + 1) * std::cos((l + 1) * t),
                                  -(l - 1) * std::sin((l - 1) * t),
                                  (l - 1) * std::cos((l - 1) * t));
    };
    conditions << l * (l + 1) * normal(0), shear(0), normal(phi), shear(phi);
    const Eigen::Vector4d x = conditions.fullPivLu().solve(Eigen::Vector4d(1, 0, 0, 0));
    constexpr double nu = 0;  // E' alone counts under frictionless contact
    return -(l + 1) * x[1] - (3 - 4 * nu + l) * x[3];
}

TEST(SharpEdge, SatisfiesTheConditionOfContactOfWilliamsWedges) {
    for (const double angle : {pi / 2, 3 * pi / 4, pi / 3})
        for (const double alpha : {-0.5, 0., 0.5, 0.9}) {
            const double exponent = edge_pressure_exponent(angle, alpha);
            if (exponent == 0) continue;
            const double wedge = flexibility(angle, exponent + 1);
            const double plane = flexibility(pi, exponent + 1);
            // Displacements of both surfaces cancel: E1'/E2' = (1 + alpha)/(1 - alpha).
            EXPECT_NEAR(wedge * (1 - alpha) / (plane * (1 + alpha)), -1, 1e-10)
                << angle << ' ' << alpha;
        }
}

TEST(SharpEdge, KnownExponents) {
    // Johnson (1985), section 5.1: similar materials, square edge, frictionless: 0.23.
    EXPECT_NEAR(edge_pressure_exponent(pi / 2, 0), -0.226, 5e-4);
    // The rigid punch: a square root, whatever its angle.
    EXPECT_EQ(edge_pressure_exponent(pi / 2, 1), -0.5);
    EXPECT_NEAR(edge_pressure_exponent(3 * pi / 4, 1 - 1e-9), -0.5, 1e-6);
    // A square elastic block on a rigid plane: half of a body of twice the width, no edge.
    EXPECT_NEAR(edge_pressure_exponent(pi / 2, -1), 0, 1e-5);
}

TEST(SharpEdge, RefusesWhatIsNoWedge) {
    EXPECT_THROW(edge_pressure_exponent(0, 0), std::domain_error);
    EXPECT_THROW(edge_pressure_exponent(pi, 0), std::domain_error);
    EXPECT_THROW(edge_pressure_exponent(pi / 2, 1.1), std::domain_error);
}

}  // namespace
}  // namespace tricontact::theory::sharp_edge_test
