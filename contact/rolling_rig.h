#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/printed_value.h"
#include "contact/uncertain.h"

namespace tricontact::contact {

/// An experiment in which a heavy roller lies on a layer of rubber, bonded to a rigid plate, and is
/// rolled back and forth by a lever. SI units; empty where the experimenter does not say.
struct RollingRig {
    enum class Shape { sphere, cylinder };

    struct Roller {
        Shape shape = Shape::sphere;
        Uncertain radius;                 ///< R [m]
        std::optional<Uncertain> length;  ///< L [m] of a cylinder
        Uncertain young;                  ///< E_1 [Pa]
        Uncertain poisson;                ///< nu_1 [-]
    };
    struct Substrate {
        Uncertain thickness;                 ///< b [m]
        Uncertain young;                     ///< E_2 [Pa]
        Uncertain poisson;                   ///< nu_2 [-]
        std::optional<Uncertain> density;    ///< rho [kg/m^3]
        std::optional<Uncertain> viscosity;  ///< eta [Pa s] of a standard solid with G_1 = E_2's
        std::optional<Uncertain> maxwell_ratio;  ///< G_2/G_1 of that solid
    };
    struct Drive {
        Uncertain speed;                            ///< v [m/s] of the roller's centre
        Uncertain smallest_amplitude_ratio;         ///< least W/a
        std::optional<Uncertain> reference_radius;  ///< a [m] of these ratios; empty: Hertz'
        std::optional<Uncertain> eigenfrequency;    ///< f_1 [Hz], the lowest of the rig
    };
    /// The substrate's oscillation under a roller that should not move it.
    struct Pivot {
        Uncertain displacement;     ///< DU [m], amplitude
        Uncertain amplitude_ratio;  ///< W/a
    };

    std::string title;
    Roller roller;
    Substrate substrate;
    Uncertain friction_coefficient;  ///< mu
    Uncertain normal_force;          ///< F_N [N]
    Drive drive;
    std::optional<Pivot> pivot;
    std::optional<Uncertain> measured_contact_size;  ///< diameter, or width 2a of a line [m]
    std::vector<PrintedValue> printed;
};

}  // namespace tricontact::contact
