#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::comparisons {

/// What the contact does in a cycle of its drive, after Vingsbo and Söderberg (1988): everything
/// sticks, part of it slips, or all of it slips at some instant. `mixed`: of several cycles that
/// are not alike.
enum class SlipRegime { stick, partial_slip, gross_slip, mixed };
/// "stick", "partial-slip", "gross-slip", "mixed".
const char* name_of(SlipRegime regime);

/// Force over shift along the drive's axis in a closed cycle of a path. Widths are those of the
/// lines through the computed steps.
struct FrictionLoop {
    std::size_t begin = 0, turn = 0, end = 0;  ///< steps of the history
    double force_amplitude = 0;                ///< half of what the force covers [N]
    double shift_amplitude = 0;                ///< half of what the shift covers [m]
    /// Slope at the reversals, mean of both, by the first two steps after each, which is of second
    /// order in their length; empty where fewer are taken or the force stays [N/m].
    std::optional<double> tangent_stiffness;
    double aperture = 0;              ///< width at the force midway between the reversals [m]
    double mean_normal_force = 0;     ///< over the steps [N]
    bool has_constant_force = false;  ///< F_N is the same in all steps, to 1e-9
    SlipRegime regime = SlipRegime::stick;
    double least_stick_area = 0;  ///< of the steps [m^2]
    /// From a reversal to where the whole contact slips, mean of both branches: where the line
    /// through the last two stick areas comes to 0, exact in a Hertzian contact of constant F_N,
    /// whose stick area falls linearly. Empty without gross slip, or where fewer than two steps
    /// stick before it [m].
    std::optional<double> gross_slip_shift;
    /// Half of what the shift of the drive covers; empty where no rig yields along it [m].
    std::optional<double> drive_shift_amplitude;

    /// [N/m]; empty where nothing moves.
    std::optional<double> secant_stiffness() const;
    /// Aperture over the shift that is covered, 0 to 1: after Fouvry, Kapsa and Vincent (1996).
    std::optional<double> sliding_ratio() const;
    /// The same of the drive's shift: what a record of the machine shows. Apertures are the same.
    std::optional<double> drive_secant_stiffness() const;
    std::optional<double> drive_sliding_ratio() const;
};

/// Of each closed cycle of the case's path (contact::closed_cycles()) along x or y, one after the
/// other; empty without.
std::vector<FrictionLoop> friction_loops(const contact::Case& c, const contact::History& history);

/// That of all loops, or `mixed`; empty without a loop.
std::optional<SlipRegime> common_regime(const std::vector<FrictionLoop>& loops);
/// Number of the first loop, from 1, whose regime is not that of the one before; empty if none.
std::optional<int> regime_change(const std::vector<FrictionLoop>& loops);

}  // namespace tricontact::comparisons
