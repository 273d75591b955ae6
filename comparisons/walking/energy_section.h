#pragma once

#include <optional>

#include "comparisons/document.h"
#include "comparisons/walking/walk_report.h"
#include "dynamics/energy.h"

namespace tricontact::comparisons::walking {

/// Energy balance of the motion that a run ends in.
struct EnergyStretch {
    dynamics::EnergyBalance balance;
    double length = 0;  ///< time, a period of a limit cycle
    double scale = 0;   ///< greatest of works and changes, > 0
};

/// From the end of the run on, a period of its limit cycle or some swings further; none for a
/// machine that fell over or does not move.
std::optional<EnergyStretch> energy_of(const WalkReport& report);

/// Whether work of the base is dissipation plus change of stored energy.
Verdict energy_verdict(const WalkReport& report, const EnergyStretch& energy);

DocumentSection energy_section(const EnergyStretch& energy);

}  // namespace tricontact::comparisons::walking
