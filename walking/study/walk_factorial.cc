#include "walking/study/walk_factorial.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <ranges>

#include "contact/base/special_values.h"
#include "report/format.h"
#include "statistics/regression.h"

namespace tricontact::walking {

namespace {

/// Parts of the model: of the mean, of one factor, or of two.
struct Term {
    std::vector<std::size_t> factors;
    std::size_t first_column = 0, n_columns = 1;
};

/// Codes of a term's columns at a combination of levels, such that parts sum to zero: the last
/// level is minus the sum of the others.
std::vector<double> codes(const FactorialDesign& design, const Term& term,
                          const std::vector<std::size_t>& levels) {
    std::vector<double> row{1};
    for (std::size_t k = 0; k < term.factors.size(); ++k) {
        const std::size_t n = design.factors[term.factors[k]].levels.size();
        std::vector<double> products;
        for (const double product : row)
            for (std::size_t column = 0; column + 1 < n; ++column)
                products.push_back(product * (levels[k] == n - 1    ? -1
                                              : levels[k] == column ? 1
                                                                    : 0));
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

    Block(const statistics::Fit& fit, const Term& term) {
        const auto n = static_cast<Eigen::Index>(term.n_columns);
        const auto* values = &fit.parameters[term.first_column];
        const auto* rows = &fit.covariance[term.first_column];
        parameters = Eigen::VectorXd::NullaryExpr(n, [&](auto i) { return values[i].value; });
        covariance = Eigen::MatrixXd::NullaryExpr(
            n, n, [&](auto i, auto j) { return rows[i][term.first_column + j]; });
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

constexpr std::size_t most_levels = 4;
constexpr double unlimited = contact::infinity;

Factor factor_of(const WalkSweep& sweep, std::size_t axis) {
    Factor factor{.name = label_of(sweep, axis), .levels = {}};
    for (const WalkSweep::Point& point : sweep.points) {
        const double level = shown_value(sweep, axis, point.values[axis]);
        if (std::isnan(level)) return {.name = factor.name, .levels = {}};
        if (std::ranges::count(factor.levels, level) == 0) factor.levels.push_back(level);
    }
    std::ranges::sort(factor.levels);
    return factor;
}

}  // namespace

std::size_t FactorialDesign::level(std::size_t combination, std::size_t factor) const {
    for (std::size_t k = factors.size() - 1; k > factor; --k)
        combination /= factors[k].levels.size();
    return combination % factors[factor].levels.size();
}

std::vector<std::size_t> FactorialDesign::kept() const {
    std::vector<std::size_t> combinations;
    for (std::size_t i = 0; i < response.size(); ++i)
        if (!std::isnan(response[i])) combinations.push_back(i);
    return combinations;
}

std::vector<MainEffect> main_effects(const FactorialDesign& design) {
    std::vector<MainEffect> effects;
    const std::vector<std::size_t> combinations = design.kept();
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
    const std::vector<std::size_t> combinations = design.kept();
    VarianceAnalysis analysis;
    analysis.explained_by_factors =
        fit_of(design, terms_of(design, false), combinations).r_squared();
    const std::vector<Term> terms = terms_of(design, true);
    const statistics::Fit fit = fit_of(design, terms, combinations);
    analysis.explained_by_pairs = fit.r_squared();
    for (const Term& term : terms)
        if (term.factors.size() == 1)
            analysis.main_shares.push_back(share_of(fit, term));
        else if (term.factors.size() == 2)
            analysis.interactions.push_back(interaction_of(design, fit, term));
    return analysis;
}

bool ExclusionRule::excludes(const WalkGroup& group) const {
    if (group.tilts()) return true;
    const double phi = group.mean([](const WalkOutcome& o) { return o.largest_phi; });
    return !(phi <= largest_ratio * group.machine().kappas.kappa4 && phi <= largest_phi);
}

const std::vector<ExclusionRule>& exclusion_rules() {
    static const std::vector<ExclusionRule> rules{
        {"max |phi| > 500 κ_4 or > 1", 500, 1}, {"max |phi| > 1000 κ_4 or > 1", 1000, 1},
        {"max |phi| > 200 κ_4 or > 1", 200, 1}, {"max |phi| > 100 κ_4 or > 1", 100, 1},
        {"max |phi| > 50 κ_4 or > 1", 50, 1},   {"max |phi| > 0.1", unlimited, 0.1},
        {"max |phi| > 0.01", unlimited, 0.01},  {"tilting alone", unlimited, unlimited},
    };
    return rules;
}

FactorialDesign WalkFactorial::design(const std::vector<WalkGroup>& groups,
                                      const ExclusionRule& rule,
                                      double (*response)(const WalkOutcome& outcome)) const {
    std::size_t n = 1;
    for (const Factor& factor : factors) n *= factor.levels.size();
    FactorialDesign design{.factors = factors,
                           .response = std::vector<double>(n, contact::undefined)};
    for (std::size_t i = 0; i < groups.size(); ++i)
        if (!rule.excludes(groups[i])) design.response[places[i]] = groups[i].mean(response);
    return design;
}

std::optional<WalkFactorial> factorial_of(const WalkSweep& sweep,
                                          const std::vector<WalkGroup>& groups,
                                          const std::vector<std::size_t>& axes) {
    WalkFactorial factorial;
    for (const std::size_t axis : axes) factorial.factors.push_back(factor_of(sweep, axis));
    for (const Factor& factor : factorial.factors)
        if (factor.levels.size() < 2 || factor.levels.size() > most_levels) return {};
    if (factorial.factors.size() < 2) return {};
    for (const WalkGroup& group : groups) {
        std::size_t place = 0;
        for (std::size_t k = 0; k < axes.size(); ++k) {
            const std::vector<double>& levels = factorial.factors[k].levels;
            const report::Cell& value = group.points.front()->values[axes[k]];
            const auto level = std::ranges::find(levels, shown_value(sweep, axes[k], value));
            place = place * levels.size() + static_cast<std::size_t>(level - levels.begin());
        }
        factorial.places.push_back(place);
    }
    return factorial;
}

report::Figure main_effects_figure(const std::string& id, const std::string& title,
                                   const std::string& response, const FactorialDesign& design) {
    report::Figure figure{.id = id,
                          .title = title,
                          .caption =
                              "Means over all runs that share a level of a factor. The levels of "
                              "each factor, named in the legend, rise from left to right; bars: "
                              "95 %, from the scatter of the runs.",
                          .x = {"factor"},
                          .y = {response}};
    const std::vector<MainEffect> effects = main_effects(design);
    for (std::size_t k = 0; k < effects.size(); ++k) {
        const Factor& factor = design.factors[k];
        report::Curve curve{
            .name = fmt::format(
                "{}: {}", factor.name,
                fmt::join(factor.levels | std::views::transform(report::as_given), ", ")),
            .kind = report::Curve::Kind::line_and_points};
        const auto n = static_cast<double>(factor.levels.size() - 1);
        constexpr double width = 0.6;  // of what lies between two factors
        for (std::size_t i = 0; i < factor.levels.size(); ++i) {
            curve.x.push_back(static_cast<double>(k + 1) +
                              width * (static_cast<double>(i) / n - 0.5));
            curve.y.push_back(effects[k].means[i].value);
            curve.y_error.push_back(effects[k].means[i].error);
        }
        figure.curves.push_back(curve);
    }
    return figure;
}

}  // namespace tricontact::walking
