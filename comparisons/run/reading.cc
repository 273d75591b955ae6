#include "comparisons/run/reading.h"

#include <fmt/format.h>

#include <cmath>

#include "comparisons/adhesion/adhesion_forms.h"
#include "comparisons/quantities/reference.h"
#include "comparisons/run/input_reading.h"
#include "comparisons/strength/body_strength.h"
#include "contact/models/model_kind.h"
#include "contact/relaxing_case.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::State;

constexpr double near_limit = 0.03;  // relative distance below which convergence gets slow

using Summaries = std::vector<Results>;

/// " of MDR", where not all models are meant.
std::string of_models(const std::vector<std::string>& models, const Summaries& summaries) {
    return models.size() == summaries.size() ? "" : " of " + report::display_names(models);
}

/// What the limit means for those of the models that it is about.
std::string expectation(const contact::Case& c, const Summaries& summaries, const Reference& r) {
    const double f = r.tangential_ratio, limit = *r.limit_tangential_ratio;
    const auto models = uncoupled_half_spaces(c, summaries);
    if (models.empty())
        return fmt::format("This case has f_T = {}; no model here is an uncoupled half-space.",
                           report::significant(f, 3));
    if (!(limit > 0)) return "No point stays in contact throughout: any tangential force ratchets.";
    if (f == limit) return "This case is at the limit: the contact converges slowly.";
    std::string text =
        fmt::format("This case has f_T = {}, {} it: {} is expected{}{}.", report::significant(f, 3),
                    report::apart(f / limit, "above", "below"),
                    f > limit ? "ratcheting" : "shakedown", of_models(models, summaries),
                    c.relaxation ? " under a drive so slow that the substrate relaxes" : "");
    if (std::abs(f / limit - 1) < near_limit)
        text += " So close to the limit the contact converges slowly.";
    return text;
}

std::string limit_sentence(const contact::Case& c, const Summaries& summaries, const Reference& r) {
    if (!r.limit_tangential_ratio) return {};
    const bool all = uncoupled_half_spaces(c, summaries).size() == summaries.size();
    return fmt::format("At the amplitude w = {} the exact limit of shakedown{} is f_T,lim = {}{}. ",
                       report::significant(r.amplitude_ratio, 3),
                       all                 ? ""
                       : c.layer.thickness ? " on a half-space"
                                           : " of uncoupled half-spaces",
                       contact::is_coulomb_round(c) ? "1 − 3/2 w + 1/2 w³ = " : "",
                       report::significant(*r.limit_tangential_ratio, 4)) +
           expectation(c, summaries, r);
}

/// MDR's springs have the exact limit where the pressure falls from the centre on.
bool has_exact_limit(const contact::Case& c, const Results& s, const Reference& r) {
    return r.limit_tangential_ratio && !c.relaxation && is_uncoupled_half_space(c, s.model) &&
           (!contact::model_kind(s.model).is_on_line() || contact::pressure_falls(c));
}

std::string undecided_sentence(const contact::Case& c, const Results& s, const Reference& r) {
    std::string text = fmt::format(
        "{} is undecided after {} {}, the last of which added {}: {}.",
        report::display_name(s.model), s.periods(), s.periods() == 1 ? "period" : "periods",
        with_ratio(s, quantities::shift_increment, quantities::shift_increment_ratio),
        s.verdict.missing.empty() ? "raise rolling.periods" : s.verdict.missing);
    if (has_exact_limit(c, s, r))
        text += r.tangential_ratio <= *r.limit_tangential_ratio
                    ? " By the exact limit it must shake down in the end."
                    : " By the exact limit it must ratchet.";
    return text;
}

/// What the answer and the tables leave open.
std::string verdict_sentence(const contact::Case& c, const Results& s, const Reference& r) {
    using namespace quantities;
    const std::string name = report::display_name(s.model);
    if (!s.state()) return {};
    if (*s.state() == State::undecided) return undecided_sentence(c, s, r);
    if (*s.state() == State::ratcheting || s.number(settled_shift)) return {};
    const std::string by = s.verdict.by_limit ? ": f_T is below the exact limit;" : "";
    return fmt::format(
        "{} {} in the end{}{} where is not known yet: after {} {} at {}, of which the last "
        "one added {}. Raise rolling.periods.",
        name, *s.state() == State::shakedown ? "shakes down" : "settles", by,
        by.empty() ? ", but" : "", s.periods(), s.periods() == 1 ? "period" : "periods",
        with_ratio(s, final_shift, final_shift_ratio),
        report::significant(s.number(shift_increment_ratio)));
}

/// Whose verdict is the limit's.
std::string by_limit_sentence(const Summaries& summaries) {
    std::vector<std::string> models;
    for (const Results& s : summaries)
        if (s.verdict.by_limit) models.push_back(s.model);
    if (models.empty()) return {};
    return fmt::format(
        "The verdict{} compares f_T with f_T,lim, which the least of the computed pressures carry: "
        "exact for uncoupled elastic contact under a constant F_T, however many periods are "
        "rolled.",
        of_models(models, summaries));
}

std::string relaxing_body(const contact::Case& c) {
    const std::string word = contact::relaxing_word(c);
    return (word == "indenter" ? "an " : "a ") + word;
}

/// Closed form and models side by side. Where a substrate still relaxes, its shift is one of a
/// stiffer body, and no closed form's.
std::string static_sentence(const contact::Case& c, const Summaries& summaries,
                            const Reference& r) {
    const bool other_load = c.load.is_by_limit() && c.layer.thickness;  // of a layer's limit
    if (!(r.static_shift_ratio > 0) || other_load) return {};
    const bool relaxed = static_shift_is_relaxed(c);
    const std::string theory =
        fmt::format("{} by {}{}", report::significant(r.static_shift_ratio), static_theory(c),
                    c.layer.thickness ? " on a half-space" : "");
    std::vector<std::string> models;
    for (const Results& s : summaries) {
        const double u = s.number(quantities::static_shift_ratio).value_or(0);
        models.push_back(report::display_name(s.model) + " " + report::significant(u));
        if (relaxed)
            models.back() += fmt::format(" ({})", report::percent(u / r.static_shift_ratio));
    }
    const std::string list = fmt::format("{}", fmt::join(models, "; "));
    return (c.rolling ? "Before rolling: " : "") +
           (relaxed ? fmt::format("u_stat = {}; {}.", theory, list)
                    : fmt::format("u_stat, {} after F_T has come, of {} that still "
                                  "relaxes: {}. Relaxed it would be {}.",
                                  report::given_quantity(c.load.hold, "s"), relaxing_body(c), list,
                                  theory));
}

/// By the loads of the model that leaves out least.
std::vector<std::string> strength_findings(const contact::Case& c, const Summaries& summaries) {
    if (summaries.empty()) return {};
    const Results& s = summaries.back();
    const auto normal_force = s.number(quantities::strength_normal_force);
    if (!normal_force) return {};
    const auto strength =
        strength_of(c, {*normal_force, s.number(quantities::strength_tangential_force).value_or(0),
                        s.number(quantities::strength_bulk_stress).value_or(0)});
    return strength ? strength_sentences(c, *strength) : std::vector<std::string>{};
}

std::string audit_sentence(const Summaries& summaries) {
    std::size_t checks = 0, failed = 0;
    for (const Results& s : summaries)
        for (const auto& check : s.audit) {
            ++checks;
            failed += check.passed() ? 0 : 1;
        }
    if (checks == 0) return {};
    if (failed > 0)
        return fmt::format("Do not use these numbers: {} of {} audit checks failed.", failed,
                           checks);
    return fmt::format("All {} audit checks of all solutions passed.", checks);
}

}  // namespace

std::string with_ratio(const Results& results, const Quantity& length, const Quantity& ratio) {
    return fmt::format("{} ({} {})", report::quantity(results.number(length).value_or(0), "m"),
                       report::significant(results.number(ratio)), ratio.over);
}

std::vector<std::string> reading(const contact::Case& c, const Summaries& summaries) {
    const Reference r = reference(c);
    std::vector<std::string> findings;
    for (const Results& s : summaries) findings.push_back(verdict_sentence(c, s, r));
    findings.push_back(by_limit_sentence(summaries));
    findings.push_back(limit_sentence(c, summaries, r));
    findings.push_back(static_sentence(c, summaries, r));
    for (const std::string& text : adhesion_sentences(c)) findings.push_back(text);
    for (const std::string& text : strength_findings(c, summaries)) findings.push_back(text);
    for (const std::string& text : map_sentences(c)) findings.push_back(text);
    for (const std::string& text : limitations(c, summaries)) findings.push_back(text);
    const std::string audit = audit_sentence(summaries);
    findings.insert(audit.starts_with("Do not") ? findings.begin() : findings.end(), audit);
    std::erase(findings, "");
    return findings;
}

}  // namespace tricontact::comparisons
