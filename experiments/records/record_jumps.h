#pragma once

#include <optional>

#include "experiments/records/record_checks.h"

namespace tricontact::experiments {

/// Levels that change from one sample to the next and stay, by more than the rolling can make: by
/// six standard deviations of the differences between samples (three steps of the resolution at
/// least), and by four more than all changes of the three samples to each side, and than 1.25 times
/// those of the five samples at the same phase of the periods beside it; twice in the first
/// four periods of an amplitude, while the contact settles, and four times in the very first. What
/// recurs at its phase, as the slip of a contact that ratchets, is no jump; nor is a change across
/// a gap, or one that is undone within ten samples by another that the rolling does not make: an
/// outlier. `loading`: when F_T was applied [s], which is none. More than one in two periods may be
/// slip of the contact at places of its own: they are said, but do not spoil the record.
void find_jumps(const Record& record, const DriveTimeline& timeline, std::optional<double> loading,
                RecordFindings& findings);

}  // namespace tricontact::experiments
