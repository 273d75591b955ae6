#pragma once

#include <memory>
#include <optional>

#include "contact/surface_model.h"

namespace tricontact::fem {

/// A contact of revolution, pressed along its axis: points are radii, tractions in the surface are
/// radial, and no force along x exists. Steps that prescribe F_T = 0 hold the axis instead. Shows
/// its surface turned about the axis, on a square grid inside of the largest radius.
class ModelOfRevolution final : public contact::Model {
  public:
    /// `shear_modulus`: G* of both bodies [Pa].
    ModelOfRevolution(std::unique_ptr<contact::Model> radial, double shear_modulus)
        : radial_(std::move(radial)), shear_modulus_(shear_modulus) {}

    std::string name() const override { return radial_->name(); }
    double step_accuracy() const override { return radial_->step_accuracy(); }
    bool is_coupled() const override { return radial_->is_coupled(); }
    /// Throws contact::InputError also for a step with a load along the surface or an offset.
    contact::StepRecord advance(const contact::LoadStep& step) override;
    void release() override { radial_->release(); }
    void enlarge(const contact::ContactAtEdge& reached) override { radial_->enlarge(reached); }
    void start_period() override { radial_->start_period(); }
    /// Friction along x, which is none of revolution, has no shift here: `unit_shift` is that of
    /// the half-space under this force on this radius, a unit for figures.
    contact::Scales scales() const override;
    contact::Surface surface() const override;
    /// Of the radii.
    std::vector<contact::ContactState> contact_states() const override {
        return radial_->contact_states();
    }
    std::unique_ptr<const contact::Interior> interior() override { return radial_->interior(); }
    double limit_tangential_ratio() const override { return radial_->limit_tangential_ratio(); }
    void start_limit() override { radial_->start_limit(); }
    std::unique_ptr<contact::Model> sibling(const contact::Case::Contact& options) const override;
    std::optional<contact::PullOff> pull_off() const override { return radial_->pull_off(); }
    std::string write_state() const override { return radial_->write_state(); }
    void read_state(std::string_view bytes) override { radial_->read_state(bytes); }
    const contact::Audit& audit() const override { return radial_->audit(); }

  private:
    std::unique_ptr<contact::Model> radial_;
    double shear_modulus_;
};

}  // namespace tricontact::fem
