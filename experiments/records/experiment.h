#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/case/rig_file.h"
#include "io/case/rig_keys.h"

namespace tricontact::experiments {

/// What a rig recorded in one run, in SI units: one value each per time.
struct Record {
    std::string name;           ///< of the file
    std::vector<double> time;   ///< [s], increasing
    std::vector<double> shift;  ///< U along the tangential load [m]
    std::vector<double> drive;  ///< rolling offset, 0 with the roller upright [m]; empty: unknown
    /// F_N and F_T [N]; empty: those of the case, constant.
    std::vector<double> normal_force = {}, tangential_force = {};
};

/// Runs of one procedure, repeated under equal conditions.
struct Experiment {
    using Kind = io::RecordKind;

    /// The drive where no column says what it did: at constant speed between turning points.
    struct Drive {
        std::optional<double> start;      ///< of the rolling [s]
        std::optional<double> period;     ///< [s]; empty: 4 W/speed, or found in the shift
        std::optional<double> amplitude;  ///< W [m]; empty: that of the case
        std::optional<double> speed;      ///< [m/s]
        std::optional<int> periods;
    };

    std::string title;
    Kind kind = Kind::shakedown;
    double confidence = 0.683;         ///< of the intervals of means; verdicts have their own
    std::optional<double> resolution;  ///< step of the recorded shift [m]; empty: seen in it
    std::optional<double> loading;     ///< when F_T was applied [s]; empty: before the record
    Drive drive;
    std::vector<Record> records;
};

/// What a case with [record] says, the records included.
struct ExperimentInput {
    Experiment experiment;
    std::optional<std::string> case_file;     ///< the file itself, if it describes a contact
    std::vector<io::UncertainKey> uncertain;  ///< numbers of that case
    statistics::Correlations correlations;    ///< of these, by their keys
    /// [measurement] names laws of friction, whose numbers its tables tell: the case has none.
    bool has_laws = false;
};

/// Reads the file and the records that it names. Without `models` it holds records alone. Throws
/// contact::InputError in one line, of the file with place, value, rule and remedy, of a record
/// with its line.
ExperimentInput read_experiment(const std::string& path,
                                const std::vector<std::string>& overrides = {});

}  // namespace tricontact::experiments
