#pragma once

#include <array>
#include <span>
#include <vector>

#include "experiments/identification/loops/loop_curve.h"
#include "experiments/identification/loops/measured_loop.h"

namespace tricontact::experiments {

/// n_of_loop numbers that are fitted to one loop beside the rig: where force and shift count from,
/// and how far the drive went, within a tenth of the extreme shifts; and what the contact carries.
struct LoopState {
    double force_offset = 0;  ///< [N]
    double centre = 0;        ///< of the shift [m]
    double amplitude = 0;     ///< of the shift [m]
    double friction = 1;      ///< over the curve's

    double& operator[](std::size_t k) {
        return k == 0 ? force_offset : k == 1 ? centre : k == 2 ? amplitude : friction;
    }
};

/// The rows of one loop.
struct LoopRows {
    const MeasuredLoop& loop;
    std::span<const double> shifts, forces;  ///< of the loop [m, N]
    std::span<const double> errors;          ///< of the forces [N]; empty: equal
    std::vector<bool> rises;

    double error(std::size_t i) const { return errors.empty() ? 1 : errors[i]; }
};

struct FittedLoop {
    LoopState state;
    std::vector<double> forces;  ///< fitted [N]
    /// Slopes of `forces` by the numbers of LoopState, friction last.
    std::array<std::vector<double>, n_of_loop + 1> slopes;
    double sum_of_squares = 0;  ///< over the errors
    /// Inverse of the information of the numbers that were free, by the errors of the rows; 0 of
    /// those at a bound.
    std::array<std::array<double, n_of_loop + 1>, n_of_loop + 1> covariance{};
};

/// The steady cycle of a state at the shifts of the rows.
FittedLoop loop_of_state(const LoopRows& rows, const LoopCurve& curve, const LoopState& state);

/// Least squares, its friction as given or free as well. `start`: a state nearby, for speed.
FittedLoop fit_loop(const LoopRows& rows, const LoopCurve& curve, double friction,
                    bool frees_friction = false, const LoopState* start = nullptr);

}  // namespace tricontact::experiments
