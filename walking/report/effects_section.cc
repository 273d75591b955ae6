#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ranges>

#include "contact/base/error.h"
#include "report/format.h"
#include "walking/report/walk_sweep_document.h"
#include "walking/study/walk_factorial.h"

namespace tricontact::walking {

namespace {

struct Response {
    const char *id, *name, *title;
    double (*value)(const WalkOutcome& outcome);
};

constexpr Response responses[] = {
    {"friction_second_half", "μ_e", "Effective friction over the second half of the run",
     [](const WalkOutcome& o) { return o.second_half.mu_e; }},
    {"friction", "μ_e", "Effective friction as judged",
     [](const WalkOutcome& o) { return o.result.mu_e; }},
    {"lowest_z", "z_min/z_stat", "Highest point of the body over the second half of the run",
     [](const WalkOutcome& o) { return o.second_half.z_min_ratio; }},
};

report::DocumentTable main_table(const Response& response, const FactorialDesign& design,
                                 const std::optional<VarianceAnalysis>& analysis) {
    report::DocumentTable table{
        .id = std::string("main_effects_") + response.id,
        .title = std::string("Main effects: ") + response.title,
        .note =
            "Errors, 95 %, from the scatter of the runs at a level. Share: of the variance that "
            "the factor alone accounts for.",
        .columns = {{"factor"}, {"level"}, {"mean"}, {"runs"}, {"share [%]", 3}}};
    const std::vector<MainEffect> effects = main_effects(design);
    for (std::size_t k = 0; k < effects.size(); ++k)
        for (std::size_t i = 0; i < effects[k].means.size(); ++i)
            table.rows.push_back({design.factors[k].name, design.factors[k].levels[i],
                                  effects[k].means[i], static_cast<double>(effects[k].n[i]),
                                  analysis ? 100 * analysis->main_shares[k] : NAN});
    return table;
}

report::DocumentTable interaction_table(const Response& response, const FactorialDesign& design,
                                        const VarianceAnalysis& analysis) {
    report::DocumentTable table{
        .id = std::string("interactions_") + response.id,
        .title = std::string("Effects of pairs: ") + response.title,
        .note =
            "How far two factors together depart from the sum of what they do alone: the largest "
            "departure, where it is, and the pair's share of the variance.",
        .columns = {{"pair"}, {"levels"}, {"largest effect"}, {"share [%]", 3}}};
    for (const Interaction& interaction : analysis.interactions) {
        const Factor &first = design.factors[interaction.first],
                     &second = design.factors[interaction.second];
        const auto largest = std::ranges::max_element(
            interaction.effects, {}, [](const auto& effect) { return std::abs(effect.value); });
        const auto place = static_cast<std::size_t>(largest - interaction.effects.begin());
        table.rows.push_back({first.name + " × " + second.name,
                              report::as_given(first.levels[place / second.levels.size()]) + ", " +
                                  report::as_given(second.levels[place % second.levels.size()]),
                              *largest, 100 * interaction.share});
    }
    return table;
}

/// Means over the runs at pairs of levels: parallel lines do not interact.
report::Figure pair_figure(const Response& response, const FactorialDesign& design,
                           const Interaction& interaction) {
    const Factor &over = design.factors[interaction.first],
                 &by = design.factors[interaction.second];
    report::Figure figure{
        .id = fmt::format("pair_{}_{}_{}", response.id, interaction.first + 1,
                          interaction.second + 1),
        .title = over.name + " and " + by.name + ": " + response.title,
        .caption =
            "Means over all runs at a pair of levels. Parallel lines: the two do not interact.",
        .x = {over.name, over.levels.front() > 0 && over.levels.back() > 50 * over.levels.front()},
        .y = {response.name}};
    for (std::size_t j = 0; j < by.levels.size(); ++j) {
        report::Curve curve{.name = by.name + " = " + report::as_given(by.levels[j]),
                            .x = over.levels,
                            .kind = report::Curve::Kind::line_and_points};
        for (std::size_t i = 0; i < over.levels.size(); ++i) {
            std::vector<double> values;
            for (const std::size_t c : design.kept())
                if (design.level(c, interaction.first) == i &&
                    design.level(c, interaction.second) == j)
                    values.push_back(design.response[c]);
            curve.y.push_back(mean_of(values).value);
        }
        figure.curves.push_back(curve);
    }
    return figure;
}

/// Last level minus first, of each factor, rule by rule.
report::DocumentTable rule_table(const std::vector<WalkGroup>& groups,
                                 const WalkFactorial& factorial) {
    report::DocumentTable table{.id = "exclusion_rules",
                                .title = "What the effects owe to the rule that excludes runs",
                                .note =
                                    "Each factor's main effect on μ_e, second half of the run: "
                                    "mean at its last level minus mean at its first.",
                                .columns = {{"excluded"}, {"runs kept"}, {"mean μ_e"}}};
    for (const Factor& factor : factorial.factors) table.columns.push_back({factor.name});
    for (const ExclusionRule& rule : exclusion_rules()) {
        const FactorialDesign design = factorial.design(groups, rule, responses[0].value);
        std::vector<double> values;
        for (const std::size_t c : design.kept()) values.push_back(design.response[c]);
        std::vector<report::Cell>& row = table.rows.emplace_back(std::vector<report::Cell>{
            rule.name, static_cast<double>(values.size()), mean_of(values).value});
        for (const MainEffect& effect : main_effects(design))
            row.emplace_back(report::WithError{
                effect.means.back().value - effect.means.front().value,
                std::hypot(effect.means.back().error, effect.means.front().error)});
    }
    return table;
}

std::string share_sentence(const Response& response, const VarianceAnalysis& analysis) {
    return fmt::format(
        "{}: factors alone account for {} % of the variance, pairs for {} % more; {} % are left to "
        "three and more factors together and to the scatter of single runs.",
        response.title, report::significant(100 * analysis.explained_by_factors, 2),
        report::significant(100 * (analysis.explained_by_pairs - analysis.explained_by_factors), 2),
        report::significant(100 * (1 - analysis.explained_by_pairs), 2));
}

constexpr std::size_t n_drawn_pairs = 3;

void add_response(const Response& response, const FactorialDesign& design, WalkSection& result) {
    report::DocumentSection& section = result.section;
    section.figures.push_back(main_effects_figure(std::string("main_effects_") + response.id,
                                                  response.title, response.name, design));
    std::optional<VarianceAnalysis> analysis;
    try {
        analysis = variance_analysis(design);
        std::ranges::stable_sort(analysis->interactions, std::ranges::greater{},
                                 &Interaction::share);
    } catch (const contact::NotConverged&) {
        section.paragraphs.push_back(std::string(response.title) +
                                     ": some pair of levels is excluded altogether, or there are "
                                     "too few runs, so that effects of pairs are not resolved.");
    } catch (const std::invalid_argument&) {  // no more runs than parts
        section.paragraphs.push_back(std::string(response.title) +
                                     ": too few runs for effects of pairs.");
    }
    section.tables.push_back(main_table(response, design, analysis));
    if (!analysis) return;
    result.verdicts.push_back({.sentence = share_sentence(response, *analysis)});
    section.tables.push_back(interaction_table(response, design, *analysis));
    for (const Interaction& pair : analysis->interactions | std::views::take(n_drawn_pairs))
        section.figures.push_back(pair_figure(response, design, pair));
}

}  // namespace

std::optional<WalkSection> effects_section(const WalkSweep& sweep,
                                           const std::vector<WalkGroup>& groups) {
    const auto factorial = factorial_of(sweep, groups, machine_axes(sweep));
    if (!factorial) return {};
    const ExclusionRule& rule = exclusion_rules().front();
    WalkSection result{.section = {.id = "effects", .heading = "Design of experiments"}};
    const auto n_excluded =
        std::ranges::count_if(groups, [&](const WalkGroup& group) { return rule.excludes(group); });
    result.verdicts.push_back(
        {.sentence = fmt::format("{} of {} runs count; excluded are those with {}, or that tilt.",
                                 std::ssize(groups) - n_excluded, groups.size(), rule.name)});
    for (const Response& response : responses)
        add_response(response, factorial->design(groups, rule, response.value), result);
    result.section.tables.push_back(rule_table(groups, *factorial));
    return result;
}

}  // namespace tricontact::walking
