#pragma once

namespace tricontact::mdr {

/// Of a line of springs. Kept with a case, see contact::Case::of().
struct Settings {
    /// Of independent ones: over the whole bed, contact diameter plus rolling path.
    int springs = 10000;
    /// Of those that a layer couples: elements in the contact radius, more where the layer is thin.
    int elements_per_radius = 100;
};

}  // namespace tricontact::mdr
