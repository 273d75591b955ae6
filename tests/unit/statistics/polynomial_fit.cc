#include "statistics/polynomial_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>

#include "statistics/latin_hypercube.h"
#include "statistics/sample_sequence.h"

namespace tricontact::statistics::polynomial_fit_test {
namespace {

using Function = std::function<double(std::span<const double>)>;

// Normal, of variance 1 (Box and Muller 1958).
double normal(SplitMix64& random) {
    const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
    return radius * std::cos(2 * std::numbers::pi * random.uniform());
}

std::vector<double> values_of(const Function& f, const std::vector<double>& points, int n_variables,
                              double noise = 0) {
    SplitMix64 random(8);
    std::vector<double> values;
    const auto stride = static_cast<std::size_t>(n_variables);
    for (std::size_t i = 0; i < points.size(); i += stride) {
        values.push_back(f(std::span(points).subspan(i, stride)));
        if (noise > 0) values.back() += noise * normal(random);
    }
    return values;
}

PolynomialFit fitted(const Function& f, std::uint32_t n_points, int n_variables, double noise = 0) {
    const auto points = sample_points(n_points, n_variables);
    return fit_polynomial(points, values_of(f, points, n_variables, noise), n_variables);
}

// Equally distributed over the cube.
std::vector<double> fresh_points(int n_points, int n_variables) {
    SplitMix64 random(9);
    std::vector<double> points;
    for (int i = 0; i < n_points * n_variables; ++i) points.push_back(2 * random.uniform() - 1);
    return points;
}

std::vector<double> fresh_errors(const PolynomialFit& fit, const Function& f,
                                 const std::vector<double>& points) {
    std::vector<double> errors = evaluate_all(fit.polynomial, points);
    const auto due = values_of(f, points, fit.polynomial.n_variables);
    for (std::size_t i = 0; i < due.size(); ++i) errors[i] = std::abs(errors[i] - due[i]);
    return errors;
}

double rms(const std::vector<double>& errors) {
    double sum = 0;
    for (const double e : errors) sum += e * e;
    return std::sqrt(sum / static_cast<double>(errors.size()));
}

double fresh_rms(const PolynomialFit& fit, const Function& f) {
    return rms(fresh_errors(fit, f, fresh_points(1000, fit.polynomial.n_variables)));
}

struct Coverage {
    double of_all;
    double worst;  ///< of the halves of the cube
};

// Of new noisy values at 2000 points of the same sequence that the fit has not seen.
Coverage coverage(const Function& f, std::uint32_t n_points, int n_variables, double noise) {
    constexpr std::uint32_t n_fresh = 2000;
    const auto all = sample_points(n_points + n_fresh, n_variables);
    const auto values = values_of(f, all, n_variables, noise);
    const auto stride = static_cast<std::size_t>(n_variables);
    const PolynomialFit fit = fit_polynomial(std::span(all).first(n_points * stride),
                                             std::span(values).first(n_points), n_variables);
    ChebyshevTable table(n_variables);
    table.cover(fit.polynomial);
    table.cover(fit.log_error);
    int n_covered = 0;
    std::vector<int> covered(2 * stride, 0), counts(2 * stride, 0);
    for (std::size_t i = n_points; i < values.size(); ++i) {
        const auto x = std::span(all).subspan(i * stride, stride);
        table.set_point(x);
        const bool is_covered =
            std::abs(values[i] - table.evaluate(fit.polynomial)) <= error_bar(fit, table);
        n_covered += is_covered;
        for (std::size_t d = 0; d < stride; ++d) {
            ++counts[2 * d + (x[d] > 0)];
            covered[2 * d + (x[d] > 0)] += is_covered;
        }
    }
    double worst = 1;
    for (std::size_t r = 0; r < counts.size(); ++r)
        worst = std::min(worst, static_cast<double>(covered[r]) / counts[r]);
    return {n_covered / static_cast<double>(n_fresh), worst};
}

double chebyshev(int k, double x) {
    return std::cos(k * std::acos(x));
}

TEST(PolynomialFit, FindsThePolynomialAndItsTerms) {
    const Function f = [](std::span<const double> x) {
        return 2 - 0.5 * chebyshev(1, x[0]) + 3 * chebyshev(4, x[1]) +
               0.25 * chebyshev(2, x[0]) * chebyshev(3, x[2]);
    };
    const PolynomialFit fit = fitted(f, 200, 3);
    EXPECT_EQ(fit.polynomial.degrees,
              (std::vector<std::uint8_t>{0, 0, 0, 0, 4, 0, 1, 0, 0, 2, 0, 3}));
    const std::vector<double> due{2, 3, -0.5, 0.25};
    ASSERT_EQ(fit.polynomial.n_terms(), due.size());
    for (std::size_t t = 0; t < due.size(); ++t)
        EXPECT_NEAR(fit.polynomial.coefficients[t], due[t], 1e-13);
    EXPECT_LT(fit.largest_error, 1e-12);
    EXPECT_LT(fresh_rms(fit, f), 1e-13);
}

// The error of an analytic function falls geometrically with the largest degree, which grows with
// the D-th root of N or faster: by a factor of at least `factor` for four times the points.
void expect_convergence(const Function& f, int n_variables, double factor) {
    double before = std::numeric_limits<double>::infinity();
    for (const std::uint32_t n : {50U, 200U, 800U}) {
        if (n > 200 && n_variables > 2) break;  // seconds each
        const PolynomialFit fit = fitted(f, n, n_variables);
        const double error = fresh_rms(fit, f);
        EXPECT_LT(error, std::max(1e-13, before / factor)) << n << " points";
        // Without noise errors are far from independent, and bars miss more than 5 %.
        if (error > 1e-12) {
            EXPECT_GT(coverage(f, n, n_variables, 0).of_all, 0.8) << n;
        }
        before = error;
    }
}

TEST(PolynomialFitSlow, ConvergesOnAReciprocal) {
    for (int n_variables = 2; n_variables <= 4; ++n_variables)
        expect_convergence(
            [](std::span<const double> x) {
                double sum = 2;
                for (std::size_t d = 0; d < x.size(); ++d)
                    sum += x[d] / static_cast<double>((d + 1) * (d + 1));
                return 1 / sum;
            },
            n_variables, 3);
}

TEST(PolynomialFitSlow, ConvergesOnAnExponential) {
    for (int n_variables = 2; n_variables <= 4; ++n_variables)
        expect_convergence(
            [](std::span<const double> x) {
                double sum = 0;
                for (std::size_t d = 0; d < x.size(); ++d) sum += x[d] / static_cast<double>(d + 1);
                return std::exp(sum);
            },
            n_variables, 10);
}

// Even in each variable: neighbours of odd degree explain nothing, the next ones do.
TEST(PolynomialFitSlow, ConvergesOnRunges) {
    for (int n_variables = 2; n_variables <= 3; ++n_variables)
        expect_convergence(
            [](std::span<const double> x) {
                double sum = 1;
                for (std::size_t d = 0; d < x.size(); ++d)
                    sum += 4 * x[d] * x[d] / (1. + 3. * static_cast<double>(d));
                return 1 / sum;
            },
            n_variables, 2);
}

double contact_like(std::span<const double> x) {
    const double f = 0.45 * (1 + x[0]) / (1 + 0.1 * x[1]);
    return (1 - std::pow(1 - 0.9 * f, 2. / 3)) * (1 + 0.2 * x[2]) / (2 + 0.5 * x[1] + 0.2 * x[3]);
}

TEST(PolynomialFit, ErrorFallsToTheNoiseAndBelow) {
    constexpr double noise = 1e-4;
    for (const std::uint32_t n : {1000U, 2000U}) {
        const PolynomialFit fit = fitted(contact_like, n, 4, noise);
        EXPECT_LT(fresh_rms(fit, contact_like), noise) << n;
        // Of a new noisy value: hardly above the noise, hardly below.
        EXPECT_LT(fit.rms_error, 2 * noise) << n;
        EXPECT_GT(fit.rms_error, 0.9 * noise) << n;
    }
}

// Local steepness: of a root, of a front, of a peak.
TEST(PolynomialFit, ErrorBarsCoverTheirShare) {
    const std::vector<Function> functions{
        contact_like,
        [](std::span<const double> x) {
            return std::tanh(3 * (x[0] + 0.3 * x[1] - 0.4)) + 0.1 * x[2] * x[3];
        },
        [](std::span<const double> x) {
            return std::exp(-4 * std::pow(x[0] - 0.6, 2) - 2 * std::pow(x[1] + 0.5, 2)) +
                   0.05 * x[2] * x[3];
        }};
    for (std::size_t k = 0; k < functions.size(); ++k)
        for (const std::uint32_t n : {500U, 1000U}) {
            const Coverage share = coverage(functions[k], n, 4, 1e-4);
            EXPECT_GT(share.of_all, 0.92) << k << ": " << n;
            EXPECT_LT(share.of_all, 0.985) << k << ": " << n;
            EXPECT_GT(share.worst, 0.90) << k << ": " << n;
        }
}

// Noise that grows by exp(3) from x_0 = -0.75 to 0.75.
TEST(PolynomialFit, ErrorBarIsAFunctionOfThePlace) {
    const auto points = sample_points(300, 2);
    std::vector<double> values;
    SplitMix64 random(6);
    for (std::size_t i = 0; i < points.size(); i += 2)
        values.push_back(points[i + 1] + 1e-3 * std::exp(2 * points[i]) * normal(random));
    const PolynomialFit fit = fit_polynomial(points, values, 2);
    ChebyshevTable table(2);
    table.cover(fit.log_error);
    table.set_point(std::vector{0.75, 0.});
    const double at_end = error_bar(fit, table);
    table.set_point(std::vector{-0.75, 0.});
    const double ratio = at_end / error_bar(fit, table);
    EXPECT_GT(ratio, std::exp(3) / 2);
    EXPECT_LT(ratio, std::exp(3) * 2);
    // 1.96 standard deviations.
    EXPECT_NEAR(at_end / (1.96e-3 * std::exp(1.5)), 1, 0.4);
}

// |x_0 - 0.1|: no polynomial converges fast, and the fit says so.
TEST(PolynomialFit, TellsAKink) {
    const Function kink = [](std::span<const double> x) { return std::abs(x[0] - 0.1) + x[1]; };
    const Function smooth = [](std::span<const double> x) { return x[0] * x[0] + x[1]; };
    const PolynomialFit fit = fitted(kink, 200, 2);
    EXPECT_GT(fit.rms_error, 0.5 * fresh_rms(fit, kink));
    EXPECT_GT(fit.largest_error, 1e-3);
    EXPECT_LT(fitted(smooth, 200, 2).largest_error, 1e-13);
}

TEST(PolynomialFit, ComesAgain) {
    const PolynomialFit a = fitted(contact_like, 300, 4, 1e-4),
                        b = fitted(contact_like, 300, 4, 1e-4);
    EXPECT_EQ(a.polynomial.degrees, b.polynomial.degrees);
    EXPECT_EQ(a.polynomial.coefficients, b.polynomial.coefficients);
    EXPECT_EQ(a.log_error.coefficients, b.log_error.coefficients);
    EXPECT_EQ(a.error_factor, b.error_factor);
}

// In lexicographic order, within the limits; with a term one of a degree lower by one or two, for
// noise makes no coefficient zero.
TEST(PolynomialFit, TermsSupportEachOther) {
    const auto points = sample_points(400, 3);
    const auto values = values_of(
        [](std::span<const double> x) { return std::abs(x[0] + x[1] * x[2]); }, points, 3, 1e-4);
    const PolynomialFit fit = fit_polynomial(points, values, 3, {.most_terms = 60});
    EXPECT_LE(fit.polynomial.n_terms(), 60U);
    std::vector<std::vector<int>> terms;
    for (std::size_t t = 0; t < fit.polynomial.n_terms(); ++t)
        terms.emplace_back(fit.polynomial.degrees.begin() + static_cast<int>(3 * t),
                           fit.polynomial.degrees.begin() + static_cast<int>(3 * t + 3));
    EXPECT_TRUE(std::ranges::is_sorted(terms));
    const std::set<std::vector<int>> all(terms.begin(), terms.end());
    EXPECT_EQ(all.size(), terms.size());
    for (const auto& term : terms)
        for (std::size_t d = 0; d < 3; ++d)
            if (term[d] > 0) {
                auto below = term, lower = term;
                below[d] -= 1;
                lower[d] -= 2;
                EXPECT_TRUE(all.contains(below) || all.contains(lower));
            }
}

std::string complaint(const std::vector<double>& points, const std::vector<double>& values,
                      int n_variables) {
    try {
        fit_polynomial(points, values, n_variables);
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "";
}

TEST(PolynomialFit, RefusesWhatDeterminesNothing) {
    const auto points = sample_points(40, 2);
    std::vector<double> values = values_of([](auto x) { return x[0]; }, points, 2);
    EXPECT_EQ(complaint(points, values, 3),
              "40 values need 3 coordinates each, but there are 80 coordinates");
    EXPECT_EQ(complaint(points, values, 7), "a polynomial fit has 1 to 6 variables, not 7");
    EXPECT_EQ(
        complaint({points.begin(), points.begin() + 38}, {values.begin(), values.begin() + 19}, 2),
        "a polynomial fit of 2 variables needs 20 points, not 19");
    EXPECT_EQ(complaint(points, std::vector<double>(40, 0.3), 2),
              "the values of a polynomial fit are all equal: no error can be told from them");
    auto beyond = points;
    beyond[7] = 1.5;
    EXPECT_EQ(complaint(beyond, values, 2), "coordinate 1 of point 3 is 1.5, outside [-1, 1]");
    values[4] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(complaint(points, values, 2), "value 4 is nan");
    EXPECT_THROW(fit_polynomial(points, values, 2, {.coverage = 1}), std::invalid_argument);
}

// As few points as are allowed, in as many variables, and the same point again and again.
TEST(PolynomialFit, TakesLittle) {
    const Function f = [](std::span<const double> x) { return std::exp(x[0]); };
    EXPECT_TRUE(std::isfinite(fitted(f, 28, 6).error_factor));
    EXPECT_TRUE(std::isfinite(fitted(f, 20, 1).error_factor));
    std::vector<double> points, values;
    for (int i = 0; i < 40; ++i) {
        points.push_back(i % 2 == 0 ? -0.5 : 0.5);
        values.push_back(points.back() + 1e-3 * (i % 5));
    }
    const PolynomialFit fit = fit_polynomial(points, values, 1);
    EXPECT_LE(fit.polynomial.n_terms(), 2U);
    EXPECT_LT(fit.largest_error, 5e-3);
    // The second variable never changes, and its odd terms are zero.
    std::vector<double> line, cubes;
    for (int i = 0; i < 40; ++i) {
        line.insert(line.end(), {std::cos(i), 0.});
        cubes.push_back(std::pow(std::cos(i), 3));
    }
    EXPECT_LT(fit_polynomial(line, cubes, 2).largest_error, 1e-13);
    // Without the one point all others are equal.
    std::vector<double> spike(40, 0.);
    spike[17] = 1;
    const PolynomialFit with_spike = fit_polynomial(sample_points(40, 2), spike, 2);
    EXPECT_TRUE(std::isfinite(with_spike.error_factor));
    EXPECT_GT(with_spike.largest_error, 0.9);
}

}  // namespace
}  // namespace tricontact::statistics::polynomial_fit_test
