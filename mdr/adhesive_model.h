#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "contact/case.h"
#include "contact/model.h"
#include "contact/models/model_kind.h"
#include "mdr/disc_springs.h"
#include "mdr/line_surface.h"
#include "theory/adhesive/adhesive_curve.h"

namespace tricontact::mdr {

/// Springs whose edge lets go when it is stretched by l, and jumps into contact at the first touch:
/// Johnson, Kendall and Roberts' adhesion, see theory::AdhesiveCurve. Pressed and pulled, without a
/// tangential load; the indenter stays in its place.
class AdhesiveModel final : public contact::Model {
  public:
    /// `n_points`, `half_length` [m]: of the surface that is shown.
    AdhesiveModel(std::string name, std::unique_ptr<const DiscSprings> springs,
                  std::shared_ptr<const PlaneProfile> profile,
                  std::shared_ptr<const contact::FrictionLaw> friction, double shear_modulus,
                  theory::AdhesiveCurve curve, int n_points, double half_length);

    std::string name() const override { return name_; }
    double step_accuracy() const override { return contact::layer_springs_accuracy; }
    /// Throws contact::InputError for a step that does anything but press or pull, and for a force
    /// that pulls the bodies apart.
    contact::StepRecord advance(const contact::LoadStep& step) override;
    void release() override { state_ = {}; }
    contact::Scales scales() const override;
    std::optional<contact::PullOff> pull_off() const override { return pull_off_; }
    /// Line layout, thinned out; the tension at the edge is infinite and ends beside it.
    contact::Surface surface() const override;
    double limit_tangential_ratio() const override { return 1; }
    void start_limit() override {}
    std::string write_state() const override;
    void read_state(std::string_view bytes) override;
    const contact::Audit& audit() const override { return audit_; }

  private:
    EvenLoads loads() const;
    void audit_step(const theory::AdhesiveCurve::Motion& motion,
                    const theory::AdhesiveCurve::State& before);

    std::string name_;
    std::unique_ptr<const DiscSprings> springs_;
    std::shared_ptr<const PlaneProfile> profile_;
    std::shared_ptr<const contact::FrictionLaw> friction_;
    double shear_modulus_;  // G* [Pa]
    theory::AdhesiveCurve curve_;
    contact::PullOff pull_off_;
    PointRow row_;
    int n_points_;
    theory::AdhesiveCurve::State state_;
    contact::Audit audit_;
};

/// Of mdr and mdr-layer. Throws contact::InputError where the contact reaches the rim.
std::unique_ptr<contact::Model> make_adhesive_model(const std::string& model,
                                                    const contact::Case& c);

}  // namespace tricontact::mdr
