#pragma once

#include <algorithm>
#include <functional>
#include <memory>

#include "contact/friction/friction_law.h"
#include "contact/model.h"
#include "contact/models/model_kind.h"
#include "fem/condensed_compliance.h"
#include "fem/finite_strain/deferred_correction.h"

namespace tricontact::fem {

/// Frictional contact of a rigid indenter on a layer at finite strains, in world-fixed coordinates;
/// contact and friction in the current configuration. How a step is solved: DeferredCorrection. One
/// that does not converge is taken in halves.
///
/// Tractions that results tell are true ones (Cauchy), on the deformed surface: pressure along its
/// normal, friction in its plane along the directions that x and y become. Slip likewise. F_N and
/// F_T are vertical and horizontal.
class StrainedModel final : public contact::Model {
  public:
    /// What siblings share: the layer, its factor, the indenter.
    struct Setup {
        std::shared_ptr<const CondensedCompliance> layer;
        std::shared_ptr<const contact::Indenter> indenter;
        double rolling_radius;  ///< [m]
        std::shared_ptr<const contact::FrictionLaw> friction;
        double tolerance;                                   ///< see DeferredCorrection
        std::array<double, meshes::n_regions> c01_ratio{};  ///< see StrainedBody
        contact::Relaxation relaxation;
        /// A layer with a larger patch of contact than the last one; empty: there is none. Throws
        /// InputError where it would be too large.
        std::function<std::shared_ptr<const CondensedCompliance>()> larger_layer = {};
    };
    /// Factorises the layer's stiffness. Throws NotConverged.
    explicit StrainedModel(Setup setup);
    ~StrainedModel() override;

    std::string name() const override { return contact::models::fem; }
    bool is_coupled() const override { return true; }
    double step_accuracy() const override { return setup_.tolerance / of_fem_tolerance; }
    contact::StepRecord advance(const contact::LoadStep& step) override;
    void release() override;
    void enlarge(const contact::ContactAtEdge& reached) override;
    void start_period() override;
    contact::Scales scales() const override;
    contact::Surface surface() const override;
    std::vector<contact::ContactState> contact_states() const override;
    double limit_tangential_ratio() const override;
    std::unique_ptr<const contact::Interior> interior() override;
    std::unique_ptr<contact::Model> sibling(const contact::Case::Contact& options) const override;
    void start_limit() override;
    std::string write_state() const override;
    void read_state(std::string_view bytes) override;
    const contact::Audit& audit() const override { return audit_; }

  private:
    const contact::ContactPoints& points() const { return setup_.layer->points(); }
    ContactFrames frames() const;
    contact::LoadStep present_step(const contact::LoadStep& next) const;
    void take(const contact::LoadStep& step, int halvings);
    void end_step(const contact::LoadStep& step, const ContactedBody& before,
                  const RelaxingStep& relaxing, const DeferredCorrection::Report& report);
    void update_slip(const ContactedBody& before, const ContactFrames& frames);
    void audit_step(const contact::LoadStep& step, const ContactFrames& frames,
                    const DeferredCorrection::Report& report);
    /// `energy`: stored in the modelled part now [J].
    void audit_energy(const ContactedBody& before, const RelaxingStep& relaxing, double energy);
    double work_of_springs(const StrainedState& from, const StrainedState& to) const;
    contact::StepRecord record(const contact::LoadStep& step) const;
    /// Of bounds per point [Pa], and of the present F_N.
    contact::FrictionLaw::Total total_friction(const std::vector<double>& bound) const;
    /// What slips are compared with [m].
    double compared_slip(const contact::FrictionLaw::Total& total) const {
        return std::max(setup_.friction->ratio(total), .1) * now_.pose.indentation;
    }
    template <class Archive, class Self>
    static void transfer(Archive& archive, Self& model);

    Setup setup_;
    struct Solver {
        explicit Solver(const Setup& setup);
        StrainedBody body;
        DeferredCorrection correction;
    };
    std::unique_ptr<Solver> solver_;
    ContactedBody now_;
    StrainMemory memory_;
    contact::Vector2 forces_{};                      // F_T of the present state [N]
    double normal_force_ = 0;                        // F_N [N]
    double energy_ = 0, relaxed_energy_ = 0;         // stored, without branches [J]
    double material_dissipation_ = 0;                // in the last step [J]
    contact::TangentialField slip_;                  // of the last step, along the frames [m]
    std::vector<double> work_;                       // of friction in the last step [J/m^2]
    std::vector<double> slip_path_, friction_work_;  // since start_period()
    std::vector<contact::ContactState> contact_state_;
    std::vector<double> least_pressure_;         // since start_limit()
    contact::FrictionLaw::Total limit_start_{};  // at start_limit()
    int iterations_ = 0;                         // of the last step
    double force_residual_ = 0, displacement_residual_ = 0;
    contact::Audit audit_;
};

}  // namespace tricontact::fem
