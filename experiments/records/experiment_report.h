#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "contact/history.h"
#include "experiments/records/experiment_evaluation.h"
#include "report/document.h"

namespace tricontact::experiments {

/// What the experiment says, one statement each, the answer first.
std::vector<report::Verdict> experiment_verdicts(const ExperimentEvaluation& e);

/// Of each model: the shift over all periods, then single values, beside what was measured.
std::vector<report::Verdict> comparison_verdicts(const ExperimentEvaluation& e);
/// What is wrong with records, one statement each.
std::vector<report::Verdict> record_verdicts(const ExperimentEvaluation& e);
/// Of each model whose limit lies within the uncertainty of the case.
std::vector<report::Verdict> limit_within_verdicts(const ExperimentEvaluation& e);
/// The ratcheting increment beside the transient at verdict_confidence [m]: of several runs their
/// mean, by its scatter.
Estimate increment_of_runs(const ExperimentEvaluation& e);

/// The text of experiment.json: fixed keys in fixed order, SI units in the names, undefined and
/// non-finite numbers as null. `laws`: of friction that were compared, else null.
std::string experiment_json(const std::string& version, const ExperimentEvaluation& e,
                            const nlohmann::ordered_json& laws);

/// Parts of it, of which the tables are made.
nlohmann::ordered_json run_json(const RunEvaluation& run);
nlohmann::ordered_json deviation_json(const Deviation& d);
nlohmann::ordered_json series_json(const SeriesDeviation& d);
nlohmann::ordered_json normalised_json(const NormalisedResults& n);
void to_json(nlohmann::ordered_json& to, const LimitReading& limit);

/// The report: verdicts, records, values over the periods with the models, criteria, tables. Title,
/// command, version and files are left to the caller.
report::Document experiment_document(const ExperimentEvaluation& e);

/// "shakedown", or "undecided".
std::string word(contact::State state);

/// "217.9 ± 0.3 µm", with the half width of the interval.
std::string shift_text(const Estimate& e);
inline std::string shift_text(const Repeated& r) {
    return shift_text(r.at_confidence);
}

/// "68.3 %" of the level of an interval.
std::string level(double confidence);

/// From metres to the units in which people read shifts and amplitudes.
inline constexpr double um = 1e6, nm = 1e9, mm = 1e3;

// Tables of an experiment's report, those of a section each.
/// u_stat, u_sd, Du; over Hertz' scales; of the models.
std::vector<report::DocumentTable> values_tables(const ExperimentEvaluation& e);
/// Walk and curvature, per run and amplitude.
report::DocumentTable stages_table(const ExperimentEvaluation& e);
/// Verdict per amplitude and run, W_lim and U_lim per run, over Hertz' scales, the models'
/// verdicts.
std::vector<report::DocumentTable> limit_tables(const ExperimentEvaluation& e);
/// Noise, drift and wobble per run; beside the models' own wobble.
std::vector<report::DocumentTable> noise_tables(const ExperimentEvaluation& e);

}  // namespace tricontact::experiments
