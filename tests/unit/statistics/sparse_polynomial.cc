#include "statistics/sparse_polynomial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "statistics/latin_hypercube.h"

namespace tricontact::statistics::sparse_polynomial_test {
namespace {

double uniform(SplitMix64& random) {
    return 2 * random.uniform() - 1;
}

SparsePolynomial drawn(int n_variables, int n_terms, int largest_degree, SplitMix64& random) {
    SparsePolynomial p{.n_variables = n_variables};
    for (int t = 0; t < n_terms; ++t) {
        p.coefficients.push_back(uniform(random));
        for (int d = 0; d < n_variables; ++d)
            p.degrees.push_back(static_cast<std::uint8_t>(
                random.below(static_cast<std::uint64_t>(largest_degree) + 1)));
    }
    return p;
}

std::vector<double> drawn_points(int n_points, int n_variables, SplitMix64& random) {
    std::vector<double> points;
    for (int i = 0; i < n_points * n_variables; ++i) points.push_back(uniform(random));
    return points;
}

// T_k(x) = cos(k acos x).
double by_cosines(const SparsePolynomial& p, const double* x) {
    double sum = 0;
    for (std::size_t t = 0; t < p.n_terms(); ++t) {
        double product = p.coefficients[t];
        for (int d = 0; d < p.n_variables; ++d)
            product *= std::cos(p.degrees[t * static_cast<std::size_t>(p.n_variables) +
                                          static_cast<std::size_t>(d)] *
                                std::acos(x[d]));
        sum += product;
    }
    return sum;
}

// Clenshaw's recurrence of one variable.
double by_clenshaw(const std::vector<double>& c, double x) {
    double b1 = 0, b2 = 0;
    for (std::size_t k = c.size(); k-- > 1;) {
        const double b = c[k] + 2 * x * b1 - b2;
        b2 = b1;
        b1 = b;
    }
    return c[0] + x * b1 - b2;
}

// Rounding of k acos(x) and of the recurrence grows with the degree, up to 40 times eps, and adds
// up over 101 terms.
constexpr double rounding = 1e-12;

TEST(SparsePolynomial, IsTheSumOfProductsOfCosines) {
    SplitMix64 random(3);
    for (int n_variables = 1; n_variables <= most_variables; ++n_variables) {
        const SparsePolynomial p = drawn(n_variables, 101, 12, random);
        const auto points = drawn_points(75, n_variables, random);
        const auto all = evaluate_all(p, points);
        ASSERT_EQ(all.size(), 75U);
        ChebyshevTable table(n_variables);
        table.cover(p);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto stride = static_cast<std::size_t>(n_variables);
            const std::span<const double> x(points.data() + i * stride, stride);
            const double due = by_cosines(p, x.data());
            EXPECT_NEAR(all[i], due, rounding);
            EXPECT_NEAR(evaluate(p, x), due, rounding);
            table.set_point(x);
            EXPECT_EQ(table.evaluate(p), evaluate(p, x));
        }
    }
}

TEST(SparsePolynomial, OfOneVariableIsClenshaws) {
    SplitMix64 random(4);
    SparsePolynomial p{.n_variables = 1};
    for (int k = 0; k <= 30; ++k) {
        p.degrees.push_back(static_cast<std::uint8_t>(k));
        p.coefficients.push_back(uniform(random));
    }
    for (const double x : {-1., -0.3, 0., 0.77, 1.})
        EXPECT_NEAR(evaluate(p, std::vector{x}), by_clenshaw(p.coefficients, x), rounding);
}

// One table for all: it reaches as far as the longest of each variable.
TEST(SparsePolynomial, SharesItsTable) {
    SplitMix64 random(5);
    const SparsePolynomial p = drawn(3, 40, 9, random), q = drawn(3, 7, 2, random);
    ChebyshevTable table(3);
    table.cover(q);
    table.cover(p);
    table.cover(q);
    const std::vector x{0.2, -0.9, 0.6};
    table.set_point(x);
    EXPECT_EQ(table.evaluate(p), evaluate(p, x));
    EXPECT_EQ(table.evaluate(q), evaluate(q, x));
}

TEST(SparsePolynomial, OfTheHighestDegreeIsAtItsEndsOne) {
    const SparsePolynomial p{2, {255, 255}, {1}};
    EXPECT_EQ(evaluate(p, std::vector{1., 1.}), 1);
    EXPECT_EQ(evaluate(p, std::vector{-1., 1.}), -1);
    EXPECT_EQ(evaluate_all(p, std::vector{-1., 1.}), std::vector{-1.});
}

TEST(SparsePolynomial, WithoutTermsIsZero) {
    const SparsePolynomial p{2, {}, {}};
    EXPECT_EQ(evaluate(p, std::vector{0.1, 0.2}), 0);
    EXPECT_EQ(evaluate_all(p, std::vector{0.1, 0.2}), std::vector{0.});
    EXPECT_TRUE(evaluate_all(p, {}).empty());
}

TEST(SparsePolynomial, RefusesSizesThatDoNotAgree) {
    const SparsePolynomial p{2, {1, 0}, {1}}, torn{2, {1, 0, 1}, {1}}, none{0, {}, {}};
    ChebyshevTable table(3);
    EXPECT_THROW(table.cover(p), std::invalid_argument);
    EXPECT_THROW(table.set_point(std::vector{0.1, 0.2}), std::invalid_argument);
    EXPECT_THROW(evaluate(p, std::vector{0.1}), std::invalid_argument);
    EXPECT_THROW(evaluate(torn, std::vector{0.1, 0.2}), std::invalid_argument);
    EXPECT_THROW(evaluate_all(p, std::vector{0.1, 0.2, 0.3}), std::invalid_argument);
    EXPECT_THROW(evaluate_all(none, std::vector{0.1}), std::invalid_argument);
    EXPECT_THROW(ChebyshevTable(7), std::invalid_argument);
}

}  // namespace
}  // namespace tricontact::statistics::sparse_polynomial_test
