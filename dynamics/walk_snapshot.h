#pragma once

#include <vector>

#include "dynamics/motion.h"

namespace tricontact::dynamics {

/// What a contact spot does; the numbers are those of contact_state in files for ParaView.
enum class SpotState { released = 0, stick = 1, slip = 2 };

/// The machine at one time, for pictures.
struct Snapshot {
    Motion motion;
    std::vector<SpotState> spots;  ///< in the order of spots_of
};

}  // namespace tricontact::dynamics
