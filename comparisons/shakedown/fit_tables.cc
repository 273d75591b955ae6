#include <cmath>

#include "comparisons/shakedown/fit_document.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

void add(std::vector<FitRow>& rows, const std::string& model, const std::string& group,
         const std::optional<FittedForm>& form) {
    for (std::size_t k = 0; form && k < form->parameters.size(); ++k)
        rows.push_back({model, group, &*form, k});
}

}  // namespace

std::vector<FitRow> mapping_rows(const StudyFit& fit) {
    std::vector<FitRow> rows;
    for (const MappingGroup& group : fit.mapping) {
        add(rows, group.model, group.group, group.constant);
        add(rows, group.model, group.group, group.plane);
    }
    return rows;
}

std::vector<FitRow> ratcheting_rows(const StudyFit& fit) {
    std::vector<FitRow> rows;
    for (const RatchetingGroup& group : fit.ratcheting) {
        add(rows, group.model, group.group, group.limit);
        for (const RatchetingLoad& load : group.loads)
            add(rows, group.model,
                group.group + ", f_T = " + report::as_given(load.tangential_ratio), load.slope);
        add(rows, group.model, group.group, group.root);
        add(rows, group.model, group.group, group.root_of_eta);
    }
    return rows;
}

report::DocumentTable form_table(const std::string& id, const std::string& title,
                                 const std::vector<FitRow>& rows) {
    report::DocumentTable table{
        .id = id,
        .title = title,
        .note =
            "Of the form's left side: SSE, the sum of squared errors (observed minus fitted), as "
            "in table A.1.1 of the thesis; SSR, the sum of squares of the regression (fitted "
            "minus mean); R² = SSR/(SSR + SSE). Residuals of a model are no noise: the interval "
            "measures how well the form describes the model.",
        .columns =
            report::columns("model", "group", "form", "parameter", "value:5", "standard error:2",
                            "low:5", "high:5", "SSE:3", "SSR:3", "R²:6", "points")};
    for (const auto& [model, group, form, k] : rows) {
        const statistics::Estimate& e = form->fit.parameters[k];
        const Goodness& g = form->of_left_side;
        table.rows.push_back({report::display_name(model), group, form->form, form->parameters[k],
                              e.value, e.standard_error, e.low, e.high, g.residual, g.explained,
                              g.r_squared, static_cast<int>(form->fit.fitted.size())});
    }
    return table;
}

report::DocumentTable mapping_use_table(const StudyFit& fit) {
    report::DocumentTable table{
        .id = "one_kappa",
        .title = "Settled shifts by one κ",
        .note =
            "u by κ over u_sd of the model, minus 1. A smaller κ moves the limit up; with a "
            "larger one some points would not settle.",
        .columns = report::columns("model", "group", "κ of", "κ", "median of magnitudes [%]:3",
                                   "worst [%]:3", "at w:3", "at f_T:3", "points",
                                   "beyond the numerical error", "would ratchet")};
    for (const MappingGroup& group : fit.mapping) {
        if (group.points.empty()) continue;
        for (const MappingUse& use : group.uses)
            table.rows.push_back(
                {report::display_name(group.model), group.group, use.name, use.kappa,
                 100 * use.median, 100 * use.worst, use.worst_amplitude_ratio,
                 use.worst_tangential_ratio, use.n,
                 use.n_with_bars > 0 ? static_cast<double>(use.n_beyond_bars) : std::nan(""),
                 use.n_ratcheting});
    }
    return table;
}

report::DocumentTable difference_table(const StudyFit& fit) {
    report::DocumentTable table{
        .id = "differences",
        .title = "Models side by side",
        .note =
            "First over second, minus 1, each in its own units (a, U_max). Worst: of the "
            "points where the bars do not overlap, else of all.",
        .columns =
            report::columns("quantity", "first", "second", "group", "median of magnitudes [%]:3",
                            "worst [%]:3", "points", "with error bars", "different beyond them")};
    for (const ModelDifference& d : fit.differences)
        table.rows.push_back({d.quantity->symbol, report::display_name(d.first),
                              report::display_name(d.second), d.group, 100 * d.median(),
                              report::WithError{100 * d.worst().relative(), 100 * d.worst().bar()},
                              static_cast<int>(d.points.size()), d.n_with_bars(), d.n_different()});
    return table;
}

report::DocumentTable point_difference_table(const StudyFit& fit) {
    report::DocumentTable table{
        .id = "point_differences",
        .title = "Settled shifts and shifts per period, point by point",
        .columns = report::columns("quantity", "first", "second", "group", "w:3", "f_T:3",
                                   "first's value", "second's value", "difference [%]", "verdict")};
    for (const ModelDifference& d : fit.differences) {
        if (d.quantity != &quantities::settled_shift && d.quantity != &quantities::shift_increment)
            continue;
        for (const PointDifference& p : d.points) {
            const bool known = p.first.has_bar() && p.second.has_bar();
            table.rows.push_back({d.quantity->symbol, report::display_name(d.first),
                                  report::display_name(d.second), d.group, p.amplitude_ratio,
                                  p.tangential_ratio,
                                  report::WithError{p.first.value, p.first.error},
                                  report::WithError{p.second.value, p.second.error},
                                  report::WithError{100 * p.relative(), 100 * p.bar()},
                                  std::string(!known                       ? "not resolved"
                                              : differs(p.first, p.second) ? "different"
                                                                           : "within the error")});
        }
    }
    return table;
}

}  // namespace tricontact::comparisons
