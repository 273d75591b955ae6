#include "contact/bodies/pressure_shape.h"

namespace tricontact::contact {

bool pressure_falls(const Case& c) {
    if (c.indenter.roughness) return false;
    switch (c.indenter.shape) {
        case Case::Shape::paraboloid:
        case Case::Shape::sphere:
        case Case::Shape::ellipsoid:
        case Case::Shape::cone:
        case Case::Shape::cylinder:
            return true;
        case Case::Shape::power_law:
            return c.indenter.exponent <= 2;
        default:
            return false;
    }
}

}  // namespace tricontact::contact
