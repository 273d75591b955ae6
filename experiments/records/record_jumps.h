#pragma once

#include <optional>

#include "experiments/records/record_checks.h"

namespace tricontact::experiments {

/// Levels that change from one sample to the next and stay, by more than the rolling can make: by
/// 4.5 standard deviations of the differences between samples, and by three beyond all changes of
/// the three samples to each side and of the five samples at the same phase of the two periods
/// before and behind. What recurs at its phase, as the slip of a contact that ratchets, is no jump;
/// nor is what happens across a gap. In the first and the last two periods, whose neighbours are on
/// one side only, changes of the contact may be three times those of the others. `loading`: when
/// F_T was applied [s], which is none.
void find_jumps(const Record& record, const DriveTimeline& timeline, std::optional<double> loading,
                RecordFindings& findings);

}  // namespace tricontact::experiments
