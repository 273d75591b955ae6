#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "contact/base/gauss_legendre.h"
#include "tests/unit/theory/layer/layer_cases.h"
#include "theory/layer/elastic_layer.h"

// The pressures of the one-dimensional equation, put into the three-dimensional theory of the layer
// by quadrature over rings and Bessel functions, which that equation never sees.
namespace tricontact::elastic_layer_hankel_test {
namespace {

using namespace layer_test;
using theory::LayerBase;

// Surface displacements under the pressure of a contact: half-space (Boussinesq, rings) plus what
// the layer differs, over wave numbers.
class HankelCheck {
  public:
    HankelCheck(const theory::LayerContact& c, const theory::ElasticLayer& layer)
        : contact_(c), layer_(layer) {
        const auto over_angle = contact::gauss_legendre(60), panel = contact::gauss_legendre(30);
        for (int i = 0; i < 60; ++i) {  // r = a sin(angle): smooth at the edge
            const double angle = pi / 2 * over_angle.points[i], a = c.contact_radius;
            radii_.push_back(a * std::sin(angle));
            loads_.push_back(pi / 2 * over_angle.weights[i] * a * std::cos(angle) *
                             c.pressure(radii_.back()));
        }
        const double slimness = c.contact_radius / layer.thickness;
        const int n_panels = static_cast<int>(12 + 2 * slimness);
        for (int i = 0; i < 30 * n_panels; ++i) {
            const double x = 24 * (i / 30 + panel.points[i % 30]) / n_panels;
            wave_numbers_.push_back(x / layer.thickness);
            weights_.push_back(24 * panel.weights[i % 30] / n_panels / layer.thickness);
            deficits_.push_back(theory::half_space_deficit(layer.material.poisson, layer.base, x));
            double transform = 0;
            for (std::size_t j = 0; j < radii_.size(); ++j)
                transform += loads_[j] * radii_[j] * bessel(wave_numbers_.back() * radii_[j]);
            transforms_.push_back(transform);
        }
    }

    double normal_displacement(double r) const {
        const double share = (1 - layer_.material.poisson) / layer_.material.shear_modulus();
        double difference = 0;
        for (std::size_t i = 0; i < weights_.size(); ++i)
            difference -=
                weights_[i] * deficits_[i].normal * transforms_[i] * bessel(wave_numbers_[i] * r);
        return share * (rings(r) + difference);
    }

    // u_x at the centre under the traction p along x; on the half-space (2 - nu)/(2 G) ∫ p dr.
    double centre_shift() const {
        const double nu = layer_.material.poisson;
        double sum = 0;
        for (const double load : loads_) sum += (2 - nu) / 2 * load;
        for (std::size_t i = 0; i < weights_.size(); ++i)
            sum -= weights_[i] * ((1 - nu) * deficits_[i].along + deficits_[i].across) / 2 *
                   transforms_[i];
        return sum / layer_.material.shear_modulus();
    }

  private:
    static double bessel(double x) { return std::cyl_bessel_j(0, x); }

    // ∫ p^ J0(kr) dk = (1/2pi) ∫ p/distance dA: the ring of radius t has 4 K(m)/(r + t), where
    // K(m) = pi/(2 AGM(1, |r - t|/(r + t))). Its logarithm at t = r is left to tanh-sinh.
    double rings(double r) const {
        const double a = contact_.contact_radius;
        auto ring = [r](double t, double distance) { return t / mean(r + t, distance); };
        double sum = 0;
        if (r >= a) {
            for (std::size_t j = 0; j < radii_.size(); ++j)
                sum += loads_[j] * ring(radii_[j], r - radii_[j]);
            return sum;
        }
        boost::math::quadrature::tanh_sinh<double> quadrature;
        auto inside = [&](double s) { return contact_.pressure(r - s) * ring(r - s, s); };
        auto outside = [&](double s) { return contact_.pressure(r + s) * ring(r + s, s); };
        return quadrature.integrate(inside, 0., r, 1e-8) +
               quadrature.integrate(outside, 0., a - r, 1e-8);
    }

    // Gauss' arithmetic-geometric mean
    static double mean(double x, double y) {
        while (x - y > 1e-9 * x) x = std::exchange(y, std::sqrt(x * y)) / 2 + x / 2;
        return std::midpoint(x, y);
    }

    const theory::LayerContact& contact_;
    theory::ElasticLayer layer_;
    std::vector<double> radii_, loads_;           // r [m] and p dr [N/m]
    std::vector<double> wave_numbers_, weights_;  // k and dk [1/m]
    std::vector<theory::HalfSpaceDeficit> deficits_;
    std::vector<double> transforms_;  // p^ = ∫ p J0(kr) r dr [N]
};

struct Place {
    double chi, nu;
    LayerBase base;
};
constexpr Place places[] = {{.2, .5, LayerBase::bonded},
                            {1, -.5, LayerBase::bonded},
                            {1, .3, LayerBase::frictionless},
                            {3, .5, LayerBase::bonded},
                            {3, .5, LayerBase::frictionless}};

TEST(ElasticLayerHankel, SurfaceFollowsTheIndenter) {
    const double radius = .04;
    for (const Place& place : places) {
        const auto c = force_ratio(place.chi, place.nu, place.base).contact;
        const HankelCheck check(c, {{3e6, place.nu}, 2.5e-3, place.base});
        auto gap = [&](double r) {  // over the indentation
            return 1 - (r * r / (2 * radius) + check.normal_displacement(r)) / c.indentation;
        };
        // p to 1e-10; half-space and difference, about 20 d each, cancel on the thinnest layer.
        for (const double rho : {.02, .45, .97})
            EXPECT_NEAR(gap(rho * c.contact_radius), 0, 2e-8) << place.chi << ' ' << rho;
        // Outside the surface stays below the indenter.
        for (const double rho : {1.1, 1.3, 2.5})
            EXPECT_LT(gap(rho * c.contact_radius), -1e-3) << place.chi << ' ' << rho;
    }
}

TEST(ElasticLayerHankel, CentreShift) {
    for (const Place& place : places) {
        if (place.base == LayerBase::frictionless) continue;
        const auto c = force_ratio(place.chi, place.nu, place.base).contact;
        const HankelCheck check(c, {{3e6, place.nu}, 2.5e-3, place.base});
        EXPECT_NEAR(*c.unit_shift / check.centre_shift(), 1, 1e-9) << place.chi;  // p: 1e-10
    }
}

}  // namespace
}  // namespace tricontact::elastic_layer_hankel_test
