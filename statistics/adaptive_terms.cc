#include "statistics/adaptive_terms.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace tricontact::statistics {

namespace {

// One more term at a time per so many terms of the set: rounds are what costs.
constexpr std::size_t terms_per_addition = 32;
// Share of the best neighbour's gain that another one of the same round must have.
constexpr double least_share = 0.3;
constexpr int largest_degree = std::numeric_limits<std::uint8_t>::max();

double dot(const std::vector<double>& a, const std::vector<double>& b) {
    const auto n = static_cast<Eigen::Index>(a.size());
    return Eigen::Map<const Eigen::VectorXd>(a.data(), n)
        .dot(Eigen::Map<const Eigen::VectorXd>(b.data(), n));
}

double scale_of(const Degrees& degrees) {
    const auto n = std::ranges::count_if(degrees, [](std::uint8_t k) { return k > 0; });
    return std::pow(2., 0.5 * static_cast<double>(n));
}

void add_terms_of_degree(int degree, int variable, int n_variables, Degrees& term,
                         std::vector<Degrees>& terms) {
    if (variable + 1 == n_variables) {
        term[variable] = static_cast<std::uint8_t>(degree);
        terms.push_back(term);
        return;
    }
    for (int k = 0; k <= degree; ++k) {
        term[variable] = static_cast<std::uint8_t>(k);
        add_terms_of_degree(degree - k, variable + 1, n_variables, term, terms);
    }
}

}  // namespace

TermColumns::TermColumns(std::span<const double> points, int n_variables)
    : points_(points),
      n_points_(points.size() / static_cast<std::size_t>(n_variables)),
      n_variables_(n_variables) {}

const std::vector<double>& TermColumns::factor(std::size_t variable, std::size_t degree) {
    auto& of_variable = factors_[variable];
    const auto stride = static_cast<std::size_t>(n_variables_);
    while (of_variable.size() < degree) {
        const std::size_t n = of_variable.size();
        std::vector<double> next(n_points_);
        for (std::size_t i = 0; i < n_points_; ++i) {
            const double x = points_[i * stride + variable];
            if (n == 0)
                next[i] = std::numbers::sqrt2 * x;
            else
                next[i] = 2 * x * of_variable[n - 1][i] -
                          (n == 1 ? std::numbers::sqrt2 : of_variable[n - 2][i]);
        }
        of_variable.push_back(std::move(next));
    }
    return of_variable[degree - 1];
}

std::vector<double> TermColumns::column(const Degrees& degrees) {
    std::vector<double> column(n_points_, 1.);
    for (std::size_t d = 0; d < degrees.size(); ++d) {
        if (degrees[d] == 0) continue;
        const std::vector<double>& values = factor(d, degrees[d]);
        for (std::size_t i = 0; i < n_points_; ++i) column[i] *= values[i];
    }
    return column;
}

SparsePolynomial make_polynomial(const std::vector<Degrees>& terms,
                                 const std::vector<double>& coefficients, int n_variables,
                                 double least) {
    std::vector<std::size_t> order(coefficients.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t t) { return terms[t]; });
    SparsePolynomial polynomial{.n_variables = n_variables};
    for (const std::size_t t : order) {
        if (std::abs(coefficients[t]) <= least) continue;
        polynomial.coefficients.push_back(coefficients[t] * scale_of(terms[t]));
        polynomial.degrees.insert(polynomial.degrees.end(), terms[t].begin(),
                                  terms[t].begin() + n_variables);
    }
    return polynomial;
}

std::vector<Degrees> terms_of_degree(int degree, int n_variables) {
    std::vector<Degrees> terms;
    Degrees term{};
    add_terms_of_degree(degree, 0, n_variables, term, terms);
    return terms;
}

AdaptiveTerms::AdaptiveTerms(TermColumns& columns, GrowingLeastSquares& squares)
    : columns_(columns), squares_(squares) {}

bool AdaptiveTerms::admits(const Degrees& degrees) const {
    if (set_.contains(degrees) || dependent_.contains(degrees)) return false;
    for (std::size_t d = 0; d < degrees.size(); ++d) {
        Degrees below = degrees;
        bool has_support = below[d] == 0;
        for (int step = 0; step < 2 && below[d] > 0; ++step) {
            --below[d];
            has_support = has_support || set_.contains(below);
        }
        if (!has_support) return false;
    }
    return true;
}

AdaptiveTerms::Neighbour& AdaptiveTerms::look_at(const Degrees& degrees) {
    const auto [place, is_new] = neighbours_.try_emplace(degrees);
    if (is_new) {
        place->second.column = columns_.column(degrees);
        place->second.length_squared = dot(place->second.column, place->second.column);
    }
    return place->second;
}

bool AdaptiveTerms::append(const Degrees& degrees) {
    const bool is_independent = squares_.append(look_at(degrees).column);
    neighbours_.erase(degrees);
    if (!is_independent) {
        dependent_.insert(degrees);
        return false;
    }
    terms_.push_back(degrees);
    set_.insert(degrees);
    const auto n_variables = static_cast<std::size_t>(columns_.n_variables());
    for (std::size_t d = 0; d < n_variables; ++d) {
        Degrees next = degrees;
        for (int step = 0; step < 2 && next[d] < largest_degree; ++step) {
            ++next[d];
            if (!admits(next)) continue;
            look_at(next).is_admissible = true;
            for (std::size_t e = 0; e < n_variables; ++e) {
                Degrees beyond = next;
                if (beyond[e] == 0 || beyond[e]++ == largest_degree) continue;
                if (!set_.contains(beyond)) look_at(beyond);
            }
        }
    }
    return true;
}

std::vector<Degrees> AdaptiveTerms::best_neighbours() const {
    std::map<Degrees, double> gains;
    // The residual is orthogonal to the set: of a column only its part beyond the set counts here,
    // while its length is of all. With more points than terms the difference is small.
    for (const auto& [degrees, neighbour] : neighbours_) {
        const double product = dot(neighbour.column, squares_.residuals());
        gains[degrees] =
            neighbour.length_squared > 0 ? product * product / neighbour.length_squared : 0;
    }
    std::vector<std::pair<double, Degrees>> ranked;
    for (const auto& [degrees, neighbour] : neighbours_) {
        if (!neighbour.is_admissible) continue;
        const double own = gains[degrees];
        double best = own;
        for (std::size_t d = 0; d < degrees.size(); ++d) {
            Degrees beyond = degrees;
            if (beyond[d]++ == largest_degree) continue;
            if (const auto found = gains.find(beyond); found != gains.end())
                best = std::max(best, 0.5 * (own + found->second));
        }
        ranked.emplace_back(-best, degrees);
    }
    std::ranges::sort(ranked);
    std::vector<Degrees> best;
    const std::size_t most = 1 + terms_.size() / terms_per_addition;
    for (const auto& [minus_gain, degrees] : ranked)
        if (best.size() < most && minus_gain <= least_share * ranked.front().first)
            best.push_back(degrees);
    return best;
}

}  // namespace tricontact::statistics
