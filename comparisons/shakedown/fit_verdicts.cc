#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/shakedown/fit_document.h"
#include "report/format.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::comparisons {

namespace {

using Standing = report::Verdict::Standing;

template <class Group>
std::string name_of(const Group& group) {
    return report::display_name(group.model) + ", " + group.group;
}

std::string interval(const statistics::Estimate& e) {
    return report::with_error(e.value, e.high - e.value);
}

const MappingUse* use_named(const MappingGroup& group, const std::string& name) {
    const auto found = std::ranges::find(group.uses, name, &MappingUse::name);
    return found == group.uses.end() ? nullptr : &*found;
}

/// "one κ for all amplitudes and loads holds: ..."
std::string finding_of(const MappingGroup& group) {
    const OneMapping& one = group.one;
    const std::string claim = "one κ for all amplitudes and loads ";
    const auto [least, most] =
        std::ranges::minmax(group.points, {}, [](const MappingPoint& p) { return p.kappa.value; });
    const std::string points = fmt::format("that of single points lies between {} and {}",
                                           report::significant(least.kappa.value, 3),
                                           report::significant(most.kappa.value, 3));
    if (one.is_negligible) return claim + "holds to 0.1 % of u_sd; " + points;
    if (one.finding == Standing::violated)
        return claim + "does not hold: " + points + ", further apart than their numerical errors";
    const std::string known =
        fmt::format("{} of {} points know it to 10 %", one.n_telling, group.points.size());
    if (one.finding == Standing::holds)
        return fmt::format(
            "{}holds within the numerical errors: {} to {} serves every point, {}; {}", claim,
            report::significant(one.low, 3), report::significant(one.high, 3), known, points);
    const bool without = one.n_with_bars < static_cast<int>(group.points.size());
    return fmt::format("whether {}holds cannot be told: {}; {}", claim,
                       without ? fmt::format("{} of {} points have numerical errors (levels of the "
                                             "study)",
                                             one.n_with_bars, group.points.size())
                               : "the numerical errors are too large, " + known,
                       points);
}

report::Verdict constant_verdict(const MappingGroup& group) {
    if (!group.constant)
        return {Standing::not_testable, fmt::format("{}: κ cannot be fitted to {} settled points",
                                                    name_of(group), group.points.size())};
    const std::string value = "κ = " + interval(group.constant->fit.parameters.front());
    const MappingUse* use = use_named(group, "fitted");
    if (!use)
        return {Standing::violated,
                fmt::format("{}: {} lies beyond what the formula takes (0 to 3/2)", name_of(group),
                            value)};
    return {
        group.one.finding,
        fmt::format("{}: {}; by least squares κ = {}, which misses u_sd by {} in the median, {} "
                    "at worst",
                    name_of(group), finding_of(group),
                    report::significant(group.constant->fit.parameters.front().value, 4),
                    report::share(use->median), report::percent(1 + use->worst))};
}

void add_thesis_mapping(std::vector<report::Verdict>& verdicts, const MappingGroup& group) {
    const MappingUse* use = use_named(group, "thesis");
    if (!use || group.points.empty()) return;
    const bool contradicted = use->n_beyond_bars > 0 || use->n_ratcheting > 0;
    const bool compared = group.one.is_known;
    verdicts.push_back(
        {contradicted ? Standing::violated
         : compared   ? Standing::holds
                      : Standing::not_testable,
         fmt::format("{}: the thesis' κ = {} misses u_sd by {} in the median, {} at worst (w = {}, "
                     "f_T = {})",
                     name_of(group), use->kappa, report::share(use->median),
                     report::percent(1 + use->worst), report::as_given(use->worst_amplitude_ratio),
                     report::as_given(use->worst_tangential_ratio)) +
             (contradicted || compared
                  ? ""
                  : "; without smaller numerical errors (levels of the study) it "
                    "is undecided whether that is the κ")});
}

void add_root(std::vector<report::Verdict>& verdicts, const RatchetingGroup& group, bool elastic) {
    if (!group.root) {
        if (group.n_turning_points_only == 0 && group.points.empty()) return;
        const std::string why =
            group.n_turning_points_only > 0
                ? fmt::format("{} points ratchet in steps from one turning point to the next only",
                              group.n_turning_points_only)
                : fmt::format("{} ratcheting points", group.points.size());
        verdicts.push_back(
            {Standing::not_testable, fmt::format("{}: η, from {}", name_of(group), why)});
        return;
    }
    const statistics::Estimate& c = group.root->fit.parameters.front();
    verdicts.push_back(
        {Standing::finding,
         fmt::format("{}: Δu = {} u_stat^(1/2) (w − w_lim), R² = {}; the thesis has 4.77 for MDR, "
                     "2^(1/2) = 1.41 parallel, 5^(1/2) = 2.24 perpendicular",
                     name_of(group), interval(c),
                     report::significant(group.root->of_left_side.r_squared, 3))});
    std::vector<double> ratios;
    for (const RatchetingPoint& p : group.points)
        if (!std::isnan(p.thesis_ratio)) ratios.push_back(p.thesis_ratio);
    if (ratios.empty() || group.model == "mdr" || !elastic) return;
    const auto [least, most] = std::ranges::minmax_element(ratios);
    verdicts.push_back(
        {*least > 0.9 && *most < 1.1 ? Standing::holds : Standing::violated,
         fmt::format("{}: the thesis' formula gives {} of Δu in the median, {} to {}",
                     name_of(group), report::share(statistics::median(ratios)),
                     report::share(*least), report::share(*most))});
}

/// The thesis' limit is 1 - w, or 1 - 1.1 w + 0.1 w^3.
void add_limit(std::vector<report::Verdict>& verdicts, const StudyFit& fit,
               const RatchetingGroup& group) {
    if (!is_parallel(group.angle) && !is_perpendicular(group.angle)) return;
    const double kappa = is_parallel(group.angle) ? theory::thesis_mapping_parallel
                                                  : theory::thesis_mapping_perpendicular;
    const auto excess = [&](const RollingPoint& p) {
        return theory::shakedown_limit(p.amplitude_ratio, kappa) /
                   p.at(quantities::limit_tangential_ratio).value -
               1;
    };
    const RollingPoint* worst = nullptr;
    for (const RollingPoint* p : points_of(fit.points, group))
        if (!worst || std::abs(excess(*p)) > std::abs(excess(*worst))) worst = p;
    if (!worst || worst->amplitude_ratio == 0) return;
    verdicts.push_back(
        {std::abs(excess(*worst)) < 0.01 ? Standing::holds : Standing::violated,
         fmt::format("{}: the thesis' limit f_T,lim = {} lies {} {} the model's at w = {} "
                     "({} against {})",
                     name_of(group), is_parallel(group.angle) ? "1 − w" : "1 − 1.1 w + 0.1 w³",
                     report::share(std::abs(excess(*worst))),
                     excess(*worst) < 0 ? "below" : "above",
                     report::as_given(worst->amplitude_ratio),
                     report::significant(theory::shakedown_limit(worst->amplitude_ratio, kappa), 3),
                     report::significant(worst->at(quantities::limit_tangential_ratio).value, 3))});
}

}  // namespace

std::vector<report::Verdict> fit_verdicts(const StudyFit& fit) {
    std::vector<report::Verdict> verdicts;
    // What the thesis' formulas are about is elastic.
    const bool elastic = fit.caveat.empty();
    if (!elastic) verdicts.push_back({Standing::not_testable, fit.caveat});
    for (const MappingGroup& group : fit.mapping) {
        verdicts.push_back(constant_verdict(group));
        if (elastic) add_thesis_mapping(verdicts, group);
    }
    for (const RatchetingGroup& group : fit.ratcheting) {
        if (elastic) add_limit(verdicts, fit, group);
        add_root(verdicts, group, elastic);
    }
    for (const ModelDifference& d : fit.differences)
        if (d.quantity == &quantities::settled_shift || d.quantity == &quantities::shift_increment)
            verdicts.push_back({d.n_with_bars() == 0 ? Standing::not_testable : Standing::finding,
                                difference_sentence(d)});
    return verdicts;
}

}  // namespace tricontact::comparisons
