#include "comparisons/walking/motion_class.h"

namespace tricontact::comparisons::walking {

MotionClass motion_class(const dynamics::WalkResult& result) {
    using dynamics::Regime;
    if (result.regime == Regime::tilting) return MotionClass::fallen;
    if (!result.transient_over) return MotionClass::unsettled;
    if (result.regime == Regime::steady) return MotionClass::steady;
    return result.regime == Regime::limit_cycle ? MotionClass::limit_cycle : MotionClass::chaotic;
}

std::string words_of(MotionClass motion) {
    switch (motion) {
        case MotionClass::steady:
            return "slides steadily";
        case MotionClass::limit_cycle:
            return "walks in a limit cycle";
        case MotionClass::chaotic:
            return "walks chaotically";
        case MotionClass::unsettled:
            return "not settled yet";
        case MotionClass::fallen:
            break;
    }
    return "falls over";
}

}  // namespace tricontact::comparisons::walking
