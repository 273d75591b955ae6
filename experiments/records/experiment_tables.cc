#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "comparisons/quantities/quantities.h"
#include "experiments/records/experiment_report.h"
#include "report/format.h"
#include "report/json_table.h"

namespace tricontact::experiments {

using json = nlohmann::ordered_json;
namespace names = comparisons::quantities;

namespace {

constexpr std::size_t most_open_rows = 12;

report::WithError with_half_width(const Estimate& e, double factor) {
    return {factor * e.value, factor * e.half_width()};
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
    const json n = normalised_json(*e.normalised);
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
    const auto add = [&](const char* name, const char* key, double unit = 1) {
        table.rows.push_back({name, report::cell_of(n.at(key), unit)});
    };
    const bool is_coulomb = e.normalised->is_coulomb;
    add(is_coulomb ? "f_T = F_T/(μ F_N)" : "f_T = F_T/F_lim", names::tangential_ratio.key);
    if (limit) {
        if (e.limit_amplitude) add("w_lim = W_lim/a", names::amplitude_ratio.key);
        add("w_lim, exact for half-spaces", "exact_amplitude_limit");
        if (is_coulomb) add("w_lim of the thesis, 1 - f_T", "thesis_amplitude_limit");
    } else if (e.normalised->amplitude_ratio.value > 0) {
        add("w = W/a", names::amplitude_ratio.key);
    }
    add("U_max [µm]", names::unit_shift.key, 1 / um);
    add("U_stat/U_max", names::static_shift_ratio.key);
    if (!limit || e.limit_shift)
        add(limit ? "U_lim/U_max" : "U_sd/U_max", names::final_shift_ratio.key);
    if (!limit) add("ΔU/U_max", "increment_ratio");
    return table;
}

report::DocumentTable deviations_table(const ExperimentEvaluation& e) {
    const auto row_of = [](const Deviation& d) {
        json row = deviation_json(d);
        row["model"] = d.model;
        row["verdict"] = agrees(d.differs());
        return row;
    };
    return report::table_of(
        {.id = "deviations",
         .title = "Measured minus computed",
         .note = "After ASME V&V 20-2009: half width of the interval of 95 % behind ±, by the "
                 "record, the uncertain numbers of the case (" +
                 numbers_with_errors(e) +
                 ") and the mesh. Resolution: the least deviation of the computed value that would "
                 "have been called a disagreement in 95 of 100 such comparisons."},
        report::list_of(e.deviations, row_of),
        {{"model", "model"},
         {"quantity", "quantity"},
         {"/measured_m/value", "measured [µm]", 1 / um},
         {"/predicted_m/value", "computed [µm]", 1 / um},
         {"/comparison/difference_m", "difference [µm]", 1 / um,
          "/comparison/half_width_95_percent_m"},
         {"/comparison/resolution", "resolution [%]:2", .01},
         {"verdict", "verdict"}});
}

report::DocumentTable series_table(const ExperimentEvaluation& e) {
    const auto row_of = [](const SeriesDeviation& d) {
        json row = series_json(d);
        const std::size_t n = d.error.furthest();
        row.update({{"model", d.model},
                    {"furthest", n},
                    {"difference", row["difference_m"][n]},
                    {"half_width", d.has_errors ? row["half_width_95_percent_m"][n] : json()},
                    {"verdict", agrees(d.differs())}});
        return row;
    };
    return report::table_of(
        {.id = "series",
         .title = "Measured minus computed, all periods together",
         .note =
             "Where the series is furthest off, in half widths that hold for all periods at once "
             "(95 %); widening: of the interval that this period has by itself. Resolution: the "
             "least relative deviation, the same in all periods, that would have been called a "
             "disagreement in 95 of 100 such comparisons."},
        report::list_of(e.series, row_of),
        {{"model", "model"},
         {"furthest", "furthest at n"},
         {"difference", "difference [µm]", 1 / um, "half_width"},
         {"widening", "widening:3"},
         {"resolution", "resolution [%]:2", .01},
         {"verdict", "verdict"}});
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

report::DocumentTable limits_table(const ExperimentEvaluation& e) {
    json rows = json::array();
    for (std::size_t i = 0; i < e.runs.size(); ++i) {
        rows.push_back(e.limits[i].value_or(LimitReading{}));
        if (!e.limits[i])
            for (json& value : rows.back()) value = nullptr;
        rows.back()["run"] = e.runs[i].name;
    }
    return report::table_of(
        {.id = "limits",
         .title = "Limit per run",
         .note = "U_lim: where the lines meet, half width of its interval behind ±."},
        rows,
        {{"run", "run"},
         {"last_shakedown_m", "last shakedown [mm]", 1 / mm},
         {"first_ratcheting_m", "first ratcheting [mm]", 1 / mm},
         {"intersection_shift_m", "U_lim [µm]", 1 / um}});
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
    return report::table_of(
        {.id = "noise",
         .title = "Noise, drift and the table's wobble",
         .note =
             "Noise: standard deviation in the rest before rolling; so many neighbouring samples "
             "count as one. Drift: slope of the rest, one standard error behind ±; the mean is "
             "subtracted. Wobble: what the shift follows the drive by, dU/dW = Δh/R (5.1.11), half "
             "width of its interval behind ±; it vanishes upright. It holds what the contact "
             "itself does in step with the drive."},
        report::list_of(e.runs, run_json),
        {{"name", "run"},
         {"resolution_m", "resolution [nm]:3", 1 / nm},
         {"noise_m", "noise [nm]:3", 1 / nm},
         {"correlated_samples", "correlated samples:2"},
         {"drift_before_m_per_s", "drift before [nm/s]:3", 1 / nm},
         {"drift_after_m_per_s", "drift after [nm/s]:3", 1 / nm},
         {"wobble_ratio", "wobble [µm/mm]:3", mm / um}});
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

report::DocumentTable stages_table(const ExperimentEvaluation& e) {
    json rows = json::array();
    for (const RunEvaluation& run : e.runs)
        for (json stage : run_json(run)["stages"]) {
            const json& errors = stage["shift_standard_error_m"];
            stage["noise_m"] = errors[errors.size() / 2];
            stage["run"] = run.name;
            stage["periods"] = errors.size() - 1;
            rows.push_back(stage);
        }
    return report::table_of(
        {.id = "stages",
         .title = "Verdicts by both criteria, per run and amplitude",
         .note = "Increment and curvature: half widths of the intervals at " +
                 level(verdict_confidence) +
                 " behind ±. Residual: of the values upright about transient and ratcheting; "
                 "noise: what "
                 "their errors explain. Curvature of all samples: as the thesis takes it, without "
                 "an interval, since neighbours in the record are not independent."},
        rows,
        {{"run", "run"},
         {names::amplitude.key, "W [mm]", 1 / mm},
         {"periods", "periods"},
         {"ratcheting_increment_m", "increment ΔU [µm]", 1 / um},
         {"state_by_increment", "verdict by it"},
         {"transient_ratio", "q:2"},
         {"residual_deviation_m", "residual [µm]:2", 1 / um},
         {"noise_m", "noise [µm]:2", 1 / um},
         {"curvature", "curvature"},
         {"state_by_curvature", "verdict by the curvature"},
         {"curvature_of_samples", "curvature of all samples:3"}});
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
