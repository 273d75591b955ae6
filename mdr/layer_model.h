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
#include "contact/substrates/relaxation.h"
#include "contact/surface_model.h"
#include "contact/wearing_contact.h"
#include "mdr/layer_springs.h"
#include "mdr/plane_profile.h"
#include "mdr/stores_shear.h"

namespace tricontact::mdr {

/// MDR of the layer: a plane profile pressed into springs that the layer couples, or the springs of
/// an elastic interface alone. The normal
/// contact of a body of revolution is exact but for the elements' length
/// (theory/layer/layer_equation.h). The tangential contact is an APPROXIMATION, as is all of MDR
/// once the contact rolls: see layer_kernel.h for what it leaves out,
/// docs/explanation/models/mdr-layer.md for what that makes.
///
/// One direction, as for a SpringBed: offsets count along the line of rolling, F_T acts along the
/// elements, areas are those of discs as long as the elements in question together.
class LayerModel final : public contact::Model, public contact::Wearable, public StoresShear {
  public:
    /// `name`: of the model. `relaxation`: of all the compliance; empty: elastic. `rolling_angle`
    /// [rad].
    LayerModel(std::string name, std::shared_ptr<const LayerSprings> springs,
               std::shared_ptr<const PlaneProfile> profile,
               std::shared_ptr<const contact::FrictionLaw> friction, double rolling_angle,
               const std::optional<contact::Relaxation>& relaxation);

    /// As many elements of the same length as the half length [m] asks for.
    using LongerLine = std::function<std::shared_ptr<const LayerSprings>(double half_length)>;
    /// Where a contact that wears finds them when it has reached the last element.
    void set_longer_line(LongerLine longer) { longer_ = std::move(longer); }

    std::string name() const override { return model_.name(); }
    double step_accuracy() const override { return contact::layer_springs_accuracy; }
    /// Throws contact::InputError if the step is none of a line's or the contact reaches the
    /// indenter's rim, contact::ContactAtEdge if it reaches the last element, NotConverged.
    contact::StepRecord advance(const contact::LoadStep& step) override;
    void release() override {
        model_.release();
        least_bounds_.clear();
    }
    /// Contact radius and peak pressure from the elements' line loads (EvenLoad).
    contact::Scales scales() const override;
    /// Line layout, thinned out; tractions transformed back, displacements those of the line.
    contact::Surface surface() const override;
    std::vector<contact::ContactState> contact_states() const override {
        return model_.contact_states();
    }
    double limit_tangential_ratio() const override;
    void start_limit() override;
    std::unique_ptr<contact::WearingContact> wearing(const contact::WearProblem& problem) override;
    std::string write_state() const override;
    void read_state(std::string_view bytes) override;
    const contact::Audit& audit() const override { return model_.audit(); }

    double shear_energy() const override;
    const LayerSprings& springs() const { return *springs_; }
    const PlaneProfile& profile() const { return *profile_; }

  private:
    void check_ends(const contact::LoadStep& step) const;
    std::vector<double> line_bounds() const;

    std::shared_ptr<const LayerSprings> springs_;
    std::shared_ptr<const PlaneProfile> profile_;
    std::shared_ptr<const contact::FrictionLaw> friction_;
    std::shared_ptr<const contact::FrictionLaw> line_law_;  // the same of the elements
    contact::Vector2 direction_;                            // of rolling
    contact::SurfaceModel model_;
    LongerLine longer_;
    // Of the elements [N/m] since start_limit, and in all at its time; not under Coulomb's law.
    std::vector<double> least_bounds_;
    double bound_at_start_ = 0;
};

/// For a case: about `elements_per_radius` elements in the contact radius, as many as contact and
/// rolling path need. On a thin layer the usual 100 stand for elements of a quarter of its
/// thickness, other numbers for longer or shorter ones in proportion. Throws contact::InputError if
/// a value of the case is out of range: no thickness, a frictionless base (nothing holds the
/// layer), too long a path, elements longer than a quarter of the thickness.
std::unique_ptr<contact::Model> make_layer_model(const contact::Case& c, int elements_per_radius);
/// The same with those of the case's settings.
std::unique_ptr<contact::Model> make_layer_model(const contact::Case& c);
/// MDR of a half-space on an elastic interface, whose springs couple those of the half-space: the
/// same without a layer. Exact for the pressing of bodies of revolution.
std::unique_ptr<contact::Model> make_model_on_interface(const contact::Case& c);

}  // namespace tricontact::mdr
