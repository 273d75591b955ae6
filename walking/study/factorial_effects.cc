#include "walking/study/factorial_effects.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <stdexcept>

#include "statistics/regression.h"

namespace tricontact::walking {

namespace {

std::size_t n_combinations(const std::vector<Factor>& factors) {
    std::size_t n = 1;
    for (const Factor& factor : factors) n *= factor.levels.size();
    return n;
}

void check(const FactorialDesign& design) {
    if (design.response.size() != n_combinations(design.factors))
        throw std::invalid_argument("a factorial design has one response per combination");
}

std::vector<std::size_t> kept(const FactorialDesign& design) {
    std::vector<std::size_t> combinations;
    for (std::size_t i = 0; i < design.response.size(); ++i)
        if (!std::isnan(design.response[i])) combinations.push_back(i);
    return combinations;
}

report::WithError mean_of(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    if (values.empty()) return {NAN, NAN};
    double sum = 0, squares = 0;
    for (const double value : values) sum += value;
    for (const double value : values) squares += (value - sum / n) * (value - sum / n);
    if (values.size() == 1) return {sum, NAN};
    const double t = statistics::student_t(confidence, static_cast<int>(values.size()) - 1);
    return {sum / n, t * std::sqrt(squares / (n - 1) / n)};
}

/// Parts of the model: of the mean, of one factor, or of two.
struct Term {
    std::vector<std::size_t> factors;
    std::size_t first_column = 0, n_columns = 1;
};

/// Coded so that parts sum to zero: the last level is minus the sum of the others.
double code(std::size_t level, std::size_t column, std::size_t n_levels) {
    if (level == n_levels - 1) return -1;
    return level == column ? 1 : 0;
}

/// Codes of a term's columns at a combination of levels.
std::vector<double> codes(const FactorialDesign& design, const Term& term,
                          const std::vector<std::size_t>& levels) {
    std::vector<double> row{1};
    for (std::size_t k = 0; k < term.factors.size(); ++k) {
        const std::size_t n = design.factors[term.factors[k]].levels.size();
        std::vector<double> products;
        for (const double product : row)
            for (std::size_t column = 0; column + 1 < n; ++column)
                products.push_back(product * code(levels[k], column, n));
        row = products;
    }
    return row;
}

std::vector<Term> terms_of(const FactorialDesign& design, bool with_pairs) {
    const std::size_t n = design.factors.size();
    std::vector<Term> terms{{}};
    for (std::size_t i = 0; i < n; ++i) terms.push_back({.factors = {i}});
    for (std::size_t i = 0; with_pairs && i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) terms.push_back({.factors = {i, j}});
    std::size_t next = 0;
    for (Term& term : terms) {
        for (const std::size_t factor : term.factors)
            term.n_columns *= design.factors[factor].levels.size() - 1;
        term.first_column = next;
        next += term.n_columns;
    }
    return terms;
}

statistics::Fit fit_of(const FactorialDesign& design, const std::vector<Term>& terms,
                       const std::vector<std::size_t>& combinations) {
    std::vector<std::vector<double>> columns(terms.back().first_column + terms.back().n_columns);
    std::vector<double> y;
    for (const std::size_t i : combinations) {
        y.push_back(design.response[i]);
        for (const Term& term : terms) {
            std::vector<std::size_t> levels;
            for (const std::size_t factor : term.factors) levels.push_back(design.level(i, factor));
            const std::vector<double> row = codes(design, term, levels);
            for (std::size_t k = 0; k < row.size(); ++k)
                columns[term.first_column + k].push_back(row[k]);
        }
    }
    return statistics::fit_linear(columns, y, {.confidence = confidence});
}

/// A term's parameters and their covariance.
struct Block {
    Eigen::VectorXd parameters;
    Eigen::MatrixXd covariance;

    Block(const statistics::Fit& fit, const Term& term)
        : parameters(static_cast<Eigen::Index>(term.n_columns)),
          covariance(parameters.size(), parameters.size()) {
        for (std::size_t i = 0; i < term.n_columns; ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            parameters[row] = fit.parameters[term.first_column + i].value;
            for (std::size_t j = 0; j < term.n_columns; ++j)
                covariance(row, static_cast<Eigen::Index>(j)) =
                    fit.covariance[term.first_column + i][term.first_column + j];
        }
    }
};

/// Share of the variance that the fit would lose without the term: b' C^-1 b of its parameters is
/// the loss in units of the residual variance.
double share_of(const statistics::Fit& fit, const Term& term) {
    const Block block(fit, term);
    const double variance = std::pow(fit.residual_standard_deviation, 2);
    const double total = fit.explained_sum_of_squares + fit.residual_sum_of_squares;
    return variance * block.parameters.dot(block.covariance.llt().solve(block.parameters)) / total;
}

Interaction interaction_of(const FactorialDesign& design, const statistics::Fit& fit,
                           const Term& term) {
    Interaction interaction{.first = term.factors[0],
                            .second = term.factors[1],
                            .effects = {},
                            .share = share_of(fit, term)};
    const Block block(fit, term);
    const double t = statistics::student_t(confidence, fit.degrees_of_freedom);
    for (std::size_t i = 0; i < design.factors[interaction.first].levels.size(); ++i)
        for (std::size_t j = 0; j < design.factors[interaction.second].levels.size(); ++j) {
            const std::vector<double> row = codes(design, term, {i, j});
            const Eigen::Map<const Eigen::VectorXd> c(row.data(), block.parameters.size());
            interaction.effects.push_back(
                {c.dot(block.parameters), t * std::sqrt(c.dot(block.covariance * c))});
        }
    return interaction;
}

}  // namespace

std::size_t FactorialDesign::level(std::size_t combination, std::size_t factor) const {
    for (std::size_t k = factors.size() - 1; k > factor; --k)
        combination /= factors[k].levels.size();
    return combination % factors[factor].levels.size();
}

std::vector<MainEffect> main_effects(const FactorialDesign& design) {
    check(design);
    std::vector<MainEffect> effects;
    const std::vector<std::size_t> combinations = kept(design);
    for (std::size_t factor = 0; factor < design.factors.size(); ++factor) {
        std::vector<std::vector<double>> values(design.factors[factor].levels.size());
        for (const std::size_t i : combinations)
            values[design.level(i, factor)].push_back(design.response[i]);
        MainEffect& effect = effects.emplace_back();
        for (const std::vector<double>& of_level : values) {
            effect.means.push_back(mean_of(of_level));
            effect.n.push_back(static_cast<int>(of_level.size()));
        }
    }
    return effects;
}

VarianceAnalysis variance_analysis(const FactorialDesign& design) {
    check(design);
    const std::vector<std::size_t> combinations = kept(design);
    VarianceAnalysis analysis;
    analysis.explained_by_factors =
        fit_of(design, terms_of(design, false), combinations).r_squared();
    const std::vector<Term> terms = terms_of(design, true);
    const statistics::Fit fit = fit_of(design, terms, combinations);
    analysis.explained_by_pairs = fit.r_squared();
    analysis.residual = fit.residual_standard_deviation;
    for (const Term& term : terms)
        if (term.factors.size() == 1)
            analysis.main_shares.push_back(share_of(fit, term));
        else if (term.factors.size() == 2)
            analysis.interactions.push_back(interaction_of(design, fit, term));
    return analysis;
}

}  // namespace tricontact::walking
