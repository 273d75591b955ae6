#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/printed_value.h"
#include "contact/uncertain.h"

namespace tricontact::contact {

/// An experiment with a micro-walking machine: an hourglass of a body and two discs lies with four
/// contact spots in a prism (two planes at 45 degrees) and is dragged by a rod or spring. SI units;
/// empty where the experimenter does not say.
struct WalkingRig {
    struct Specimen {
        Uncertain mass;           ///< m [kg]
        Uncertain disc_diameter;  ///< D [m]
        Uncertain disc_length;    ///< l_2 [m]
        Uncertain centre_length;  ///< l_1 [m], between the discs
        Uncertain edge_radius;    ///< R_c [m] of the discs where they touch
        Uncertain young;          ///< E_1 [Pa] of the discs
        Uncertain poisson;        ///< nu_1 [-]
    };
    struct Substrate {
        Uncertain young;    ///< E_2 [Pa]
        Uncertain poisson;  ///< nu_2 [-]
    };
    struct Contact {
        Uncertain diameter;                      ///< D_c [m] that the evaluation uses
        std::optional<Uncertain> wear_diameter;  ///< [m] of the wear spots
    };
    struct Spring {
        Uncertain stiffness;                        ///< [N/m] of the spring alone
        std::optional<Uncertain> sensor_stiffness;  ///< [N/m], in series with it
        std::optional<Uncertain> length;            ///< l_s [m] of a rod
        std::optional<Uncertain> young;             ///< E_s [Pa] of a rod
        std::optional<Uncertain> height_ratio;      ///< kappa_8 = h/a, where it attaches
    };
    /// Characteristic frequency of the spring force, in the experiment and in its simulation.
    struct Oscillation {
        Uncertain frequency;                     ///< Omega_exp [Hz]
        Uncertain simulated;                     ///< omega_sim [-], in units of 1/tau
        Uncertain time;                          ///< tau [s] that the evaluation uses
        std::optional<Uncertain> sampling_rate;  ///< [Hz] of the force
    };

    std::string title;
    Specimen specimen;
    Substrate substrate;
    Uncertain friction_coefficient;  ///< mu
    Contact contact;
    Spring spring;
    std::optional<Oscillation> oscillation;
    std::vector<PrintedValue> printed;
};

}  // namespace tricontact::contact
