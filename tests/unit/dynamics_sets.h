#pragma once

#include "dynamics/kappas.h"

namespace tricontact::dynamics {

/// Wetter (2016), eq. 4.1.25: slides as if it were one block.
inline Kappas set_a() {
    return {2, 1.2, 0.5, 1e-4, 0.5, 1e-4, 0.42, 0.5};
}

/// Wetter (2016), eq. 4.1.26: walks.
inline Kappas set_b() {
    return {2, 1.2, 0.5, 1e-4, 0.68, 1e-4, 0.42, 1.18};
}

}  // namespace tricontact::dynamics
