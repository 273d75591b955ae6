#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "contact/model.h"
#include "contact/rig_stiffness.h"
#include "contact/wearing_contact.h"

namespace tricontact::contact {

/// A model behind a rig that yields: steps prescribe the shift and depth of the drive. What is left
/// for the contact solves z + F(z)/k = z_drive, step by step, by Broyden's method over steps of
/// the model that are taken back; of one unknown bracketed, since F does not fall where z grows.
/// Where friction falls faster than the rig is stiff there may be no solution: the contact jumps,
/// and the step throws NotConverged.
class ModelOnRig final : public Model, public Wearable {
  public:
    ModelOnRig(std::unique_ptr<Model> model, const RigStiffness& rig);

    StepRecord advance(const LoadStep& step) override;
    void release() override;
    void enlarge(const ContactAtEdge& reached) override;
    std::string write_state() const override;
    void read_state(std::string_view bytes) override;
    std::unique_ptr<Model> sibling(const Case::Contact& options) const override;

    std::string name() const override { return model_->name(); }
    bool is_coupled() const override { return model_->is_coupled(); }
    double step_accuracy() const override { return model_->step_accuracy(); }
    void start_period() override { model_->start_period(); }
    Scales scales() const override { return model_->scales(); }
    Surface surface() const override { return model_->surface(); }
    std::vector<ContactState> contact_states() const override { return model_->contact_states(); }
    double limit_tangential_ratio() const override { return model_->limit_tangential_ratio(); }
    void start_limit() override { model_->start_limit(); }
    std::unique_ptr<const Interior> interior() override { return model_->interior(); }
    const Audit& audit() const override { return model_->audit(); }
    /// Of a rig that is rigid along the normal: throws InputError.
    std::unique_ptr<WearingContact> wearing(const WearProblem& problem) override;

  private:
    /// Depth, shift along x, along y [m]; forces likewise [N].
    using Vector = std::array<double, 3>;
    struct Search;

    void forget();

    std::unique_ptr<Model> model_;
    RigStiffness rig_;
    Vector compliance_;  // [m/N]
    // Of the last step: contact and drive [m], and how the contact follows the drive [-].
    Vector contact_, drive_;
    std::array<Vector, 3> share_;
};

}  // namespace tricontact::contact
