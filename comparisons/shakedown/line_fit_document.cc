#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "comparisons/shakedown/fit_document.h"
#include "report/format.h"
#include "theory/oscillating_cylinder.h"

namespace tricontact::comparisons {

namespace {

/// Loads from which a settled point counts as near its limit.
constexpr double near_line_limit = 0.97;

/// u_sd of the half-space at load f.
double exact_shift(double w, double f, double lambda) {
    const auto stick = theory::line_stick_half_width(w, f);
    return stick ? theory::line_settled_shift_ratio(w, *stick, lambda) : std::nan("");
}

constexpr int of_thesis_line = 0, exact_line = 1;  // kinds of forms

report::Figure stick_widths(const ThesisFigures& of) {
    std::vector<Form> forms;
    const auto add = [&](const char* name, double w, auto force, int kind) {
        const double widest = (1 - w) * (1 - 1e-9);  // at 1 - w itself nothing slips
        const auto force_at = [=](double c) { return force(w, c); };
        forms.push_back({name, 0, widest, force_at, std::identity(), kind});
    };
    for (const double w : of.amplitudes) {
        add("exact, half-space", w, theory::line_stick_force, exact_line);
        add("thesis (3.5.24)", w, theory::thesis_line_stick_force, of_thesis_line);
    }
    return of.figure("3.40", "Half width that sticks after shakedown",
                     "Lines: exact on the half-space, and the thesis' (3.5.24), for the "
                     "amplitudes of the points up to the limit.",
                     "f_T", "c_sd/a", forms, over_load(quantities::stick_ratio));
}

report::Figure settled(const ThesisFigures& of, double lambda) {
    std::set<double> amplitudes = of.amplitudes;
    amplitudes.insert(0);
    std::vector<Form> forms;
    for (const double w : amplitudes) {
        const double limit = theory::line_shakedown_limit(w);
        const auto exact = [=](double load) {
            return exact_shift(w, std::min(load, limit), lambda);
        };
        const auto thesis = [=](double load) {
            return theory::thesis_line_settled_shift_ratio(w, std::min(load, limit)).value();
        };
        forms.push_back({"exact, half-space", 0, limit, std::identity(), exact, exact_line});
        forms.push_back({"thesis (3.5.26)", 0, limit, std::identity(), thesis, of_thesis_line});
    }
    return of.figure("3.43", "Settled shift over the load",
                     "Lines: exact on the half-space, and u_sd = 1 − (1 − f_T)^0.92 + 0.3 "
                     "f_T w of the thesis (3.5.26), for the amplitudes of the points up to "
                     "the limit; the lowest is u_stat (w = 0).",
                     "f_T", "u_sd [U_max]", forms, over_load(quantities::settled_shift_ratio));
}

report::Figure limits(const ThesisFigures& of) {
    return of.figure(
        "3.44", "Largest amplitude that settles",
        "Points: f_T,lim from each model's own pressures. Exact: (3.5.27) under "
        "Hertz' pressure. Thesis: its fit w_lim = 1 − f^0.73 (3.5.28).",
        "f_T,lim", "w_lim",
        {{"exact, half-space", 0, 1, theory::line_shakedown_limit, std::identity(), exact_line},
         {"thesis (3.5.28)", 0, 1, std::identity(), theory::thesis_line_amplitude_limit,
          of_thesis_line}},
        amplitude_over_limit());
}

report::Figure limit_shifts(const ThesisFigures& of, double lambda) {
    const auto exact = [=](double w) { return theory::line_settled_shift_ratio(w, 0, lambda); };
    return of.figure("3.45", "Shift at the limit",
                     fmt::format("Points: settled shifts at {} of the model's limit or more. "
                                 "Thesis: its fit u_lim = f^0.87 (3.5.29).",
                                 near_line_limit),
                     "f_T,lim", "u_lim [U_max]",
                     {{"exact, half-space", 0, 1, theory::line_shakedown_limit, exact, exact_line},
                      {"thesis (3.5.29)", 0, 1, std::identity(),
                       theory::thesis_line_limit_shift_ratio, of_thesis_line}},
                     settled_near_limit(near_line_limit));
}

report::Figure increments(const ThesisFigures& of) {
    std::vector<Form> forms;
    for (const double w : of.amplitudes)
        forms.push_back({"thesis (3.5.30)", theory::line_shakedown_limit(w), 1, std::identity(),
                         [=](double load) { return theory::thesis_line_increment(w, load); },
                         of_thesis_line});
    return of.figure("3.46", "Shift per period over the load",
                     "Lines: the thesis' Δu = 0.64 f_T (w − w_lim) (3.5.30) for the "
                     "amplitudes of the points.",
                     "f_T", "Δu [U_max]", forms, over_load(quantities::shift_increment_ratio));
}

report::WithError cell(const Computed& value) {
    return {value.value, value.error};
}

/// "+1.2" of a ratio 1.012.
double percent_above(double ratio) {
    return 100 * (ratio - 1);
}

report::DocumentTable settled_table(const StudyFit& fit, double lambda) {
    report::DocumentTable table{
        .id = "settled",
        .title = "Settled shifts",
        .note =
            "Exact: the uncoupled half-space at the model's own w. Differences "
            "are of the closed forms from the model.",
        .columns = report::columns("model", "group", "w:3", "f_T:3", "f_T,lim:4", "u_sd", "exact:5",
                                   "difference [%]:2", "(3.5.26):5", "difference [%]:2")};
    for (const RollingPoint& p : fit.points) {
        const Computed* settled = p.find(quantities::settled_shift_ratio);
        if (!settled) continue;
        const double w = p.amplitude_ratio, f = p.tangential_ratio, u = settled->value;
        const double exact = exact_shift(w, f, lambda);
        const double thesis = theory::thesis_line_settled_shift_ratio(w, f).value_or(std::nan(""));
        table.rows.push_back({report::display_name(p.model), p.group, w, f,
                              p.at(quantities::limit_tangential_ratio).value, cell(*settled), exact,
                              percent_above(exact / u), thesis, percent_above(thesis / u)});
    }
    return table;
}

report::DocumentTable stick_table(const StudyFit& fit) {
    report::DocumentTable table{
        .id = "sticking",
        .title = "Half width that sticks after shakedown",
        .note =
            "Of the model between its cells. Exact and (3.5.24): the uncoupled "
            "half-space at the model's own w.",
        .columns =
            report::columns("model", "group", "w:3", "f_T:3", "c_sd/a", "exact:4", "(3.5.24):4")};
    for (const RollingPoint& p : fit.points) {
        const Computed* stick = p.find(quantities::stick_ratio);
        if (!stick) continue;
        const double w = p.amplitude_ratio, f = p.tangential_ratio;
        const auto number = [](std::optional<double> c) { return c.value_or(std::nan("")); };
        table.rows.push_back({report::display_name(p.model), p.group, w, f, cell(*stick),
                              number(theory::line_stick_half_width(w, f)),
                              number(theory::thesis_line_stick_half_width(w, f))});
    }
    return table;
}

report::DocumentTable increment_table(const StudyFit& fit, double lambda) {
    report::DocumentTable table{
        .id = "increments",
        .title = "Shift per period beyond the limit",
        .note =
            "Δu/(f_T (w − w_lim)): with w_lim of (3.5.27), where the thesis has "
            "0.64 and its fit of w_lim. Carter: dΔu/dw over f_T far beyond the "
            "limit, where each way is rolled in steady state on the half-space.",
        .columns = report::columns("model", "group", "w:3", "f_T:3", "Δu", "Δu/(f_T (w − w_lim)):3",
                                   "Carter:3", "(3.5.30):4", "difference [%]:2")};
    for (const RollingPoint& p : fit.points) {
        const Computed* increment = p.find(quantities::shift_increment_ratio);
        if (!increment) continue;
        const double w = p.amplitude_ratio, f = p.tangential_ratio, du = increment->value;
        const double excess = w - theory::line_amplitude_limit(f);
        const double thesis = theory::thesis_line_increment(w, f);
        table.rows.push_back(
            {report::display_name(p.model), p.group, w, f, cell(*increment),
             excess > 0 ? du / (f * excess) : std::nan(""),
             is_half_space(p.model) ? theory::line_steady_slope(f, lambda) / f : std::nan(""),
             thesis, percent_above(thesis / du)});
    }
    return table;
}

}  // namespace

report::Document line_fit_document(const StudyFit& fit, double shift_factor) {
    report::Document document{
        .kind = "Line contacts of a sweep",
        .title = fit.title,
        .lead =
            "Settled shifts, limits and increments of a rolling cylinder beside the exact solution "
            "on the half-space and the fits of the thesis. w, f_T and u are ratios to each model's "
            "own half width, friction limit and U_max.",
        .settings = fit.settings,
        .files = {{"all numbers (JSON)", "fit.json"}},
        .command = fit.command,
        .version = fit.version};
    if (!fit.caveat.empty())
        document.verdicts.push_back({report::Verdict::Standing::not_testable, fit.caveat});
    const ThesisFigures of(fit, "", "", 1e3);
    document.sections.push_back(
        {.id = "thesis",
         .heading = "Figures of the thesis",
         .paragraphs = {"Closed forms are dashed. Bars are numerical errors."},
         .figures = with_model_points({stick_widths(of), settled(of, shift_factor), limits(of),
                                       limit_shifts(of, shift_factor), increments(of)}),
         .tables = {settled_table(fit, shift_factor), stick_table(fit),
                    increment_table(fit, shift_factor)}});
    std::erase_if(document.sections.front().tables,
                  [](const report::DocumentTable& table) { return table.rows.empty(); });
    return document;
}

}  // namespace tricontact::comparisons
