#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tricontact::experiments {

/// What a rig recorded in one run, in SI units: one value each per time.
struct Record {
    std::string name;           ///< of the file
    std::vector<double> time;   ///< [s], increasing
    std::vector<double> shift;  ///< U along the tangential load [m]
    std::vector<double> drive;  ///< rolling offset, 0 with the roller upright [m]; empty: unknown
};

/// Runs of one procedure, repeated under equal conditions.
struct Experiment {
    /// Shakedown and ratcheting: one amplitude below, or beyond, the limit; limit: amplitude raised
    /// in steps until the contact ratchets.
    enum class Kind { shakedown, ratcheting, limit };

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

}  // namespace tricontact::experiments
