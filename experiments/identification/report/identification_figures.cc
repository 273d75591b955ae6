// The figures of an identification.

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <numeric>

#include "contact/base/special_values.h"
#include "experiments/identification/friction_values.h"
#include "experiments/identification/identification_report.h"
#include "experiments/identification/report/loop_report.h"
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
std::vector<double> error_bars(const IdentificationStudy& study, std::size_t t) {
    std::vector<double> bars;
    for (const double error : study.input.tables[t].standard_errors)
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

/// Of a table, with the words in front where there are several.
std::string id_of(const IdentificationStudy& study, const std::string& word, std::size_t t) {
    if (study.input.tables.size() == 1) return word;
    const auto& table = study.input.tables[t];
    const std::string name(name_of(table.measurement));
    return word + "_" + boost::replace_all_copy(name, "-", "_") +
           (table.place > 0 ? fmt::format("_{}", table.place + 1) : "");
}

/// With the table's file where there are several of its kind.
std::string title_of(const std::string& title, const IdentificationInput::Table& table) {
    return table.label.empty() ? title : title + ": " + table.label;
}

/// Of a model's fitted values, or of further observations where a posterior tells them.
report::Band band_of(const IdentifiedModel& model, std::size_t t, std::size_t first_row,
                     const std::vector<double>& x, const Scaled& given, const Scaled& observed) {
    const TableFit& fit = model.found.tables[t];
    std::vector<double> low, high;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (model.posterior) {
            low.push_back(model.posterior->predicted[first_row + i].low);
            high.push_back(model.posterior->predicted[first_row + i].high);
        } else {
            low.push_back(fit.fitted[i] - fit.fitted_half_widths[i]);
            high.push_back(fit.fitted[i] + fit.fitted_half_widths[i]);
        }
    }
    return {.name = model.name,
            .x = given(ordered(x, x)),
            .low = observed(ordered(x, low)),
            .high = observed(ordered(x, high))};
}

/// Fitted values of a table of several loads, a curve for each.
void add_loads(const IdentificationStudy& study, const IdentifiedModel& model, std::size_t t,
               const Scaled& given, const Scaled& observed, report::Figure& figure) {
    const auto& table = study.input.tables[t];
    for (const LoadedRows& load : rows_by_load(table, study.input.rig, table.given)) {
        std::vector<double> fitted;
        for (const std::size_t row : load.rows) fitted.push_back(model.found.tables[t].fitted[row]);
        figure.curves.push_back({.name = fmt::format("{}, F_N = {}", model.name,
                                                     report::quantity(load.normal_force, "N", 3)),
                                 .x = given(ordered(load.given, load.given)),
                                 .y = observed(ordered(load.given, fitted))});
    }
}

report::Figure fit_figure(const IdentificationStudy& study, std::size_t t, std::size_t first_row) {
    const auto& table = study.input.tables[t];
    const auto& columns = columns_of(table.measurement);
    const auto& x = table.given;
    const Scaled given(x, columns.given.unit), observed(table.observed, columns.observed.unit);
    const bool is_predictive =
        std::ranges::all_of(study.models, [](const auto& m) { return m.posterior.has_value(); });
    report::Figure figure{
        .id = id_of(study, "fit", t),
        .title = title_of("What was measured, and the models at their best", table),
        .caption = fmt::format(
            "{}: where {} with a confidence of {:g} %{}.",
            table.normal_forces.empty() ? "Bands"
                                        : "A curve under each load; bands of other tables",
            is_predictive ? "the posterior predicts further observations to lie"
                          : "the fitted curves lie",
            100 * study.models.front().found.confidence,
            table.standard_errors.empty() ? "" : "; bars: the same of the observed values"),
        .x = {given.label(columns.given.axis)},
        .y = {observed.label(columns.observed.axis)}};
    for (const IdentifiedModel& model : study.models) {
        if (!table.normal_forces.empty()) {
            add_loads(study, model, t, given, observed, figure);
            continue;
        }
        const bool curved = !model.curves.empty();
        figure.curves.push_back(
            {.name = model.name,
             .x = given(curved ? study.curve_points[t] : ordered(x, x)),
             .y = observed(curved ? model.curves[t] : ordered(x, model.found.tables[t].fitted))});
        if (!is_predictive || model.posterior)
            figure.bands.push_back(band_of(model, t, first_row, x, given, observed));
    }
    figure.curves.push_back({.name = "measured",
                             .x = given(x),
                             .y = observed(table.observed),
                             .y_error = observed(error_bars(study, t)),
                             .kind = report::Curve::Kind::points});
    return figure;
}

report::Figure residual_figure(const IdentificationStudy& study, std::size_t t) {
    std::vector<double> all;
    for (const IdentifiedModel& model : study.models)
        std::ranges::copy(model.found.tables[t].residuals, std::back_inserter(all));
    const auto& table = study.input.tables[t];
    const auto& columns = columns_of(table.measurement);
    const Scaled given(table.given, columns.given.unit), scale(all, columns.observed.unit);
    report::Figure figure{.id = id_of(study, "residuals", t),
                          .title = title_of("What the models leave unexplained", table),
                          .caption =
                              "Observed minus fitted. Without a pattern the rest is noise; a wave "
                              "or a bend is a model that does not fit.",
                          .x = {given.label(columns.given.axis)},
                          .y = {scale.label("residual")}};
    for (const IdentifiedModel& model : study.models)
        figure.curves.push_back({.name = model.name,
                                 .x = given(table.given),
                                 .y = scale(model.found.tables[t].residuals),
                                 .y_error = scale(error_bars(study, t)),
                                 .kind = report::Curve::Kind::points});
    const auto [low, high] = std::ranges::minmax(given(table.given));
    figure.curves.push_back({.name = "", .x = {low, high}, .y = {0, 0}, .theory = true});
    return figure;
}

/// Sums of squares from 0 at the best to 1 at a level.
std::vector<double> relative(const std::vector<double>& sums, const Identification& found,
                             double level) {
    std::vector<double> result;
    for (const double sum : sums)
        result.push_back(std::isfinite(sum)
                             ? (sum - found.sum_of_squares) / (level - found.sum_of_squares)
                             : contact::undefined);
    return result;
}

std::string axis_label(const FreeParameter& p, const Scaled& scale) {
    return p.unit.empty() ? p.symbol : scale.label(p.symbol);
}

report::Figure profile_figure(const IdentificationStudy& study, const FreeParameter& p) {
    std::vector<double> all;
    for (const IdentifiedModel& model : study.models)
        if (const auto k = model.found.find(p.key, p.index))
            std::ranges::copy(model.profiles[*k].value, std::back_inserter(all));
    const Scaled scale(all, p.unit);
    report::Figure figure{
        .id = "profile_" + p.symbol,
        .title = "Profile of " + p.symbol,
        .caption = fmt::format(
            "Sum of squares with this value held and what else is free at its best: 0 at the best, "
            "1 at the edges of the {:g} % interval of the likelihood. A parabola where the "
            "linearised interval would do; a curve that stays below 1 has no bound.",
            100 * study.models.front().found.confidence),
        .x = {axis_label(p, scale)},
        .y = {"excess of the sum of squares"}};
    for (const IdentifiedModel& model : study.models)
        if (const auto k = model.found.find(p.key, p.index))
            figure.curves.push_back({.name = model.name,
                                     .x = scale(model.profiles[*k].value),
                                     .y = relative(model.profiles[*k].sum_of_squares, model.found,
                                                   model.found.parameters[*k].level)});
    const auto [low, high] = std::ranges::minmax(scale(all));
    figure.curves.push_back(
        {.name = "edge of the interval", .x = {low, high}, .y = {1, 1}, .theory = true});
    return figure;
}

/// What a correlation means, where there is one to two digits.
std::string correlation_text(std::optional<double> correlation) {
    if (!correlation || !(std::abs(*correlation) >= 0.005)) return "";
    return fmt::format(" Correlation {}.", report::significant(*correlation, 2));
}

report::Figure map_figure(const IdentifiedModel& model, const SquaresMap& map) {
    const Identification& found = model.found;
    const FreeParameter &p = found.free[map.first], &q = found.free[map.second];
    const Scaled x(map.x, p.unit), y(map.y, q.unit);
    report::Figure figure{
        .id = fmt::format("map_{}_{}_{}", report::id_of_model(model.name), p.symbol, q.symbol),
        .title = fmt::format("{} and {} together: {}", p.symbol, q.symbol, model.name),
        .caption = fmt::format(
            "Sum of squares, 0 at the best values (point), 1 at the edge of the region that holds "
            "both with a confidence of {:g} %.{}{} White: no such contact.",
            100 * found.confidence, correlation_text(found.correlation(map.first, map.second)),
            found.free.size() > 2 ? " What else is free follows to first order." : ""),
        .x = {axis_label(p, x)},
        .y = {axis_label(q, y)}};
    figure.map = report::ContourMap{
        .label = "excess of the sum of squares",
        .x = x(map.x),
        .y = y(map.y),
        .values = relative(map.values, found, found.level_of_pair(map.first, map.second)),
        .levels = {.25, 1, 4}};
    figure.curves.push_back({.name = "best values",
                             .x = x({found.parameters[map.first].value}),
                             .y = y({found.parameters[map.second].value}),
                             .kind = report::Curve::Kind::points});
    return figure;
}

/// Its points, thinned.
report::Figure posterior_figure(const IdentifiedModel& model, std::size_t i, std::size_t k) {
    constexpr std::size_t most_drawn = 1500;
    std::vector<double> u, v;
    const auto& points = model.posterior->points;
    const std::size_t every = points.size() / most_drawn + 1;
    for (std::size_t n = 0; n < points.size(); n += every) {
        u.push_back(points[n][i]);
        v.push_back(points[n][k]);
    }
    const FreeParameter &p = model.found.free[i], &q = model.found.free[k];
    const Scaled x(u, p.unit), y(v, q.unit);
    return {.id = fmt::format("posterior_{}_{}_{}", report::id_of_model(model.name), p.symbol,
                              q.symbol),
            .title =
                fmt::format("What the data leave of {} and {}: {}", p.symbol, q.symbol, model.name),
            .caption = posterior_sentence(model) +
                       " Points of the posterior density, thinned; the uncertain inputs take all "
                       "their values.",
            .x = {axis_label(p, x)},
            .y = {axis_label(q, y)},
            .curves = {
                {.name = "posterior", .x = x(u), .y = y(v), .kind = report::Curve::Kind::points}}};
}

}  // namespace

std::vector<report::Figure> fit_figures(const IdentificationStudy& study) {
    std::vector<report::Figure> figures;
    std::size_t row = 0;
    for (std::size_t t = 0; t < study.input.tables.size(); ++t) {
        const bool is_loop = !study.input.tables[t].loops.loops.empty();
        figures.push_back(is_loop ? loop_figure(study, t) : fit_figure(study, t, row));
        figures.push_back(residual_figure(study, t));
        row += study.input.tables[t].observed.size();
    }
    if (study.loops) figures.push_back(loop_friction_figure(study));
    return figures;
}

std::vector<report::Figure> parameter_figures(const IdentificationStudy& study) {
    std::vector<report::Figure> figures;
    for (const FreeParameter& p : reference_model(study).found.free)
        figures.push_back(profile_figure(study, p));
    for (const IdentifiedModel& model : study.models)
        for (const SquaresMap& map : model.maps) figures.push_back(map_figure(model, map));
    for (const IdentifiedModel& model : study.models)
        if (model.posterior)
            for (const SquaresMap& map : model.maps)
                figures.push_back(posterior_figure(model, map.first, map.second));
    return figures;
}

}  // namespace tricontact::experiments
