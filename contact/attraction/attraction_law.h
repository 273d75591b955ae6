#pragma once

namespace tricontact::contact {

/// The law of the surfaces, whatever points they have.
struct AttractionLaw {
    double work;  ///< w [J/m^2]
    double
        distance;  ///< as Attraction's [m]; 0: short-ranged, what Johnson, Kendall and Roberts did
    bool decays;   ///< as Attraction's
};

}  // namespace tricontact::contact
