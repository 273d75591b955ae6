#pragma once

#include <algorithm>

namespace tricontact::contact {

/// How the coefficient of friction mu changes with the temperature T of the surfaces where they
/// touch: mu up to T = `from`, mu + change from `to` on, linearly between.
struct FrictionTemperature {
    double change = 0;        ///< [-], above -mu, not 0
    double from = 0, to = 0;  ///< [degC], from < to

    /// At T [degC], of mu up to `from` [-].
    double coefficient(double mu, double temperature) const {
        return mu + change * std::clamp((temperature - from) / (to - from), 0., 1.);
    }
};

}  // namespace tricontact::contact
