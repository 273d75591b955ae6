// The report of an identification.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/special_values.h"
#include "experiments/identification/identification_report.h"
#include "report/format.h"
#include "statistics/regression.h"

namespace tricontact::experiments {

namespace {

/// Numbers over the unit that fits the largest of them.
struct Scaled {
    report::Unit unit;  // numbers without a unit stay as they are

    Scaled(const std::vector<double>& values, std::string_view base) {
        double largest = 0;
        for (const double value : values) largest = std::max(largest, std::abs(value));
        if (!base.empty()) unit = report::fitting_unit(largest, std::string(base));
    }
    std::vector<double> operator()(std::vector<double> values) const {
        for (double& value : values) value /= unit.factor;
        return values;
    }
    std::string label(std::string_view name) const {
        return fmt::format("{} [{}]", name, unit.symbol);
    }
};

// Normal errors are known ones; half widths of the observed values' intervals.
std::vector<double> error_bars(const IdentificationStudy& study) {
    std::vector<double> bars;
    for (const double error : study.input.standard_errors)
        bars.push_back(statistics::normal_quantile(study.models.front().found.confidence) * error);
    return bars;
}

/// Values in the order of increasing `x`.
std::vector<double> ordered(const std::vector<double>& x, const std::vector<double>& values) {
    std::vector<std::size_t> order(x.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](std::size_t i) { return x[i]; });
    std::vector<double> result;
    for (const std::size_t i : order) result.push_back(values[i]);
    return result;
}

report::Figure fit_figure(const IdentificationStudy& study) {
    const auto& columns = columns_of(study.input.measurement);
    const auto& x = study.input.given;
    const Scaled given(x, columns.given.unit),
        observed(study.input.observed, columns.observed.unit);
    report::Figure figure{
        .id = "fit",
        .title = "What was measured, and the models at their best",
        .caption = fmt::format(
            "Bands: where the fitted curves lie with a confidence of {:g} %{}.",
            100 * study.models.front().found.confidence,
            study.input.standard_errors.empty() ? "" : "; bars: the same of the observed values"),
        .x = {given.label(columns.given.axis)},
        .y = {observed.label(columns.observed.axis)}};
    for (const IdentifiedModel& model : study.models) {
        const bool curved = !model.curve.empty();
        figure.curves.push_back(
            {.name = model.name,
             .x = given(curved ? study.curve_points : ordered(x, x)),
             .y = observed(curved ? model.curve : ordered(x, model.found.fitted))});
        const auto& widths = model.found.fitted_half_widths;
        if (widths.empty()) continue;
        std::vector<double> low, high;
        for (std::size_t i = 0; i < widths.size(); ++i) {
            low.push_back(model.found.fitted[i] - widths[i]);
            high.push_back(model.found.fitted[i] + widths[i]);
        }
        figure.bands.push_back({.name = model.name,
                                .x = given(ordered(x, x)),
                                .low = observed(ordered(x, low)),
                                .high = observed(ordered(x, high))});
    }
    figure.curves.push_back({.name = "measured",
                             .x = given(x),
                             .y = observed(study.input.observed),
                             .y_error = observed(error_bars(study)),
                             .kind = report::Curve::Kind::points});
    return figure;
}

report::Figure residual_figure(const IdentificationStudy& study) {
    std::vector<double> all;
    for (const IdentifiedModel& model : study.models)
        all.insert(all.end(), model.found.residuals.begin(), model.found.residuals.end());
    const auto& columns = columns_of(study.input.measurement);
    const Scaled given(study.input.given, columns.given.unit), scale(all, columns.observed.unit);
    report::Figure figure{.id = "residuals",
                          .title = "What the models leave unexplained",
                          .caption =
                              "Observed minus fitted. Without a pattern the rest is noise; a wave "
                              "or a bend is a model that does not fit.",
                          .x = {given.label(columns.given.axis)},
                          .y = {scale.label("residual")}};
    for (const IdentifiedModel& model : study.models)
        figure.curves.push_back({.name = model.name,
                                 .x = given(study.input.given),
                                 .y = scale(model.found.residuals),
                                 .y_error = scale(error_bars(study)),
                                 .kind = report::Curve::Kind::points});
    const auto [low, high] = std::ranges::minmax(given(study.input.given));
    figure.curves.push_back({.name = "", .x = {low, high}, .y = {0, 0}, .theory = true});
    return figure;
}

/// Sums of squares from 0 at the best to 1 at the edge of the interval.
std::vector<double> relative(const std::vector<double>& sums, const Identification& found,
                             double level) {
    std::vector<double> result;
    for (const double sum : sums)
        result.push_back(std::isfinite(sum)
                             ? (sum - found.sum_of_squares) / (level - found.sum_of_squares)
                             : contact::undefined);
    return result;
}

std::optional<report::Figure> profile_figure(const IdentificationStudy& study, Property property) {
    const bool young = property == Property::young;
    std::vector<double> all;
    for (const IdentifiedModel& model : study.models)
        if (const auto& profile = model.profiles[property])
            all.insert(all.end(), profile->value.begin(), profile->value.end());
    if (all.empty()) return {};
    const Scaled scale(all, young ? "Pa" : "");
    report::Figure figure{
        .id = young ? "profile_E" : "profile_mu",
        .title = young ? "Profile of E" : "Profile of mu",
        .caption = fmt::format(
            "Sum of squares with this value held and what else is free at its best: 0 at the best, "
            "1 at the edges of the {:g} % interval of the likelihood. A parabola where the "
            "linearised interval would do; a curve that stays below 1 tells no bound.",
            100 * study.models.front().found.confidence),
        .x = {young ? scale.label("modulus E") : "friction coefficient mu"},
        .y = {"excess of the sum of squares"}};
    for (const IdentifiedModel& model : study.models)
        if (const auto& profile = model.profiles[property])
            figure.curves.push_back({.name = model.name,
                                     .x = scale(profile->value),
                                     .y = relative(profile->sum_of_squares, model.found,
                                                   model.found.level_of_interval[0])});
    const auto [low, high] = std::ranges::minmax(scale(all));
    figure.curves.push_back(
        {.name = "edge of the interval", .x = {low, high}, .y = {1, 1}, .theory = true});
    return figure;
}

/// What a correlation of E and mu means, where there is one to two digits.
std::string correlation_text(std::optional<double> correlation) {
    if (!correlation || !(std::abs(*correlation) >= 0.005)) return "";
    return fmt::format("Correlation {}: more friction is answered by a {} modulus. ",
                       report::significant(*correlation, 2),
                       *correlation < 0 ? "smaller" : "larger");
}

report::Figure map_figure(const IdentifiedModel& model) {
    const Scaled scale(model.map->young, "Pa");
    const Identification& found = model.found;
    report::Figure figure{
        .id = "map_" + report::id_of_model(model.name),
        .title = "E and mu together: " + model.name,
        .caption = fmt::format(
            "Sum of squares, 0 at the best values (point), 1 at the edge of the region that holds "
            "both with a confidence of {:g} %. {}White: the largest force would slide.",
            100 * found.confidence, correlation_text(found.correlation)),
        .x = {scale.label("modulus E")},
        .y = {"friction coefficient mu"}};
    figure.map =
        report::ContourMap{.label = "excess of the sum of squares",
                           .x = scale(model.map->young),
                           .y = model.map->friction,
                           .values = relative(model.map->values, found, found.level_of_interval[1]),
                           .levels = {.25, 1, 4}};
    figure.curves.push_back({.name = "best values",
                             .x = scale({found.best.young}),
                             .y = {found.best.friction},
                             .kind = report::Curve::Kind::points});
    return figure;
}

/// Its points, thinned.
std::optional<report::Figure> posterior_figure(const IdentifiedModel& model) {
    constexpr std::size_t most_drawn = 1500;
    if (!model.posterior || !model.found.young || !model.found.friction) return {};
    std::vector<double> young, friction;
    const auto& points = model.posterior->points;
    const std::size_t every = points.size() / most_drawn + 1;
    for (std::size_t i = 0; i < points.size(); i += every) {
        young.push_back(points[i].young);
        friction.push_back(points[i].friction);
    }
    const Scaled scale(young, "Pa");
    return report::Figure{.id = "posterior_" + report::id_of_model(model.name),
                          .title = "What the data leave: " + model.name,
                          .caption = posterior_sentence(model) +
                                     " Points of the posterior density, thinned; the uncertain "
                                     "inputs take all their values.",
                          .x = {scale.label("modulus E")},
                          .y = {"friction coefficient mu"},
                          .curves = {{.name = "posterior",
                                      .x = scale(young),
                                      .y = friction,
                                      .kind = report::Curve::Kind::points}}};
}

/// One row per model and property.
report::DocumentTable value_table(const IdentificationStudy& study) {
    report::DocumentTable table{
        .id = "properties",
        .title = "Properties found",
        .note = fmt::format(
            "Intervals of {:g} %: low and high from the likelihood and the errors of the rig's "
            "data ({}), by the fit alone beside them; half width of the linearised one of the fit. "
            "Inputs: what the standard errors of the rig's data change, added in squares; both: "
            "with the standard error of the fit, in squares (A.1.4).",
            100 * study.models.front().found.confidence,
            study.input.rig_errors.empty() ? "none is stated"
                                           : "those stated behind ± in the case"),
        .columns = report::columns("model", "property", "value", "low", "high", "low by the fit",
                                   "high by the fit", "half width, linearised",
                                   "standard error of the fit", "of the inputs", "both")};
    for (const IdentifiedModel& model : study.models)
        for (const Property property : both_properties) {
            const bool young = property == Property::young;
            const auto& estimate = model.found[property];
            if (!estimate) continue;
            const double factor = young ? 1e6 : 1;
            const auto open_or = [factor](double value) {
                return std::isfinite(value) ? report::Cell(value / factor) : report::Cell("open");
            };
            const Interval full = full_interval(model, property);
            table.rows.push_back(
                {model.name, young ? "E [MPa]" : "mu", estimate->value / factor, open_or(full.low),
                 open_or(full.high), open_or(estimate->likelihood.low),
                 open_or(estimate->likelihood.high), open_or(estimate->high - estimate->value),
                 open_or(estimate->standard_error), input_standard_error(model, property) / factor,
                 open_or(combined_standard_error(model, property))});
        }
    return table;
}

report::DocumentTable goodness_table(const IdentificationStudy& study) {
    const bool known = !study.input.standard_errors.empty();
    report::DocumentTable table{
        .id = "goodness",
        .title = "How well the models fit",
        .note = known ? "chi^2: residuals over their standard errors, squared; p: how often noise "
                        "alone exceeds it."
                      : "Standard errors of the observed values are not stated: they are estimated "
                        "from the residuals, and nothing says whether a model fits.",
        .columns =
            report::columns("model", known ? "chi^2" : "sum of squares [SI]", "degrees of freedom",
                            "p", "R^2:6", "correlation of E and mu:3", "interpolation error:2")};
    for (const IdentifiedModel& model : study.models) {
        const Identification& found = model.found;
        table.rows.push_back({model.name, found.sum_of_squares,
                              std::to_string(found.degrees_of_freedom),
                              report::p_number(found.goodness.value_or(contact::undefined)),
                              found.r_squared, found.correlation.value_or(contact::undefined),
                              model.interpolation_error.value_or(contact::undefined)});
    }
    return table;
}

/// What each uncertain input does.
std::optional<report::DocumentTable> input_table(const IdentificationStudy& study) {
    report::DocumentTable table{
        .id = "inputs",
        .title = "Errors of the rig's data",
        .note = "Change of the property by one standard error of the input, to first order.",
        .columns = report::columns("model", "input", "standard error [SI]", "change of E [MPa]:3",
                                   "change of mu:3")};
    for (const IdentifiedModel& model : study.models)
        for (const InputContribution& input : model.contributions)
            table.rows.push_back(
                {model.name, input.key, input.standard_error,
                 model.found.young ? input.change.young / 1e6 : contact::undefined,
                 model.found.friction ? input.change.friction : contact::undefined});
    if (table.rows.empty()) return {};
    return table;
}

}  // namespace

report::Document identification_document(const IdentificationStudy& study) {
    report::Document document{.kind = "Identification",
                              .title = study.title,
                              .lead =
                                  "Which Young's modulus, and which friction, do the measured "
                                  "values have? Every model is fitted by least squares on its own.",
                              .verdicts = identification_verdicts(study),
                              .settings = study.settings,
                              .files = {{"all numbers (JSON)", "identify.json"}}};
    if (study.models.size() > 1)
        document.lead +=
            " The differences between their answers are what the simpler one leaves out.";
    report::DocumentSection fit{.id = "fit_section",
                                .heading = "Fit",
                                .figures = {fit_figure(study), residual_figure(study)},
                                .tables = {goodness_table(study)}};
    report::DocumentSection values{
        .id = "values_section", .heading = "Properties", .tables = {value_table(study)}};
    if (auto inputs = input_table(study)) values.tables.push_back(std::move(*inputs));
    for (const Property property : both_properties)
        if (auto figure = profile_figure(study, property))
            values.figures.push_back(std::move(*figure));
    for (const IdentifiedModel& model : study.models)
        if (model.map) values.figures.push_back(map_figure(model));
    for (const IdentifiedModel& model : study.models)
        if (auto figure = posterior_figure(model)) values.figures.push_back(std::move(*figure));
    document.sections = {std::move(fit), std::move(values)};
    const bool has_posterior = std::ranges::any_of(
        study.models, [](const IdentifiedModel& model) { return model.posterior.has_value(); });
    if (has_posterior) document.files.push_back({"points of the posterior", "posterior.csv"});
    return document;
}

}  // namespace tricontact::experiments
