#pragma once

#include "contact/case.h"
#include "contact/cells.h"

namespace tricontact::speed {

/// The rig of table 5.1.1 (sphere on rubber, load parallel to rolling), 0.2 mm cells.
inline contact::Case rig(double w, double tangential_ratio) {
    contact::Case c;
    c.indenter.radius = 0.04;
    c.indenter.material = contact::Material{206e9, 0.3};
    c.substrate = {5.2e6, 0.5};
    c.friction.coefficient = 0.57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = tangential_ratio;
    c.rolling = contact::Case::Rolling{};
    c.rolling->amplitude_ratio = w;
    c.of<contact::Cells>().spacing = 2e-4;
    return c;
}

}  // namespace tricontact::speed
