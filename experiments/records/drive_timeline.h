#pragma once

#include <vector>

#include "experiments/records/experiment.h"

namespace tricontact::experiments {

/// What the drive did in a record.
struct DriveTimeline {
    /// Successive periods of one amplitude.
    struct Stage {
        double amplitude = 0;         ///< W [m]
        std::vector<double> upright;  ///< when: before the first period and after each [s]
        double extent = 0;  ///< half the distance of its recorded turning points, median [m]

        int periods() const { return static_cast<int>(upright.size()) - 1; }
        /// Mean [s].
        double period() const { return (upright.back() - upright.front()) / periods(); }
    };

    std::vector<Stage> stages;
    std::vector<double> offset;  ///< of the roller, one per sample [m]

    double start() const { return stages.front().upright.front(); }  ///< [s]
    double end() const { return stages.back().upright.back(); }      ///< [s]
};

/// Part of a period to both sides of the upright roller in which its value is read.
inline constexpr double upright_window = 1. / 16;

/// Fewest samples in a period: an eighth of it, where a value is taken, then has four.
inline constexpr int fewest_samples = 32;

/// Times from the recorded drive, or from what is known of it. The drive moves at constant speed
/// between its turning points, and amplitudes that differ by less than 1 % are one stage. Amplitude
/// 0 where nothing says it. Throws contact::InputError if the drive does not move or returns, if a
/// period has too few samples or lies outside of the record.
DriveTimeline drive_timeline(const Record& record, const Experiment& experiment);

/// Throws contact::InputError "record: rule; remedy".
[[noreturn]] void refuse_record(const Record& record, const std::string& rule,
                                const std::string& remedy);

/// Rolling period [s] as seen in the recorded shift alone, known to begin at `start` [s] and to
/// number `periods`: the lag at which the autocorrelation of the shift's speed is highest, refined
/// by its multiples. Both halves of a period look alike when the table does not wobble, so that the
/// longest of nearly equal peaks counts; rest after the rolling must be shorter than the rolling.
/// Throws contact::InputError if no period stands out.
double shift_period(const Record& record, double start, int periods);

}  // namespace tricontact::experiments
