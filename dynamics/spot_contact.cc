#include "dynamics/spot_contact.h"

namespace tricontact::dynamics {

double SpotContact::normal_stiffness() const {
    return contact::MaterialPair(substrate, body).effective_modulus() * diameter;
}

double SpotContact::tangential_stiffness() const {
    return contact::MaterialPair(substrate, body).effective_shear_modulus() * diameter;
}

}  // namespace tricontact::dynamics
