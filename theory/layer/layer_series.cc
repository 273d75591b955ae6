#include "theory/layer/layer_series.h"

#include <fmt/format.h>

#include <cmath>

#include "contact/error.h"

namespace tricontact::theory {

double LayerForceSeries::force_ratio(double chi) const {
    if (!(chi >= 0) || !std::isfinite(chi))
        throw contact::InputError(fmt::format(
            "layer series: sqrt(R d)/b must not be negative or infinite, but is {:.6g}; correct it",
            chi));
    const auto& [c1, c2, c3, c4] = coefficients;
    return 1 + chi * (c1 + chi * (c2 + chi * (c3 + chi * c4)));
}

}  // namespace tricontact::theory
