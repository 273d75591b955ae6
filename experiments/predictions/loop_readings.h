#pragma once

#include <optional>
#include <vector>

#include "experiments/identification/loops/loop_stiffness.h"
#include "experiments/predictions/loop_predictions.h"

namespace tricontact::experiments {

/// One measured loop, and how its rows are read.
struct LoopReading {
    const LoopFinding* finding = nullptr;
    std::size_t place = 0;  ///< in its table
    LoopRows rows;
    RowWeights secant;
    std::optional<RowWeights> initial;
};

/// A series of loops under one load at one amplitude, with what was measured of it.
struct SeriesReading {
    std::size_t place = 0;
    std::vector<LoopReading> loops;
    double normal_force = 0, amplitude = 0;  ///< means, of the drive [N, m]
    double friction = 0;                     ///< mean, over that of its table
    std::vector<LoopNumber> numbers;         ///< nothing is predicted yet

    const LoopReading& middle() const { return loops[loops.size() / 2]; }
};

/// Work, secant and initial stiffness by the rows, the shift at which all slides by what was found;
/// what the errors of that do to the same numbers of a fitted loop. `contributions`: of the inputs.
/// Input, findings and what was found are to outlive the readings.
std::vector<SeriesReading> read_series(const IdentificationInput& input,
                                       const Identification& found,
                                       const std::vector<InputContribution>& contributions,
                                       const statistics::Correlations& correlations,
                                       const LoopFindings& findings);

/// Force and shift of a contact that carries `factor` times as much grow alike.
void scale_friction(contact::Friction& friction, double factor);

}  // namespace tricontact::experiments
