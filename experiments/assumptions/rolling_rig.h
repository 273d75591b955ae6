#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/assumptions/printed_value.h"
#include "statistics/uncertain.h"

namespace tricontact::experiments {

/// An experiment in which a heavy roller lies on a layer of rubber, bonded to a rigid plate, and is
/// rolled back and forth by a lever. SI units; empty where the experimenter does not say.
struct RollingRig {
    enum class Shape { sphere, cylinder };

    struct Roller {
        Shape shape = Shape::sphere;
        statistics::Uncertain radius;                 ///< R [m]
        std::optional<statistics::Uncertain> length;  ///< L [m] of a cylinder
        statistics::Uncertain young;                  ///< E_1 [Pa]
        statistics::Uncertain poisson;                ///< nu_1 [-]
    };
    struct Substrate {
        statistics::Uncertain thickness;               ///< b [m]
        statistics::Uncertain young;                   ///< E_2 [Pa]
        statistics::Uncertain poisson;                 ///< nu_2 [-]
        std::optional<statistics::Uncertain> density;  ///< rho [kg/m^3]
        std::optional<statistics::Uncertain>
            viscosity;  ///< eta [Pa s] of a standard solid with G_1 = E_2's
        std::optional<statistics::Uncertain> maxwell_ratio;  ///< G_2/G_1 of that solid
    };
    struct Drive {
        statistics::Uncertain speed;                     ///< v [m/s] of the roller's centre
        statistics::Uncertain smallest_amplitude_ratio;  ///< least W/a
        std::optional<statistics::Uncertain>
            reference_radius;  ///< a [m] of these ratios; empty: Hertz'
        std::optional<statistics::Uncertain> eigenfrequency;  ///< f_1 [Hz], the lowest of the rig
    };
    /// The substrate's oscillation under a roller that should not move it.
    struct Pivot {
        statistics::Uncertain displacement;     ///< DU [m], amplitude
        statistics::Uncertain amplitude_ratio;  ///< W/a
    };

    std::string title;
    Roller roller;
    Substrate substrate;
    statistics::Uncertain friction_coefficient;  ///< mu
    statistics::Uncertain normal_force;          ///< F_N [N]
    Drive drive;
    std::optional<Pivot> pivot;
    std::optional<statistics::Uncertain>
        measured_contact_size;  ///< diameter, or width 2a of a line [m]
    std::vector<PrintedValue> printed;
};

}  // namespace tricontact::experiments
