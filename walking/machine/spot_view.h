#pragma once

#include <vector>

#include "walking/machine/contact_element.h"
#include "walking/machine/machine.h"
#include "walking/machine/motion.h"

namespace tricontact::walking {

/// A run as the spots of its machine see it: the springs of a bed count as one, whose deflections
/// are those of a single spring of the spot's stiffness with the same forces. It sticks while one
/// of them does, and slips as far as the one that slips least. Without a bed: the run itself.
class SpotView {
  public:
    explicit SpotView(const Machine& machine);

    /// `motion` and `steps`: of springs_of(machine), in their order. Valid until the next call.
    void look_at(const Motion& motion, const std::vector<SpotStep>& steps);

    const Motion& motion() const { return *motion_; }
    /// In the order of spots_of.
    const std::vector<SpotStep>& steps() const { return *steps_; }

  private:
    std::vector<Spot> spots_, springs_;
    Motion sums_;
    std::vector<SpotStep> sum_steps_;
    const Motion* motion_ = nullptr;
    const std::vector<SpotStep>* steps_ = nullptr;
};

}  // namespace tricontact::walking
