#include "theory/layer/layer_compliance.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <string>

#include "contact/base/error.h"

namespace tricontact::layer_compliance_test {
namespace {

using theory::ElasticLayer;
using theory::layer_compliance;
using theory::LayerBase;
using theory::LayerCompliance;

constexpr LayerBase both_bases[] = {LayerBase::bonded, LayerBase::frictionless};

// Scales different from 1: G = 3.7 MPa, b = 0.6 m.
ElasticLayer layer_of(double nu, LayerBase base) {
    return {{2 * (1 + nu) * 3.7e6, nu}, .6, base};
}

// The boundary value problem of one wave number, free of the formulas: Hooke's law and equilibrium
// as a first-order system in z for u_x = U sin kx, u_z = W cos kx, sigma_zz = S cos kx,
// sigma_xz = T sin kx (plane strain), and v = V, tau = sigma_yz/G (antiplane), through the
// thickness by the matrix exponential in long double.
class BoundaryValueProblem {
  public:
    using Real = long double;
    using Matrix = Eigen::Matrix<Real, 4, 4>;
    using Matrix2 = Eigen::Matrix<Real, 2, 2>;

    // G = b = 1, so that k = x
    static LayerCompliance solve(double nu, LayerBase base, double x) {
        Matrix rate = Matrix::Zero();  // of (U, W, S, T)
        const Real k = x, n = nu;
        rate(0, 1) = k, rate(0, 3) = 1;
        rate(1, 0) = -k * n / (1 - n), rate(1, 2) = (1 - 2 * n) / (2 * (1 - n));
        rate(2, 3) = -k;
        rate(3, 0) = 2 * k * k / (1 - n), rate(3, 2) = k * n / (1 - n);
        const Matrix through = exponential<Matrix>(rate);
        // At the base W = 0 and either U = 0 or T = 0.
        const int other = base == LayerBase::bonded ? 0 : 3;
        Matrix2 of_displacement, of_stress;  // (U, W) and (S, T) at the surface
        of_displacement << through(1, 0), through(1, 1), through(other, 0), through(other, 1);
        of_stress << through(1, 2), through(1, 3), through(other, 2), through(other, 3);
        // p = -S, t = -T at the surface z = 0
        const Matrix2 compliance = of_displacement.fullPivLu().solve(of_stress);

        Matrix2 shear;
        shear << 0, 1, k * k, 0;
        const Matrix2 antiplane = exponential<Matrix2>(shear);
        const int row = base == LayerBase::bonded ? 0 : 1;
        // p cos kx = Re p exp(ikx) drives u_x = Re(i C13 p exp(ikx)) = -C13 p sin kx
        return {static_cast<double>(compliance(1, 0)), static_cast<double>(compliance(0, 1)),
                static_cast<double>(antiplane(row, 1) / antiplane(row, 0)),
                static_cast<double>(-compliance(0, 0))};
    }

  private:
    // Scaling and squaring of Taylor's series.
    template <typename M>
    static M exponential(M a) {
        constexpr int halvings = 8;
        a /= Real(1 << halvings);
        M term = M::Identity(), sum = M::Identity();
        for (int n = 1; n <= 24; ++n) {
            term = term * a / Real(n);
            sum += term;
        }
        for (int i = 0; i < halvings; ++i) sum = sum * sum;
        return sum;
    }
};

TEST(TheoryLayerCompliance, SolvesTheBoundaryValueProblem) {
    for (const LayerBase base : both_bases)
        for (const double nu : {-.9, -.3, 0., .25, .3, .49, .5})
            for (const double x : {.03, .2, .7, .999, 1.001, 2.3, 5.1, 8.}) {
                const ElasticLayer layer = layer_of(nu, base);
                const auto c = layer_compliance(layer, x / layer.thickness);
                const auto exact = BoundaryValueProblem::solve(nu, base, x);
                const double scale = layer.thickness / layer.material.shear_modulus();
                // Long double, 1e-19, times the growth exp(2x) = 1e7 through the thickness, and
                // over C33 = x^2/3 = 3e-4 of thin incompressible layers: far below.
                const double tolerance = 1e-12;
                const auto place = ::testing::Message() << "nu " << nu << ", x " << x;
                EXPECT_NEAR(c.normal / scale / exact.normal, 1, tolerance) << place;
                EXPECT_NEAR(c.along / scale / exact.along, 1, tolerance) << place;
                EXPECT_NEAR(c.across / scale / exact.across, 1, tolerance) << place;
                EXPECT_NEAR(
                    (c.coupling / scale - exact.coupling) / std::sqrt(exact.normal * exact.along),
                    0, tolerance)
                    << place;
            }
}

TEST(TheoryLayerCompliance, BecomesTheHalfSpace) {
    for (const LayerBase base : both_bases)
        for (const double x : {39.9, 40.1, 1e3, 1e200}) {
            const ElasticLayer layer = layer_of(.3, base);
            const double k = x / layer.thickness;
            const auto c = layer_compliance(layer, k);
            const double unit = 1 / (layer.material.shear_modulus() * k);
            EXPECT_NEAR(c.normal / unit, .7, 1e-15) << x;
            EXPECT_NEAR(c.along / unit, .7, 1e-15) << x;
            EXPECT_NEAR(c.across / unit, 1, 1e-15) << x;
            EXPECT_NEAR(c.coupling / unit, .2, 1e-15) << x;
        }
}

TEST(TheoryLayerCompliance, TendsToUniformLoadOnABondedLayer) {
    for (const double nu : {-.5, 0., .3, .49}) {
        const ElasticLayer layer = layer_of(nu, LayerBase::bonded);
        const auto limit = layer_compliance(layer, 0);
        const double shear = layer.thickness / layer.material.shear_modulus();
        EXPECT_NEAR(limit.normal / shear, (1 - 2 * nu) / (2 * (1 - nu)), 1e-15);  // oedometer
        EXPECT_EQ(limit.along, shear);
        EXPECT_EQ(limit.across, shear);
        EXPECT_EQ(limit.coupling, 0);
        const auto near = layer_compliance(layer, 1e-7 / layer.thickness);
        // The next terms are O(x^2) = 1e-14, times 1/(1 - 2 nu) = 50 in C33; C13 = O(x) = 1e-7.
        EXPECT_NEAR(near.normal / limit.normal, 1, 1e-12) << nu;
        EXPECT_NEAR(near.along / limit.along, 1, 1e-13) << nu;
        EXPECT_NEAR(near.across / limit.across, 1, 1e-13) << nu;
        const double kappa = 3 - 4 * nu;  // C13 -> k b^2 (kappa - 2)/(G (kappa + 1))
        EXPECT_NEAR(near.coupling / shear * 1e7, (kappa - 2) / (kappa + 1), 1e-13) << nu;
    }
}

TEST(TheoryLayerCompliance, ThinIncompressibleLayerIsLubrication) {
    const ElasticLayer layer = layer_of(.5, LayerBase::bonded);
    EXPECT_EQ(layer_compliance(layer, 0).normal, 0);
    for (const double x : {1e-8, 1e-6, 1e-4}) {
        const double k = x / layer.thickness;
        const double scale = layer.thickness / layer.material.shear_modulus();
        // k^2 b^3/(3 G); the next term is 8/5 x^2 of it: 1.6e-8 at x = 1e-4
        EXPECT_NEAR(layer_compliance(layer, k).normal / (scale * x * x / 3), 1, 2 * x * x + 1e-14);
        EXPECT_NEAR(layer_compliance(layer, k).coupling / (-scale * x / 2), 1, 2 * x * x + 1e-14);
    }
}

TEST(TheoryLayerCompliance, GlidingLayerAtRest) {
    for (const double nu : {-.5, 0., .3, .5}) {
        const ElasticLayer layer = layer_of(nu, LayerBase::frictionless);
        const double scale = layer.thickness / layer.material.shear_modulus(), x = 1e-7;
        const auto limit = layer_compliance(layer, 0);
        const auto near = layer_compliance(layer, x / layer.thickness);
        EXPECT_NEAR(limit.normal / scale, (1 - nu) / 2, 1e-15);
        EXPECT_NEAR(near.normal / limit.normal, 1, 1e-13);  // O(x^2)
        // The layer moves as a plate: plane stress along, nothing but shear waves across.
        EXPECT_NEAR(near.along / scale, (1 - nu) / (2 * x * x), 1e-13 / (x * x));
        EXPECT_NEAR(near.across / scale, 1 / (x * x), 1e-13 / (x * x));
        EXPECT_NEAR(near.coupling / scale, -nu / (2 * x), 1e-7);
        EXPECT_TRUE(std::isinf(limit.along) && std::isinf(limit.across));
        EXPECT_EQ(limit.coupling, nu == 0 ? 0 : -nu * std::numeric_limits<double>::infinity());
    }
}

TEST(TheoryLayerCompliance, IsContinuousAtTheSwitches) {
    for (const LayerBase base : both_bases)
        for (const double nu : {-.5, .25, .5})
            for (const double x : {1., 40.}) {
                const ElasticLayer layer{{1, nu}, 1, base};
                const auto below = layer_compliance(layer, std::nextafter(x, 0));
                const auto above = layer_compliance(layer, x);
                // The direct form has lost one digit at its end.
                const double allowed = 2e-15 * above.along;
                EXPECT_NEAR(below.normal, above.normal, allowed) << nu << ' ' << x;
                EXPECT_NEAR(below.along, above.along, allowed) << nu << ' ' << x;
                EXPECT_NEAR(below.across, above.across, 2 * allowed) << nu << ' ' << x;
                EXPECT_NEAR(below.coupling, above.coupling, allowed) << nu << ' ' << x;
            }
}

TEST(TheoryLayerCompliance, ThinIncompressibleLayersCoupleMost) {
    auto decoupling = [](double x) {
        const auto c = layer_compliance({{1, .5}, 1, LayerBase::bonded}, x);
        return 1 - c.coupling * c.coupling / (c.normal * c.along);
    };
    EXPECT_NEAR(decoupling(1e-6), .25, 1e-11);  // O(x^2)
    double before = .25;
    for (double x = 1e-3; x < 10; x *= 1.2) {
        EXPECT_GT(decoupling(x), before) << x;
        before = decoupling(x);
    }
    EXPECT_GT(before, .9999);  // the incompressible half-space does not couple
}

TEST(TheoryLayerCompliance, IsPositiveDefinite) {
    const bool holds = rc::check("positive definite", [] {
        const double nu = -.999 + 1.499 * *rc::gen::inRange(0, 1001) / 1000;
        const double x = std::exp(-14. + *rc::gen::inRange(0, 1801) / 100.);
        const LayerBase base = *rc::gen::element(LayerBase::bonded, LayerBase::frictionless);
        const auto c = layer_compliance(layer_of(nu, base), x / .6);
        RC_ASSERT(c.normal > 0);
        RC_ASSERT(c.along > 0);
        RC_ASSERT(c.across > 0);
        RC_ASSERT(c.coupling * c.coupling < c.normal * c.along);
    });
    EXPECT_TRUE(holds);
}

TEST(TheoryLayerCompliance, DeficitIsWhatTheHalfSpaceHasMore) {
    for (const LayerBase base : both_bases)
        for (const double nu : {-.5, 0., .3, .5})
            for (const double x : {1e-3, .1, .9, 1.1, 3., 8.}) {
                const auto c = layer_compliance({{2 * (1 + nu), nu}, 1, base}, x);  // G = 1
                const auto deficit = theory::half_space_deficit(nu, base, x);
                // roundings of 1, or of the soft gliding layer's C11 = 1/(2x) half-spaces
                const double normal = x * c.normal / (1 - nu), along = x * c.along / (1 - nu);
                EXPECT_NEAR(deficit.normal, 1 - normal, 1e-15) << nu << ' ' << x;
                EXPECT_NEAR(deficit.along, 1 - along, 1e-15 * (1 + along)) << nu << ' ' << x;
                EXPECT_NEAR(deficit.across, 1 - x * c.across, 1e-15 * (1 + x * c.across))
                    << nu << ' ' << x;
            }
}

TEST(TheoryLayerCompliance, DeficitFallsExponentially) {
    const double x = 30, decay = std::exp(-2 * x), kappa = 1.8;  // nu = 0.3
    const auto bonded = theory::half_space_deficit(.3, LayerBase::bonded, x);
    // leading terms; the rest is smaller by exp(-2x) x^2 = 1e-23
    EXPECT_NEAR(bonded.normal / (decay * (61 * 61 + kappa * kappa) / kappa), 1, 1e-14);
    EXPECT_NEAR(bonded.along / (decay * (59 * 59 + kappa * kappa) / kappa), 1, 1e-14);
    EXPECT_NEAR(bonded.across / (2 * decay), 1, 1e-14);
    const auto gliding = theory::half_space_deficit(.3, LayerBase::frictionless, x);
    EXPECT_NEAR(gliding.normal / (2 * decay * 61), 1, 1e-14);
    EXPECT_NEAR(gliding.along / (2 * decay * 59), 1, 1e-14);
    EXPECT_NEAR(gliding.across / (-2 * decay), 1, 1e-14);
    EXPECT_EQ(theory::half_space_deficit(.3, LayerBase::bonded, 1e200).normal, 0);
    EXPECT_EQ(theory::half_space_deficit(.3, LayerBase::bonded, 0).normal, 1);
    EXPECT_EQ(theory::half_space_deficit(.3, LayerBase::frictionless, 0).normal, 1);
}

std::string message_of(const ElasticLayer& layer, double k) {
    try {
        layer_compliance(layer, k);
    } catch (const contact::InputError& e) {
        return e.what();
    }
    return {};
}

TEST(TheoryLayerCompliance, RefusesBadInput) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double b : {0., -1., infinity, std::nan("")})
        EXPECT_NE(message_of({{1, .3}, b}, 1).find("thickness must be positive"),
                  std::string::npos);
    for (const double nu : {-1., .51, std::nan("")})
        EXPECT_NE(message_of({{1, nu}, 1}, 1).find("Poisson's ratio must lie in"),
                  std::string::npos);
    EXPECT_NE(message_of({{0, .3}, 1}, 1).find("Young's modulus"), std::string::npos);
    for (const double k : {-1., infinity, std::nan("")})
        EXPECT_NE(message_of({{1, .3}, 1}, k).find("wave number"), std::string::npos);
    EXPECT_THROW(theory::half_space_deficit(.6, LayerBase::bonded, 1), contact::InputError);
    EXPECT_THROW(theory::half_space_deficit(.3, LayerBase::bonded, -1), contact::InputError);
}

}  // namespace
}  // namespace tricontact::layer_compliance_test
