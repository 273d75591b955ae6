#pragma once

#include <optional>
#include <string>
#include <vector>

#include "statistics/uncertain.h"

namespace tricontact::experiments {

/// A number that a publication states, SI units.
struct PrintedValue {
    std::string name;             ///< of the quantity: "contact_radius"
    std::string text;             ///< as printed: "4.56 mm"
    statistics::Uncertain value;  ///< with the printed error, 0 if there is none
    double half_digit = 0;        ///< half a unit of the last digit of the value ...
    double half_error_digit = 0;  ///< ... and of its error
    std::string source;           ///< "table 5.1.1"
};

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

/// An experiment with a micro-walking machine: an hourglass of a body and two discs lies with four
/// contact spots in a prism (two planes at 45 degrees) and is dragged by a rod or spring. SI units;
/// empty where the experimenter does not say.
struct WalkingRig {
    struct Specimen {
        statistics::Uncertain mass;           ///< m [kg]
        statistics::Uncertain disc_diameter;  ///< D [m]
        statistics::Uncertain disc_length;    ///< l_2 [m]
        statistics::Uncertain centre_length;  ///< l_1 [m], between the discs
        statistics::Uncertain edge_radius;    ///< R_c [m] of the discs where they touch
        statistics::Uncertain young;          ///< E_1 [Pa] of the discs
        statistics::Uncertain poisson;        ///< nu_1 [-]
    };
    struct Substrate {
        statistics::Uncertain young;    ///< E_2 [Pa]
        statistics::Uncertain poisson;  ///< nu_2 [-]
    };
    struct Contact {
        statistics::Uncertain diameter;                      ///< D_c [m] that the evaluation uses
        std::optional<statistics::Uncertain> wear_diameter;  ///< [m] of the wear spots
    };
    struct Spring {
        statistics::Uncertain stiffness;                        ///< [N/m] of the spring alone
        std::optional<statistics::Uncertain> sensor_stiffness;  ///< [N/m], in series with it
        std::optional<statistics::Uncertain> length;            ///< l_s [m] of a rod
        std::optional<statistics::Uncertain> young;             ///< E_s [Pa] of a rod
        std::optional<statistics::Uncertain> height_ratio;  ///< kappa_8 = h/a, where it attaches
    };
    /// Characteristic frequency of the spring force, in the experiment and in its simulation.
    struct Oscillation {
        statistics::Uncertain frequency;                     ///< Omega_exp [Hz]
        statistics::Uncertain simulated;                     ///< omega_sim [-], in units of 1/tau
        statistics::Uncertain time;                          ///< tau [s] that the evaluation uses
        std::optional<statistics::Uncertain> sampling_rate;  ///< [Hz] of the force
    };

    std::string title;
    Specimen specimen;
    Substrate substrate;
    statistics::Uncertain friction_coefficient;  ///< mu
    Contact contact;
    Spring spring;
    std::optional<Oscillation> oscillation;
    std::vector<PrintedValue> printed;
};

}  // namespace tricontact::experiments
