#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "experiments/identification/law_comparison.h"
#include "experiments/predictions/record_predictions.h"
#include "report/document.h"

namespace tricontact::experiments {

/// A record beside models under one law of friction, whose numbers the tables of [measurement]
/// tell, within their errors.
struct RecordedLaw {
    std::vector<std::string> overrides;  ///< key=value of what the tables tell of the case
    /// The record with the models' predictions; empty: see `why_not`.
    std::optional<ExperimentEvaluation> evaluation;
    std::string why_not;  ///< why no model was run
    /// Of limit runs: W_lim between two amplitudes, and by the law's closed form, 95 % [m].
    std::optional<Estimate> measured_limit, predicted_limit;
    std::string why_excluded;  ///< by tables or record; empty: it is not

    /// Whether the models disagree with the record, at 95 % over all periods together, or the two
    /// intervals of W_lim have nothing in common; empty where that cannot be told. Springs settle
    /// otherwise than a half-space does: where they are all models, U_stat is what they tell.
    std::optional<bool> differs() const;
    bool is_excluded() const { return !why_excluded.empty(); }
};

/// Laws of friction by tables and record, which are independent of each other.
struct RecordLaws {
    LawComparison tables;
    std::vector<RecordedLaw> laws;  ///< one for each law of `tables`
    /// The only one that is left, or the one that the tables support, unless the record excludes
    /// it; empty: none, or several.
    std::optional<std::size_t> named;
    std::size_t best = 0;  ///< named, else that of the least AICc among those left

    std::vector<std::size_t> supported() const;
    const RecordedLaw& best_law() const { return laws[best]; }
    /// The compared law of fewer numbers that this one is where its numbers are at the end of their
    /// range; empty if they are not.
    std::optional<std::size_t> end_of(std::size_t law) const;
};

/// Finds the numbers of each law of measurement.laws by the tables, and runs the models of the case
/// with them as the rig rolled. A law whose numbers lie at the end of their range is one that it
/// contains, and excluded with that. Throws contact::InputError, contact::NotConverged.
RecordLaws compare_record_laws(const ExperimentEvaluation& record, const ExperimentInput& input,
                               const PredictionRuns& runs);

/// Tables alone, record alone and both, in RecordLaws::laws' why_excluded, named and best.
void judge(RecordLaws& laws);

bool is_of_springs(const std::string& model);
/// U_stat of a model in an evaluation.
const Deviation& static_deviation(const ExperimentEvaluation& e, const std::string& model);

/// Which laws tables and record support, cannot tell apart and exclude; then one of each law.
std::vector<report::Verdict> record_law_verdicts(const RecordLaws& laws);
report::DocumentSection record_law_section(const RecordLaws& laws);
nlohmann::ordered_json record_law_json(const RecordLaws& laws);

}  // namespace tricontact::experiments
