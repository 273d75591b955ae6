#pragma once

namespace tricontact::contact {

/// Of surfaces that attract each other, without friction: where a contact that is pulled slowly
/// lets go.
struct PullOff {
    double force = 0;             ///< the largest tension that it holds [N]
    double radius = 0;            ///< a under that force [m]
    double indentation = 0;       ///< d likewise [m], negative: below the height of first touch
    double last_indentation = 0;  ///< d at which it lets go where the depth is prescribed [m]
};

}  // namespace tricontact::contact
