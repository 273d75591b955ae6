#include "dynamics/walk_result.h"

namespace tricontact::dynamics {

std::string_view word_of(Regime regime) {
    constexpr std::string_view words[all_regimes.size()] = {
        "steady",   "limit-cycle", "chaotic",    "tilting",
        "sticking", "shakedown",   "ratcheting", "walking"};
    return words[static_cast<int>(regime)];
}

}  // namespace tricontact::dynamics
