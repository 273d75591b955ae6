#pragma once

#include "walking/machine/machine.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking {

/// Wetter (2016), eq. 4.1.25: slides as if it were one block.
inline Kappas set_a() {
    return {2, 1.2, 0.5, 1e-4, 0.5, 1e-4, 0.42, 0.5};
}

/// Wetter (2016), eq. 4.1.26: walks.
inline Kappas set_b() {
    return {2, 1.2, 0.5, 1e-4, 0.68, 1e-4, 0.42, 1.18};
}

/// From rest to `end`, in steps of 1e-3.
inline WalkCase case_of(const Kappas& kappas, double end) {
    WalkCase walk_case;
    walk_case.machine.kappas = kappas;
    walk_case.time.end = end;
    return walk_case;
}

}  // namespace tricontact::walking
