#include "walking/machine/spot_view.h"

#include <cmath>

namespace tricontact::walking {

SpotView::SpotView(const Machine& machine) : spots_(spots_of(machine)) {
    if (machine.bed) springs_ = springs_of(machine);
    sum_steps_.resize(spots_.size());
}

void SpotView::look_at(const Motion& motion, const std::vector<SpotStep>& steps) {
    motion_ = &motion;
    steps_ = &steps;
    if (springs_.empty()) return;
    sums_ = motion;
    sums_.spots.assign(spots_.size(), {});
    const std::size_t n = springs_.size() / spots_.size();
    for (std::size_t spot = 0; spot < spots_.size(); ++spot) {
        SpotDeflection& sum = sums_.spots[spot];
        SpotStep& sum_step = sum_steps_[spot];
        sum_step = {};
        bool touches = false;
        for (std::size_t i = spot * n; i < (spot + 1) * n; ++i) {
            const SpotDeflection& spring = motion.spots[i];
            if (spring.normal == 0) continue;
            const double share = springs_[i].stiffness / spots_[spot].stiffness;
            sum.normal += share * spring.normal;
            sum.tangential += share * spring.tangential;
            sum_step.sticks = sum_step.sticks || steps[i].sticks;
            if (!touches || std::abs(steps[i].slip) < std::abs(sum_step.slip))
                sum_step.slip = steps[i].slip;
            touches = true;
        }
    }
    motion_ = &sums_;
    steps_ = &sum_steps_;
}

}  // namespace tricontact::walking
