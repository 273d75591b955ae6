#pragma once

#include <optional>
#include <vector>

namespace tricontact::walking {

/// An elastic contact spot at the base of the body, or one spring of the bed of a rounded tip.
/// Lengths in units of b.
struct Spot {
    double position = 0;    ///< along the base, from its middle; negative is left, behind
    double height = 0;      ///< of its tip above the base plane
    double stiffness = 1;   ///< normal in units of k_z, tangential of k_x
    double offset = 0;      ///< of the spring from the tip, along the base
    double tip_radius = 0;  ///< of curvature; 0: a point, which does not roll

    bool operator==(const Spot&) const = default;
};

/// Approach of the spot to the ground when the body has sunk by z and turned by `rotation` Phi,
/// counter-clockwise; lengths in units of b. Wetter (2016), eq. B.4.1.
///
/// A rounded tip rolls: turned by Phi, the paraboloid s^2/(2 R) is the same one, its lowest point
/// moved by -R Phi and R Phi^2/2 lower. With the plane profile s^2/R of the method of
/// dimensionality reduction (Popov and Hess 2015) its springs approach by
///   d + R Phi^2/2 - (s + R Phi)^2/R = d - 2 s Phi - s^2/R - R Phi^2/2,
/// d = z - position Phi; `height` contains s^2/R. Wetter (2016), eq. B.1.1, with W = R Phi.
inline double approach(const Spot& spot, double z, double rotation) {
    return z - (spot.position + 2 * spot.offset) * rotation - spot.height -
           spot.tip_radius / 2 * rotation * rotation;
}

/// Lever of the normal force about the middle of the base, in units of b: -d approach/d Phi, so
/// that normal forces conserve energy. Over a rounded tip its mean, weighted with the forces, is
/// the place of its lowest point, position - R Phi.
inline double normal_lever(const Spot& spot, double rotation) {
    return spot.position + 2 * spot.offset + spot.tip_radius * rotation;
}

/// Contact spots as rounded tips: each is a bed of independent springs by the method of
/// dimensionality reduction (Popov and Hess 2015), pressed with the plane profile s^2/R, so that
/// it slips in part. The springs belong to the body, whose spots are the elastic ones.
///
/// k_z = E* D_c and k_x = G* D_c of Wetter (2016), eq. 4.1.7, are the stiffnesses of the bed at
/// rest: D_c is the contact's diameter under an equal share of the weight, d its indentation.
struct Bed {
    double radius = 0;  ///< R of the tips, in units of b, >= 0
    int springs = 0;    ///< per spot, >= 1
    double width = 3;   ///< of the bed over D_c; a tip ends there. Enough for 9 d upright

    bool operator==(const Bed&) const = default;
};

/// Indentation d at rest under `load` > 0, the force on a spot over k_z b; in units of b. Hertz:
/// F = 4/3 E* sqrt(R) d^(3/2) = 2/3 k_z d.
inline double resting_indentation(double load) {
    return 1.5 * load;
}

/// Springs of a spot with its bed, from left to right; `load` as above, of a spot under an equal
/// share of the weight.
std::vector<Spot> bed_springs(const Bed& bed, const Spot& spot, double load);

/// Dimensionless parameters of a micro-walking machine: a body of mass m, half height a, half width
/// b and moment of inertia Theta on contact spots of stiffness k_x and k_z, dragged by a spring k_s
/// at height h above its centre of gravity, whose base moves at v_0. Lengths are in units of b,
/// times of sqrt(m/k_x). Wetter (2016), table 4.1.1.
struct Kappas {
    double kappa1 = 0;  ///< k_s/k_x
    double kappa2 = 0;  ///< k_z/k_x
    double kappa3 = 0;  ///< a/b
    double kappa4 = 0;  ///< m g/(k_x b)
    double kappa5 = 0;  ///< friction coefficient mu
    double kappa6 = 0;  ///< (v_0/b) sqrt(m/k_x)
    double kappa7 = 0;  ///< Theta/(m b^2)
    double kappa8 = 0;  ///< h/a

    bool operator==(const Kappas&) const = default;
};

/// Friction above which the sliding body tilts over its leading spot; infinite where the spring
/// pulls at or below the base. Wetter (2016), eq. 4.2.13.
double critical_friction(const Kappas& kappas);

/// What the motion may make use of; taking one away tells how much it matters.
struct Mechanisms {
    bool vertical = true;  ///< else z stays at rest
    bool rotation = true;  ///< else phi stays 0
    bool coupling = true;  ///< else friction is bounded by mu times the spots' static normal forces

    bool operator==(const Mechanisms&) const = default;
};

/// Harmonic load on the body from outside, sin(omega t).
struct Excitation {
    double moment = 0;     ///< amplitude, counter-clockwise, in units of k_x b^2
    double force = 0;      ///< amplitude, downwards, in units of k_x b
    double frequency = 0;  ///< omega, in units of sqrt(k_x/m)

    bool operator==(const Excitation&) const = default;
};

/// A micro-walking machine, dimensionless.
struct Machine {
    enum class Model {
        two_spot,  ///< at both ends of the base: Wetter (2016), section 4.1.3
        prism,     ///< the same in a prism of 45 degrees, two contacts a side: section 5.2.3, B.4
        spots      ///< any number, anywhere along the base
    };

    Kappas kappas;
    Model model = Model::two_spot;
    std::vector<Spot> spots = {};  ///< of Model::spots only
    std::optional<Bed> bed = {};   ///< of every spot; not in the prism
    Mechanisms mechanisms = {};
    Excitation excitation = {};
    double tilting_angle = 0.1;  ///< |Phi| [rad] above which it counts as tilting

    bool operator==(const Machine&) const = default;
};

/// The spots that carry the machine: its own, or those of its model, left one first.
std::vector<Spot> spots_of(const Machine& machine);

/// The springs that carry it: its spots, or those of their beds, spot after spot.
std::vector<Spot> springs_of(const Machine& machine);

/// Vertical displacement at rest with phi = 0, in units of b; kappa4/(2 kappa2) for two spots at
/// the base plane: Wetter (2016), eq. 4.1.22. Prism: tangential springs of its flanks at rest.
double static_displacement(const Machine& machine);

/// Factor of the friction force in <f_s> = factor mu kappa4 for steady sliding: 1, or sqrt(2) in
/// the prism: Wetter (2016), eqs. 4.1.24 and 5.2.26.
double normal_load_factor(const Machine& machine);

/// f_s while all spots slide, in units of k_x b: the one that mu_e = 1 stands for.
double sliding_force(const Machine& machine);

/// Friction above which the steadily sliding machine tilts over its leading spot; infinite where
/// the spring pulls at or below the base. Wetter (2016), eq. 4.2.13, for spots anywhere and with
/// the larger friction of the prism.
double critical_friction(const Machine& machine);

/// |phi| above which the machine counts as tilting. At the 0.1 rad that a machine has by default
/// the sine of the small rotation that the model assumes is off by 0.2 % and its cosine by 0.5 %.
/// One that vibrates in the range of its static displacement stays far below, one that tilts goes
/// through any limit; large ones let machines that jump high go on.
double tilting_limit(const Machine& machine);

/// Frequency of the spring force while the body is in the air, in cycles per unit time: with
/// e = x_s - x + kappa8 phi, e'' = -kappa1 (1 + kappa3^2 kappa8^2/kappa7) e follows from Wetter
/// (2016), eqs. 4.1.17 and 4.1.19, to first order in phi.
double free_flight_frequency(const Kappas& kappas);

}  // namespace tricontact::walking
