#pragma once

namespace tricontact::mdr {

/// Of a bed of independent springs. Kept with a case, see contact::Case::of().
struct Settings {
    int springs = 10000;  ///< over the whole bed, contact diameter plus rolling path
};

}  // namespace tricontact::mdr
