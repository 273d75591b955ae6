#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/quantities/friction_loop.h"
#include "experiments/identification/estimation/identification.h"
#include "experiments/identification/loop_values.h"

namespace tricontact::experiments {

/// Frictional work of a cycle over 4 F U of its amplitudes, U without the rig's share: below this
/// a recorded loop counts as closed, and the contact as sticking.
inline constexpr double closed_loop_ratio = .01;

/// What was found of one measured loop.
struct LoopFinding {
    std::size_t table = 0, series = 0;  ///< the series counts over all tables
    double cycle = 0;
    double normal_force = 0;      ///< [N]
    LoopState state;              ///< with the values of all loops
    double force = 0;             ///< amplitude of the fitted force [N]
    double contact_shift = 0;     ///< amplitude of the shift without the rig's share [m]
    double sliding_shift = 0;     ///< amplitude of the drive's shift at which all slides [m]
    statistics::Estimate energy;  ///< frictional work of the cycle [J]
    double energy_ratio = 0;      ///< over 4 F U of force and contact_shift
    /// Force at which all slides over the normal force, by this loop with E and k_rig of all; of
    /// partial slip by its curvature.
    statistics::Estimate friction;
    /// dF/dU behind the reversals by the rows alone, contact and rig in series [N/m]; empty where
    /// too few rows are there.
    std::optional<statistics::Estimate> stiffness;
    double shared_error = 0;        ///< part of its standard error that E and k_rig bring
    double sticks = 0, slides = 0;  ///< probabilities of a closed loop, and that all slides

    /// Of the way of a branch: where it is about as stiff as it gets.
    double stiff_part() const;
    double slips_partly() const { return std::max(0., 1 - sticks - slides); }
    comparisons::SlipRegime regime() const;
};

/// Friction over consecutive cycles of a series: weighted mean.
struct CycleBlock {
    double first = 0, last = 0;  ///< cycles
    std::size_t n = 0;
    statistics::Estimate friction;  ///< F_lim/F_N
};

/// Cycles under one load at one amplitude.
struct LoopSeries {
    std::size_t table = 0;
    double normal_force = 0, shift = 0;  ///< means [N], amplitude of the drive [m]
    std::size_t n_loops = 0;
    double first_cycle = 0, last_cycle = 0;
    std::string regime;           ///< "stick", "partial-slip", "mixed", "gross-slip"
    double confidence = 0;        ///< of the regime
    double largest_ratio = 0;     ///< of energy_ratio
    statistics::Estimate energy;  ///< mean of the cycles [J]
    std::vector<CycleBlock> blocks;
    /// Change per cycle of where shift [m] and force [N] count from; empty below four cycles.
    std::optional<statistics::Estimate> shift_drift, force_drift;
    /// The same of the stiffness, over its mean: of E, k_rig or a contact that grows.
    std::optional<statistics::Estimate> stiffness_drift;
};

struct LoopFindings {
    std::vector<LoopFinding> loops;
    std::vector<LoopSeries> series;
};

/// Variance of a value of the rig by the errors of the parameters that count, with their
/// correlations; infinite if a number of friction that counts is not told.
double shared_variance(const IdentificationInput& input, const Identification& found,
                       const std::function<bool(const FreeParameter&)>& counts,
                       const std::function<double(const IdentifiedRig&)>& value);

/// Of a model's fit to the tables of friction loops.
LoopFindings loop_findings(const IdentificationInput& input, const IdentificationTask& task,
                           const Identification& found);

}  // namespace tricontact::experiments
