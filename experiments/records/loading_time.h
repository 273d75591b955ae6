#pragma once

#include <optional>
#include <string>

#include "experiments/records/experiment.h"

namespace tricontact::experiments {

/// When F_T was applied, as the shift shows it.
struct LoadingTime {
    double time = 0;             ///< the stated one where the record agrees with it [s]
    std::size_t n_unloaded = 0;  ///< samples before the shift rises
    double last_unloaded = 0;    ///< [s]
    double half_way = 0;         ///< when half of the shift is reached [s]

    bool agrees(double stated, double interval) const {
        return stated >= last_unloaded - 2 * interval && stated <= half_way + 2 * interval;
    }
};

/// The rise of the shift before the rolling, which begins at `start` [s]: half way from the level
/// of the first samples before it to that of the second half of the rest under load. Unloaded are
/// the samples before the shift leaves the first level by more than its noise and half a per cent
/// of the rise, whatever `stated` says; where that time lies within the rise, or two samples beside
/// it, it counts as the loading. Throws contact::InputError if nothing rises before the rolling.
LoadingTime loading_time(const Record& record, double stated, double start);

}  // namespace tricontact::experiments
