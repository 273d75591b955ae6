#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "contact/base/special_values.h"
#include "contact/bodies/indenter.h"
#include "contact/case.h"
#include "contact/friction/friction_law.h"
#include "contact/mirrored_surface.h"
#include "contact/model.h"
#include "contact/solvers/pull_off.h"
#include "contact/solvers/staggered_solver.h"
#include "contact/wearing_contact.h"

namespace tricontact::contact {

/// Contact of an indenter over any compliance, with friction, in world-fixed coordinates:
/// surface points keep their displacement when the indenter rolls away from them.
///
/// How a step is solved: StaggeredSolver.
class SurfaceModel final : public Model, public Wearable, public ShowsSurface {
  public:
    /// `tolerance` [-]: see StaggeredSolver.
    SurfaceModel(std::string name, const Substrate& substrate,
                 std::shared_ptr<const Indenter> indenter,
                 std::shared_ptr<const FrictionLaw> friction, double tolerance,
                 const Case::Contact& options = {});
    /// On an elastic substrate.
    SurfaceModel(std::string name, std::shared_ptr<const Compliance> compliance,
                 std::shared_ptr<const Indenter> indenter,
                 std::shared_ptr<const FrictionLaw> friction, double tolerance,
                 const Case::Contact& options = {});

    /// The same body on a larger grid than that whose edge the contact has reached, a still larger
    /// one each time. Throws InputError, NotConverged.
    using LargerGrid = std::function<std::unique_ptr<Substrate>(const ContactAtEdge& reached)>;
    /// Where `enlarge` finds it. Siblings have it too.
    void set_larger_grid(LargerGrid larger) { larger_grid_ = std::move(larger); }

    /// The surfaces attract each other from now on, at rest, see StaggeredSolver.
    /// `modulus`: E* of the pair [Pa]. Throws InputError as attraction_on(), or
    /// attraction_by_cell().
    void attract(const AttractionLaw& law, double modulus, bool by_cell = false);

    std::string name() const override { return name_; }
    double step_accuracy() const override { return tolerance_; }
    bool is_coupled() const override { return !solver_->coupling().is_decoupled(); }
    StepRecord advance(const LoadStep& step) override {
        return take(step, {solver_->tractions(), now().displacement, now().shift,
                           step.rotation - rotation_, centre_of(step), false, now().way,
                           Vector2{step.bulk.strain[0] - bulk_.strain[0],
                                   step.bulk.strain[1] - bulk_.strain[1]}});
    }
    /// Rolls on by one cell of the grid along x, in the frame that moves with the indenter: its
    /// offset stays, and all fields are advected by one cell before the step is taken. In it the
    /// indenter also rotates by `rotation` [rad] about the step's centre, from x towards y. Throws
    /// InputError as check_rolls_on().
    StepRecord roll(const LoadStep& step, double rotation);
    void release() override;
    void enlarge(const ContactAtEdge& reached) override;
    void start_period() override {
        slip_path_.assign(points().size(), 0);
        friction_work_ = slip_path_;
    }
    Scales scales() const override;
    std::optional<PullOff> pull_off() const override;
    Surface surface() const override;
    bool show(const Look& look) const override;
    std::vector<ContactState> contact_states() const override;
    double limit_tangential_ratio() const override;
    void start_limit() override {
        least_pressure_ = now().normal->pressure;
        least_share_ = now().normal->share;
        limit_start_ = solver_->total_friction();
    }
    std::unique_ptr<const Interior> interior() override;
    std::unique_ptr<Model> sibling(const Case::Contact& options) const override;
    std::unique_ptr<WearingContact> wearing(const WearProblem& problem) override;
    std::string write_state() const override;
    void read_state(std::string_view bytes) override;
    const Audit& audit() const override { return audit_; }

  private:
    friend class SurfaceWearing;
    /// Of a step [J]: work on the surface less what became of it; the magnitudes of all terms.
    struct EnergyBalance {
        double missing, magnitude;
    };

    StepRecord take(const LoadStep& step, const StepStart& before);
    const ContactSolution& now() const { return solver_->now(); }
    const ContactPoints& points() const { return substrate_->compliance().points(); }
    Blocks blocks(std::size_t n) const { return {n, substrate_->compliance().n_threads()}; }
    void make_solver();
    void update_slip(const StepStart& before);
    void update_memory(const StepStart& before);
    // Of the last step, as results tell it [m], [J/m^2].
    Vector2 slip(std::size_t i) const { return told_slip(contact_state_[i], slip_.at(i)); }
    double friction_work(std::size_t i) const {
        return work_.empty() ? frictional_work(contact_state_[i], now().tangential.traction.at(i),
                                               slip_.at(i))
                             : work_[i];
    }
    /// What a surface tells that is no field of the solution, at the points.
    struct Told {
        std::vector<double> gap, slip_x, slip_y, dissipation, separation_work;
    };
    Told told() const;
    StepRecord record(const LoadStep& step) const;
    std::optional<PullOff> pulled_off() const;
    void audit_attracted(const LoadStep& step);
    void audit_friction(const LoadStep& step);
    void audit_step(const LoadStep& step, bool advected);
    EnergyBalance update_energy();
    template <class Archive, class Self>
    static void transfer_rest(Archive& archive, Self& model);

    Vector2 centre_of(const LoadStep& step) const {
        return step.centre.at(step.offset, indenter_->lowest_point());
    }

    std::string name_;
    std::unique_ptr<Substrate> substrate_;
    std::shared_ptr<const Indenter> indenter_;
    std::shared_ptr<const FrictionLaw> friction_;
    double tolerance_;
    Case::Contact options_;
    LargerGrid larger_grid_;
    struct Attracted {
        AttractionLaw law;
        double modulus;  // [Pa]
        bool by_cell;
    };
    std::optional<Attracted> attracted_;
    static constexpr NormalControl not_pressed{NormalControl::Kind::force, -infinity};
    NormalControl hardest_ = not_pressed;  // of surfaces that attract each other
    std::optional<StaggeredSolver> solver_;

    double phase_ = 0;                               // 0 of what does not recur
    double rotation_ = 0;                            // of the indenter since the start [rad]
    BulkState bulk_;                                 // of the substrate
    TangentialField slip_;                           // of the last step [m]
    std::vector<double> slip_path_, friction_work_;  // since start_period(), see Surface
    std::vector<ContactState> contact_state_;
    // Of the last step, where friction remembers: frictional work [J/m^2] and, in all, what the
    // tractions' work on the slip exceeds it by [J].
    std::vector<double> work_;
    double released_ = 0;
    std::vector<double> least_pressure_, least_share_;  // since start_limit()
    FrictionLaw::Total limit_start_{};                  // at start_limit()
    double energy_ = 0;                                 // stored, of the present state [J]
    double material_dissipation_ = 0;                   // of the last step [J]
    Audit audit_;
};

}  // namespace tricontact::contact
