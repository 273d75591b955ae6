#include "walking/study/motion_class.h"

namespace tricontact::walking {

MotionClass motion_class(const WalkResult& result) {
    if (result.regime == Regime::tilting) return MotionClass::fallen;
    if (!result.transient_over) return MotionClass::unsettled;
    if (result.regime == Regime::steady) return MotionClass::steady;
    return result.regime == Regime::limit_cycle ? MotionClass::limit_cycle : MotionClass::chaotic;
}

std::string words_of(MotionClass motion) {
    constexpr const char* words[n_motion_classes] = {"slides steadily", "walks in a limit cycle",
                                                     "walks chaotically", "not settled yet",
                                                     "falls over"};
    return words[static_cast<int>(motion)];
}

}  // namespace tricontact::walking
