#include "fem/mortar/mean_heights.h"

#include <array>
#include <cmath>

namespace tricontact::fem {

// Of one linear function over [-1, 1] the rule has the moments 1, 1/6 and 1/15: exact to degree 5.
double MeanHeights::height(double x, double y) const {
    static const std::array<double, 3> at{-std::sqrt(.4), 0, std::sqrt(.4)};
    constexpr std::array<double, 3> part{5. / 24, 7. / 12, 5. / 24};
    const double here = body_->height(x, y);
    if (!std::isfinite(here)) return here;
    double sum = 0, parts = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double h = body_->height(x + at[i] * spacing_[0], y + at[j] * spacing_[1]);
            if (!std::isfinite(h)) continue;
            sum += part[i] * part[j] * h;
            parts += part[i] * part[j];
        }
    return sum / parts;
}

}  // namespace tricontact::fem
