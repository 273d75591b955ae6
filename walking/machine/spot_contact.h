#pragma once

#include <optional>

#include "contact/substrates/material.h"

namespace tricontact::walking {

/// What the stiffness of a contact spot follows from: a contact area and the bodies at it. Wetter
/// (2016), eqs. 4.1.7, 4.1.8 and 5.2.3.
struct SpotContact {
    double diameter = 0;  ///< D_c [m]
    contact::Material body = {};
    std::optional<contact::Material> substrate = {};  ///< empty: rigid

    /// k_z = E* D_c [N/m].
    double normal_stiffness() const {
        return contact::MaterialPair(substrate, body).effective_modulus() * diameter;
    }
    /// k_x = G* D_c [N/m].
    double tangential_stiffness() const {
        return contact::MaterialPair(substrate, body).effective_shear_modulus() * diameter;
    }
};

}  // namespace tricontact::walking
