#pragma once

#include <functional>
#include <map>
#include <memory>
#include <tuple>

#include "contact/bodies/indenter.h"
#include "contact/case.h"
#include "contact/model.h"
#include "contact/period_starts.h"
#include "contact/solvers/compliance.h"
#include "contact/solvers/coupling.h"
#include "contact/solvers/normal_solver.h"
#include "contact/solvers/tangential_solver.h"
#include "contact/substrates/substrate.h"

namespace tricontact::contact {

/// Contact of an indenter over any compliance, with Coulomb friction, in world-fixed coordinates:
/// surface points keep their displacement when the indenter rolls away from them.
///
/// Coupled normal and tangential contact are solved in turns (Panagiotopoulos 1975), accelerated
/// (see FixedPoint), until what the friction does to the gap no longer changes.
///
/// A relaxing substrate (see Substrate) is stepped as an elastic one whose displacements are the
/// effective ones, stiffness u + offset: heights, shifts and what was displaced before enter the
/// solvers in that measure.
class SurfaceModel final : public Model {
  public:
    /// `tolerance` [-]: of the tangential solver and of the turns, over mu d and d; the normal
    /// solver gets a tenth of it.
    SurfaceModel(std::string name, const Substrate& substrate,
                 std::shared_ptr<const Indenter> indenter, double friction_coefficient,
                 double tolerance, const Case::Contact& options = {});
    /// On an elastic substrate.
    SurfaceModel(std::string name, std::shared_ptr<const Compliance> compliance,
                 std::shared_ptr<const Indenter> indenter, double friction_coefficient,
                 double tolerance, const Case::Contact& options = {});

    /// The same body on a larger grid than that whose edge the contact has reached, a still larger
    /// one each time. Throws InputError, NotConverged.
    using LargerGrid = std::function<std::unique_ptr<Substrate>(const ContactAtEdge& reached)>;
    /// Where `enlarge` finds it. Siblings have it too.
    void set_larger_grid(LargerGrid larger) { larger_grid_ = std::move(larger); }

    std::string name() const override { return name_; }
    bool is_coupled() const override { return !coupling_.absent(); }
    StepRecord advance(const LoadStep& step) override;
    /// Rolls on by one cell of the grid along x, in the frame that moves with the indenter: its
    /// offset stays, and all fields are carried to the cell behind before the step is taken. In it
    /// the indenter also turns by `turn` [rad] about z through its lowest point, from x towards y.
    /// Throws InputError as check_rolls_on().
    StepRecord roll(const LoadStep& step, double turn);
    void release() override;
    void enlarge(const ContactAtEdge& reached) override;
    void start_period() override;
    Scales scales() const override;
    Surface surface() const override;
    std::vector<ContactState> contact_states() const override { return contact_state_; }
    double limit_tangential_ratio() const override;
    void start_limit() override;
    std::unique_ptr<const Interior> interior() override;
    std::unique_ptr<Model> sibling(const Case::Contact& options) const override;
    std::string write_state() const override;
    void read_state(std::string_view bytes) override;
    const Audit& audit() const override { return audit_; }

  private:
    using Key = std::tuple<Vector2, NormalControl::Kind, double>;  // offset and normal control

    /// Of a step [J]: work on the surface less what became of it; the magnitudes of all terms.
    struct EnergyBalance {
        double missing, magnitude;
    };
    /// The state of the surface that a step starts from.
    struct Before {
        SurfaceField traction, displacement;
        Vector2 shift;
        double turn = 0;       // of the indenter in the step [rad]
        bool carried = false;  // from one cell ahead
    };

    StepRecord take(const LoadStep& step, const Before& before);
    Vector2 rigid_turn(const Before& before, std::size_t i) const;
    SurfaceField tractions() const;  // of the present solution, in all
    SurfaceField displacements() const { return SurfaceField(displacement_, displacement_z_); }
    const ContactPoints& points() const { return substrate_->compliance().points(); }
    std::vector<double> effective_height() const;
    void recall_start();
    void keep_start();
    void make_solvers();
    void solve_uncoupled(const LoadStep& step, const Before& before);
    void solve_coupled(const LoadStep& step, const Before& before);
    void solve_normal(NormalControl control, const std::vector<double>& height);
    void reuse_or_solve_normal(const LoadStep& step);
    void solve_tangential(const LoadStep& step, const Before& before);
    std::array<TangentialControl, 2> forces_and_shifts(const LoadStep& step) const;
    void slide_freely(const LoadStep& step);
    void find_shift_factor();
    void update_totals();
    void update_slip(const Before& before);
    Vector2 slip(std::size_t i) const;          // of the last step, as results tell it [m]
    double friction_work(std::size_t i) const;  // likewise [J/m^2]
    StepRecord record(const LoadStep& step) const;
    void audit_step(const LoadStep& step, bool carried);
    EnergyBalance update_energy();

    std::string name_;
    std::unique_ptr<Substrate> substrate_;
    std::shared_ptr<const Indenter> indenter_;
    double friction_coefficient_;
    double tolerance_;
    Case::Contact options_;
    LargerGrid larger_grid_;
    Coupling coupling_;
    // They keep factors of the compliance.
    std::optional<NormalSolver> normal_solver_;
    std::optional<TangentialSolver> tangential_solver_;

    double phase_ = 0;
    Vector2 offset_{};
    Vector2 shift_{};
    std::shared_ptr<const NormalSolution> normal_;
    std::map<Key, std::shared_ptr<const NormalSolution>> normal_cache_;
    PeriodStarts starts_;        // of coupled contact
    std::vector<double> bound_;  // mu p [Pa]
    TangentialSolution tangential_;
    TangentialField displacement_;                   // by all tractions [m]
    std::vector<double> displacement_z_;             // likewise
    TangentialField slip_;                           // of the last step [m]
    std::vector<double> slip_path_, friction_work_;  // since start_period(), see Surface
    std::vector<ContactState> contact_state_;
    double gap_residual_ = 0;  // of the coupled solution, over d
    double shift_factor_ = 0;  // slips are compared with it times mu d; 0: not known yet
    int normal_iterations_ = 0, tangential_iterations_ = 0;
    std::vector<double> least_pressure_;  // since start_limit()
    double least_pressure_force_ = 0;     // F_N at start_limit()
    double energy_ = 0;                   // stored, of the present state [J]
    double material_dissipation_ = 0;     // of the last step [J]
    Audit audit_;
};

}  // namespace tricontact::contact
