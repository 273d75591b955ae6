// The report of an identification.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"
#include "experiments/identification/identification_report.h"
#include "experiments/identification/report/loop_report.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

/// One row per model and parameter.
report::DocumentTable value_table(const IdentificationStudy& study) {
    report::DocumentTable table{
        .id = "properties",
        .title = "Values found",
        .note = fmt::format(
            "Intervals of {:g} %: low and high from the likelihood and the errors of the rig's "
            "data ({}), by the fit alone beside them; half width of the linearised one of the fit. "
            "Inputs: what the standard errors of the rig's data change, added in squares; both: "
            "with the standard error of the fit, in squares (A.1.4).",
            100 * study.models.front().found.confidence,
            study.input.rig_errors.empty() ? "none is stated"
                                           : "those stated behind ± in the case"),
        .columns = report::columns("model", "parameter", "value", "low", "high", "low by the fit",
                                   "high by the fit", "half width, linearised",
                                   "standard error of the fit", "of the inputs", "both")};
    for (const IdentifiedModel& model : study.models)
        for (std::size_t k = 0; k < model.found.free.size(); ++k) {
            const FreeParameter& p = model.found.free[k];
            const ParameterEstimate& estimate = model.found.parameters[k];
            const auto [factor, symbol] =
                p.unit.empty() ? report::Unit{} : report::fitting_unit(estimate.value, p.unit);
            const auto open_or = [f = factor](double value) {
                return std::isfinite(value) ? report::Cell(value / f) : report::Cell("open");
            };
            const Interval full = full_interval(model, k);
            table.rows.push_back(
                {model.name, symbol.empty() ? p.symbol : fmt::format("{} [{}]", p.symbol, symbol),
                 estimate.value / factor, open_or(full.low), open_or(full.high),
                 open_or(estimate.likelihood.low), open_or(estimate.likelihood.high),
                 open_or(estimate.high - estimate.value), open_or(estimate.standard_error),
                 input_standard_error(model, k) / factor,
                 open_or(combined_standard_error(model, k))});
        }
    return table;
}

report::DocumentTable goodness_table(const IdentificationStudy& study) {
    report::DocumentTable table{
        .id = "goodness",
        .title = "How well the models fit",
        .note =
            "chi^2: residuals over their standard errors, squared; p: how often noise alone "
            "exceeds it. Errors that a table does not state are estimated from its residuals "
            "(root mean square over the degrees of freedom, observations less the share of the "
            "parameters that the table determines), and only a pattern of these shows that a model "
            "does not fit it. Correlation: of neighbouring residuals, and how often independent "
            "errors leave as much.",
        .columns =
            report::columns("model", "table", "chi^2", "degrees of freedom", "p", "R^2:6",
                            "standard error of an observation [SI]:3", "interpolation error:2",
                            "correlation:2", "p of the correlation")};
    for (const IdentifiedModel& model : study.models)
        for (std::size_t t = 0; t < model.found.tables.size(); ++t) {
            const TableFit& fit = model.found.tables[t];
            const auto& correlation = model.found.residuals.at(t).correlation;
            table.rows.push_back(
                {model.name, name_of(study.input.tables[t]),
                 fit.goodness ? fit.sum_of_squares : contact::undefined, fit.degrees_of_freedom,
                 report::p_number(fit.goodness.value_or(contact::undefined)), fit.r_squared,
                 fit.residual_standard_deviation,
                 model.interpolation_error.value_or(contact::undefined),
                 correlation ? correlation->lag_one : contact::undefined,
                 report::p_number(correlation ? correlation->chance : contact::undefined)});
        }
    return table;
}

/// Of each two parameters in the linearised model; empty if there is only one.
std::optional<report::DocumentTable> correlation_table(const IdentificationStudy& study) {
    report::DocumentTable table{.id = "correlations",
                                .title = "Correlations",
                                .note = "Of what the data leave, in the linearised model.",
                                .columns = report::columns("model", "pair", "correlation:3")};
    for (const IdentifiedModel& model : study.models)
        for (std::size_t i = 0; i < model.found.free.size(); ++i)
            for (std::size_t k = i + 1; k < model.found.free.size(); ++k)
                table.rows.push_back(
                    {model.name, model.found.free[i].symbol + " and " + model.found.free[k].symbol,
                     model.found.correlation(i, k).value_or(contact::undefined)});
    if (table.rows.empty()) return {};
    return table;
}

/// What each uncertain input does.
std::optional<report::DocumentTable> input_table(const IdentificationStudy& study) {
    report::DocumentTable table{
        .id = "inputs",
        .title = "Errors of the rig's data",
        .note = "Change of a value found by one standard error of the input, to first order.",
        .columns = report::columns("model", "input", "standard error [SI]", "value",
                                   "change [SI]:3", "change [%]:3")};
    for (const IdentifiedModel& model : study.models)
        for (const InputContribution& input : model.contributions)
            for (std::size_t k = 0; k < model.found.free.size(); ++k)
                table.rows.push_back({model.name, input.key, input.standard_error,
                                      model.found.free[k].symbol, input.change[k],
                                      100 * input.change[k] / model.found.parameters[k].value});
    if (table.rows.empty()) return {};
    return table;
}

}  // namespace

report::Document identification_document(const IdentificationStudy& study) {
    report::Document document{.kind = "Identification",
                              .title = study.title,
                              .lead =
                                  "Which values explain the measurements? Every "
                                  "model is fitted by least squares on its own.",
                              .verdicts = identification_verdicts(study),
                              .settings = study.settings,
                              .files = {{"all numbers (JSON)", "identify.json"}}};
    if (study.models.size() > 1)
        document.lead +=
            " The differences between their answers are what the simpler one leaves out.";
    document.answer = document.verdicts.front();  // the values of the most complete model
    document.answer->word = "identified";
    document.verdicts.erase(document.verdicts.begin());
    report::DocumentSection fit{.id = "fit_section",
                                .heading = "Fit",
                                .figures = fit_figures(study),
                                .tables = {goodness_table(study)}};
    std::ranges::move(loop_tables(study), std::back_inserter(fit.tables));
    if (study.laws) fit.tables.push_back(law_table(*study.laws));
    if (study.interfaces) fit.tables.push_back(interface_table(*study.interfaces));
    report::DocumentSection values{.id = "values_section",
                                   .heading = "Values",
                                   .figures = parameter_figures(study),
                                   .tables = {value_table(study)}};
    if (auto inputs = input_table(study)) values.tables.push_back(std::move(*inputs));
    if (auto pairs = correlation_table(study)) values.tables.push_back(std::move(*pairs));
    document.sections = {std::move(fit), std::move(values)};
    const bool has_posterior = std::ranges::any_of(
        study.models, [](const IdentifiedModel& model) { return model.posterior.has_value(); });
    if (study.loops) document.files.push_back({"cycles", "loops.csv"});
    if (has_posterior) document.files.push_back({"points of the posterior", "posterior.csv"});
    return document;
}

}  // namespace tricontact::experiments
