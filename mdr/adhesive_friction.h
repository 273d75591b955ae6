#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "contact/model.h"

namespace tricontact::mdr {

/// The tangential contact of surfaces that attract each other and carry tau_0 wherever they touch.
/// As normal and tangential contact do not couple, and no traction along the surface is infinite
/// anywhere (none peels the edge), nothing of the normal contact matters but its radius: it is that
/// of the same body pressed without attraction until its contact is as wide.
class AdhesiveFriction {
  public:
    /// `unattracted`: of springs, which StoresShear.
    explicit AdhesiveFriction(std::unique_ptr<contact::Model> unattracted);

    /// Takes the tangential part of a step to a contact that is pressed to this depth without
    /// attraction [m], and adds it to the record of the normal part, whose contact_area is known.
    /// Throws contact::InputError for a contact that no depth makes as wide.
    void advance(const contact::LoadStep& step, double depth, contact::StepRecord& record,
                 contact::Audit& audit);
    /// Contact has been lost, with all that was stored along the surface. Throws
    /// contact::InputError under a tangential load or shift, which nothing holds then.
    void let_go(const contact::LoadStep& step, contact::StepRecord& record);
    void release() { unattracted_->release(); }

    const contact::Model& model() const { return *unattracted_; }
    contact::Model& model() { return *unattracted_; }

  private:
    double stored() const;

    std::unique_ptr<contact::Model> unattracted_;
};

}  // namespace tricontact::mdr
