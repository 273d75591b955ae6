#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "contact/compliances/blocks.h"
#include "contact/compliances/focused_compliance.h"
#include "contact/friction/friction_law.h"
#include "contact/solvers/adhesive_normal.h"
#include "contact/solvers/contact_share.h"
#include "contact/solvers/coupling.h"
#include "contact/solvers/edge_chatter.h"
#include "contact/solvers/load_step.h"
#include "contact/solvers/normal_solver.h"
#include "contact/solvers/tangential_solver.h"
#include "contact/substrates/substrate.h"

namespace tricontact::contact {

/// The state of the surface that a step starts from.
struct StepStart {
    SurfaceField traction, displacement;  ///< [Pa], [m]
    Vector2 shift;                        ///< U [m]
    double rotation = 0;                  ///< of the indenter in the step [rad], about `centre`
    Vector2 centre{};                     ///< [m]
    bool advected = false;                ///< by one cell, see advect()
    std::vector<double> way = {};         ///< see ContactSolution [m]
    Vector2 strain = {};                  ///< of all of the substrate in the step, XX and YY [-]
};

/// Normal and tangential contact at the end of a step.
struct ContactSolution {
    Vector2 offset{};         ///< of the indenter [m]
    NormalControl control{};  ///< what is prescribed normal to the surface
    Vector2 shift{};          ///< U [m]
    std::shared_ptr<const NormalSolution> normal;
    std::vector<double> bound;  ///< of friction [Pa]
    double total_bound = 0;     ///< of friction on these pressures, at rest [N]
    std::vector<double> way;    ///< of slip, where friction remembers() it [m]; else empty
    bool may_differ = false;    ///< another state has the same loads, or none is known not to
    TangentialSolution tangential;
    SurfaceField displacement;  ///< by all tractions [m]
    double gap_residual = 0;    ///< of coupled contact, over the length of `normal` [-]
    double shift_factor = 0;    ///< slips are compared with it times mu d; 0: not known yet
    int normal_iterations = 0, tangential_iterations = 0;
};

/// Normal and tangential contact with friction in one step. Uncoupled, one after the other;
/// coupled by a staggered iteration (Panagiotopoulos 1975), Anderson-accelerated (see FixedPoint),
/// until what the friction does to the gap no longer changes. A relaxing substrate is stepped as an
/// elastic one whose displacements are the effective ones, stiffness u + offset: heights, shifts
/// and what was displaced before enter the solvers in that measure. Where the compliance exposes
/// its matrix, coupled contact is solved on the points that may touch, and then looked at on all:
/// those that penetrate join them.
class StaggeredSolver {
  public:
    /// `name`: for messages. `tolerance` [-]: of the tangential solver and of the staggered
    /// iteration, over mu d and d; the normal solver gets a tenth of it.
    StaggeredSolver(std::string name, Substrate& substrate, const Indenter& indenter,
                    std::shared_ptr<const FrictionLaw> friction, double tolerance,
                    const ContactOptions& options);

    /// The surfaces attract each other from now on, uncoupled. They carry a shear strength where
    /// they touch; under Coulomb's law they are pressed alone.
    void attract(const Attraction& attraction);
    /// How; null if they do not.
    const AdhesiveNormal* adhesive() const { return adhesive_ ? &*adhesive_ : nullptr; }

    const ContactSolution& now() const { return now_; }
    const Coupling& coupling() const { return coupling_; }
    SurfaceField tractions() const;  ///< of the present solution, in all [Pa]

    /// Forgets all steps; normal solutions of positions stay.
    void release();
    /// The indenter is worn by this depth over the points from now on [m]; forgets all steps.
    void wear(std::vector<double> depth) {
        coupling_.wear(std::move(depth));
        normal_cache_.clear();
        release();
    }
    /// Begins the step of the substrate and solves. Throws NotConverged.
    void solve(const LoadStep& step, const StepStart& before);
    /// Keeps the solution as the start of the same phase in the next period.
    void keep_start(double phase);
    /// Takes over what points remember of their slip after a step.
    void remember(std::vector<double> way) { now_.way = std::move(way); }
    /// Goes on from this solution of a step at `phase`.
    void resume(ContactSolution solution, double phase);
    /// What is prescribed of a step, ratios as the forces that they are at the present F_N.
    std::array<TangentialControl, 2> forces_and_shifts(const LoadStep& step) const;
    FrictionLaw::Total total_friction() const {
        return {now_.normal->touch_force(), now_.total_bound};
    }
    /// Bound over pressure, in the mean of the present contact [-]: mu of Coulomb's law.
    double friction_ratio() const { return friction_->ratio(total_friction()); }
    /// Shift of the indenter over a point in the step by its rotation, and by the strain of the
    /// substrate [m].
    Vector2 uneven_shift(const StepStart& before, std::size_t i) const;
    /// By how much the indenter has moved over a point in the step before they met within it [m],
    /// see LoadStep::in_proportion.
    Vector2 before_touch(std::size_t i) const {
        return before_touch_.size() == 0 ? Vector2{} : before_touch_.at(i);
    }

  private:
    /// The last solution at a phase of the period. A contact that rolls back and forth comes back
    /// to nearly the same pressures and tractions one period later: the best start for an iteration
    /// that is to find them. Starts change no result by more than the solvers' tolerance.
    struct PeriodStart {
        std::shared_ptr<const NormalSolution> normal;
        TangentialField traction;   // [Pa]
        Vector2 shift_increment{};  // [m]
        double highest = 0;         // see highest_
    };
    using Key = std::tuple<Vector2, NormalControl::Kind, double>;  // offset and normal control
    Key key() const { return {now_.offset, now_.control.kind, now_.control.value}; }

    const Compliance& compliance() const { return focused_ ? *focused_ : substrate_.compliance(); }
    const ContactPoints& points() const { return substrate_.compliance().points(); }
    int n_threads() const { return substrate_.compliance().n_threads(); }
    Blocks blocks() const { return {points().size(), n_threads()}; }
    void make_solvers();
    std::vector<double> update_height();
    void recall_start(double phase);
    void recall_pressure(double phase);
    void keep_pressure_change(long key);
    void solve_uncoupled(const LoadStep& step, const StepStart& before);
    void keep_normal();
    void roll_adhesive(const Vector2& offset);
    void solve_adhesive(const LoadStep& step, const StepStart& before);
    void solve_coupled(const LoadStep& step, const StepStart& before);
    void iterate(const LoadStep& step, const StepStart& before);
    std::vector<std::uint8_t> may_touch() const;
    void focus(const std::vector<std::uint8_t>& on);
    bool look_at_all();
    void find_highest();
    void solve_normal(NormalControl control, const std::vector<double>& height);
    double update_bounds();
    void share_points(const std::vector<double>& height, NormalSolution& solution);
    void solve_friction(const LoadStep& step, const StepStart& before);
    void solve_tangential(const LoadStep& step, const StepStart& before);
    void solve_under_bounds(const LoadStep& step, const StepStart& before, double contact_area,
                            const Hardening* hardening = nullptr);
    void harden(const LoadStep& step, const StepStart& before, double contact_area);
    void follow_slip(const LoadStep& step, const StepStart& before, double contact_area);
    std::vector<double> bounds_by_way(const std::vector<double>& way,
                                      const std::vector<double>& at_rest) const;
    void update_way(const StepStart& before);
    void settle_bounds(const LoadStep& step, const StepStart& before,
                       const std::vector<double>& at_rest, double contact_area);
    bool may_slip_more(const LoadStep& step, const StepStart& before,
                       const std::vector<double>& at_rest, double contact_area);
    void keep_gap(const LoadStep& step, const StepStart& before);
    void solve_growing(const TangentialProblem& problem, const StepStart& before);
    std::vector<double> traction_ratio(const std::vector<std::size_t>& met, double radius) const;
    double local_ratio() const;
    TangentialField beyond_touch(const TangentialProblem& problem,
                                 const std::vector<std::size_t>& met, double ratio, double radius);
    void slide_freely(const LoadStep& step);
    TangentialField displaced_before(const StepStart& before) const;
    void find_shift_factor();
    void update_displacement();

    std::string name_;
    Substrate& substrate_;
    std::shared_ptr<const FrictionLaw> friction_;
    double tolerance_;
    std::optional<FocusedCompliance> focused_;  // of a dense one that is coupled
    Coupling coupling_;
    std::optional<ContactShare> share_;  // where the law jumps at the edge of the contact
    int n_shared_ = 0;                   // times in this step
    std::vector<std::uint8_t> focus_;    // per point, empty: all
    double highest_ = 0;                 // the indenter over the points in contact, undeformed [m]
    double looseness_ = 1;               // of the tangential contact in this staggered iteration
    std::vector<double> gap_before_;     // at the start of a step in proportion [m]; else empty
    TangentialField before_touch_;       // see before_touch(); empty: 0
    // Of solve_growing(): t/p where points are met, and whether this step keeps it.
    std::vector<double> met_traction_;
    bool met_is_kept_ = false;
    // They keep factors of the compliance.
    std::optional<NormalSolver> normal_solver_;
    std::optional<TangentialSolver> tangential_solver_;
    std::optional<AdhesiveNormal> adhesive_;
    EdgeChatter chatter_;
    ContactSolution now_;
    std::map<Key, std::shared_ptr<const NormalSolution>> normal_cache_;  // of uncoupled contact
    std::map<long, PeriodStart>
        starts_;  // of coupled contact and relaxing substrates, by the phase
    // Of the last step, over its phase one period before [Pa]; empty: that is not known.
    std::vector<double> pressure_change_;
};

}  // namespace tricontact::contact
