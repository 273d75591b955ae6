#include "theory/layer/layer_forms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "contact/base/special_values.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/layer/layer_compliance.h"
#include "theory/layer/wave_numbers.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::layer_forms_test {
namespace {

using std::numbers::pi;
using theory::LayerForm;

struct Moments {
    double lift = 0, tangential_lift = 0, bending = 0;
};

Moments exact_moments(double nu) {
    const theory::WaveNumbers rule(1);
    Moments m;
    for (Eigen::Index i = 0; i < rule.size(); ++i) {
        const double x = rule.points()[i], weight = 4 / (3 * pi) * rule.weights()[i];
        const auto d = theory::half_space_deficit(nu, theory::LayerBase::bonded, x);
        m.lift += weight * d.normal;
        m.tangential_lift += weight * ((1 - nu) * d.along + d.across) / (2 - nu);
        m.bending += weight * d.normal * x * x / 3;
    }
    return m;
}

TEST(LayerForms, ThickLayersLiftAndBend) {
    for (const double nu : {0., .1, .2, .3, .4, .45, .5}) {
        const Moments exact = exact_moments(nu);
        const double chi = 1e-3;
        const LayerForm layer{1 / (2 * chi), nu};
        EXPECT_NEAR((1 / theory::layer_indentation_ratio(layer) - 1) / chi / exact.lift, 1, .007)
            << nu;
        EXPECT_NEAR((1 / theory::layer_unit_shift_ratio(layer) - 1) / chi / exact.tangential_lift,
                    1, .006)
            << nu;
        const double thick = .02;  // chi^3 = 8e-6 against rounding, chi^2 to the next order
        const double radius = theory::layer_radius_ratio({1 / (2 * thick), nu});
        EXPECT_NEAR(2 * (1 - radius) / std::pow(thick, 3) / exact.bending, 1, .026) << nu;
    }
}

TEST(LayerForms, HalfSpace) {
    const LayerForm half_space{std::numeric_limits<double>::infinity(), .5};
    EXPECT_EQ(theory::layer_radius_ratio(half_space), 1);
    EXPECT_EQ(theory::layer_indentation_ratio(half_space), 1);
    EXPECT_EQ(theory::layer_pressure_ratio(half_space), 1);
    EXPECT_EQ(theory::layer_unit_shift_ratio(half_space), 1);
    EXPECT_EQ(theory::layer_shakedown_limit(half_space, .4), theory::shakedown_limit(.4));
    EXPECT_EQ(theory::layer_shakedown_limit({.25, .5}, 0), 1);
}

// f_T,lim = 1 - ∫_0^W q dx/∫_0^a q dx of q ~ 1 - x^2 and (1 - x^2)^2, mixed in the ratio of the
// centre's pressures, is that of the second term with the exponent 2: small lambda.
TEST(LayerForms, LimitIsThatOfTheShape) {
    const LayerForm layer{1.2, .5};
    const double shape = theory::layer_pressure_shape(layer);
    ASSERT_LT(shape, .01);
    for (const double w : {.1, .4, .8}) {
        const double gathered = 1 - 15. / 8 * (w - 2 * w * w * w / 3 + std::pow(w, 5) / 5);
        const double mixed = (1 - shape) * theory::shakedown_limit(w) + shape * gathered;
        EXPECT_NEAR(theory::layer_shakedown_limit(layer, w), mixed, shape * shape * .2) << w;
    }
}

TEST(LayerForms, ShiftsTendToTheHalfSpace) {
    const LayerForm half_space{std::numeric_limits<double>::infinity(), .4};
    const theory::MappedRolling point{.3, .2, .5, .4};
    EXPECT_EQ(theory::layer_static_shift_ratio(half_space, .3), theory::static_shift_ratio(.3));
    EXPECT_EQ(*theory::layer_settled_shift_ratio(half_space, point, contact::infinity),
              *theory::half_space_settled_shift_ratio(point));
    EXPECT_NEAR(theory::layer_coupling(half_space, .5), (1 - 2 * .4) / (2 * (1 - .4) * .5), 1e-14);
    EXPECT_LT(theory::layer_coupling({.3, .5}, .5), -.5);  // a thin incompressible layer couples
    const LayerForm thin{.3, .4};
    EXPECT_EQ(theory::layer_static_shift_ratio(thin, 0), 0);
    EXPECT_EQ(theory::layer_static_shift_ratio(thin, 1), 1);
    // Without rolling the settled shift is the static one, with coupling too.
    EXPECT_NEAR(*theory::layer_settled_shift_ratio(thin, {0, .4}, .5),
                theory::layer_static_shift_ratio(thin, .4), 1e-14);
    const double limit = theory::layer_shakedown_limit(thin, .5);
    EXPECT_TRUE(theory::layer_settled_shift_ratio(thin, {.5, .999 * limit}, 1));
    EXPECT_FALSE(theory::layer_settled_shift_ratio(thin, {.5, 1.001 * limit}, 1));
}

TEST(LayerForms, RejectWhatLiesOutside) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const LayerForm& layer :
         {LayerForm{.2, .5}, LayerForm{nan, .5}, LayerForm{1, -.1}, LayerForm{1, .51}}) {
        EXPECT_THROW(theory::layer_radius_ratio(layer), std::domain_error);
        EXPECT_THROW(theory::layer_indentation_ratio(layer), std::domain_error);
        EXPECT_THROW(theory::layer_pressure_shape(layer), std::domain_error);
        EXPECT_THROW(theory::layer_pressure_ratio(layer), std::domain_error);
        EXPECT_THROW(theory::layer_unit_shift_ratio(layer), std::domain_error);
        EXPECT_THROW(theory::layer_shakedown_limit(layer, .3), std::domain_error);
    }
    EXPECT_THROW(theory::layer_shakedown_limit({1, .5}, .9), std::domain_error);
    EXPECT_THROW(theory::layer_shakedown_limit({1, .5}, -.1), std::domain_error);
    EXPECT_THROW(theory::layer_static_shift_ratio({1, .5}, 1.1), std::domain_error);
    EXPECT_THROW(theory::layer_settled_shift_ratio({1, .5}, {.3, .1}, .3), std::domain_error);
    EXPECT_THROW(theory::layer_settled_shift_ratio({1, .5}, {.9, .1}, 1), std::domain_error);
}

}  // namespace
}  // namespace tricontact::layer_forms_test
