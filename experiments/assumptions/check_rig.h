#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/assumptions/assumption.h"
#include "experiments/assumptions/measured_effect.h"
#include "experiments/assumptions/rig.h"

namespace tricontact::experiments {

/// The contact of a rig's sphere over the normal force, by both theories: what a measurement of
/// either would have to tell apart. SI units.
struct ForceCurves {
    struct ByTheory {
        std::vector<double> hertz, layer;
    };
    std::vector<double> force;                  ///< up to one and a half times that of the rig [N]
    ByTheory diameter, indentation;             ///< 2 a, d [m]
    Estimate rig_force;                         ///< F_N [N]
    std::optional<Estimate> measured_diameter;  ///< at that force [m]
};

/// Empty for other bodies and for a sphere that is not rigid beside the substrate. Throws as
/// check_rig() does.
std::optional<ForceCurves> force_curves(const Rig& rig);

/// A published number beside the same number computed from the rig's data.
struct PrintedCheck {
    enum class Agreement {
        agrees,        ///< equal when rounded like the print
        within_error,  ///< not that, but closer than the printed or propagated error
        differs,
        not_computed  ///< the rig file lacks what the formula needs
    };

    PrintedValue printed;
    std::optional<Calculation> calculation;
    Agreement agreement = Agreement::not_computed;
    double ratio = 0;  ///< printed over computed
    /// Printed error over the propagated one, if both are there, ...
    std::optional<double> error_ratio;
    bool error_agrees = true;  ///< ... and whether they are equal when rounded like the print
    std::vector<Substitute> substitutes;  ///< which the print would follow from, if it differs
};

/// What follows about an experiment.
struct RigReport {
    std::string title;
    std::vector<Assumption> assumptions = {};
    std::vector<MeasuredEffect> effects = {};  ///< of these on what is measured
    std::vector<PrintedCheck> printed = {};
};

/// F_T/(mu F_N) at which the effect of the layer's coupling is told.
inline constexpr double coupling_tangential_ratio = 0.56;

/// Shift [m] of the rig's sphere on its layer under F_N and `coupling_tangential_ratio`, normal and
/// tangential contact coupled or not: by a model that the caller has.
using StaticShift = std::function<double(const Rig& rig, bool coupled)>;

/// What rolling makes of the static shift of the rig's sphere by its least amplitude, along a load
/// of half the layer's limit of shakedown: U_sd/U_stat. Empty if unknown.
struct Growth {
    double amplitude = 0;         ///< W [m]
    double tangential_ratio = 0;  ///< F_T/(mu F_N)
    Estimate half_space, layer;
};
/// The least amplitude of the rig's drive [m].
double smallest_rolling_amplitude(const Rig& rig);
using RolledGrowth = std::function<std::optional<Growth>(const Rig& rig)>;

/// A rig's indenter pressed by F_N on its layer: as the body that it is, and as a half-space.
/// NaN: not compared.
struct IndenterContacts {
    BodyContact body, half_space;
};
/// By models that the caller has; empty where it has none.
using IndenterRun = std::function<std::optional<IndenterContacts>(const Rig& rig)>;

/// Whether the size of the rig's indenter matters: a ball or cylinder that is not rigid beside the
/// substrate.
bool has_soft_indenter(const Rig& rig);

/// What the evaluation of a rig takes for granted, with verdicts. Rig::body has to be there for
/// Kind::body. `static_shift` empty: the effect
/// of coupling stays open; `growth` empty: what rolling adds does; `indenter` empty: the size of
/// one that deforms does. Throws contact::InputError for a rig out of the range of the layer's
/// theory or materials out of range, contact::NotConverged.
RigReport check_rig(const Rig& rig, const StaticShift& static_shift = {},
                    const RolledGrowth& growth = {}, const IndenterRun& indenter = {});

/// Looks the printed quantities up by name among the calculations of the assumptions.
std::vector<PrintedCheck> check_printed(const std::vector<PrintedValue>& printed,
                                        const std::vector<Assumption>& assumptions);

}  // namespace tricontact::experiments
