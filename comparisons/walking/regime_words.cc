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
            break;
    }
    return "falls over";
}

}  // namespace tricontact::comparisons::walking
