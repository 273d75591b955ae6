#include "statistics/distribution.h"

#include <gsl/gsl_cdf.h>

#include <array>
#include <cmath>
#include <numbers>

namespace tricontact::statistics {

std::string_view name_of(Distribution distribution) {
    constexpr std::array<std::string_view, 3> names{"normal", "uniform", "triangular"};
    return names[static_cast<std::size_t>(distribution)];
}

double standard_deviations(Distribution distribution) {
    switch (distribution) {
        case Distribution::uniform:
            return std::numbers::inv_sqrt3;
        case Distribution::triangular:
            return std::numbers::inv_sqrt3 / std::numbers::sqrt2;
        case Distribution::normal:
            break;
    }
    return 1;
}

double standard_quantile(Distribution distribution, double probability) {
    const double half_width = 1 / standard_deviations(distribution);
    switch (distribution) {
        case Distribution::uniform:
            return half_width * (2 * probability - 1);
        case Distribution::triangular:  // from -1 to 1: P = (1 + x)^2/2 for x < 0
            return half_width * (probability < .5 ? std::sqrt(2 * probability) - 1
                                                  : 1 - std::sqrt(2 * (1 - probability)));
        case Distribution::normal:
            break;
    }
    return gsl_cdf_ugaussian_Pinv(probability);
}

}  // namespace tricontact::statistics
