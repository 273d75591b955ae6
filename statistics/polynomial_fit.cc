#include "statistics/polynomial_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "statistics/adaptive_terms.h"
#include "statistics/growing_least_squares.h"

namespace tricontact::statistics {

namespace {

// Points per term of all that a fit starts with, and of the largest fit of the error.
constexpr std::size_t points_per_start = 4, points_per_error_term = 10;
constexpr int start_degree = 2, largest_error_degree = 3;
// Terms beyond the best number that are tried before the search ends, and their share of it.
constexpr std::size_t patience = 40;
constexpr double patience_share = 0.25;
// Residuals below this share of the median count as this: the logarithm of a residual that happens
// to be almost zero says nothing about its size.
constexpr double least_residual_share = 0.05;
// Points below which a region tells no share of 95 % apart from others: five of them are expected
// beyond the bar.
constexpr std::size_t least_region = 100;
// By how many standard deviations of chance a region may fall short of the coverage.
constexpr double chance = 2;
// Of the points, for the check of error bars by points that took no part in their fit.
// So many of them are enough: the share scatters by .7 %.
constexpr std::size_t n_folds = 5, enough_checks = 1000;

void check_fit_arguments(std::span<const double> points, std::span<const double> values,
                         int n_variables, const PolynomialFitOptions& options) {
    if (n_variables < 1 || n_variables > most_variables)
        throw std::invalid_argument(fmt::format("a polynomial fit has 1 to {} variables, not {}",
                                                most_variables, n_variables));
    if (points.size() != values.size() * static_cast<std::size_t>(n_variables))
        throw std::invalid_argument(
            fmt::format("{} values need {} coordinates each, but there are {} coordinates",
                        values.size(), n_variables, points.size()));
    if (values.size() < least_points(n_variables))
        throw std::invalid_argument(
            fmt::format("a polynomial fit of {} variables needs {} points, "
                        "not {}",
                        n_variables, least_points(n_variables), values.size()));
    if (!(options.coverage > 0 && options.coverage < 1))
        throw std::invalid_argument("the coverage of an error bar lies between 0 and 1");
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!(std::abs(points[i]) <= 1))
            throw std::invalid_argument(
                fmt::format("coordinate {} of point {} is {}, outside [-1, 1]",
                            i % static_cast<std::size_t>(n_variables),
                            i / static_cast<std::size_t>(n_variables), points[i]));
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            throw std::invalid_argument(fmt::format("value {} is {}", i, values[i]));
    if (std::ranges::all_of(values, [&](double v) { return v == values.front(); }))
        throw std::invalid_argument(
            "the values of a polynomial fit are all equal: no error can be "
            "told from them");
}

double largest_amount(std::span<const double> values) {
    double largest = 0;
    for (const double v : values) largest = std::max(largest, std::abs(v));
    return largest;
}

// Mean square of the leave-one-out residuals times the factor that makes up for the choice of terms
// by the same points: Chapelle, Vapnik and Bengio (2002); Blatman and Sudret (2011), eq. 27.
double corrected_error(const GrowingLeastSquares& squares) {
    const auto n = static_cast<double>(squares.n_values());
    const auto m = static_cast<double>(squares.n_columns());
    return squares.leave_one_out_square() * n / (n - m) * (1 + squares.inverse_trace());
}

// The number of terms of least corrected error so far.
class BestSize {
  public:
    void look(const GrowingLeastSquares& squares) {
        const double error = corrected_error(squares);
        if (n_terms_ > 0 && !(error < error_)) return;
        error_ = error;
        n_terms_ = squares.n_columns();
    }
    std::size_t n_terms() const { return n_terms_; }
    double error() const { return error_; }
    bool is_passed_by(std::size_t n) const {
        return n > n_terms_ + patience +
                       static_cast<std::size_t>(patience_share * static_cast<double>(n_terms_));
    }

  private:
    std::size_t n_terms_ = 0;
    double error_ = std::numeric_limits<double>::infinity();
};

// What a fit takes from its points: terms, coefficients and leave-one-out residuals.
struct Solution {
    SparsePolynomial polynomial;
    std::vector<double> left_out;
};

Solution solution(const GrowingLeastSquares& squares, const std::vector<Degrees>& terms,
                  std::size_t n_terms, int n_variables, double least) {
    return {make_polynomial(terms, squares.coefficients(n_terms), n_variables, least),
            squares.leave_one_out_residuals(n_terms)};
}

Solution adaptive_fit(TermColumns& columns, std::span<const double> values, double scale,
                      std::size_t most_terms) {
    GrowingLeastSquares squares({values.begin(), values.end()});
    AdaptiveTerms terms(columns, squares);
    BestSize best;
    // Coefficients, and errors, of this size are rounding.
    const double rounding = 50 * std::numeric_limits<double>::epsilon() * scale;
    const auto append = [&](const Degrees& degrees) {
        if (terms.append(degrees)) best.look(squares);
    };
    append({});
    for (int degree = 1; degree <= start_degree; ++degree) {
        const auto more = terms_of_degree(degree, columns.n_variables());
        if ((terms.terms().size() + more.size()) * points_per_start > values.size()) break;
        for (const Degrees& degrees : more) append(degrees);
    }
    while (terms.terms().size() < most_terms && !best.is_passed_by(terms.terms().size()) &&
           best.error() > rounding * rounding) {
        const std::vector<Degrees> round = terms.best_neighbours();
        if (round.empty()) break;
        for (const Degrees& degrees : round)
            if (terms.terms().size() < most_terms) append(degrees);
    }
    return solution(squares, terms.terms(), best.n_terms(), columns.n_variables(), rounding);
}

// ln of the residuals' sizes by all terms up to the total degree of least leave-one-out error.
Solution fit_log_error(TermColumns& columns, const std::vector<double>& logarithms) {
    GrowingLeastSquares squares(logarithms);
    std::vector<Degrees> terms;
    double least = std::numeric_limits<double>::infinity();
    std::size_t n_terms = 0;
    for (int degree = 0; degree <= largest_error_degree; ++degree) {
        const auto more = terms_of_degree(degree, columns.n_variables());
        if (degree > 0 && (terms.size() + more.size()) * points_per_error_term > logarithms.size())
            break;
        for (const Degrees& degrees : more)
            if (squares.append(columns.column(degrees))) terms.push_back(degrees);
        const double error = squares.leave_one_out_square();
        if (!(error < least)) continue;
        least = error;
        n_terms = terms.size();
    }
    return solution(squares, terms, n_terms, columns.n_variables(), 0);
}

// The least factor that `n_over` scores at the most exceed.
double exceeded_by(std::vector<double> scores, std::size_t n_over) {
    const auto place = scores.begin() + static_cast<std::ptrdiff_t>(n_over);
    std::ranges::nth_element(scores, place, std::greater<>{});
    return *place;
}

// Of a region no more scores exceed the factor than chance lets exceed.
double factor_of_region(const std::vector<double>& scores, double coverage) {
    const auto n = static_cast<double>(scores.size());
    const double over = n * (1 - coverage) + chance * std::sqrt(n * coverage * (1 - coverage));
    return exceeded_by(scores, std::min(scores.size() - 1, static_cast<std::size_t>(over)));
}

// What a new score stays below with the probability `coverage` (Lei, G'Sell, Rinaldo, Tibshirani
// and Wasserman 2018; of leave-one-out residuals Barber, Candes, Ramdas and Tibshirani 2021).
double quantile_of(const std::vector<double>& scores, double coverage) {
    const std::size_t n = scores.size();
    const double rank = std::ceil(static_cast<double>(n + 1) * coverage);
    return exceeded_by(scores, n - std::min(n, static_cast<std::size_t>(std::max(1., rank))));
}

// That quantile, raised where a region falls short of it by more than chance.
double calibrate(std::span<const double> points, const std::vector<double>& scores, int n_variables,
                 double coverage) {
    const std::size_t n = scores.size();
    double factor = quantile_of(scores, coverage);
    const auto stride = static_cast<std::size_t>(n_variables);
    const auto raise = [&](const std::vector<double>& region) {
        if (region.size() >= least_region)
            factor = std::max(factor, factor_of_region(region, coverage));
    };
    std::vector<std::vector<double>> patterns(std::size_t{1} << stride), halves(2 * stride);
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t pattern = 0;
        for (std::size_t d = 0; d < stride; ++d) {
            const std::size_t is_upper = points[i * stride + d] > 0 ? 1 : 0;
            pattern |= is_upper << d;
            halves[2 * d + is_upper].push_back(scores[i]);
        }
        patterns[pattern].push_back(scores[i]);
    }
    for (const auto& region : patterns) raise(region);
    for (const auto& region : halves) raise(region);
    return factor;
}

// Polynomial and error bar by leave-one-out residuals of the terms that have been chosen. Of
// `scale` are the largest values.
PolynomialFit fit_by_leave_one_out(std::span<const double> points, std::span<const double> values,
                                   int n_variables, double scale,
                                   const PolynomialFitOptions& options) {
    const std::size_t n = values.size();
    TermColumns columns(points, n_variables);
    Solution main =
        adaptive_fit(columns, values, scale, std::clamp<std::size_t>(options.most_terms, 1, n / 2));
    PolynomialFit fit{.polynomial = std::move(main.polynomial)};
    std::vector<double> errors = std::move(main.left_out);
    double sum = 0;
    for (double& error : errors) {
        error = std::abs(error);
        sum += error * error;
    }
    fit.rms_error = std::sqrt(sum / static_cast<double>(n));
    fit.largest_error = *std::ranges::max_element(errors);
    fit.median_error = exceeded_by(errors, n / 2);
    const double floor = std::max(least_residual_share * fit.median_error,
                                  std::numeric_limits<double>::epsilon() * scale);
    for (double& error : errors) error = std::log(std::max(error, floor));
    Solution log_error = fit_log_error(columns, errors);
    fit.log_error = std::move(log_error.polynomial);
    std::vector<double> scores = std::move(log_error.left_out);
    for (double& score : scores) score = std::exp(score);
    fit.error_factor = calibrate(points, scores, n_variables, options.coverage);
    return fit;
}

// The leave-one-out residuals know the terms, which all points chose: they are too small where many
// terms come from few points. By how much bars have to be longer is what points tell that take no
// part in the choice: each fold of them against the fit of the others. At least 1.
double find_optimism(std::span<const double> points, std::span<const double> values,
                     int n_variables, double scale, const PolynomialFitOptions& options) {
    const auto stride = static_cast<std::size_t>(n_variables);
    std::vector<double> scores;
    for (std::size_t fold = 0; fold < n_folds && scores.size() < enough_checks; ++fold) {
        std::vector<double> other_points, other_values;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (i % n_folds == fold) continue;
            other_values.push_back(values[i]);
            const auto x = points.subspan(i * stride, stride);
            other_points.insert(other_points.end(), x.begin(), x.end());
        }
        const PolynomialFit fit =
            fit_by_leave_one_out(other_points, other_values, n_variables, scale, options);
        ChebyshevTable table(n_variables);
        table.cover(fit.polynomial);
        table.cover(fit.log_error);
        for (std::size_t i = fold; i < values.size(); i += n_folds) {
            table.set_point(points.subspan(i * stride, stride));
            scores.push_back(std::abs(values[i] - table.evaluate(fit.polynomial)) /
                             error_bar(fit, table));
        }
    }
    return std::max(1., quantile_of(scores, options.coverage));
}

}  // namespace

std::size_t least_points(int n_variables) {
    return std::max<std::size_t>(20, 4 * (static_cast<std::size_t>(n_variables) + 1));
}

PolynomialFit fit_polynomial(std::span<const double> points, std::span<const double> values,
                             int n_variables, const PolynomialFitOptions& options) {
    check_fit_arguments(points, values, n_variables, options);
    const double scale = largest_amount(values);
    PolynomialFit fit = fit_by_leave_one_out(points, values, n_variables, scale, options);
    fit.optimism = find_optimism(points, values, n_variables, scale, options);
    fit.error_factor *= fit.optimism;
    return fit;
}

double error_bar(const PolynomialFit& fit, const ChebyshevTable& table) {
    return fit.error_factor * std::exp(table.evaluate(fit.log_error));
}

}  // namespace tricontact::statistics
