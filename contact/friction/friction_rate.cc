#include "contact/friction/friction_rate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tricontact::contact {

namespace {

/// f_k at v/v_k.
double share_left(FrictionRate::Law law, std::size_t k, double ratio) {
    switch (law) {
        case FrictionRate::Law::linear:
            return std::max(0., 1 - ratio / 2);
        case FrictionRate::Law::rational:
            return 1 / (1 + (k == 0 ? ratio : ratio * ratio));
        case FrictionRate::Law::exponential:
            break;
    }
    return std::exp2(-ratio);
}

}  // namespace

double FrictionRate::coefficient(double at_rest, double speed) const {
    double mu = at_rest;
    for (std::size_t k = 0; k < drops.size(); ++k)
        mu -= drops[k] * (1 - share_left(law, k, speed / speeds[k]));
    return mu;
}

double FrictionRate::least(double at_rest) const {
    return at_rest - std::accumulate(drops.begin(), drops.end(), 0.);
}

double FrictionRate::memory(double time, double speed) const {
    if (memory_length == 0) return 0;
    return memory_length / (memory_length + time * std::max(speed, memory_speed));
}

std::string FrictionRate::fall() const {
    std::string text = "falling by ";
    for (std::size_t k = 0; k < drops.size(); ++k)
        text += fmt::format("{}{:.4g} p (half of it at {:.4g} m/s)", k == 0 ? "" : " and ",
                            drops[k], speeds[k]);
    return text + (law == Law::linear     ? ", linearly"
                   : law == Law::rational ? ", as a quotient"
                                          : ", exponentially");
}

}  // namespace tricontact::contact
