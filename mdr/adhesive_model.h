#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/case.h"
#include "contact/model.h"
#include "contact/models/model_kind.h"
#include "mdr/adhesive_friction.h"
#include "mdr/disc_springs.h"
#include "mdr/line_surface.h"
#include "theory/adhesive/adhesive_hysteresis.h"

namespace tricontact::mdr {

/// Springs whose edge lets go when it is stretched by l, and jumps into contact at the first touch:
/// Johnson, Kendall and Roberts' adhesion, see theory::AdhesiveHysteresis; on the half-space also
/// Dugdale's tension of some range, theory::dugdale_contacts(). Where the surfaces are
/// alike all over, and so is the work of adhesion whether they close or part, the normal contact
/// moves along with an indenter that rolls: it closes in front as it opens behind.
class AdhesiveModel final : public contact::Model {
  public:
    struct Parts {
        std::shared_ptr<const PlaneProfile> profile;
        std::unique_ptr<const DiscSprings> springs;
        std::optional<theory::AdhesiveHysteresis> curve;
    };
    /// `shear_modulus`: G* [Pa]. `sliding` empty: pressed and pulled alone, the indenter stays in
    /// its place. `n_points`, `half_length` [m]: of the surface that is shown then.
    AdhesiveModel(std::string name, Parts parts,
                  std::shared_ptr<const contact::FrictionLaw> friction, double shear_modulus,
                  std::optional<AdhesiveFriction> sliding, int n_points, double half_length);

    std::string name() const override { return name_; }
    double step_accuracy() const override {
        return sliding_ ? sliding_->model().step_accuracy() : contact::layer_springs_accuracy;
    }
    /// Throws contact::InputError for a step that does anything but press or pull where nothing is
    /// known to slide, and for a force that pulls the bodies apart.
    contact::StepRecord advance(const contact::LoadStep& step) override;
    void release() override {
        state_ = {};
        widest_ = 0;
        if (sliding_) sliding_->release();
    }
    contact::Scales scales() const override;
    std::optional<contact::PullOff> pull_off() const override { return pull_off_; }
    /// Line layout, thinned out; the tension at the edge is infinite and ends beside it.
    contact::Surface surface() const override;
    std::vector<contact::ContactState> contact_states() const override {
        return sliding_ && state_.touches() ? sliding_->model().contact_states()
                                            : surface().contact_state;
    }
    double limit_tangential_ratio() const override {
        return sliding_ ? sliding_->model().limit_tangential_ratio() : 1;
    }
    void start_limit() override {
        if (sliding_) sliding_->model().start_limit();
    }
    std::string write_state() const override;
    void read_state(std::string_view bytes) override;
    const contact::Audit& audit() const override { return audit_; }

  private:
    EvenLoads loads() const;
    EvenLoads with_ring(EvenLoads even) const;
    void show_normal(const EvenLoads& even, int point, contact::Surface& s) const;
    void audit_step(const theory::AdhesiveCurve::Motion& motion,
                    const theory::AdhesiveCurve::State& before);
    template <class Archive, class Self>
    static void transfer(Archive& archive, Self& model);

    std::string name_;
    Parts parts_;
    std::shared_ptr<const contact::FrictionLaw> friction_;
    double shear_modulus_;  // G* [Pa]
    contact::PullOff pull_off_;
    std::optional<AdhesiveFriction> sliding_;
    PointRow row_;
    int n_points_;
    theory::AdhesiveCurve::State state_;
    double widest_ = 0;  // contact radius so far [m]
    contact::Audit audit_;
};

/// Of mdr and mdr-layer; `unattracted` makes the same model of a case without adhesion. Throws
/// contact::InputError where the contact reaches the rim.
std::unique_ptr<contact::Model> make_adhesive_model(
    const std::string& model, const contact::Case& c,
    const std::function<std::unique_ptr<contact::Model>(const contact::Case&)>& unattracted);

}  // namespace tricontact::mdr
