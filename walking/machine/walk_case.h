#pragma once

#include <optional>
#include <string>
#include <vector>

#include "walking/machine/dimensional_machine.h"
#include "walking/machine/machine.h"
#include "walking/machine/motion.h"

namespace tricontact::walking {

/// What a case of the micro-walking machine says. Times in units of sqrt(m/k_x).
struct WalkCase {
    struct Time {
        double step = 1e-3;
        double end = 20000;

        bool operator==(const Time&) const = default;
    };

    /// What the case states in place of numbers that follow from it.
    struct Input {
        std::optional<double> height_ratio;  ///< h/a of a dimensional machine: its lever arm
        std::optional<SpotContact> contact;  ///< of a dimensional machine: its stiffnesses
        std::optional<double> duration;      ///< [s] of a dimensional machine: Time::end
        /// Of Model::spots, position by position; heights empty: 0, stiffnesses empty: 1.
        std::vector<double> positions, heights, stiffnesses;
    };

    std::string title;
    Machine machine;
    std::optional<DimensionalMachine> dimensional;  ///< what the kappas follow from, if given
    Start start;
    Time time;
    Input input;
    int frames = 100;  ///< of the animation
};

}  // namespace tricontact::walking
