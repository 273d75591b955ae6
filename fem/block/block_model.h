#pragma once

#include "contact/surface_model.h"
#include "fem/block/corrected_substrate.h"

namespace tricontact::fem {

/// Contact on a block that no factor of fits the memory. Steps are solved on the lattice's
/// compliance; the block is asked for its own displacements under the tractions found, and the
/// difference enters the step anew until it no longer changes: a few solutions of the block for a
/// step, however many products the step takes.
class BlockModel final : public contact::Model {
  public:
    /// `tolerance` [-]: of the contact's solvers, and of displacements over the indentation.
    BlockModel(std::string name, BlockElasticity elasticity,
               std::shared_ptr<const contact::Indenter> indenter,
               std::shared_ptr<const contact::FrictionLaw> friction, double tolerance,
               const contact::Case::Contact& options);

    std::string name() const override { return linear_.name(); }
    double step_accuracy() const override { return linear_.step_accuracy(); }
    bool is_coupled() const override { return linear_.is_coupled(); }
    /// Throws contact::NotConverged, contact::ContactAtEdge.
    contact::StepRecord advance(const contact::LoadStep& step) override;
    void release() override;
    void start_period() override { linear_.start_period(); }
    contact::Scales scales() const override { return linear_.scales(); }
    contact::Surface surface() const override { return linear_.surface(); }
    std::vector<contact::ContactState> contact_states() const override {
        return linear_.contact_states();
    }
    double limit_tangential_ratio() const override { return linear_.limit_tangential_ratio(); }
    void start_limit() override { linear_.start_limit(); }
    std::unique_ptr<const contact::Interior> interior() override { return linear_.interior(); }
    /// Coupled only.
    std::unique_ptr<Model> sibling(const contact::Case::Contact& options) const override;
    const contact::Audit& audit() const override { return audit_; }
    /// With the block's last solution, 8 bytes for each unknown: what begins from another one
    /// differs within the tolerance.
    std::string write_state() const override;
    void read_state(std::string_view bytes) override;

  private:
    template <class Archive, class Self>
    static void transfer_correction(Archive& archive, Self& m);
    double update_correction(double indentation);
    void audit_step();

    BlockElasticity elasticity_;
    std::shared_ptr<const contact::Indenter> indenter_;
    std::shared_ptr<const contact::FrictionLaw> friction_;
    double tolerance_;
    std::shared_ptr<CorrectedSubstrate::Correction> correction_;
    contact::SurfaceModel linear_;
    contact::Audit audit_;
    double worst_reaction_ = 0, worst_mismatch_ = 0;
};

}  // namespace tricontact::fem
