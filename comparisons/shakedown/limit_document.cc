// Limits of shakedown as a report.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/shakedown/limit.h"
#include "report/format.h"
#include "report/plot_style.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::comparisons {

namespace {

using contact::State;
using Standing = report::Verdict::Standing;

/// Bisection and what the resolution is known to do to the limit, as far as it is.
double error_of(const ModelLimit& m) {
    return m.bracket.half_width() + (m.exact ? std::abs(m.by_pressures - *m.exact) : 0);
}

/// "2.31 % above"
std::string apart(double value, double reference) {
    return report::apart(value / reference, "above", "below");
}

/// Where the limit is a fold, beside which shifts go as a square root: round elastic bodies,
/// uncoupled.
bool is_fold(const LimitStudy& study) {
    return study.round && !study.relaxing &&
           std::ranges::none_of(study.models, [](const ModelLimit& m) { return m.coupled; });
}

report::Verdict model_verdict(const ModelLimit& m, const char* symbol) {
    std::string text =
        fmt::format("{}: the limit by bisection is {} = {}", report::display_name(m.model), symbol,
                    report::with_error(m.bracket.centre(), m.bracket.half_width()));
    if (!m.exact) return {Standing::finding, text + "."};
    const double off = m.bracket.centre() - *m.exact;
    const std::string exact = fmt::format("{:.7g}", *m.exact);
    const bool within = std::abs(off) <= error_of(m);
    if (m.coupled) {
        const std::string where =
            within ? "within the errors of" : apart(m.bracket.centre(), *m.exact);
        return {Standing::finding,
                text + fmt::format("; the coupled contact has its limit {} the uncoupled {}.",
                                   where, exact)};
    }
    return {within ? Standing::pass : Standing::fail,
            text + fmt::format("; the exact limit of uncoupled contact is {}{}.", exact,
                               within ? ", within bisection and resolution" : "")};
}

/// What is only said where the intervals do not overlap.
void add_differences(const LimitStudy& study, std::vector<report::Verdict>& verdicts) {
    const auto& models = study.models;
    for (std::size_t i = 0; i < models.size(); ++i)
        for (std::size_t k = i + 1; k < models.size(); ++k) {
            const double a = models[i].bracket.centre(), b = models[k].bracket.centre();
            if (std::abs(a - b) <= error_of(models[i]) + error_of(models[k])) continue;
            verdicts.push_back(
                {Standing::finding, fmt::format("{} finds a limit {} that of {}.",
                                                report::display_name(models[k].model), apart(b, a),
                                                report::display_name(models[i].model))});
        }
}

void add_thesis(const LimitStudy& study, const char* symbol,
                std::vector<report::Verdict>& verdicts) {
    if (!study.thesis) return;
    const auto agrees = [&](const ModelLimit& m) {
        return std::abs(m.bracket.centre() - *study.thesis) <= error_of(m);
    };
    const auto& models = study.models;
    const bool any = std::ranges::any_of(models, agrees);
    std::string off;
    for (const ModelLimit& m : models)
        if (!agrees(m))
            off += fmt::format("{}{} that of {}", off.empty() ? "" : ", ",
                               apart(*study.thesis, m.bracket.centre()),
                               report::display_name(m.model));
    verdicts.push_back({any ? Standing::pass : Standing::fail,
                        fmt::format("The thesis' limit {} = {:.4g}{}{}.", symbol, *study.thesis,
                                    off.empty() ? " agrees" : " lies ", off)});
}

/// u of MDR over what is varied, up to its limit: (3.2.16) with kappa = 3/2.
report::Curve settled_shift_of_mdr(const LimitStudy& study) {
    constexpr int n = 200;
    const bool load = study.variable == LimitVariable::load;
    const double limit =
        load ? theory::shakedown_limit(study.given) : theory::amplitude_limit(study.given);
    report::Curve curve{.name = "MDR, closed form", .theory = true};
    for (int i = 0; i <= n; ++i) {
        // Closer towards the limit, where the shift rises as a square root.
        const double x = limit * (1 - std::pow(1 - static_cast<double>(i) / n, 2));
        const auto u = load ? theory::settled_shift_ratio(study.given, x)
                            : theory::settled_shift_ratio(x, study.given);
        if (u) curve.add(x, *u);
    }
    return curve;
}

report::Figure shift_figure(const LimitStudy& study) {
    report::Figure figure{
        .id = "shift",
        .title = "Where the contact comes to rest",
        .caption = fmt::format(
            "Shift after the last period of the runs that shake down, at {} = {:.4g}.{}",
            study.fixed().symbol, study.given,
            is_fold(study) ? " It approaches the limit as a square root: just below it, a little "
                             "more of it lets the contact go much farther."
                           : ""),
        .x = {study.variable == LimitVariable::load ? "tangential load f_T"
                                                    : "rolling amplitude w"},
        .y = {"final shift u = U/U_max"}};
    for (std::size_t i = 0; i < study.models.size(); ++i) {
        report::Curve& curve = figure.curves.emplace_back(
            report::Curve{.name = report::display_name(study.models[i].model),
                          .kind = report::Curve::Kind::line_and_points});
        for (const LimitRun& run : study.models[i].runs)
            if (run.state == State::shakedown) curve.add(run.value, run.final_shift_ratio);
    }
    if (study.round && study.given <= 1) figure.curves.push_back(settled_shift_of_mdr(study));
    return figure;
}

report::Figure period_figure(const LimitStudy& study) {
    report::Figure figure{
        .id = "periods",
        .title = "How many periods the verdict takes",
        .caption = "Runs on both sides of the limit.",
        .x = {fmt::format("distance of {} from the limit", study.varied().symbol), true},
        .y = {"periods until the verdict", true}};
    if (is_fold(study))
        figure.caption +=
            " The nearer, the longer: as the distance to the power -1/2, for the contact creeps "
            "past the place where it nearly comes to rest. A test of n periods determines the "
            "limit to "
            "the order of 1/n² only.";
    for (const ModelLimit& m : study.models)
        for (const State state : {State::shakedown, State::ratcheting}) {
            const int style = report::model_style(m.model).value_or(0);
            report::Curve& curve = figure.curves.emplace_back(report::Curve{
                .name =
                    fmt::format("{}, {}", report::display_name(m.model), contact::name_of(state)),
                .kind = report::Curve::Kind::points,
                .colour = style + (state == State::shakedown ? 0 : report::n_model_colours)});
            for (const LimitRun& run : m.runs) {
                // Nearer than the half width the distance is not known.
                const double distance = std::abs(run.value - m.bracket.centre());
                if (run.state == state && distance > m.bracket.half_width())
                    curve.add(distance, run.periods);
            }
        }
    return figure;
}

}  // namespace

report::Document limit_document(LimitStudy study) {
    for (ModelLimit& m : study.models) std::ranges::sort(m.runs, {}, &LimitRun::value);
    report::Document document{
        .kind = "Limit of shakedown",
        .title = study.title,
        .lead = fmt::format(
            "Up to which {} does the contact, rolling back and forth at {} = {:.4g}, come to rest? "
            "Each model is computed from the start at one value after another.",
            study.varied().symbol, study.fixed().symbol, study.given),
        .settings = {{study.fixed().symbol, fmt::format("{:.6g}", study.given)},
                     {"rolling direction to the load",
                      fmt::format("{:.4g}°", study.angle * 180 / std::numbers::pi)}}};
    for (const ModelLimit& m : study.models)
        document.verdicts.push_back(model_verdict(m, study.varied().symbol));
    add_differences(study, document.verdicts);
    add_thesis(study, study.varied().symbol, document.verdicts);
    document.sections = {
        {.id = "limits",
         .heading = "Limits",
         .figures = {shift_figure(study)},
         .tables = {limit_table(study)}},
        {.id = "judging",
         .heading = "How each run was judged",
         .paragraphs =
             {"A run ratchets when no point sticks throughout the last quarter of its periods and "
              "the increments of the shift fall so slowly that the contact would have to shift by "
              "more than 2 U_max until it rests; it has shaken down when points stick throughout a "
              "period and the increments are below a hundredth of the tolerance. What is neither "
              "when the periods are over stays undecided, and the "
              "limit lies anywhere in the band of such values."},
         .figures = {period_figure(study)},
         .tables = {limit_run_table(study)}}};
    return document;
}

}  // namespace tricontact::comparisons
