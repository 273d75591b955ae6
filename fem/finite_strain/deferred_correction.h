#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/friction/friction_law.h"
#include "contact/load_path.h"
#include "contact/solvers/normal_solver.h"
#include "contact/solvers/tangential_solver.h"
#include "fem/discretisation.h"
#include "fem/finite_strain/contact_frames.h"
#include "fem/finite_strain/step_slip.h"
#include "fem/finite_strain/strained_body.h"
#include "fem/single_factor.h"

namespace tricontact::fem {

/// A body at finite strains and the indenter on it.
struct ContactedBody {
    StrainedState body;
    Pose pose;
    std::vector<Vector3> position;      ///< of the contact points, x, y and into the substrate [m]
    std::vector<double> pressure;       ///< vertical force over reference area [Pa]
    contact::TangentialField traction;  ///< of friction along the frames [Pa]
    contact::TangentialField slip;      ///< of the step, indenter over substrate, likewise [m]
};

/// Tolerance over fem.tolerance: it costs an iteration or two.
constexpr double of_fem_tolerance = .01;

/// Solves a step of frictional contact at finite strains by the linear layer's factor and its
/// condensed compliance: what the linear elasticity leaves of the balance of forces is a load on it
/// in the next iteration (deferred correction), in which contact is linear in the frames of the
/// present surface. Gap, normals and slip are those of the displaced surface and of the indenter's
/// full motion. Iterates are combined as FixedPoint does, which for a body that is smooth about its
/// state is GMRES on its consistent tangent with the linear factor as preconditioner (Walker and Ni
/// 2011, SIAM J. Numer. Anal. 49, section 2).
class DeferredCorrection {
  public:
    struct Problem {
        const Discretisation& discretisation;
        const StrainedBody& body;
        const SingleFactor& factor;             ///< of the linear stiffness
        const contact::Compliance& compliance;  ///< of the same, on the contact points
        const contact::Indenter& indenter;
        double rolling_radius;  ///< [m]
        const contact::FrictionLaw& friction;
        double tolerance;  ///< [-] on forces over the largest, and lengths over d
    };
    /// What an iteration and the solution left.
    struct Report {
        int iterations = 0;
        double force_residual = 0;         ///< of all nodes, over the forces on the surface [-]
        double gap_residual = 0;           ///< what penetrates or does not touch, over d [-]
        double displacement_residual = 1;  ///< last change of the surface over d [-]
        double energy = 0;                 ///< stored in the modelled part of the body [J]
        contact::NormalSolution normal;
        contact::TangentialSolution tangential;
    };

    explicit DeferredCorrection(const Problem& problem);
    ~DeferredCorrection();

    /// From the state `before` to that at the end of the step, in which the body relaxes as
    /// `relaxing` says; `now` holds the start of the iteration. Throws NotConverged.
    Report solve(const contact::LoadStep& step, const RelaxingStep& relaxing,
                 const ContactedBody& before, ContactedBody& now);
    ContactedBody at_rest() const;
    StepSlip step_slip(const ContactedBody& before, const Pose& now) const;
    /// F_N downwards and F_T in the plane [N], of the whole contact.
    Vector3 forces(const ContactedBody& state) const;
    /// Of friction, over the areas of the undeformed surface [Pa].
    std::vector<double> bounds(const ContactedBody& state, const ContactFrames& frames) const;
    /// What penetrates or does not touch, over the indentation [-].
    double gap_residual(const ContactedBody& state, const ContactFrames& frames) const;

  private:
    struct Contact;
    std::vector<Vector3> positions(const StrainedState& body) const;
    std::vector<Vector3> tractions(const ContactedBody& state, const ContactFrames& frames) const;
    std::vector<double> contact_forces(const std::vector<Vector3>& traction) const;
    std::vector<double> missing_forces(const std::vector<Vector3>& traction,
                                       const std::vector<double>& of_body) const;
    double balance_residual(const std::vector<Vector3>& traction,
                            const std::vector<double>& of_body, double depth) const;
    std::vector<double> as_one(const ContactedBody& state) const;
    void take(const std::vector<double>& all, ContactedBody& state) const;
    std::vector<Vector3> move_surface(std::span<const float> eliminated) const;
    std::vector<double> move_all(std::span<const float> eliminated,
                                 const std::vector<Vector3>& old_traction,
                                 const std::vector<Vector3>& traction, double part) const;
    void solve_contact(const contact::LoadStep& step, const ContactedBody& before,
                       const ContactFrames& frames, const std::vector<Vector3>& moved,
                       Contact& contact, ContactedBody& now, Report& report) const;
    double carried_by_friction(const ContactedBody& now, const ContactFrames& frames) const;
    void press(contact::NormalControl control, const std::vector<double>& height, double carried,
               Contact& contact, ContactedBody& now, Report& report) const;
    /// What friction is asked for in a contact at given pressures.
    struct Sliding {
        std::array<contact::TangentialControl, 2> control;
        contact::Vector2 shift_before;              ///< [m]
        const contact::TangentialField& bare_slip;  ///< without tractions [m]
        double carried;                             ///< of F_N by friction on slopes [N]
        double looseness;                           ///< see contact::TangentialProblem
    };
    void slide(const Sliding& sliding, const ContactFrames& frames, Contact& contact,
               ContactedBody& now, Report& report) const;

    Problem problem_;
};

}  // namespace tricontact::fem
