#pragma once

#include <cstdint>
#include <vector>

namespace tricontact::walking {

/// Instruction set a batch computes with. All lead to the same statistics; avx2 and avx512, which
/// have fused multiply-add, also to the same bits, and so do plain and sse2.
enum class Kernel {
    plain,  ///< no vectors
    sse2,   ///< 2 machines at once
    avx2,   ///< 4
    avx512  ///< 8
};

/// Those that this processor has, the fastest one last.
std::vector<Kernel> available_kernels();

/// The fastest one that this processor has.
Kernel best_kernel();

}  // namespace tricontact::walking

namespace tricontact::walking::kernels {

/// What a kernel knows of a lane, that is one machine of a batch. Scaled so that a step takes few
/// operations: p = phi/kappa3^2, Z = c_n z with c_n z the friction bound of a spot (c_n = mu
/// kappa2, in the prism over sqrt(2)), Y = kappa1 (x_s - x), and the increments of positions over a
/// step instead of velocities.
enum Field : int {
    // Constants of the machine and the step dt.
    lever,           ///< of p in the approach of a spot: c_n kappa3
    spring,          ///< kappa1
    spring_lever,    ///< of p in f_s: kappa1 kappa8 kappa3^2
    base_increment,  ///< of Y by the base: kappa1 kappa6 dt
    rotation_reach,  ///< of p in s = x + phi: kappa3^2
    weight,          ///< in the increment of Z: dt^2 c_n kappa4
    lift,            ///< of mu times the normal forces in it: dt^2 c_n/mu
    pull,            ///< of a force in the increment of x: dt^2
    turn,            ///< of a moment in the increment of p: dt^2/kappa7
    normal_moment,   ///< of mu times a normal force: 1/(mu kappa3)
    tilted_moment,   ///< the same times p: kappa3/mu
    spring_height,   ///< kappa8
    flank_reach,     ///< prism: of the approach's increment in that of u_s: 1/(mu kappa2)
    flank_force,     ///< prism: of u_s in mu times the normal force of a side: sqrt(2) mu
    n_constants,

    // State after a step.
    rotation = n_constants,  ///< p
    rotation_increment,
    height,  ///< Z
    height_increment,
    extension,  ///< Y
    x_increment,
    deflection_1,  ///< u of the left spot
    deflection_2,
    flank_1,  ///< u_s of the left spot
    flank_2,
    slip_1,  ///< increment of s = x + phi - u in the last step
    slip_2,
    end_of_state,

    // Sums and extremes over the steps of one call.
    sum_force = end_of_state,  ///< f_s
    min_height,
    max_height,
    min_rotation,
    max_rotation,
    sum_x_squared,  ///< of two increments, the ones before and after
    sum_height_squared,
    sum_rotation_squared,
    sum_sticking_1,
    sum_sticking_2,
    sum_slip_1,  ///< of two steps, the one before and the one after the deflection
    sum_slip_2,
    sum_slip_squared_1,
    sum_slip_squared_2,
    sum_bound_1,  ///< c_n n, before the step
    sum_bound_2,
    sum_bound_squared_1,
    sum_bound_squared_2,
    sum_bound_slip_1,
    sum_bound_slip_2,
    n_fields
};

constexpr int n_sums = n_fields - end_of_state;

/// The step compiled for one instruction set.
struct LaneFunctions {
    int n_lanes;
    /// Advances lanes of two spots, of prisms: fields[f * n_lanes + i] is field f of lane i, on a
    /// boundary of 64 bytes.
    void (*advance[2])(double* fields, std::int64_t n_steps);
};

LaneFunctions avx2_lanes();
LaneFunctions avx512_lanes();
LaneFunctions functions_of(Kernel kernel);

}  // namespace tricontact::walking::kernels
