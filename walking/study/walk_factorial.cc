#include "walking/study/walk_factorial.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/special_values.h"
#include "report/format.h"

namespace tricontact::walking {

namespace {

constexpr std::size_t most_levels = 4;
constexpr double unlimited = std::numeric_limits<double>::infinity();

Factor factor_of(const WalkSweep& sweep, std::size_t axis) {
    Factor factor{.name = label_of(sweep, axis), .levels = {}};
    for (const WalkSweep::Point& point : sweep.points) {
        const double level = shown_value(sweep, axis, point.values[axis]);
        if (std::isnan(level)) return {.name = factor.name, .levels = {}};
        if (std::find(factor.levels.begin(), factor.levels.end(), level) == factor.levels.end())
            factor.levels.push_back(level);
    }
    std::sort(factor.levels.begin(), factor.levels.end());
    return factor;
}

std::size_t level_of(const Factor& factor, double value) {
    return static_cast<std::size_t>(std::find(factor.levels.begin(), factor.levels.end(), value) -
                                    factor.levels.begin());
}

std::string levels_text(const Factor& factor) {
    std::string text;
    for (const double level : factor.levels)
        text.append(text.empty() ? "" : ", ").append(report::as_given(level));
    return text;
}

}  // namespace

bool ExclusionRule::excludes(const WalkGroup& group) const {
    if (group.tilts()) return true;
    const double phi = group.mean([](const WalkOutcome& o) { return o.largest_phi; });
    return !(phi <= largest_ratio * group.kappas().kappa4 && phi <= largest_phi);
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
            const Factor& factor = factorial.factors[k];
            const report::Cell& value = group.points.front()->values[axes[k]];
            place =
                place * factor.levels.size() + level_of(factor, shown_value(sweep, axes[k], value));
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
        report::Curve curve{.name = factor.name + ": " + levels_text(factor),
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
