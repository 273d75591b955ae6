#include "bem/summed_compliance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "bem/grid_compliance.h"

namespace tricontact::summed_compliance_test {
namespace {

using contact::CombinedCompliance;
using contact::ContactPoints;
using contact::TangentialField;

const ContactPoints grid = ContactPoints::grid(7, 4, {-.3, -.2}, {.1, .15});

CombinedCompliance::Parts half_spaces() {
    CombinedCompliance::Parts parts;
    for (const double poisson : {.1, .3, .5})
        parts.push_back(bem::half_space_compliance({{}, {2e6 + 1e6 * poisson, poisson}}, grid, 1));
    return parts;
}

void expect_equal(const std::vector<double>& one, const std::vector<double>& other) {
    double largest = 0;
    for (const double value : other) largest = std::max(largest, std::abs(value));
    // Rounding of the transforms.
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i], other[i], 1e-13 * largest);
}

TEST(SummedCompliance, HasTheProductsOfItsPartsSummed) {
    const auto parts = half_spaces();
    const std::vector<double> weights = {.8, -.5, 1.3};
    CombinedCompliance products(parts, true);
    products.set_weights(weights);
    const auto sum = bem::sum_of(parts, 1)(weights);
    EXPECT_TRUE(sum->is_coupled());
    EXPECT_NEAR(sum->local_tangential() / products.local_tangential(), 1, 1e-14);
    const std::size_t n = grid.size();
    std::vector<double> p(n), u(n), other(n);
    TangentialField t(n), v(n), other_v(n);
    for (std::size_t i = 0; i < n; ++i) {
        p[i] = std::sin(static_cast<double>(i * i));
        t.set(i, {std::cos(static_cast<double>(3 * i)), p[i] - .2});
    }
    sum->normal(p, u);
    products.normal(p, other);
    expect_equal(u, other);
    sum->normal_from_tangential(t, u);
    products.normal_from_tangential(t, other);
    expect_equal(u, other);
    for (const bool by_pressure : {false, true}) {
        const auto apply = [&](const contact::Compliance& compliance, TangentialField& field) {
            if (by_pressure)
                compliance.tangential_from_normal(p, field);
            else
                compliance.tangential(t, field);
        };
        apply(*sum, v);
        apply(products, other_v);
        expect_equal(v.x, other_v.x);
        expect_equal(v.y, other_v.y);
    }
}

TEST(SummedCompliance, IsNoneOfPartsWithoutCoefficients) {
    auto parts = half_spaces();
    parts.push_back(std::make_shared<CombinedCompliance>(half_spaces(), true));
    EXPECT_FALSE(bem::sum_of(parts, 1));
}

}  // namespace
}  // namespace tricontact::summed_compliance_test
