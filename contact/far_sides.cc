#include "contact/far_sides.h"

namespace tricontact::contact {

// On a bonded base 0.01 % is left of the difference between held and free sides at 6 thicknesses; a
// line's displacements fall slower with the distance, 0.03 % at 6 and 0.003 % at 8.
// On a frictionless one the layer is a sheet whose sides are felt as the inverse square of their
// distance: 1.4 % at 6 thicknesses, nu = 1/2.
double far_sides(const Case& c) {
    if (c.layer.base != Case::Base::bonded) return 40;
    return c.is_line_contact() ? 8 : 6;
}

}  // namespace tricontact::contact
