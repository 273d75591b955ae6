#pragma once

#include "contact/interface.h"
#include "contact/models/model_kind.h"

namespace tricontact::mdr {

/// Of a line of springs. Kept with a case, see contact::Case::of().
struct Settings {
    /// Of independent ones: over the whole bed, contact diameter plus rolling path.
    int springs = 10000;
    /// Of those that a layer or the springs of the interface couple: elements in the contact
    /// radius, more where a layer is thin.
    int elements_per_radius = 100;
};

/// Whether a model's springs are independent, their number the resolution. Springs of the interface
/// couple those of the half-space as a layer does.
inline bool springs_are_independent(const contact::ModelKind& kind,
                                    const contact::Interface& interface) {
    return kind.is_independent() && !interface.is_elastic();
}
/// Key of the resolution of a model on a line.
inline const char* line_resolution(const contact::ModelKind& kind,
                                   const contact::Interface& interface) {
    return springs_are_independent(kind, interface) ? "mdr.springs" : "mdr.elements_per_radius";
}

}  // namespace tricontact::mdr
