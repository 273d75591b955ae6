// Energy around a loop of depths with a jump into contact and one off, by two ways that know
// nothing of each other.

#pragma once

#include <array>
#include <string>

#include "contact/base/error.h"
#include "contact/model.h"
#include "tests/unit/adhesive_ball.h"

namespace tricontact::test {

struct LoopEnergy {
    double lost;  ///< what the steps of an ordinary run tell, added up [J]
    double work;  ///< of the force around the loop [J]
};

/// From `low` to `high` and back, over the ball's unit of depth. The work is Simpson's integral of
/// the force alone between the places of both jumps, which are bisected; beyond them either way has
/// the same states. Near the jump the force goes as the root of the distance from it, which is what
/// the integral goes by.
inline LoopEnergy energy_of_loop(contact::Model& model, const AdhesiveBall& ball, double low,
                                 double high, int steps = 20) {
    const auto force_at = [&](double depth) {
        return ball.press(model, depth).normal_force / ball.force();
    };
    const auto restart = [&](double depth) {
        model.release();
        force_at(depth);
    };
    LoopEnergy energy{};
    const double length = (high - low) / steps;
    double in = low, off = low;  // ends of the steps that jump
    restart(low);
    for (int k = 1; k <= 2 * steps; ++k) {
        const double depth = low + length * (k <= steps ? k : 2 * steps - k),
                     lost = ball.press(model, depth).released_energy;
        if (lost > 0) (k <= steps ? in : off) = depth;
        energy.lost += lost;
    }
    // Each trial goes on from the last state on the side where the way began.
    const auto place = [&](double start, double apart, double together) {
        constexpr double holds = -.15;
        const bool begins_held = start > together;
        restart(start);
        force_at(begins_held ? together : apart);
        std::string before = model.write_state();
        for (int k = 0; k < 10; ++k) {
            const double middle = (apart + together) / 2;
            bool is_held = false;
            try {
                is_held = force_at(middle) < holds;
                if (is_held == begins_held) before = model.write_state();
            } catch (const contact::NotConverged&) {  // next to the jump
            }
            (is_held ? together : apart) = middle;
            model.read_state(before);
        }
        return std::array{apart, together};
    };
    // From either end up to its jump.
    const auto integral = [&](double start, double from, double jump, int n) {
        restart(start);
        double sum = 0;
        for (int k = 0; k < n; ++k) {
            const double t = 1 - static_cast<double>(k) / n, weight = k == 0       ? 1
                                                                      : k % 2 == 1 ? 4
                                                                                   : 2;
            sum += weight * 2 * t * force_at(jump + (from - jump) * t * t);
        }
        return (from - jump) * sum / (3 * n);
    };
    const auto first = place(low, in - length, in), last = place(high, off, off + length);
    const double held = integral(high, first[1], last[1], 24),
                 apart = integral(low, low, first[0], 16);
    energy.work = (-held - apart) * ball.force() * ball.depth();
    return energy;
}

}  // namespace tricontact::test
