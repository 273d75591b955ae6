#pragma once

#include <memory>
#include <optional>

#include "contact/surface_model.h"
#include "fem/case/conforming_friction.h"

namespace tricontact::fem {

/// A pin in a hole, whose points are pressed along their common radius. `along_z` solves it with
/// pressures times the cosine of the angle and lengths over it (see planar::pair_compliance); this
/// model tells pressures, gaps and displacements along the radius. Its x is the arc on the pin.
/// Coupled, it is pressed with friction along the arc.
class ConformingModel final : public contact::Model {
  public:
    /// `radius` of the pin [m]; `friction` of `along_z`, if coupled.
    ConformingModel(std::unique_ptr<contact::Model> along_z, double radius,
                    std::shared_ptr<const ConformingFriction> friction)
        : along_z_(std::move(along_z)), radius_(radius), friction_(std::move(friction)) {}

    std::string name() const override { return along_z_->name(); }
    double step_accuracy() const override { return along_z_->step_accuracy(); }
    bool is_coupled() const override { return along_z_->is_coupled(); }
    /// Throws contact::InputError also for a step with a load along the surface or an offset: the
    /// pin is held where no force along x is; and for one that takes back a pin which jams.
    contact::StepRecord advance(const contact::LoadStep& step) override;
    void release() override {
        last_.reset();
        along_z_->release();
    }
    void enlarge(const contact::ContactAtEdge& reached) override { along_z_->enlarge(reached); }
    void start_period() override { along_z_->start_period(); }
    /// The contact radius is R times the half angle, where p^2, which falls to zero there as a
    /// smooth function, is zero.
    contact::Scales scales() const override;
    contact::Surface surface() const override;
    std::vector<contact::ContactState> contact_states() const override {
        return along_z_->contact_states();
    }
    std::unique_ptr<const contact::Interior> interior() override { return along_z_->interior(); }
    double limit_tangential_ratio() const override { return along_z_->limit_tangential_ratio(); }
    void start_limit() override { along_z_->start_limit(); }
    std::unique_ptr<contact::Model> sibling(const contact::Case::Contact& options) const override;
    /// With the last load: a run that goes on knows where a pin is taken back.
    std::string write_state() const override;
    void read_state(std::string_view bytes) override;
    const contact::Audit& audit() const override { return along_z_->audit(); }

  private:
    struct Pressed {
        double indentation, force;
        double of(contact::NormalControl::Kind kind) const {
            return kind == contact::NormalControl::Kind::force ? force : indentation;
        }
    };
    contact::StepRecord press(const contact::LoadStep& step);
    void refuse_jam() const;

    std::unique_ptr<contact::Model> along_z_;
    double radius_;
    std::shared_ptr<const ConformingFriction> friction_;
    std::optional<Pressed> last_;  ///< of the step before
};

}  // namespace tricontact::fem
