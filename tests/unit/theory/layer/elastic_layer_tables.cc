#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "contact/base/error.h"
#include "tests/unit/theory/layer/layer_cases.h"
#include "theory/layer/elastic_layer.h"

// Reference numbers of independent programs, and the refusals.
namespace tricontact::elastic_layer_tables_test {
namespace {

using namespace layer_test;
using theory::LayerBase;
using theory::solve_layer_contact;

// In units of the last digit given: 0.6685 had become 0.669 from 0.66849, rounded twice.
constexpr double rounding = .55;

TEST(ElasticLayerTables, ForceAgainstIndentation) {
    struct Row {
        double chi, force_50, force_49, force_30, radius_50, force_digit, radius_digit;
    };
    for (const Row& row : {Row{.1, 1.1291, 1.1263, 1.0972, 1.0410, 1e-4, 1e-4},
                           Row{.2, 1.2980, 1.2906, 1.2156, 1.0880, 1e-4, 1e-4},
                           Row{.5, 2.1562, 2.1099, 1.7170, 1.2383, 1e-4, 1e-4},
                           Row{1, 5.115, 4.798, 2.920, 1.4095, 1e-3, 1e-4},
                           Row{2, 18.37, 15.23, 5.712, 1.577, 1e-2, 1e-3}}) {
        const auto incompressible = force_ratio(row.chi, .5, LayerBase::bonded);
        EXPECT_NEAR(incompressible.force, row.force_50, row.force_digit * rounding) << row.chi;
        EXPECT_NEAR(incompressible.contact_radius, row.radius_50, row.radius_digit * rounding)
            << row.chi;
        EXPECT_NEAR(force_ratio(row.chi, .49, LayerBase::bonded).force, row.force_49,
                    row.force_digit * rounding)
            << row.chi;
        EXPECT_NEAR(force_ratio(row.chi, .3, LayerBase::bonded).force, row.force_30,
                    row.force_digit * rounding)
            << row.chi;
    }
}

TEST(ElasticLayerTables, FlatPunch) {
    struct Row {
        double ratio, factor_50, factor_30, digit_50;
    };
    const double b = 2.5e-3;
    auto factor = [&](double ratio, double nu) {  // F/(2 E* a d)
        return flat_punch({{3e6, nu}, b}, ratio * b).force / (2 * 3e6 / (1 - nu * nu) * ratio * b);
    };
    for (const Row& row : {Row{.2, 1.2806, 1.2066, 1e-4}, Row{.4, 1.6837, 1.4726, 1e-4},
                           Row{.6, 2.2129, 1.7848, 1e-4}, Row{1, 3.6187, 2.4835, 1e-4},
                           Row{2, 9.149, 4.353, 1e-3}}) {
        EXPECT_NEAR(factor(row.ratio, .5), row.factor_50, row.digit_50 * rounding) << row.ratio;
        EXPECT_NEAR(factor(row.ratio, .3), row.factor_30, row.digit_50 * rounding) << row.ratio;
    }
}

TEST(ElasticLayerTables, LayerOverHalfSpaceAtEqualForce) {
    struct Row {
        double ratio, a, d, p0, shift, stiffness, a_digit;
    };
    // nu = 0.5, D_c = 2 a_Hertz
    const double radius = .04, young = 5.2e6, nu = .5, f = 21.1;
    const double modulus = young / (1 - nu * nu), shear = young / (2 * (1 + nu));
    const double a = std::cbrt(3 * f * radius / (4 * modulus)), d = a * a / radius;
    for (const Row& row :
         {Row{.25, .790, .304, 1.858, .858, 5.10, 1e-3},
          Row{.5, .909, .476, 1.267, .849, 2.96, 1e-3},
          Row{.889, .969, .637, 1.073, .875, 1.99, 1e-3},
          Row{1, .976, .669, 1.054, .883, 1.86, 1e-3}, Row{2, .996, .819, 1.008, .931, 1.36, 1e-3},
          Row{4, .9995, .907, 1.001, .964, 1.16, 1e-4}, Row{10, 1, .963, 1, .985, 1.06, 1e-3}}) {
        const auto c = solve_layer_contact({{young, nu}, row.ratio * 2 * a},
                                           contact::Paraboloid(radius), force(f));
        EXPECT_NEAR(c.contact_radius / a, row.a, row.a_digit * rounding) << row.ratio;
        EXPECT_NEAR(c.indentation / d, row.d, 1e-3 * rounding) << row.ratio;
        EXPECT_NEAR(c.centre_pressure / (1.5 * f / (pi * a * a)), row.p0, 1e-3 * rounding)
            << row.ratio;
        const double shift = (2 - nu) / (4 * shear) * modulus * d;
        EXPECT_NEAR(*c.unit_shift / shift, row.shift, 1e-3 * rounding) << row.ratio;
        EXPECT_NEAR(c.normal_stiffness / (2 * modulus * a), row.stiffness, 1e-2 * rounding)
            << row.ratio;
    }
}

TEST(ElasticLayerTables, Rigs) {
    const contact::Paraboloid sphere(.04);
    const auto parallel = solve_layer_contact({{5.2e6, .5}, 8e-3}, sphere, force(21.1));
    EXPECT_NEAR(parallel.contact_radius, 4.3638e-3, 5e-8);
    EXPECT_NEAR(parallel.indentation, .3229e-3, 5e-8);
    EXPECT_NEAR(parallel.centre_pressure, .5330e6, 50);
    EXPECT_NEAR(*parallel.unit_shift, .6651e-3, 5e-8);
    const auto perpendicular = solve_layer_contact({{4.35e6, .5}, 8e-3}, sphere, force(21.19));
    EXPECT_NEAR(perpendicular.contact_radius, 4.6167e-3, 5e-8);
    EXPECT_NEAR(perpendicular.indentation, .3552e-3, 5e-8);
    EXPECT_NEAR(perpendicular.centre_pressure, .4791e6, 50);
}

// The message of the refusal; empty if there was none.
template <typename Error, typename Action>
std::string refusal(Action action) {
    try {
        action();
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}

// A conical bump in a moat: no contact of this body is a disc between bump and far flank.
class Bumpy final : public contact::AxisymmetricIndenter {
  public:
    double profile(double r) const override {
        return r < .01 ? r : r < .012 ? .04 - 3 * r : 2 * r - .02;
    }
    double profile_slope(double r) const override { return r < .01 ? 1 : r < .012 ? -3 : 2; }
    double outer_radius() const override { return std::numeric_limits<double>::infinity(); }
    std::vector<double> kinks() const override { return {.01, .012}; }
};

TEST(ElasticLayerTables, RefusesBadInput) {
    const contact::Paraboloid paraboloid(.04);
    const theory::ElasticLayer layer{{5.2e6, .5}, 8e-3};
    using contact::InputError;
    auto contains = [](const std::string& text, const char* part) {
        return text.find(part) != std::string::npos ? ::testing::AssertionSuccess()
                                                    : ::testing::AssertionFailure() << text;
    };
    auto press = [&](const theory::ElasticLayer& l, const contact::AxisymmetricIndenter& indenter,
                     contact::NormalControl control) {
        return refusal<InputError>([&] { solve_layer_contact(l, indenter, control); });
    };
    EXPECT_TRUE(contains(press(layer, paraboloid, force(0)), "force must be positive"));
    EXPECT_TRUE(contains(press(layer, paraboloid, indentation(-1e-3)), "indentation must be"));
    EXPECT_TRUE(contains(press({{5.2e6, .5}, 0}, paraboloid, force(1)), "thickness must be"));
    EXPECT_TRUE(contains(press({{5.2e6, .6}, 1}, paraboloid, force(1)), "Poisson's ratio"));
    EXPECT_TRUE(contains(press({{5.2e6, .5}, 1e-5}, paraboloid, force(20)), "exceeds 32 thick"));
    EXPECT_TRUE(contains(press(layer, contact::Sphere(.002), force(500)), "rim of the indenter"));
    // d below the bump's own, the search set off behind it
    EXPECT_TRUE(contains(press({{1e6, .3}, .0512}, Bumpy(), indentation(.0115)), "convex"));
}

// A cone whose slope doubles at an undeclared radius: what quadrature cannot see it must not hide.
class UndeclaredKink final : public contact::AxisymmetricIndenter {
  public:
    double profile(double r) const override { return r < .005 ? r : 2 * r - .005; }
    double profile_slope(double r) const override { return r < .005 ? 1 : 2; }
    double outer_radius() const override { return std::numeric_limits<double>::infinity(); }
};

TEST(ElasticLayerTables, DoesNotHideAnUndeclaredKink) {
    const auto message = refusal<contact::InputError>([] {
        solve_layer_contact({{1e6, .3}, .02}, UndeclaredKink(), indentation(.02));
    });
    EXPECT_NE(message.find("declare its kinks"), std::string::npos) << message;
}

}  // namespace
}  // namespace tricontact::elastic_layer_tables_test
