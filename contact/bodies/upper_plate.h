#pragma once

#include "contact/substrates/material.h"

namespace tricontact::contact {

/// The plate above a body between two plates (ElasticBody::Support::plates) where it is not like
/// the substrate: rigid, or a layer bonded to rigid ground. Kept with a case that has one, see
/// Case::of().
struct UpperPlate {
    bool is_rigid = false;
    Material material{0, 0};
    double thickness = 0;  ///< [m]
};

}  // namespace tricontact::contact
