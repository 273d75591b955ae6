#pragma once

namespace tricontact::statistics {

/// A measured or derived quantity in SI units.
struct Uncertain {
    double value = 0;
    double standard_error = 0;  ///< one standard deviation, same unit; 0: exact
};

}  // namespace tricontact::statistics
