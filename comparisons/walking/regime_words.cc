#include "comparisons/walking/regime_words.h"

namespace tricontact::comparisons::walking {

std::string words_of(dynamics::Regime regime) {
    switch (regime) {
        case dynamics::Regime::steady:
            return "slides steadily";
        case dynamics::Regime::limit_cycle:
            return "walks in a limit cycle";
        case dynamics::Regime::chaotic:
            return "walks chaotically";
        case dynamics::Regime::tilting:
            return "falls over";
        case dynamics::Regime::shakedown:
            return "shakes down";
        case dynamics::Regime::ratcheting:
            return "ratchets";
        case dynamics::Regime::walking:
            break;
    }
    return "walks";
}

}  // namespace tricontact::comparisons::walking
