// Friction loops beside those of models: sentences, table, figure and JSON.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "contact/base/special_values.h"
#include "experiments/identification/report/loop_report.h"
#include "experiments/predictions/loop_predictions.h"
#include "report/format.h"
#include "report/json_number.h"

namespace tricontact::experiments {

namespace {

using json = nlohmann::ordered_json;
using report::Verdict;
using enum Verdict::Standing;

double half_width(const LoopNumber& number, double confidence) {
    return statistics::normal_quantile(confidence) * number.standard_error();
}

/// "-1.2 % ± 0.8 %" of what is predicted.
std::string relative_text(const LoopNumber& number, double confidence) {
    return fmt::format("{:+.2g} % ± {:.2g} %", 100 * number.difference() / number.predicted,
                       100 * half_width(number, confidence) / std::abs(number.predicted));
}

/// A number and the series it is of.
struct Place {
    const LoopNumber* number = nullptr;
    std::size_t series = 0;
    double deviations() const {
        const double error = number->standard_error();
        const double difference = std::abs(number->difference());
        return error > 0 ? difference / error : difference > 0 ? contact::infinity : 0;
    }
};

std::vector<Place> compared(const LoopPrediction& prediction) {
    std::vector<Place> places;
    for (const SeriesPrediction& series : prediction.series)
        for (const LoopNumber& number : series.numbers)
            if (number.is_compared() && !number.is_found)
                places.push_back({&number, series.series});
    return places;
}

/// Series whose regime is not the model's; "mixed" ones have none that a model could have.
std::string other_regimes(const LoopPrediction& prediction, const LoopFindings& findings) {
    std::string text;
    for (const SeriesPrediction& series : prediction.series) {
        const LoopSeries& measured = findings.series[series.series];
        const std::string regime = comparisons::name_of(series.regime);
        if (measured.regime == "mixed" || measured.regime == regime) continue;
        text += fmt::format("{}{}: {} measured (confidence {}), {} computed",
                            text.empty() ? "" : "; ", loop_series_text(measured), measured.regime,
                            report::share(std::max(0., measured.confidence), 3), regime);
    }
    return text;
}

Verdict verdict_of(const LawPrediction& law, const LoopPrediction& prediction,
                   const IdentificationStudy& study, double confidence) {
    const auto places = compared(prediction);
    const auto furthest = std::ranges::max_element(places, {}, &Place::deviations);
    // Of all numbers together (Bonferroni).
    const double level = 1 - (1 - confidence) / static_cast<double>(places.size());
    const bool agrees = furthest->deviations() <= statistics::normal_quantile(level);
    const auto& findings = *study.loops;
    const std::string regimes = other_regimes(prediction, findings);
    double deviation = 0;
    for (const SeriesPrediction& series : prediction.series)
        deviation = std::max(deviation, series.deviation);
    std::string sentence = fmt::format(
        "{} under {} {} with the measured loops: furthest off is the {} of {}, measured minus "
        "computed {} ({} of {} numbers together); force at most {} of its amplitude off (root mean "
        "square of a cycle). ",
        prediction.model, law.law, agrees ? "agrees" : "does not agree", furthest->number->name,
        loop_series_text(findings.series[furthest->series]),
        relative_text(*furthest->number, level), report::share(confidence), places.size(),
        report::share(deviation, 2));
    sentence +=
        regimes.empty() ? "Its regimes are the measured ones." : "Regimes differ: " + regimes + ".";
    if (!prediction.why_no_mesh_error.empty())
        sentence += " The error of its mesh is not known: " + prediction.why_no_mesh_error + ".";
    return {.standing = agrees ? pass : fail,
            .sentence = std::move(sentence),
            .subject = prediction.model + " under " + law.law,
            .number = relative_text(*furthest->number, level),
            .threshold = fmt::format("0 within {}", report::share(confidence))};
}

report::DocumentTable number_table(const IdentificationStudy& study,
                                   const LoopPredictions& predictions) {
    report::DocumentTable table{
        .id = "loop_predictions",
        .title = "Measured and computed loops",
        .note = fmt::format(
            "A row per law, model, series and number; half widths of {}. Stiffnesses are read from "
            "the rows of both loops alike: secant, between the last twentieths of both branches; "
            "initial, over the first {} of the way of a branch, or of that to sliding. Errors: of "
            "the rows; of what was found (E, mu, k_rig) and of the inputs; of the model's mesh and "
            "steps. The shift at which all slides is measured by what was found, and computed in "
            "gross slip. What was found is from the same loops, so that the half width is an upper "
            "bound.",
            report::share(predictions.confidence), report::share(stiff_part)),
        .columns =
            report::columns("law", "model", "series", "number", "measured", "computed",
                            "measured - computed [%]:2", "half width [%]:2", "by the rows [%]:2",
                            "by the values [%]:2", "by the resolution [%]:2")};
    const double quantile = statistics::normal_quantile(predictions.confidence);
    for (const LawPrediction& law : predictions.laws)
        for (const LoopPrediction& model : law.models)
            for (const SeriesPrediction& series : model.series)
                for (const LoopNumber& n : series.numbers) {
                    if (!std::isfinite(n.measured)) continue;
                    const auto [factor, symbol] = report::fitting_unit(n.measured, n.unit);
                    const double percent = 100 / std::abs(n.predicted);
                    table.rows.push_back(
                        {law.law, model.model, loop_series_text(study.loops->series[series.series]),
                         fmt::format("{} [{}]", n.name, symbol), n.measured / factor,
                         n.predicted / factor, percent * n.difference(),
                         percent * half_width(n, predictions.confidence),
                         percent * quantile * n.noise, percent * quantile * n.by_values,
                         percent * quantile * n.by_resolution});
                }
    return table;
}

/// Middle cycles of all series of a table, measured, and by each model under the best law.
report::Figure figure_of(const IdentificationStudy& study, const LawPrediction& law,
                         std::size_t t) {
    const auto& table = study.input.tables[t];
    const auto shift = report::fitting_unit(table.loops.loops.front().amplitude, "m"),
               force = report::fitting_unit(std::ranges::max(table.observed), "N");
    report::Figure figure{.id = fmt::format("computed_loops_{}", t + 1),
                          .title = "Computed loops beside measured ones",
                          .caption =
                              "The middle cycle of each series, measured and by the models "
                              "under " +
                              law.law + ".",
                          .x = {fmt::format("shift [{}]", shift.symbol)},
                          .y = {fmt::format("tangential force [{}]", force.symbol)}};
    report::Curve measured{.name = "measured", .kind = report::Curve::Kind::points};
    const auto part = [](const std::vector<double>& values, const MeasuredLoop& loop,
                         double factor) {
        std::vector<double> some;
        for (std::size_t i = 0; i < loop.n; ++i) some.push_back(values[loop.first + i] / factor);
        return some;
    };
    for (const LoopPrediction& model : law.models)
        for (const SeriesPrediction& series : model.series) {
            if (series.table != t) continue;
            const MeasuredLoop& loop = table.loops.loops[series.loop];
            auto x = part(table.given, loop, shift.factor);
            if (&model == &law.models.front()) {
                const auto y = part(table.observed, loop, force.factor);
                measured.x.insert(measured.x.end(), x.begin(), x.end());
                measured.y.insert(measured.y.end(), y.begin(), y.end());
            }
            std::vector<double> y = series.forces;
            for (double& value : y) value /= force.factor;
            x.push_back(x.front());
            y.push_back(y.front());
            figure.curves.push_back(
                {.name = fmt::format("{}, {}", model.model,
                                     loop_series_text(study.loops->series[series.series])),
                 .x = std::move(x),
                 .y = std::move(y)});
        }
    figure.curves.push_back(std::move(measured));
    return figure;
}

const LawPrediction* best_law(const IdentificationStudy& study,
                              const LoopPredictions& predictions) {
    if (predictions.laws.empty()) return nullptr;
    const LawPrediction& law = predictions.laws[study.laws ? study.laws->best : 0];
    return law.models.empty() ? nullptr : &law;
}

}  // namespace

std::vector<Verdict> loop_prediction_verdicts(const IdentificationStudy& study,
                                              const LoopPredictions& predictions) {
    if (predictions.laws.empty())
        return {{not_testable,
                 "The file names no models: add models = [\"mdr\", \"bem\"] to hold them against "
                 "the loops."}};
    std::vector<Verdict> verdicts;
    const LawPrediction* best = best_law(study, predictions);
    for (const bool is_best : {true, false})
        for (const LawPrediction& law : predictions.laws) {
            if ((&law == best) != is_best) continue;
            for (const LoopPrediction& model : law.models)
                verdicts.push_back(verdict_of(law, model, study, predictions.confidence));
            if (!law.why_not.empty())
                verdicts.push_back({not_testable, fmt::format("Under {} no model was run: {}.",
                                                              law.law, law.why_not)});
        }
    return verdicts;
}

report::DocumentSection loop_prediction_section(const IdentificationStudy& study,
                                                const LoopPredictions& predictions) {
    report::DocumentSection section{.id = "loop_predictions_section",
                                    .heading = "Measured and computed loops",
                                    .tables = {number_table(study, predictions)}};
    if (const LawPrediction* best = best_law(study, predictions))
        for (std::size_t t = 0; t < study.input.tables.size(); ++t)
            section.figures.push_back(figure_of(study, *best, t));
    return section;
}

json loop_prediction_json(const LoopPredictions& predictions) {
    json laws = json::array();
    for (const LawPrediction& law : predictions.laws) {
        json models = json::object();
        for (const LoopPrediction& model : law.models)
            for (const SeriesPrediction& series : model.series) {
                json one{{"series", series.series + 1}};
                for (const LoopNumber& n : series.numbers)
                    one[n.key] = {{"measured", n.measured},
                                  {"predicted", n.predicted},
                                  {"difference", n.difference()},
                                  {"half_width", half_width(n, predictions.confidence)},
                                  {"standard_error_by_rows", n.noise},
                                  {"standard_error_by_values", n.by_values},
                                  {"standard_error_by_resolution", n.by_resolution}};
                one["regime"] = comparisons::name_of(series.regime);
                one["force_deviation"] = series.deviation;
                models[model.model].push_back(std::move(one));
            }
        laws.push_back({{"law", law.law},
                        {"why_not", law.why_not.empty() ? json() : json(law.why_not)},
                        {"models", std::move(models)}});
    }
    return laws;
}

}  // namespace tricontact::experiments
