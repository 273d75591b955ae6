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

std::string FrictionRate::formula() const {
    std::string text;
    for (std::size_t k = 0; k < drops.size(); ++k) {
        const std::string ratio = fmt::format("v/({:.4g} m/s)", speeds[k]);
        text += fmt::format(" - {:.4g} (1 - ", drops[k]);
        switch (law) {
            case Law::linear:
                text += fmt::format("max(0, 1 - {}/2)", ratio);
                break;
            case Law::rational:
                text += fmt::format("1/(1 + {}{})", k == 0 ? ratio : '(' + ratio + ')',
                                    k == 0 ? "" : "^2");
                break;
            case Law::exponential:
                text += fmt::format("2^(-{})", ratio);
        }
        text += ')';
    }
    return text;
}

}  // namespace tricontact::contact
