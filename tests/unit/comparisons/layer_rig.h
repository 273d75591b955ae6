#pragma once

#include "contact/case.h"
#include "contact/cells.h"

namespace tricontact::synthetic {

/// The thesis' rig 5.1.1: rubber of 8 mm, rigid sphere, rolled.
inline contact::Case layer_rig() {
    contact::Case c;
    c.models = {"bem-layer"};
    c.indenter.radius = .04;
    c.substrate = {5.2e6, .5};
    c.layer.thickness = 8e-3;
    c.friction.coefficient = .57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = .56;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = .24;
    c.of<contact::Cells>().per_radius = 22.5;
    return c;
}

}  // namespace tricontact::synthetic
