#pragma once

#include <functional>
#include <vector>

#include "contact/bodies/indenter.h"
#include "contact/history.h"
#include "contact/solvers/control.h"

namespace tricontact::theory {

/// Frictionless contact of one radius a under a rigid body of revolution, without adhesion, and
/// what a flat punch of that radius does on the same substrate.
struct DiscContact {
    double indentation = 0;  ///< d_0 [m]
    double force = 0;        ///< F_0 [N]
    double energy = 0;       ///< elastic [J]
    double stiffness = 0;    ///< S of the punch [N/m], on the half-space 2 E* a
    double edge = 1;         ///< its line load at the edge over E* d, on the half-space 1
};

/// Short-ranged adhesion after Johnson, Kendall and Roberts (1971) of any body of revolution on any
/// elastic substrate. A punch pulled back by l after the contact has been made,
///   d = d_0(a) - l,   F = F_0(a) - S(a) l,
/// leaves the line load -E* e l at the edge, where the pressure is its 1/(pi sqrt(a^2 - r^2)): that
/// of a crack, whose energy release rate (E* e l)^2/(2 pi a E*) is the work of adhesion w,
///   e l = sqrt(2 pi a w/E*):
/// on the half-space (e = 1) the rule of Hess for the springs of the method of dimensionality
/// reduction (Popov and Hess 2015, ch. 4). It is the same as w = l^2/2 dS/dA, A = pi a^2.
///
/// As a grows from 0 either control, F or d, falls at first, and no such state is stable. A slow
/// motion follows the stable branch from its last state, jumps at its ends, and may lose contact.
class AdhesiveCurve {
  public:
    using Family = std::function<DiscContact(double radius)>;

    /// `family`: of radii in (0, largest_radius] [m]; `guess` [m]: any of them, from where the
    /// contact that touches at d = 0 is sought, of whose radius 2 % are the least looked at. Throws
    /// std::domain_error unless modulus [Pa] and work [J/m^2] are positive, contact::InputError as
    /// follow().
    AdhesiveCurve(Family family, double modulus, double work, double guess, double largest_radius);

    struct State {
        double place = 0;        ///< along the branch [m]; without a range a; 0: far apart
        double radius = 0;       ///< a [m]; 0: out of contact
        double reach = 0;        ///< of the tension [m]; without a range a
        double indentation = 0;  ///< d [m]
        double force = 0;        ///< F [N]
        double energy = 0;       ///< elastic [J]
        double attraction = 0;   ///< of the surfaces [J]: -w A without a range, 0 far apart
        double detached = 0;     ///< l [m]
        bool touches() const { return radius > 0; }
    };
    /// States of surfaces that attract each other, by their place from 0 on.
    using Branch = std::function<State(double place)>;
    /// Of another law than a short range: `range` [m] is how far it reaches beyond the surface,
    /// `guess` and `largest_place` places, as above.
    AdhesiveCurve(Branch branch, double modulus, double work, double range, double guess,
                  double largest_place);

    State at(double place) const { return branch_(place); }
    /// The edge being held there, whatever its energy release rate.
    State held(double radius, const contact::NormalControl& control) const;

    struct Motion {
        State state;
        double released = 0;  ///< energy lost in jumps [J]
        double work = 0;      ///< of the normal force, by the trapezoidal rule over the branch [J]
        int jumps = 0;
    };
    /// From a state to that under a control, slowly. Throws contact::InputError where no radius up
    /// to the largest has it, or where a force pulls the body off.
    Motion follow(const State& from, const contact::NormalControl& control);
    /// Whether some radius up to the largest has the control, and all that pull-off goes through.
    bool reaches(const contact::NormalControl& control);
    /// Of a contact that is pulled from a wide one.
    contact::PullOff pull_off();
    /// Stable states under a control, apart included; 1 where none other is.
    int stable_states(const contact::NormalControl& control);

    /// U and the attraction [J], what the work of the force changes where nothing jumps.
    static double stored(const State& s) { return s.energy + s.attraction; }
    double work_of_adhesion() const { return work_; }

  private:
    using Kind = contact::NormalControl::Kind;
    struct Walk;

    static State pulled(double radius, const DiscContact& disc, double l, double work);
    /// Of a control [m, N]: below it nothing attracts.
    double meets_at(Kind kind) const { return kind == Kind::force ? 0 : -range_; }

    void start(double guess);
    void extend();
    const State& node(int k);
    State crossing(const State& below, const State& above, Kind kind, double level) const;
    State limit_point(double first, double last, Kind kind, int direction) const;
    State least_in_touch(Kind kind);
    void touch(Walk& walk);
    void go(Walk& walk, int direction);
    void jump_from(Walk& walk, const State& limit, int next, int direction);
    void lose(Walk& walk) const;

    Family family_;  // without a range
    Branch branch_;
    double modulus_, work_, largest_;
    double range_ = 0;
    bool begins_stable_ = false;  // the depth grows from the first place on
    std::vector<State> nodes_;    // at places that grow by a constant factor
};

/// Contacts of a body of revolution, which shall outlive them, on an elastic half-space of the
/// modulus E* [Pa]; exact.
AdhesiveCurve::Family half_space_contacts(const contact::AxisymmetricIndenter& body,
                                          double modulus);
/// On the half-space; `body` shall outlive the curve.
AdhesiveCurve half_space_curve(const contact::AxisymmetricIndenter& body, double modulus,
                               double work);

}  // namespace tricontact::theory
