#include "dynamics/walk_result.h"

namespace tricontact::dynamics {

std::string_view word_of(Regime regime) {
    switch (regime) {
        case Regime::steady:
            return "steady";
        case Regime::limit_cycle:
            return "limit-cycle";
        case Regime::chaotic:
            return "chaotic";
        case Regime::tilting:
            return "tilting";
        case Regime::sticking:
            return "sticking";
        case Regime::shakedown:
            return "shakedown";
        case Regime::ratcheting:
            return "ratcheting";
        case Regime::walking:
            break;
    }
    return "walking";
}

}  // namespace tricontact::dynamics
