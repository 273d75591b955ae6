#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/records/drive_timeline.h"
#include "experiments/records/experiment.h"

namespace tricontact::experiments {

/// Something that is wrong with a record, found before it is evaluated.
struct RecordFinding {
    enum class Kind {
        gap,
        jump,
        outlier,
        stuck,
        clipped,
        loading,
        drift,
        delay,
        noise,
        correlation,
        sign,
        unit,
        resolution,
        drive,
        hum
    };

    Kind kind{};
    std::string sentence;  ///< without the record's name
    /// Values of the record are wrong by an unknown amount: no verdict is based on them.
    bool spoils = false;
    /// W is not known: no model is set beside it.
    bool hides_amplitude = false;
};

/// "gap", "jump", "outlier", "stuck", "clipped", "loading", "drift", "delay", "noise",
/// "correlation", "sign", "unit", "resolution", "drive", "hum".
const char* name_of(RecordFinding::Kind kind);

using RecordFindings = std::vector<RecordFinding>;

/// An interval between samples is a gap where it is so many times as long as the three to each
/// side.
inline constexpr double gap_factor = 4;
inline constexpr std::size_t longest_outlier = 10;  ///< samples

/// The record without outliers: up to ten samples away from both neighbours by more than eight
/// standard deviations of the differences between samples, and four times as far as any of the
/// three samples to each side are from theirs, between samples that agree. Throws
/// contact::InputError where the shift never changes: a dead channel.
Record without_outliers(const Record& record, RecordFindings& findings);

/// From `from` on [s]: values that repeat longer than noise lets them (once in 10^9 samples, by how
/// often neighbours are equal in the rest before rolling): a sensor that is clipped where this is
/// the largest or smallest value, else one that is stuck. Clipped, too, is a record that has its
/// largest or smallest value in twenty samples, and three times as often as the next one. Nothing
/// is found where the noise is below the resolution.
void find_repeated_values(const Record& record, const DriveTimeline& timeline, double from,
                          RecordFindings& findings);

/// Intervals between samples that are four times as long as the three to each side. Throws
/// contact::InputError where the roller is upright in one, or where it hides what the drive did
/// (longer than two fifths of a period).
void find_gaps(const Record& record, const DriveTimeline& timeline, RecordFindings& findings);

/// A noise-like scale of the differences between successive samples.
double usual_difference(const Record& record);

}  // namespace tricontact::experiments
