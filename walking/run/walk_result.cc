#include "walking/run/walk_result.h"

namespace tricontact::walking {

std::string_view word_of(Regime regime) {
    constexpr std::string_view words[all_regimes.size()] = {
        "steady",   "limit-cycle", "chaotic",    "tilting",
        "sticking", "shakedown",   "ratcheting", "walking"};
    return words[static_cast<int>(regime)];
}

}  // namespace tricontact::walking
