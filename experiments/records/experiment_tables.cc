#include <fmt/format.h>

#include "contact/special_values.h"
#include "experiments/records/experiment_report.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

constexpr std::size_t most_open_rows = 12;

report::WithError with_half_width(const Estimate& e, double factor) {
    return {factor * e.value, factor * e.half_width()};
}

std::string interval(const Estimate& e, double factor) {
    return report::significant(factor * e.low, 3) + " to " +
           report::significant(factor * e.high, 3);
}

report::WithError with_standard_error(const Estimate& e, double factor) {
    return {factor * e.value, factor * e.standard_error};
}

std::string numbers_with_errors(const ExperimentEvaluation& e) {
    if (e.uncertain_numbers.empty()) return "none is stated";
    return fmt::format("{}", fmt::join(e.uncertain_numbers, ", "));
}

const char* agrees(std::optional<bool> differs) {
    return report::word_of(!differs   ? report::Verdict::Standing::not_resolved
                           : *differs ? report::Verdict::Standing::fail
                                      : report::Verdict::Standing::pass);
}

report::DocumentTable values_table(const ExperimentEvaluation& e) {
    report::DocumentTable table{
        .id = "values",
        .title = "Values",
        .note =
            "Half widths of the intervals behind ±. U_stat: before rolling. U_sd: upright after "
            "the last period. u_inf: where the transient of the second half of the periods leads. "
            "ΔU: slope over the second half of the periods.",
        .columns =
            report::columns("quantity", level(e.confidence) + " [µm]", "95 % [µm]", "runs:1")};
    const auto add = [&](const char* name, const Repeated& r) {
        table.rows.push_back({name, with_half_width(r.at_confidence, um),
                              with_half_width(r.at_95, um), double(r.runs)});
    };
    add("U_stat", e.static_shift);
    add("U_sd", e.final_shift);
    if (e.state != contact::State::ratcheting) add("u_inf", e.settled_shift);
    add("ΔU", e.increment);
    return table;
}

report::DocumentTable normalised_table(const ExperimentEvaluation& e) {
    const NormalisedResults& n = *e.normalised;
    const bool limit = e.kind == Experiment::Kind::limit;
    report::DocumentTable table{
        .id = "normalised",
        .title = "Over Hertz' scales of the case",
        .note =
            "One standard error behind ±: of the measured value and of the case's numbers, first "
            "order" +
            std::string(e.correlation.empty() ? ", independent" : ", with their correlations") +
            "; F_T and W are what the rig sets. Uncertain numbers of the case: " +
            numbers_with_errors(e) + ".",
        .columns = report::columns("quantity", "value")};
    const auto add = [&](const char* name, const Estimate& u, double factor = 1) {
        // An error of 0 is one that was not stated.
        table.rows.push_back({name, u.standard_error == 0
                                        ? report::Cell(factor * u.value)
                                        : report::Cell(with_standard_error(u, factor))});
    };
    add("f_T = F_T/(μ F_N)", n.tangential_ratio);
    if (limit) {
        if (e.limit_amplitude) add("w_lim = W_lim/a", n.amplitude_ratio);
        add("w_lim, exact for half-spaces", n.exact_limit);
        add("w_lim of the thesis, 1 - f_T", n.thesis_limit);
    } else if (n.amplitude_ratio.value > 0) {
        add("w = W/a", n.amplitude_ratio);
    }
    add("U_max [µm]", n.unit_shift, um);
    add("U_stat/U_max", n.static_ratio);
    if (!limit || e.limit_shift) add(limit ? "U_lim/U_max" : "U_sd/U_max", n.final_ratio);
    if (!limit) add("ΔU/U_max", n.increment_ratio);
    return table;
}

report::DocumentTable deviations_table(const ExperimentEvaluation& e) {
    report::DocumentTable table{
        .id = "deviations",
        .title = "Measured minus computed",
        .note =
            "After ASME V&V 20-2009: half width of the interval of 95 % behind ±, by the "
            "record, the uncertain numbers of the case (" +
            numbers_with_errors(e) +
            ") and the mesh. Resolution: the least deviation of the computed value that would "
            "have been called a disagreement in 95 of 100 such comparisons.",
        .columns = report::columns("model", "quantity", "measured [µm]", "computed [µm]",
                                   "difference [µm]", "resolution [%]:2", "verdict")};
    for (const Deviation& d : e.deviations)
        table.rows.push_back({report::display_name(d.model), d.quantity, um * d.error.measured,
                              um * d.error.computed,
                              d.has_errors
                                  ? report::Cell(report::WithError{um * d.error.difference(),
                                                                   um * d.error.half_width()})
                                  : report::Cell(um * d.error.difference()),
                              d.has_errors ? report::Cell(100 * d.error.resolution())
                                           : report::Cell(contact::undefined),
                              agrees(d.differs())});
    return table;
}

report::DocumentTable series_table(const ExperimentEvaluation& e) {
    report::DocumentTable table{
        .id = "series",
        .title = "Measured minus computed, all periods together",
        .note =
            "Where the series is furthest off, in half widths that hold for all periods at once "
            "(95 %); widening: of the interval that this period has by itself. Resolution: the "
            "least relative deviation, the same in all periods, that would have been called a "
            "disagreement in 95 of 100 such comparisons.",
        .columns = report::columns("model", "furthest at n", "difference [µm]", "widening:3",
                                   "resolution [%]:2", "verdict")};
    for (const SeriesDeviation& d : e.series) {
        const std::size_t n = d.error.furthest();
        const double difference = um * d.error.values[n].difference();
        table.rows.push_back({report::display_name(d.model), static_cast<int>(n), difference,
                              contact::undefined, contact::undefined, agrees(d.differs())});
        if (!d.has_errors) continue;
        auto& row = table.rows.back();
        row[2] = report::WithError{difference, um * d.error.half_width(n)};
        row[3] = d.error.widening;
        row[4] = 100 * d.error.resolution;
    }
    return table;
}

report::DocumentTable contributions_table(const ExperimentEvaluation& e) {
    report::DocumentTable table{
        .id = "contributions",
        .title = "What the uncertainty is made of",
        .note =
            "Standard error that each source gives to measured minus computed, and its share of "
            "the variance, that of the covariances of correlated numbers apart.",
        .columns =
            report::columns("model", "quantity", "source", "standard error [µm]:3", "share [%]:2")};
    const auto add = [&](const std::string& model, const std::string& quantity,
                         const ComparisonError& error) {
        const double whole = error.standard_error();
        for (const UncertaintySource& one : error.sources) {
            if (one.standard_error == 0) continue;  // a half-space has no thickness
            table.rows.push_back({report::display_name(model), quantity, one.name,
                                  um * one.standard_error,
                                  100 * one.standard_error * one.standard_error / (whole * whole)});
        }
        if (error.covariance != 0)
            table.rows.push_back({report::display_name(model), quantity, "correlations", "",
                                  100 * error.covariance / (whole * whole)});
    };
    for (const Deviation& d : e.deviations) add(d.model, d.quantity, d.error);
    for (const SeriesDeviation& d : e.series) {
        const std::size_t n = d.error.furthest();
        add(d.model, fmt::format("all periods, n = {}", n), d.error.values[n]);
    }
    table.folded = table.rows.size() > most_open_rows;
    return table;
}

report::DocumentTable stages_table(const ExperimentEvaluation& e) {
    report::DocumentTable table{
        .id = "stages",
        .title = "Verdict per amplitude",
        .note = "Walk and curvature: intervals at " + level(verdict_confidence) + ".",
        .columns = report::columns("run", "W [mm]", "periods", "increment ΔU [µm]", "verdict by it",
                                   "curvature", "verdict by the curvature")};
    for (const RunEvaluation& run : e.runs)
        for (const StageEvaluation& s : run.stages)
            table.rows.push_back({run.name, mm * s.amplitude, double(s.periods()),
                                  interval(s.settling.increment, um), word(s.by_increment),
                                  interval(s.curvature, 1), word(s.by_curvature)});
    return table;
}

report::DocumentTable limits_table(const ExperimentEvaluation& e) {
    report::DocumentTable table{
        .id = "limits",
        .title = "Limit per run",
        .note = "U_lim: where the lines meet, half width of its interval behind ±.",
        .columns =
            report::columns("run", "last shakedown [mm]", "first ratcheting [mm]", "U_lim [µm]")};
    for (std::size_t i = 0; i < e.runs.size(); ++i) {
        table.rows.push_back(
            {e.runs[i].name, contact::undefined, contact::undefined, contact::undefined});
        if (const auto& limit = e.limits[i])
            table.rows.back() = {e.runs[i].name, mm * limit->amplitude_low,
                                 mm * limit->amplitude_high,
                                 with_half_width(limit->lines.shift, um)};
    }
    return table;
}

report::DocumentTable model_stages_table(const ExperimentEvaluation& e) {
    report::DocumentTable table{.id = "model_stages",
                                .title = "The models at these amplitudes",
                                .note = "Amplitudes of the first run; each rolled from rest.",
                                .columns = {{"W [mm]"}}};
    for (const PredictedLimit& limit : e.model_limits)
        table.columns.push_back({report::display_name(limit.model)});
    for (std::size_t k = 0; k < e.runs.front().stages.size(); ++k) {
        table.rows.push_back({mm * e.runs.front().stages[k].amplitude});
        for (const PredictedLimit& limit : e.model_limits)
            table.rows.back().push_back(word(limit.states[k]));
    }
    return table;
}

report::DocumentTable wobble_table(const ExperimentEvaluation& e) {
    report::DocumentTable table{
        .id = "wobble",
        .title = "Shift that follows the drive",
        .note =
            "dU/dW of whole periods. On a layer that couples normal and tangential contact free "
            "rolling creeps, so that a model has a wobble of its own; by what the measured one has "
            "beside it the pivot sits Dh = R dU/dW too high (5.1.11), below zero too low; one "
            "standard error behind ±.",
        .columns = report::columns("beside", "its own dU/dW [µm/mm]", "Dh of the rest [µm]")};
    const auto add = [&](const std::string& name, double own) {
        table.rows.push_back({name, um / mm * own, with_standard_error(pivot_height(e, own), um)});
    };
    add("nothing", 0);
    for (const ModelPrediction& p : e.predictions) add(report::display_name(p.model), p.wobble);
    return table;
}

report::DocumentTable noise_table(const ExperimentEvaluation& e) {
    report::DocumentTable table{
        .id = "noise",
        .title = "Noise, drift and the table's wobble",
        .note =
            "Noise: standard deviation in the rest before rolling; so many neighbouring samples "
            "count as one. Drift: slope of the rest, one standard error behind ±; the mean is "
            "subtracted. Wobble: what the shift follows the drive by, dU/dW = Δh/R (5.1.11), half "
            "width of its interval behind ±; it vanishes upright. It holds what the contact itself "
            "does in step with the drive.",
        .columns =
            report::columns("run", "resolution [nm]:3", "noise [nm]:3", "correlated samples:2",
                            "drift before [nm/s]:3", "drift after [nm/s]:3", "wobble [µm/mm]:3")};
    for (const RunEvaluation& run : e.runs) {
        const Estimate after = run.after.value_or(Estimate{contact::undefined, contact::undefined});
        table.rows.push_back({run.name, nm * run.noise.resolution,
                              nm * run.noise.standard_deviation, run.noise.correlated_samples,
                              with_standard_error(run.before, nm), with_standard_error(after, nm),
                              run.wobble ? report::Cell(with_half_width(*run.wobble, um / mm))
                                         : report::Cell(contact::undefined)});
    }
    return table;
}

}  // namespace

std::vector<report::DocumentTable> values_tables(const ExperimentEvaluation& e) {
    std::vector<report::DocumentTable> tables{values_table(e)};
    if (e.normalised) tables.push_back(normalised_table(e));
    if (!e.deviations.empty()) {
        tables.push_back(deviations_table(e));
        tables.push_back(series_table(e));
        tables.push_back(contributions_table(e));
    }
    return tables;
}

report::DocumentTable criteria_table(const ExperimentEvaluation& e) {
    report::DocumentTable table{
        .id = "criteria_by_run",
        .title = "Both criteria",
        .note =
            "Intervals at " + level(verdict_confidence) +
            ". Residual: of the values upright about transient and ratcheting; noise: what their "
            "errors explain. Curvature of all samples: as the thesis takes it, without an "
            "interval, since neighbours in the record are not independent.",
        .columns = report::columns("run", "increment ΔU [µm]", "verdict by it", "q:2",
                                   "residual [µm]:2", "noise [µm]:2", "curvature", "verdict by it",
                                   "curvature of all samples:3")};
    for (const RunEvaluation& run : e.runs) {
        const StageEvaluation& s = run.stages.front();
        table.rows.push_back({run.name, interval(s.settling.increment, um), word(s.by_increment),
                              s.settling.ratio, um * s.settling.residual_deviation,
                              um * s.shift_error[s.shift_error.size() / 2],
                              interval(s.curvature, 1), word(s.by_curvature), s.sampled_curvature});
    }
    return table;
}

std::vector<report::DocumentTable> limit_tables(const ExperimentEvaluation& e) {
    std::vector<report::DocumentTable> tables{stages_table(e), limits_table(e)};
    if (e.normalised) tables.push_back(normalised_table(e));
    if (!e.model_limits.empty()) tables.push_back(model_stages_table(e));
    return tables;
}

std::vector<report::DocumentTable> noise_tables(const ExperimentEvaluation& e) {
    std::vector<report::DocumentTable> tables{noise_table(e)};
    if (e.wobble && e.normalised) tables.push_back(wobble_table(e));
    return tables;
}

}  // namespace tricontact::experiments
