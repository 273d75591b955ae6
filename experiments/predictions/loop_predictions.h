#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/quantities/friction_loop.h"
#include "experiments/identification/identification_report.h"
#include "experiments/predictions/record_predictions.h"

namespace tricontact::experiments {

// Friction loops that a rig recorded, beside those of the models of a case. What of the case the
// loops tell - friction, E, k_rig, their drift - is what `identify` finds of them; the rest stands
// in the case.

/// A number of a series of loops, measured and computed.
struct LoopNumber {
    const char* key;   ///< "energy_J"
    const char* name;  ///< "work per cycle"
    const char* unit;
    double measured = 0;
    double noise = 0;          ///< standard error by the rows; of what only a fit tells, its own
    double predicted = 0;      ///< not a number: the model does not tell it
    double by_values = 0;      ///< standard error by what was found, and the errors of the inputs
    double by_resolution = 0;  ///< mesh and steps of the model
    /// Not by rows but by the same values: beside the model's number its own part is left, and it
    /// is no test of the model.
    bool is_found = false;

    double difference() const { return measured - predicted; }
    double standard_error() const;  ///< of the difference
    bool is_compared() const;
};

/// What a model makes of one series.
struct SeriesPrediction {
    std::size_t series = 0;
    std::vector<LoopNumber> numbers;
    comparisons::SlipRegime regime{};
    /// Of the middle cycle, a force at each row [N], and the root of the mean square of what it
    /// differs by, over half of what the force covers.
    std::size_t table = 0, loop = 0;
    std::vector<double> forces;
    double deviation = 0;
};

struct LoopPrediction {
    std::string model;
    std::vector<SeriesPrediction> series;
    std::string why_no_mesh_error;  ///< there is no coarser one: why
};

/// Under one law of friction, with its numbers at their best.
struct LawPrediction {
    std::string law;      ///< name, or formula of the stated one
    std::string why_not;  ///< why no model was run
    std::vector<LoopPrediction> models;
};

struct LoopPredictions {
    std::vector<LawPrediction> laws;  ///< of measurement.laws, or the stated one
    double confidence = .95;
};

/// Whether the file has a table of friction loops in [measurement], which is evaluated as such.
/// Throws contact::InputError where it has [record] or [wear] as well.
bool has_friction_loops(const std::string& path, const std::vector<std::string>& overrides);

/// Throws contact::InputError where models of the case cannot run whatever the loops tell: before
/// these are fitted, which takes longer.
void check_loop_models(const IdentificationInput& input, const std::string& case_file,
                       const std::vector<std::string>& overrides);

/// Runs the models of the case at the mean load, amplitude and friction of each series, the drive's
/// shift prescribed behind the rig; without `models` none. Throws contact::InputError,
/// contact::NotConverged.
LoopPredictions predict_loops(const IdentificationStudy& study, const std::string& case_file,
                              const PredictionRuns& runs);

/// One for each law and model, those of the best law first; then what they rest on.
std::vector<report::Verdict> loop_prediction_verdicts(const IdentificationStudy& study,
                                                      const LoopPredictions& predictions);
report::DocumentSection loop_prediction_section(const IdentificationStudy& study,
                                                const LoopPredictions& predictions);
nlohmann::ordered_json loop_prediction_json(const LoopPredictions& predictions);

}  // namespace tricontact::experiments
