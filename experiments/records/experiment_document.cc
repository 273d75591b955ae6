#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "contact/base/special_values.h"
#include "experiments/records/experiment_report.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

constexpr double least_drawn = 1e-3;      // [um] of growth: below what a vibrometer could see
constexpr std::size_t most_drawn = 1500;  // samples of a curve: more than a screen has columns

std::vector<double> scaled(const std::vector<double>& values, double factor) {
    std::vector<double> result = values;
    for (double& value : result) value *= factor;
    return result;
}

/// What was measured, and the models' curves behind it; `of` makes one from shifts [m].
template <class Of>
std::vector<report::Curve> with_models(const ExperimentEvaluation& e,
                                       const std::vector<Estimate>& bars, std::size_t first_period,
                                       const Of& of) {
    std::vector<double> shift, errors;
    for (const Estimate& u : e.shift) shift.push_back(u.value);
    for (const Estimate& bar : bars) errors.push_back(um * bar.half_width());
    const auto counts = [&](std::size_t n) {
        std::vector<double> result;
        for (std::size_t i = first_period; i < n; ++i) result.push_back(static_cast<double>(i));
        return result;
    };
    std::vector<report::Curve> curves;
    for (const ModelPrediction& p : e.predictions)
        curves.push_back(
            {.name = report::display_name(p.model), .x = counts(p.shift.size()), .y = of(p.shift)});
    curves.push_back({.name = "measured",
                      .x = counts(shift.size()),
                      .y = of(shift),
                      .y_error = errors,
                      .kind = report::Curve::Kind::points});
    return curves;
}

report::Figure periods_figure(const ExperimentEvaluation& e) {
    report::Figure figure{
        .id = "shift_over_periods",
        .title = "Shift over the rolling periods",
        .caption = fmt::format(
            "U with the roller upright, before the first period (n = 0) and after each; bars: "
            "{:.4g} %, by the scatter of the runs or, for one run, by noise and drift. Lines: "
            "the models on the case, same amplitude and periods, their bars of 95 % by its "
            "uncertain numbers and the mesh.",
            100 * e.confidence),
        .x = {"period n [-]"},
        .y = {"shift U [µm]"},
        .curves = with_models(e, e.shift, 0,
                              [](const std::vector<double>& shift) { return scaled(shift, um); })};
    for (std::size_t i = 0; i < e.predictions.size(); ++i)  // behind what was measured
        figure.curves[i].y_error = scaled(half_widths(e.predictions[i], e.correlation), um);
    return figure;
}

// No logarithm of what does not grow.
std::vector<double> growth(const std::vector<double>& shift) {
    std::vector<double> result;
    for (std::size_t n = 1; n < shift.size(); ++n) {
        const double d = um * (shift[n] - shift[n - 1]);
        result.push_back(d > least_drawn ? d : contact::undefined);
    }
    return result;
}

report::Figure increments_figure(const ExperimentEvaluation& e) {
    return {.id = "increments",
            .title = "Growth per period",
            .caption = fmt::format(
                "u_n - u_(n-1): a transient falls along a straight line, ratcheting stays at its "
                "level. Bars: {:.4g} %; values that do not grow are left out.",
                100 * e.confidence),
            .x = {"period n [-]"},
            .y = {"growth in the period [µm]", true},
            .curves = with_models(e, e.period_increments, 1, growth)};
}

// Figure 5.9 of the thesis, by values of periods.
report::Figure criterion_figure(const ExperimentEvaluation& e) {
    const StageEvaluation& stage = e.runs.front().stages.front();
    const double rise = stage.shift.back() - stage.shift.front();
    report::Figure figure{
        .id = "criterion",
        .title = "Curvature, and transient with ratcheting",
        .caption = fmt::format(
            "{}: shift and time of the interval normalised to run from 0 to 1, the "
            "thesis' parabola (its curvature {} is its criterion), and the fit of a "
            "geometric transient with steady ratcheting, which the verdict is based on.",
            e.runs.front().name, report::significant(stage.curvature.value, 3)),
        .x = {"time (t - t_0)/(t_N - t_0) [-]"},
        .y = {"shift (U - u_0)/(u_N - u_0) [-]"}};
    report::Curve values{.name = "values upright", .kind = report::Curve::Kind::points};
    report::Curve fit{.name = "transient and ratcheting"};
    for (std::size_t n = 0; n < stage.shift.size(); ++n) {
        const double t =
            (stage.time[n] - stage.time.front()) / (stage.time.back() - stage.time.front());
        values.add(t, (stage.shift[n] - stage.shift.front()) / rise);
        fit.add(t, (stage.settling.fitted[n] - stage.shift.front()) / rise);
    }
    const auto parabola = fit_polynomial(values.x, values.y, 2).fitted;
    figure.curves = {
        values,
        fit,
        {.name = "parabola of the thesis", .x = values.x, .y = parabola, .theory = true}};
    return figure;
}

report::Figure records_figure(const ExperimentEvaluation& e) {
    report::Figure figure{
        .id = "records",
        .title = "Records",
        .caption = fmt::format(
            "U(t) of each run, rid of the drift; at most {} of the samples are drawn.", most_drawn),
        .x = {"time t [s]"},
        .y = {"shift U [µm]"}};
    for (const RunEvaluation& run : e.runs) {
        report::Curve& curve = figure.curves.emplace_back(report::Curve{.name = run.name});
        const std::size_t every = run.time.size() / most_drawn + 1;
        for (std::size_t i = 0; i < run.time.size(); i += every)
            curve.add(run.time[i], um * run.shift[i]);
    }
    return figure;
}

report::Figure loads_figure(const RecordedPath& recorded) {
    report::Figure figure{
        .id = "loads",
        .title = "Loads that the models follow",
        .caption =
            "By straight lines through the recorded forces around each step, means of the "
            "runs; what has no column is constant. Time from the first touch.",
        .x = {"time t [s]"},
        .y = {"force [N]"},
        .curves = {{.name = "F_N"}, {.name = "F_T"}}};
    for (const auto& row : recorded.path.rows) {
        figure.curves[0].add(row.time, row.normal.value);
        figure.curves[1].add(row.time, row.tangential[0].value);
    }
    return figure;
}

report::Curve line(const StageEvaluation& stage, const LineIntersection& lines, double slope,
                   const std::string& name) {
    report::Curve curve{.name = name, .theory = true};
    for (const double t : {std::min(stage.time.front(), lines.time), lines.time,
                           std::max(stage.time.back(), lines.time)})
        curve.add(t, um * (lines.shift.value + slope * (t - lines.time)));
    return curve;
}

report::Figure limit_figure(const RunEvaluation& run, const LimitReading& limit) {
    const StageEvaluation &before = run.stages[limit.shakedown],
                          &after = run.stages[limit.ratcheting];
    report::Figure figure{
        .id = "limit",
        .title = "The last amplitude that shakes down, the first that ratchets",
        .caption = fmt::format(
            "{}: values upright of both intervals, W = {} mm and {} mm, and the straight lines of "
            "least squares through them (5.1.9); they meet at U_lim (5.1.10).",
            run.name, report::significant(mm * before.amplitude, 4),
            report::significant(mm * after.amplitude, 4)),
        .x = {"time t [s]"},
        .y = {"shift U [µm]"}};
    for (const auto* stage : {&before, &after})
        figure.curves.push_back({.name = stage == &before ? "shakedown" : "ratcheting",
                                 .x = stage->time,
                                 .y = scaled(stage->shift, um),
                                 .kind = report::Curve::Kind::points});
    figure.curves.push_back(line(before, limit.lines, limit.lines.slopes[0], "line, shakedown"));
    figure.curves.push_back(line(after, limit.lines, limit.lines.slopes[1], "line, ratcheting"));
    return figure;
}

report::DocumentSection limit_section(const ExperimentEvaluation& e) {
    report::DocumentSection section{.id = "limit", .heading = "Limit", .tables = limit_tables(e)};
    for (std::size_t i = 0; i < e.runs.size(); ++i)
        if (e.limits[i] && section.figures.empty())
            section.figures.push_back(limit_figure(e.runs[i], *e.limits[i]));
    return section;
}

report::Figure series_figure(const SeriesDeviation& d) {
    const std::string name = report::display_name(d.model);
    report::Curve difference{.name = "measured minus " + name,
                             .kind = report::Curve::Kind::line_and_points};
    report::Band band{.name = difference.name};
    for (std::size_t n = 0; n < d.error.values.size(); ++n) {
        const double value = um * d.error.values[n].difference(), half = um * d.error.half_width(n);
        difference.add(static_cast<double>(n), value);
        band.x.push_back(static_cast<double>(n));
        band.low.push_back(value - half);
        band.high.push_back(value + half);
    }
    report::Figure figure{
        .id = "series_" + report::id_of_model(d.model),
        .title = "Measured minus computed over the periods: " + name,
        .caption = d.has_errors
                       ? "The band holds for all periods together in 95 % of the cases, by the "
                         "record, the uncertain numbers of the case and the mesh: measured and "
                         "computed agree if zero lies in it everywhere."
                       : "The case states no uncertainty of its numbers: there is no band.",
        .x = {"period n [-]"},
        .y = {"measured minus computed [µm]"},
        .curves = {difference}};
    if (d.has_errors) figure.bands = {band};
    figure.curves.push_back({.name = "no difference", .theory = true});
    figure.curves.back().add(0, 0);
    figure.curves.back().add(difference.x.back(), 0);
    return figure;
}

report::DocumentSection values_section(const ExperimentEvaluation& e) {
    report::DocumentSection section{.id = "values",
                                    .heading = "Shift over the periods",
                                    .figures = {periods_figure(e), increments_figure(e)},
                                    .tables = values_tables(e)};
    for (const SeriesDeviation& d : e.series) section.figures.push_back(series_figure(d));
    return section;
}

report::DocumentSection criteria_section(const ExperimentEvaluation& e) {
    return {
        .id = "criteria",
        .heading = "Shakedown or ratcheting",
        .paragraphs = {fmt::format(
                           "Verdict: U_n = U_0 + A (1 - qⁿ) + ΔU n is fitted to the values "
                           "upright; shakedown if the upper end of the {:.4g} % interval of the "
                           "ratcheting increment ΔU adds less than {:.4g} % of the shift over the "
                           "interval, else "
                           "ratcheting if its lower end is positive, else it is undecided.",
                           100 * verdict_confidence, 100 * negligible_ratcheting),
                       "The thesis takes the sign of a parabola's curvature. Steady ratcheting has "
                       "none: the sign is then that of the noise, or of the transient before it."},
        .figures = {criterion_figure(e)},
        .tables = {stages_table(e)}};
}

}  // namespace

report::Document experiment_document(const ExperimentEvaluation& e) {
    const bool limit = e.kind == Experiment::Kind::limit;
    report::Document document{
        .kind = "Evaluated experiment",
        .title = e.title.empty() ? "Experiment" : e.title,
        .lead = limit
                    ? "At which rolling amplitude does the contact begin to ratchet, and where was "
                      "it then?"
                    : "Did the contact settle or ratchet, how far, and do the models agree?",
        .settings = {{"runs", std::to_string(e.runs.size())},
                     {"periods", std::to_string(e.periods)},
                     {"confidence", level(e.confidence)}}};
    std::vector<report::Verdict> verdicts = experiment_verdicts(e);
    document.answer = std::move(verdicts.front());
    document.answer->word = limit ? e.limit_amplitude ? "limit" : "no limit" : word(e.state);
    document.judged = "comparison", document.consequence = "what it can see";
    document.verdicts.assign(std::next(verdicts.begin()), verdicts.end());
    if (e.amplitude > 0)
        document.settings.push_back({limit ? "first amplitude W" : "amplitude W",
                                     report::significant(mm * e.amplitude, 4) + " mm"});
    document.sections =
        limit ? std::vector{limit_section(e)} : std::vector{values_section(e), criteria_section(e)};
    document.sections.push_back({.id = "measurement",
                                 .heading = "Records and their noise",
                                 .figures = {records_figure(e)},
                                 .tables = noise_tables(e)});
    if (e.rolled_as.loads)
        document.sections.back().figures.push_back(loads_figure(e.rolled_as.loads->as_recorded));
    return document;
}

}  // namespace tricontact::experiments
