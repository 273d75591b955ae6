#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/shakedown/fit_document.h"
#include "contact/models/model_kind.h"
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

std::string miss_text(const MappingUse& use) {
    return fmt::format("u_sd {} off in the median, {} at worst", report::share(use.median),
                       report::percent(1 + use.worst));
}

/// "0.889 to 1.08".
std::string range_text(const MappingGroup& group) {
    const auto [least, most] =
        std::ranges::minmax(group.points, {}, [](const MappingPoint& p) { return p.kappa.value; });
    return fmt::format("{} to {}", report::significant(least.kappa.value, 3),
                       report::significant(most.kappa.value, 3));
}

std::string value_text(const MappingGroup& group) {
    return report::significant(group.constant->fit.parameters.front().value, 4);
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
        fmt::format("{} of {} points determine it to 10 %", one.n_telling, group.points.size());
    if (one.finding == Standing::holds)
        return fmt::format(
            "{}holds within the numerical errors: {} to {} serves every point, {}; {}", claim,
            report::significant(one.low, 3), report::significant(one.high, 3), known, points);
    const bool without = one.n_with_bars < static_cast<int>(group.points.size());
    return fmt::format("whether {}holds is not testable: {}; {}", claim,
                       without ? fmt::format("{} of {} points have numerical errors (levels of the "
                                             "study)",
                                             one.n_with_bars, group.points.size())
                               : "the numerical errors are too large, " + known,
                       points);
}

report::Verdict constant_verdict(const MappingGroup& group, const theory::RolledLaw& law) {
    if (!group.constant)
        return {Standing::not_testable, fmt::format("{}: κ cannot be fitted to {} settled points",
                                                    name_of(group), group.points.size())};
    const std::string value = "κ = " + interval(group.constant->fit.parameters.front());
    const MappingUse* use = use_named(group, "fitted");
    if (!use)
        return {Standing::violated,
                fmt::format("{}: {} lies beyond what the formula takes (0 to {})", name_of(group),
                            value, law.mdr_text)};
    const bool is_negligible = group.one.is_negligible;
    return {
        .standing = group.one.finding,
        .sentence = fmt::format(
            "{}: {}; by least squares κ = {}, which misses u_sd by {} in the median, {} "
            "at worst",
            name_of(group), finding_of(group),
            report::significant(group.constant->fit.parameters.front().value, 4),
            report::share(use->median), report::percent(1 + use->worst)),
        .subject = name_of(group) + ": one κ for all amplitudes and loads",
        .number = fmt::format("κ = {}; of single points {}", value_text(group), range_text(group)),
        .threshold = is_negligible ? "0.1 % of u_sd" : "numerical errors",
        .effect = miss_text(*use)};
}

void add_thesis_mapping(std::vector<report::Verdict>& verdicts, const MappingGroup& group) {
    const MappingUse* use = use_named(group, "thesis");
    if (!use || group.points.empty()) return;
    const bool contradicted = use->n_beyond_bars > 0 || use->n_ratcheting > 0;
    const bool compared = group.one.is_known;
    report::Verdict& verdict = verdicts.emplace_back(report::Verdict{
        contradicted ? Standing::fail
        : compared   ? Standing::pass
                     : Standing::not_resolved,
        fmt::format("{}: the thesis' κ = {} misses u_sd by {} in the median, {} at worst (w = {}, "
                    "f_T = {})",
                    name_of(group), use->kappa, report::share(use->median),
                    report::percent(1 + use->worst), report::as_given(use->worst_amplitude_ratio),
                    report::as_given(use->worst_tangential_ratio)) +
            (contradicted || compared
                 ? ""
                 : "; without smaller numerical errors (levels of the study) it "
                   "is undecided whether that is the κ")});
    verdict.subject = name_of(group) + ": κ of the thesis";
    verdict.number = fmt::format("κ = {}", use->kappa);
    verdict.threshold = "numerical errors";
    verdict.effect = miss_text(*use);
}

void add_root(std::vector<report::Verdict>& verdicts, const RatchetingGroup& group,
              bool has_thesis) {
    if (!group.root) {
        if (group.n_turning_points_only == 0 && group.points.empty()) return;
        const std::string why =
            group.n_turning_points_only > 0
                ? fmt::format(
                      "all {} ratcheting points used turning points; set "
                      "rolling.steps_per_quarter",
                      group.n_turning_points_only)
                : fmt::format("{} ratcheting points are too few", group.points.size());
        verdicts.push_back({Standing::not_resolved,
                            fmt::format("{}: η cannot be computed: {}", name_of(group), why)});
        return;
    }
    const statistics::Estimate& c = group.root->fit.parameters.front();
    const double r_squared = group.root->of_left_side.r_squared;
    verdicts.push_back(
        {Standing::finding,
         fmt::format("{}: Δu = {} u_stat^(1/2) (w − w_lim){}{}", name_of(group), interval(c),
                     std::isnan(r_squared) ? "" : ", R² = " + report::significant(r_squared, 3),
                     has_thesis ? "; the thesis has 4.77 for MDR, 2^(1/2) = 1.41 parallel, "
                                  "5^(1/2) = 2.24 perpendicular"
                                : "")});
    std::vector<double> ratios;
    for (const RatchetingPoint& p : group.points)
        if (!std::isnan(p.thesis_ratio)) ratios.push_back(p.thesis_ratio);
    if (ratios.empty() || contact::model_kind(group.model).is_on_line() || !has_thesis) return;
    const auto [least, most] = std::ranges::minmax_element(ratios);
    report::Verdict& verdict = verdicts.emplace_back(report::Verdict{
        *least > 0.9 && *most < 1.1 ? Standing::pass : Standing::fail,
        fmt::format("{}: the thesis' formula gives {} of Δu in the median, {} to {}",
                    name_of(group), report::share(statistics::median(ratios)),
                    report::share(*least), report::share(*most))});
    verdict.subject = name_of(group) + ": Δu by the formula of the thesis";
    verdict.number = fmt::format("{} to {} of Δu", report::share(*least), report::share(*most));
    verdict.threshold = "90 % to 110 %";
    verdict.effect = fmt::format("Δu is {} of the model's in the median",
                                 report::share(statistics::median(ratios)));
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
    report::Verdict& verdict = verdicts.emplace_back(report::Verdict{
        std::abs(excess(*worst)) < 0.01 ? Standing::pass : Standing::fail,
        fmt::format("{}: the thesis' limit f_T,lim = {} lies {} {} the model's at w = {} "
                    "({} against {})",
                    name_of(group), is_parallel(group.angle) ? "1 − w" : "1 − 1.1 w + 0.1 w³",
                    report::share(std::abs(excess(*worst))), excess(*worst) < 0 ? "below" : "above",
                    report::as_given(worst->amplitude_ratio),
                    report::significant(theory::shakedown_limit(worst->amplitude_ratio, kappa), 3),
                    report::significant(worst->at(quantities::limit_tangential_ratio).value, 3))});
    verdict.subject = name_of(group) + ": limit of the thesis";
    verdict.number = fmt::format("f_T,lim {} at w = {}", report::percent(1 + excess(*worst)),
                                 report::as_given(worst->amplitude_ratio));
    verdict.threshold = "1 %";
    verdict.effect = excess(*worst) > 0 ? "ratcheting is taken for shakedown near the limit"
                                        : "shakedown is taken for ratcheting near the limit";
}

}  // namespace

std::vector<report::Verdict> fit_verdicts(const StudyFit& fit) {
    std::vector<report::Verdict> verdicts;
    // What the thesis' formulas are about is elastic and rubs by Coulomb's law.
    const bool has_thesis = fit.caveat.empty() && fit.law->is_coulomb();
    if (!fit.caveat.empty()) verdicts.push_back({Standing::not_testable, fit.caveat});
    for (const MappingGroup& group : fit.mapping) {
        verdicts.push_back(constant_verdict(group, *fit.law));
        if (has_thesis) add_thesis_mapping(verdicts, group);
    }
    for (const RatchetingGroup& group : fit.ratcheting) {
        if (has_thesis) add_limit(verdicts, fit, group);
        add_root(verdicts, group, has_thesis);
    }
    for (const ModelDifference& d : fit.differences)
        if (d.quantity == &quantities::settled_shift || d.quantity == &quantities::shift_increment)
            verdicts.push_back({d.n_with_bars() == 0 ? Standing::not_resolved : Standing::finding,
                                difference_sentence(d)});
    return verdicts;
}

}  // namespace tricontact::comparisons
