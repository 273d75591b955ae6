#include <fmt/format.h>

#include <algorithm>

#include "experiments/design/design_report.h"
#include "experiments/rig_report/rig_report.h"
#include "io/keys/units.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

constexpr int digits = 4;
constexpr std::size_t most_contributors = 3;

std::string number_text(const io::Key& key, double value) {
    const std::string unit(io::si_unit(key.dimension));
    return key.dimension == io::Dimension::none ? report::significant(value, digits)
                                                : report::quantity(value, unit, digits);
}

bool is_share(const Requirement& r) {
    return r.unit == "1" && r.relation == Criterion::Relation::at_most && r.limit < 1;
}

std::string finding_alone(const Requirement& r, double finding) {
    return is_share(r) ? report::significant(100 * finding, 3) + " %" : text_of({finding}, r.unit);
}

std::string limit_text(const Requirement& r) {
    const char* relation = r.relation == Criterion::Relation::at_most ? "at most" : "at least";
    return is_share(r) ? fmt::format("{} {} %", relation, report::as_given(100 * r.limit))
                       : fmt::format("{} {}", relation, report::as_given(r.limit));
}

std::string margin_text(double ratio) {
    if (ratio <= 1) return fmt::format("margin {} %", report::significant(100 * (1 - ratio), 2));
    return fmt::format("missed by a factor of {}", report::significant(ratio, 3));
}

std::string end_text(const DesignStudy& study, std::size_t axis, double fraction,
                     const std::optional<std::size_t>& requirement) {
    const std::string value =
        number_text(study.input.axes[axis].key(), study.value(axis, fraction));
    if (requirement) return fmt::format("{} ({})", value, study.requirements[*requirement].name);
    const bool is_bound = fraction == 0 || fraction == 1;
    return fmt::format("{} ({})", value, is_bound ? "its bound" : "beyond it not all is known");
}

/// The line of one key.
std::string axis_sentence(const DesignStudy& study, std::size_t axis) {
    const DesignSolution& s = study.solution;
    std::string text = value_text(study, axis, s.best.fractions[axis]);
    if (s.stretches.empty()) return text;
    const Stretch& stretch = s.stretches[axis];
    return fmt::format("{}; alone it may lie between {} and {}", text,
                       end_text(study, axis, stretch.low, stretch.low_requirement),
                       end_text(study, axis, stretch.high, stretch.high_requirement));
}

std::string names_of_binding(const DesignStudy& study) {
    std::vector<std::string> names;
    for (const std::size_t i : study.solution.best.binding())
        names.push_back(study.requirements[i].name);
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string remedy(const DesignStudy& study) {
    std::vector<std::string> bounds;
    for (const Widening& one : study.solution.widenings) {
        const DesignAxis& axis = study.input.axes[one.axis];
        bounds.push_back(fmt::format(
            "{} {} {}", axis.key().path, one.upwards ? "above" : "below",
            number_text(axis.key(), one.upwards ? axis.range().to : axis.range().from)));
    }
    if (!bounds.empty()) return fmt::format("Widen the bounds: {}.", fmt::join(bounds, "; "));
    const bool resolution_binds =
        std::ranges::any_of(study.solution.best.binding(),
                            [&](std::size_t i) { return study.requirements[i].is_resolution(); });
    std::string text = "No bound is in the way: widen a limit, or vary another key.";
    if (resolution_binds && study.comparison)
        text += " The resolution is that of " +
                largest_contributors(*study.comparison, most_contributors) + '.';
    return text;
}

report::Verdict answer_of(const DesignStudy& study) {
    const DesignPoint& best = study.solution.best;
    if (best.is_feasible())
        return {
            report::Verdict::Standing::pass,
            fmt::format("All requirements can be met. Here the least margin is largest: {} % "
                        "of the limit of {}.",
                        report::significant(100 * (1 - best.worst()), 2), names_of_binding(study)),
            "feasible"};
    return {report::Verdict::Standing::fail,
            fmt::format("Nothing within the bounds meets all requirements. Closest, with the worst "
                        "finding {} times its limit ({}):",
                        report::significant(best.worst(), 3), names_of_binding(study)),
            "not feasible"};
}

report::Verdict requirement_verdict(const DesignStudy& study, std::size_t i) {
    const Requirement& r = study.requirements[i];
    const double ratio = study.solution.best.ratios[i];
    const std::string of = r.is_resolution()
                               ? fmt::format("{} of {} ({})", r.name, study.input.quantity,
                                             report::display_name(study.model))
                               : fmt::format("{}: {}", r.name, r.symbol);
    const std::string finding = finding_alone(r, r.finding(ratio));
    return {
        .standing = ratio <= 1 ? report::Verdict::Standing::pass : report::Verdict::Standing::fail,
        .sentence = fmt::format("{} = {}, {}: {}", of, finding, limit_text(r), margin_text(ratio)),
        .subject = r.is_resolution() ? of : r.name,
        .number = r.is_resolution() ? finding : fmt::format("{} = {}", r.symbol, finding),
        .threshold = limit_text(r),
        .effect =
            ratio <= 1 ? report::significant(100 * (1 - ratio), 2) + " %" : margin_text(ratio)};
}

}  // namespace

double DesignStudy::value(std::size_t axis, double fraction) const {
    return input.axes[axis].range().value_at(fraction);
}

std::string value_text(const DesignStudy& study, std::size_t axis, double fraction) {
    const io::Key& key = study.input.axes[axis].key();
    return fmt::format("{} = {}", key.path, number_text(key, study.value(axis, fraction)));
}

std::string finding_text(const Requirement& r, double ratio) {
    return fmt::format("{}, {}", finding_alone(r, r.finding(ratio)), limit_text(r));
}

std::vector<report::Verdict> design_verdicts(const DesignStudy& study) {
    std::vector<report::Verdict> verdicts{answer_of(study)};
    for (std::size_t axis = 0; axis < study.input.axes.size(); ++axis)
        verdicts.push_back({.sentence = axis_sentence(study, axis)});
    for (std::size_t i = 0; i < study.requirements.size(); ++i)
        verdicts.push_back(requirement_verdict(study, i));
    if (study.separation) verdicts.push_back({.sentence = planned_sentence(study)});
    if (study.comparison)
        verdicts.push_back({.sentence = "The comparison's uncertainty is that of " +
                                        largest_contributors(*study.comparison, most_contributors) +
                                        '.'});
    if (!study.solution.best.is_feasible()) verdicts.push_back({.sentence = remedy(study)});
    return verdicts;
}

std::string best_overrides(const DesignStudy& study) {
    std::string text;
    for (std::size_t axis = 0; axis < study.input.axes.size(); ++axis) {
        const DesignAxis& one = study.input.axes[axis];
        const std::string unit(io::si_unit(one.key().dimension));
        std::string value =
            fmt::format("{:.4g}", study.value(axis, study.solution.best.fractions[axis]));
        if (one.key().dimension != io::Dimension::none) value += ' ' + unit;
        if (!one.uncertainty.empty()) value += ' ' + one.uncertainty;
        text += fmt::format(" --set '{}=\"{}\"'", one.key().path, value);
    }
    return text;
}

}  // namespace tricontact::experiments
